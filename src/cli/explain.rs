//! `xacro-lint explain` and `xacro-lint rules`.

use super::args::{Plain, RulesArgs};
use super::io::Io;
use super::render::visible;
use rules::{self, Activation, Rule};

/// Print the page of a rule; without one, or of several, a list.
pub(super) fn explain(rule: Option<&str>, io: &mut Io<'_>) -> u8 {
    let Some(selector) = rule else {
        return rules(&RulesArgs::default(), io);
    };
    let found = rules::find(selector).find(|rule| rule.name == selector || rule.code == selector);
    match found {
        Some(rule) => {
            io.out(rule.docs);
            0
        }
        None => rules(
            &RulesArgs {
                rules: vec![selector.to_owned()],
                ..RulesArgs::default()
            },
            io,
        ),
    }
}

/// Print the rules that are asked for.
pub(super) fn rules(args: &RulesArgs, io: &mut Io<'_>) -> u8 {
    if let Some(unknown) = args.rules.iter().find(|selector| !is_known(selector)) {
        io.line(&format!(
            "error: {}",
            visible(&rules::unknown_selector(unknown))
        ));
        return 2;
    }
    let found: Vec<&'static Rule> = rules::all().filter(|rule| is_wanted(rule, args)).collect();
    match args.format {
        Plain::Json => io.out(&rules::catalogue_of(found.iter().copied())),
        Plain::Text => {
            let width = found.iter().map(|rule| rule.name.len()).max().unwrap_or(0);
            for Rule {
                code,
                name,
                severity,
                default,
                fix,
                ..
            } in found
            {
                let fix = fix.map_or("", |safety| safety.name());
                let line = format!("{code}  {name:width$}  {:7}  {default}", severity.name());
                let line = if fix.is_empty() {
                    line
                } else {
                    format!("{line}  ({fix} fix)")
                };
                io.out(&format!("{line}\n"));
            }
        }
    }
    0
}

fn is_known(selector: &str) -> bool {
    selector == "ALL" || rules::find(selector).next().is_some()
}

fn is_wanted(rule: &Rule, args: &RulesArgs) -> bool {
    let named = |selector: &String| selector == "ALL" || rule.is_named(selector);
    let in_profile = |profile: &String| match rule.default {
        Activation::On => true,
        Activation::Off => false,
        Activation::Profiles(profiles) => profiles.contains(&profile.as_str()),
    };
    (args.rules.is_empty() || args.rules.iter().any(named))
        && args
            .category
            .as_ref()
            .is_none_or(|category| rule.category.name() == category)
        && args
            .severity
            .is_none_or(|severity| rule.severity == severity.0)
        && args.profile.as_ref().is_none_or(in_profile)
        && (!args.fixable || rule.fix.is_some())
}
