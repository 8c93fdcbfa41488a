//! Reading a launch file, script or page for the descriptions it names and the arguments it gives.

use std::borrow::Cow;
use std::path::Path;

use super::caller::{Caller, GivenArg, NamePrefix};
use super::config;
use super::era::era;
use super::file_names;
use super::file_names::is_description;
use super::text_words::TextWords;
use crate::launch;
use base::FastMap;

/// Whether a text holds one of these words, also as a part of another.
pub(super) fn has_any(text: &str, words: &[&str]) -> bool {
    words.iter().any(|word| text.contains(word))
}

/// What a file calls; none when it names no description. Only then it is read as a launch file.
pub(super) fn caller(path: &Path, text: &str) -> Option<Caller> {
    let whole = text;
    let name = path.file_name()?.to_str()?;
    let text = &*without_comments(name, text);
    let descriptions = descriptions(name, text);
    let mut endings = computed(text);
    if file_names::is_launch(path) {
        endings.extend(added(text));
    }
    if ["py", "sh", "cpp"]
        .iter()
        .any(|ending| name.ends_with(ending))
    {
        endings.extend(searched(text));
    }
    let is_yaml = name.ends_with(".yaml") || name.ends_with(".yml");
    let based_on = is_yaml.then(|| config::based_on(text)).flatten();
    if descriptions.is_empty() && endings.is_empty() && based_on.is_none() {
        return None;
    }
    let calls = launch::read(path, whole)
        .as_ref()
        .map(launch::calls)
        .unwrap_or_default();
    let given = calls.iter().flat_map(|call| &call.args);
    let given = given.map(|arg| GivenArg {
        name: arg.name.clone(),
        value: arg.value.literal(),
    });
    // of a text that no reader understands, only what it spells out
    let mut args: Vec<GivenArg> = if calls.is_empty() {
        spelled(text)
    } else {
        given.collect()
    };
    if is_yaml {
        args.extend(config::urdf_params(text));
    }
    Some(Caller {
        path: path.to_owned(),
        descriptions,
        endings,
        is_open: takes_any(text),
        has_default: false,
        era: era(text),
        is_bullet: has_any(text, &["loadURDF(", "Bullet", "pybullet"]),
        is_isaac: has_any(text, &["gymapi", "isaacgym", "legged_gym"]),
        is_raisim: has_any(text, &["addArticulatedSystem", "raisim"]),
        simulates: TextWords::is_about_simulation(text),
        args,
        based_on,
    })
}

/// A text without its comments: what they name is not called.
pub fn without_comments<'t>(name: &str, text: &'t str) -> Cow<'t, str> {
    match name.rsplit_once('.').map_or("", |(_, ending)| ending) {
        "launch" | "xml" | "test" | "xacro" | "urdf" if text.contains("<!--") => {
            let mut parts = text.split("<!--");
            let first = parts.next().unwrap_or("").to_owned();
            let behind = parts.filter_map(|part| Some(part.split_once("-->")?.1));
            Cow::Owned(behind.fold(first, |kept, part| kept + part))
        }
        "py" | "sh" | "bash" | "yaml" | "yml" if text.contains('#') => {
            let lines = text.split_inclusive('\n');
            let kept = lines.flat_map(|line| {
                let kept = without_line_comment(line);
                // the next line stays one of its own: YAML counts its blanks
                let is_cut = kept.len() < line.len() && line.ends_with('\n');
                [kept, if is_cut { "\n" } else { "" }]
            });
            Cow::Owned(kept.collect())
        }
        _ => Cow::Borrowed(text),
    }
}

/// A line up to a `#` that begins a comment: outside of quotes, and behind a blank or nothing.
fn without_line_comment(line: &str) -> &str {
    // most lines have none
    if !line.contains('#') {
        return line;
    }
    let (mut quote, mut before) = (None, ' ');
    for (at, c) in line.char_indices() {
        match c {
            '"' | '\'' if quote.is_none() => quote = Some(c),
            c if quote == Some(c) && before != '\\' => quote = None,
            '#' if quote.is_none()
                && (before.is_whitespace() || matches!(before, ',' | '(' | '[' | ')' | ']')) =>
            {
                return line.get(..at).unwrap_or(line);
            }
            _ => {}
        }
        before = c;
    }
    line
}

