//! What may be written at a place in a configuration file.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::declared::KnownArguments;
use super::host::AnalysisHost;
use super::launch_values::compared_words;
use super::root_config::RootConfig;
use super::session::Session;
use base::{CancelFlag, TextRange};
use rules::THRESHOLDS;
use workspace::config::{
    self, CONFIG_NAMES, ConfigCursor, ConfigCursorKind, ExpectedValue, files_named, place_at,
    wanted,
};

/// Files of a folder that are offered.
const MOST_FILES: usize = 500;

/// What may be written at a place in a configuration file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConfigChoices {
    /// What it replaces.
    pub range: TextRange,
    /// The choices, each with the text that is written.
    pub items: Vec<ConfigChoice>,
}

/// One of them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConfigChoice {
    /// What it is.
    pub kind: ConfigChoiceKind,
    /// Its name.
    pub name: String,
    /// The text that is written.
    pub text: String,
    /// A few words about it.
    pub detail: String,
}

/// What a choice is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum ConfigChoiceKind {
    Key,
    Argument,
    Value,
    Link,
    Joint,
    Rule,
    File,
    Folder,
}

/// Whether a file is a configuration, by its name.
pub fn is_config(path: &Path) -> bool {
    path.file_name()
        .is_some_and(|name| CONFIG_NAMES.iter().any(|own| name == *own))
}

/// Names with a few words about each.
type DescribedNames = Vec<(String, String)>;

/// What may be written at an offset of a configuration file. `None` where nothing may, or when cancelled.
pub fn config_choices_at(
    host: &mut AnalysisHost,
    path: &Path,
    offset: u32,
    cancel: &CancelFlag,
) -> Option<ConfigChoices> {
    let text = host.session().vfs.text(path).ok()?;
    let place = place_at(&text.text, offset)?;
    let (kind, names) = match wanted(&place)? {
        ExpectedValue::Keys(keys) => {
            let names = keys
                .into_iter()
                .map(|(name, doc)| (name.to_owned(), doc.to_owned()));
            (ConfigChoiceKind::Key, names.collect())
        }
        ExpectedValue::Words(words) => (
            ConfigChoiceKind::Value,
            plain(words.iter().map(|word| (*word).to_owned())),
        ),
        ExpectedValue::Bool => (
            ConfigChoiceKind::Value,
            plain(["true", "false"].map(str::to_owned)),
        ),
        ExpectedValue::Free => names_at(host, path, &place, cancel)?,
    };
    let after = text.text.get(place.range.end as usize..).unwrap_or("");
    let item = |(name, detail): (String, String)| {
        let is_folder = kind == ConfigChoiceKind::File && name.ends_with('/');
        let kind = if is_folder {
            ConfigChoiceKind::Folder
        } else {
            kind
        };
        ConfigChoice {
            text: written(&place, kind, &name, after),
            kind,
            name,
            detail,
        }
    };
    Some(ConfigChoices {
        range: place.range,
        items: names.into_iter().map(item).collect(),
    })
}

/// What the table of keys says of the key at an offset of a configuration file, with its place.
pub fn config_key_at(
    session: &Session,
    path: &Path,
    offset: u32,
) -> Option<(TextRange, &'static str)> {
    let text = session.vfs.text(path).ok()?;
    let place = place_at(&text.text, offset)
        .filter(|place| !matches!(place.kind, ConfigCursorKind::Value { .. }))?;
    let mut keys = place.path;
    keys.push(place.range.slice(&text.text).to_owned());
    Some((place.range, config::doc(&keys)?))
}

