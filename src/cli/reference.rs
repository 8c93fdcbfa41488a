//! The commands and options as a page, made from their declaration.

use clap::{Arg, Command, CommandFactory};

use super::args::Arguments;

/// Every command with its arguments and options, as Markdown.
pub fn reference() -> String {
    let mut command = Arguments::command();
    command.build();
    let mut out = String::new();
    for command in command
        .get_subcommands()
        .filter(|command| command.get_name() != "help")
    {
        out.push_str(&section(command));
    }
    out
}

fn section(command: &Command) -> String {
    let about = command
        .get_about()
        .map(ToString::to_string)
        .unwrap_or_default();
    let mut out = format!("\n### `{}`\n\n{about}.\n", command.get_name());
    if command.get_name() == "fix" {
        out.push_str("Takes the options of `check`.\n");
        return out;
    }
    let rows: Vec<String> = command
        .get_arguments()
        .filter(|arg| arg.get_id() != "help" && !arg.is_hide_set())
        .map(|arg| format!("| {} | {} |\n", name(arg), meaning(arg)))
        .collect();
    if !rows.is_empty() {
        out.push_str("\n| argument | meaning |\n|---|---|\n");
        out.extend(rows);
    }
    out
}

fn takes_value(arg: &Arg) -> bool {
    arg.get_action().takes_values()
}

/// `` `--format FORMAT` ``, `` `-o`, `--output FILE` ``
fn name(arg: &Arg) -> String {
    let id = arg.get_id().as_str().to_uppercase();
    let value = arg
        .get_value_names()
        .and_then(|names| names.first())
        .map_or(id, ToString::to_string);
    let Some(long) = arg.get_long() else {
        return format!("`{value}`");
    };
    let value = if takes_value(arg) {
        format!(" {value}")
    } else {
        String::new()
    };
    let aliases = arg.get_all_aliases().unwrap_or_default();
    let aliases: String = aliases
        .iter()
        .map(|alias| format!(", `--{alias}`"))
        .collect();
    let short = arg
        .get_short()
        .map(|short| format!("`-{short}`, "))
        .unwrap_or_default();
    format!("{short}`--{long}{value}`{aliases}")
}

fn meaning(arg: &Arg) -> String {
    let mut text = arg.get_help().map(ToString::to_string).unwrap_or_default();
    let values = if takes_value(arg) {
        arg.get_possible_values()
    } else {
        Vec::new()
    };
    if !values.is_empty() {
        let names: Vec<String> = values
            .iter()
            .map(|value| format!("`{}`", value.get_name()))
            .collect();
        text.push_str(&format!(": {}", names.join(", ")));
    }
    let defaults = if takes_value(arg) {
        arg.get_default_values()
    } else {
        &[]
    };
    if let Some(default) = defaults.first() {
        text.push_str(&format!("; default `{}`", default.display()));
    }
    text.replace('|', "\\|")
}