/// The names of descriptions in a text, each with the folders that are written in front of it. What is only installed or
/// included is not called.
pub(super) fn descriptions(name: &str, text: &str) -> FastMap<String, Vec<NamePrefix>> {
    let mut found: FastMap<String, Vec<NamePrefix>> = FastMap::default();
    for ending in [".xacro", ".urdf", ".URDF"] {
        for (at, _) in text.match_indices(ending) {
            let (before, after) = text.split_at(at + ending.len());
            let goes_on = |c: char| c.is_alphanumeric() || c == '_' || c == '.' && after.len() > 1;
            let sentence_ends = after.starts_with('.')
                && !after
                    .get(1..)
                    .is_some_and(|rest| rest.starts_with(char::is_alphanumeric));
            if after.starts_with(goes_on) && !sentence_ends {
                continue;
            }
            let word = before
                .rfind(|c: char| !is_name(c))
                .map_or(before, |at| before.get(at..).unwrap_or(""));
            let word = word.trim_start_matches(|c: char| !is_name(c));
            let lead = before.strip_suffix(word).unwrap_or("");
            if word.len() > ending.len()
                && !is_installed(name, lead)
                && !is_passed_over(text, tag_before(lead))
                && !is_listed(lead)
            {
                found
                    .entry(word.to_owned())
                    .or_default()
                    .push(folders_before(lead));
            }
        }
    }
    found
}

/// The package that is written in front of a path whose last name follows `lead`.
pub(super) fn package_of(lead: &str) -> Option<String> {
    folders_before(lead).package
}

/// The folders that are written in front of a name, as far as they are: `urdf/old` of `$(find arm)/urdf/old/arm.urdf` and
/// of `join(share, 'urdf', 'old', 'arm.urdf')`; and the package in front of them.
fn folders_before(lead: &str) -> NamePrefix {
    let mut names = Vec::new();
    let mut rest = lead;
    while let Some(before) = rest.strip_suffix('/').or_else(|| before_joined(rest)) {
        let name = last_name(before);
        if ["", ".", ".."].contains(&name) {
            break;
        }
        names.push(name);
        rest = before.strip_suffix(name).unwrap_or("");
    }
    NamePrefix {
        package: package_before(rest).map(str::to_owned),
        folders: names.into_iter().rev().collect(),
    }
}

/// The package that a text ends with: `arm` of `$(find arm)/`, `package://arm/` and `FindPackageShare('arm'), `.
fn package_before(lead: &str) -> Option<&str> {
    let call = lead
        .trim_end_matches(['"', '\'', ' ', ',', '/', '\n', '\t'])
        .strip_suffix(')')?;
    let name = last_name(call.trim_end_matches(['"', '\'']));
    let before = call.trim_end_matches(['"', '\'']).strip_suffix(name)?;
    let finds = [
        "$(find ",
        "FindPackageShare(",
        "get_package_share_directory(",
        "get_package_share_path(",
    ];
    finds
        .iter()
        .any(|find| before.trim_end_matches(['"', '\'']).ends_with(find))
        .then_some(name)
}

/// The name at the end of a text.
fn last_name(text: &str) -> &str {
    let start = text.rfind(|c: char| !is_name(c));
    let start = start.map_or(0, |at| at + text.get(at..).map_or(1, first_len));
    text.get(start..).unwrap_or("")
}

/// The text before the end of a quoted one, when what follows is joined to it as the next step of a path.
fn before_joined(lead: &str) -> Option<&str> {
    const QUOTES: [char; 2] = ['"', '\''];
    let lead = lead.strip_suffix(QUOTES)?.trim_end();
    lead.strip_suffix([',', '/'])?
        .trim_end()
        .strip_suffix(QUOTES)
}

fn first_len(text: &str) -> usize {
    text.chars().next().map_or(1, char::len_utf8)
}