/// The names that belong to a place where any may stand.
fn names_at(
    host: &mut AnalysisHost,
    path: &Path,
    place: &ConfigCursor,
    cancel: &CancelFlag,
) -> Option<(ConfigChoiceKind, DescribedNames)> {
    let keys: Vec<&str> = place.path.iter().map(String::as_str).collect();
    let is_key = !matches!(place.kind, ConfigCursorKind::Value { .. });
    let folder = path.parent().unwrap_or(Path::new(""));
    Some(match (keys.as_slice(), is_key) {
        (
            ["roots", "args" | "exclude"] | ["roots", "presets", _] | ["roots", "expect", "when"],
            true,
        ) => (
            ConfigChoiceKind::Argument,
            arguments_of(host.session(), &robots(host, folder, place)),
        ),
        (
            ["roots", "args" | "exclude", name]
            | ["roots", "presets", _, name]
            | ["roots", "expect", "when", name],
            false,
        ) => (
            ConfigChoiceKind::Value,
            values_of(host.session(), &robots(host, folder, place), name),
        ),
        (["roots", "expect", "root" | "links" | "no-links" | "chains"], false)
        | (["roots", "expect", "joint", _, "parent" | "child"], false) => (
            ConfigChoiceKind::Link,
            part_names(host, &robots(host, folder, place), true, cancel)?,
        ),
        (
            [
                "roots",
                "expect",
                "joint" | "command-interfaces" | "state-interfaces",
            ],
            true,
        )
        | (["roots", "expect", "joints" | "no-joints"], false)
        | (["roots", "expect", "joint", _, "mimic"], false) => (
            ConfigChoiceKind::Joint,
            part_names(host, &robots(host, folder, place), false, cancel)?,
        ),
        (["severity"], true)
        | (["select" | "extend-select" | "ignore"] | ["per-file-ignores", _], false) => {
            let rules = rules::all().map(|rule| (rule.name.to_owned(), rule.code.to_owned()));
            (ConfigChoiceKind::Rule, rules.collect())
        }
        (["thresholds"], true) => (
            ConfigChoiceKind::Key,
            plain(THRESHOLDS.iter().map(|threshold| threshold.name.to_owned())),
        ),
        (["roots", "file"] | ["extend"] | ["roots", "expect", "expands-to"], false) => (
            ConfigChoiceKind::File,
            files_at(host.session(), path, folder, place, keys.last().copied()),
        ),
        _ => return None,
    })
}

/// The arguments of robots.
fn arguments_of(session: &Session, robots: &[PathBuf]) -> DescribedNames {
    let mut found = DescribedNames::new();
    for (name, default) in robots
        .iter()
        .flat_map(|robot| KnownArguments::of(session, robot).defaults())
    {
        if !name.contains('$') && !found.iter().any(|(known, _)| *known == name) {
            let detail = default.map(|default| format!("default: `{default}`"));
            found.push((name, detail.unwrap_or_default()));
        }
    }
    found
}

/// Values of an argument: what conditions of robots compare it with, its default, and what launch files give.
fn values_of(session: &Session, robots: &[PathBuf], name: &str) -> DescribedNames {
    let mut found = DescribedNames::new();
    for robot in robots {
        let known = KnownArguments::of(session, robot);
        let declared = known.defaults().into_iter().filter(|(own, _)| own == name);
        for default in declared.filter_map(|(_, default)| default) {
            let is_bool = ["true", "false"]
                .iter()
                .any(|word| default.eq_ignore_ascii_case(word));
            add_value(&mut found, default, "default");
            if is_bool {
                ["true", "false"]
                    .iter()
                    .for_each(|word| add_value(&mut found, (*word).to_owned(), ""));
            }
        }
        for call in session
            .robot_calls(robot)
            .iter()
            .filter(|call| call.target.as_ref() == Some(robot))
        {
            let given = call
                .call
                .args
                .iter()
                .filter(|argument| argument.name == name);
            let file = call
                .call
                .caller
                .file_name()
                .unwrap_or_default()
                .to_string_lossy();
            given
                .filter_map(|argument| argument.value.literal())
                .for_each(|value| add_value(&mut found, value, &file));
        }
        let choices = session
            .callers
            .choices(robot)
            .into_iter()
            .filter(|(own, _)| own == name);
        choices
            .flat_map(|(_, values)| values)
            .for_each(|value| add_value(&mut found, value, "choice of a launch file"));
        compared_words(&known, name)
            .into_iter()
            .for_each(|value| add_value(&mut found, value, "in a condition"));
    }
    found
}

/// The links or joints of robots with their defaults.
fn part_names(
    host: &mut AnalysisHost,
    robots: &[PathBuf],
    links: bool,
    cancel: &CancelFlag,
) -> Option<DescribedNames> {
    let mut names: BTreeSet<String> = BTreeSet::new();
    for robot in robots {
        let analyzed = host.analyzed(&RootConfig::plain(robot), cancel)?;
        let Some(robot) = &analyzed.robot else {
            continue;
        };
        if links {
            names.extend(robot.links.iter().map(|link| link.shown().to_owned()));
        } else {
            names.extend(robot.joints.iter().map(|joint| joint.shown().to_owned()));
        }
    }
    Some(plain(names))
}

/// Files and folders that a path at a place may go on with.
fn files_at(
    session: &Session,
    config: &Path,
    folder: &Path,
    place: &ConfigCursor,
    key: Option<&str>,
) -> DescribedNames {
    let vfs = &session.vfs;
    let text = vfs.text(config);
    let typed = text
        .as_ref()
        .map_or("", |file| place.range.slice(&file.text));
    let lead = typed
        .rfind('/')
        .map_or("", |at| typed.get(..=at).unwrap_or(""));
    let entries = vfs.list_dir(&folder.join(lead));
    let shown = entries.iter().filter(|entry| {
        !entry.name.starts_with('.') && (entry.is_dir || fits(&entry.name, key, config, lead))
    });
    let names = shown.map(|entry| {
        format!(
            "{lead}{}{}",
            entry.name,
            if entry.is_dir { "/" } else { "" }
        )
    });
    plain(names.take(MOST_FILES))
}

/// The robots of the entry of `roots` around a place.
fn robots(host: &AnalysisHost, folder: &Path, place: &ConfigCursor) -> Vec<PathBuf> {
    let file = place.file.as_deref();
    let mut robots = file
        .map(|file| files_named(file, folder, &host.session().vfs))
        .unwrap_or_default();
    robots.truncate(MOST_ROBOTS);
    robots
}

/// Robots that are read for one answer.
const MOST_ROBOTS: usize = 20;

fn plain(names: impl IntoIterator<Item = String>) -> DescribedNames {
    names
        .into_iter()
        .map(|name| (name, String::new()))
        .collect()
}

/// The text of a choice: with quotes where it needs them and none are open, and with `=` behind a key.
fn written(place: &ConfigCursor, kind: ConfigChoiceKind, name: &str, after: &str) -> String {
    let is_key = !matches!(place.kind, ConfigCursorKind::Value { .. });
    let is_plain = if is_key {
        !name.is_empty() && name.chars().all(config::is_bare)
    } else {
        matches!(name, "true" | "false")
    };
    let close = match place.quote {
        Some(quote) if !after.starts_with(quote) && kind != ConfigChoiceKind::Folder => {
            quote.to_string()
        }
        _ => String::new(),
    };
    let text = match place.quote {
        Some('\'') => name.to_owned() + &close,
        Some(_) => escaped(name) + &close,
        None if is_plain => name.to_owned(),
        None => format!("\"{}\"", escaped(name)),
    };
    let after = after
        .strip_prefix(['"', '\''])
        .unwrap_or(after)
        .trim_start_matches([' ', '\t']);
    let with_sign = place.kind == ConfigCursorKind::Key && !after.starts_with(['=', '.']);
    if with_sign && (place.quote.is_none() || !close.is_empty()) {
        text + " = "
    } else {
        text
    }
}

/// A text as it stands between double quotes.
fn escaped(text: &str) -> String {
    text.chars()
        .flat_map(|c| {
            if matches!(c, '"' | '\\') {
                vec!['\\', c]
            } else {
                vec![c]
            }
        })
        .collect()
}

/// Add a value that is written out, unless it is there.
fn add_value(values: &mut DescribedNames, value: String, detail: &str) {
    if !value.contains("$(")
        && !value.contains("${")
        && !values.iter().any(|(known, _)| *known == value)
    {
        values.push((value, detail.to_owned()));
    }
}

/// Whether a file below `lead` fits a key of a configuration, which does not extend itself.
fn fits(name: &str, key: Option<&str>, config: &Path, lead: &str) -> bool {
    match key {
        Some("file") => super::walk::is_description(Path::new(name)),
        Some("extend") => name.ends_with(".toml") && !(lead.is_empty() && config.ends_with(name)),
        _ => name.ends_with(".urdf"),
    }
}