/// Whether a text holds a name by itself, not as a part of another.
pub fn has_name(text: &str, name: &str) -> bool {
    let mut found = memchr::memmem::find_iter(text.as_bytes(), name.as_bytes());
    found.any(|at| {
        text.split_at_checked(at).is_some_and(|(before, after)| {
            let rest = after.get(name.len()..).unwrap_or("");
            !before.ends_with(is_name) && !rest.starts_with(is_name)
        })
    })
}

/// What the names of descriptions end with whose beginnings are computed: `_base.xacro` of `$(arg kind)_base.xacro`. The
/// empty text when the whole name is an argument of the call: `xacro $(arg model)`.
fn computed(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (at, _) in text.match_indices([')', '}']) {
        let after = text.get(at + 1..).unwrap_or("");
        let ending = after.split(|c: char| !is_name(c)).next().unwrap_or("");
        if is_description(ending) && !is_included(tag_before(text.get(..at).unwrap_or(""))) {
            found.push(ending.to_owned());
        }
    }
    if takes_any(text)
        || ["xacro.process", "xacro.parse("]
            .iter()
            .any(|call| text.contains(call))
    {
        found.push(String::new());
    }
    found
}

/// The endings that Python adds to names that it has: `MODEL + '.urdf'`. The whole name, where the text says what it adds to.
fn added(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (at, _) in text.match_indices('+') {
        let (before, after) = text.split_at(at);
        let after = after.trim_start_matches(['+', ' ']);
        let Some(after) = after.strip_prefix(['\'', '"']) else {
            continue;
        };
        let ending = after.split(|c: char| !is_name(c)).next().unwrap_or("");
        if ending.starts_with(['.', '_']) && is_description(ending) {
            let variable = before.trim_end().rsplit(|c: char| !is_name(c)).next();
            let start = variable.and_then(|variable| constant(text, variable));
            found.push(start.unwrap_or_default().to_owned() + ending);
        }
    }
    found
}

/// The text of a variable of Python that is set once, to a plain name.
fn constant<'t>(text: &'t str, variable: &str) -> Option<&'t str> {
    let value = |line: &'t str| {
        let rest = line.trim_start().strip_prefix(variable)?.trim_start();
        rest.strip_prefix('=').filter(|rest| !rest.starts_with('='))
    };
    let mut values = text.lines().filter_map(value);
    let only = values.next().filter(|_| values.next().is_none())?.trim();
    let inside = ['\'', '"']
        .into_iter()
        .find_map(|quote| only.strip_prefix(quote)?.strip_suffix(quote))?;
    inside.chars().all(is_name).then_some(inside)
}

/// The endings of the files that a program takes, whatever their names are.
fn searched(text: &str) -> impl Iterator<Item = String> {
    let takes = move |ending: &&&str| {
        let ways = [
            "*",
            "endswith('",
            "endswith(\"",
            "suffix == '",
            "suffix == \"",
        ];
        ways.iter()
            .any(|way| text.contains(&format!("{way}{ending}")))
    };
    [".urdf", ".xacro"]
        .iter()
        .filter(takes)
        .map(|ending| (*ending).to_owned())
}

/// Whether the name of the description is an argument of the call.
fn takes_any(text: &str) -> bool {
    const ARGUMENTS: [&str; 3] = ["$(arg ", "$(var ", "LaunchConfiguration("];
    let calls = text
        .match_indices("xacro")
        .filter_map(|(at, word)| text.get(at + word.len()..));
    let mut names =
        calls.map(|after| after.trim_start_matches([' ', '\'', '"', ',', '.', 'p', 'y']));
    names.any(|name| ARGUMENTS.iter().any(|argument| name.starts_with(argument)))
}

pub(super) fn is_name(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '-' | '.')
}

/// The end of a text, where what a name belongs to begins: a file may hold thousands of names in one line.
fn end_of(lead: &str) -> &str {
    const MOST: usize = 10_000;
    let start = lead.len().saturating_sub(MOST);
    lead.get(lead.ceil_char_boundary(start)..).unwrap_or("")
}

/// Whether a name behind this text stands in an `install(...)` of CMake.
fn is_installed(name: &str, lead: &str) -> bool {
    let lead = end_of(lead);
    let command = lead
        .rfind('(')
        .map_or("", |at| last_word(lead.get(..at).unwrap_or("")));
    let is_cmake = name == "CMakeLists.txt" || name.ends_with(".cmake");
    is_cmake
        && (command.eq_ignore_ascii_case("install")
            || command.eq_ignore_ascii_case("configure_file"))
}

/// Whether a name behind this text is part of a drawn tree of folders.
fn is_listed(lead: &str) -> bool {
    let line = end_of(lead).rsplit('\n').next().unwrap_or("");
    line.contains(['├', '└', '│']) || line.starts_with(' ') && is_branch(line.trim_start())
}

/// Whether a text is nothing but what draws a branch, as with `|--` and `>`.
fn is_branch(text: &str) -> bool {
    text.starts_with(['|', '+', '>']) && text.chars().all(|c| "|+->`\\ ".contains(c))
}

/// The tag that a text ends in, or has ended with.
fn tag_before(lead: &str) -> &str {
    let lead = end_of(lead);
    lead.rfind('<').and_then(|at| lead.get(at..)).unwrap_or("")
}

/// Whether a name in a tag loads nothing.
fn is_passed_over(text: &str, tag: &str) -> bool {
    is_included(tag) || is_idle_default(text, tag)
}

/// Whether a name in a tag is that of an include.
fn is_included(tag: &str) -> bool {
    tag.starts_with("<xacro:include") || tag.starts_with("<include") && tag.contains("filename")
}

/// Whether a name in a tag is the default of an argument that the launch file neither reads nor passes on.
fn is_idle_default(text: &str, tag: &str) -> bool {
    let name = tag
        .strip_prefix("<arg ")
        .and_then(|rest| rest.split_once("name=")?.1.get(1..))
        .and_then(|rest| rest.split(['"', '\'']).next());
    // in expressions an argument stands by its name alone
    const ANY: [&str; 2] = ["$(eval", "pass_all_args"];
    name.is_some_and(|name| {
        let read = [format!("$(arg {name})"), format!("$(var {name})")];
        tag.contains("default=")
            && !read.iter().any(|read| text.contains(read.as_str()))
            && !ANY.iter().any(|word| text.contains(word))
    })
}

/// The identifier at the end of a text.
fn last_word(text: &str) -> &str {
    let text = text.trim_end_matches(' ');
    let start = text.rfind(|c: char| !(c.is_alphanumeric() || c == '_'));
    let start = start.map_or(0, |at| {
        at + text
            .get(at..)
            .and_then(|rest| rest.chars().next())
            .map_or(1, char::len_utf8)
    });
    text.get(start..).unwrap_or("")
}

/// The arguments behind whose `:=` a text stands, in a file of any kind.
fn spelled(text: &str) -> Vec<GivenArg> {
    let mut args = Vec::new();
    for (at, _) in text.match_indices(":=") {
        let (before, after) = text.split_at(at);
        let own = last_word(before);
        if !own.is_empty() && !own.starts_with(|c: char| c == '_' || c.is_ascii_digit()) {
            args.push(GivenArg {
                name: own.to_owned(),
                value: given(after.get(2..).unwrap_or("")),
            });
        }
    }
    args
}

/// What is given behind `:=`: bare text, or the next element of a list of Python.
fn given(after: &str) -> Option<String> {
    let ends = |c: char| c.is_whitespace() || matches!(c, '"' | '\'' | ',' | '<' | '`' | ']' | ';');
    let bare = after.split(ends).next()?;
    if !bare.is_empty() {
        let bare = bare.trim_end_matches(')');
        return (!bare.contains(['$', '{', '%', '\\', '('])).then(|| bare.to_owned());
    }
    let next = after.get(1..).filter(|_| after.starts_with(['"', '\'']))?;
    let next = next.trim_start().strip_prefix([',', '+'])?.trim_start();
    let literal = quoted(next)?;
    (!literal.is_empty() && !literal.contains(['{', '$', ' ', '\n'])).then(|| literal.to_owned())
}

/// The text in quotes at the start of another.
fn quoted(text: &str) -> Option<&str> {
    let text = text.trim_start();
    let quote = text.chars().next().filter(|c| matches!(c, '"' | '\''))?;
    text.get(1..)?.split_once(quote).map(|(inner, _)| inner)
}
