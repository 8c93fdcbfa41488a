//! Values that launch files give to arguments and that nothing is made for, and arguments that they never give.
use std::path::{Path, PathBuf};

use ecow::EcoString;

use super::argument_places::argument_place;
use super::declared::KnownArguments;
use super::session::Session;
use base::{FastMap, FastSet, Span, TextRange};
use facts::{FactKind, MentionKind, facts_of};
use packages::nearest;
use rules::{Finding, argument_never_set, value_never_compared, value_outside_choices};
use workspace::RobotCall;
use workspace::config::Root;

/// Words that say that there is none of something: no condition need compare with them.
const NEUTRAL: [&str; 12] = [
    "", "0", "1", "default", "disabled", "false", "no", "none", "null", "off", "true", "yes",
];

/// What the conditions of a robot compare an argument with.
#[derive(Default)]
struct ComparedWords {
    words: Vec<String>,
    /// How many of its mentions are comparisons.
    comparisons: usize,
}

/// Values that some launch files below a folder give and that choices rule out.
pub(super) fn outside_choices(
    session: &Session,
    folder: &Path,
    is_meant: impl Fn(&PathBuf) -> bool,
) -> Vec<Finding> {
    let excluded = session.callers.excluded_values(folder);
    let checked = excluded.iter().filter(|found| is_meant(&found.giver));
    let checked = checked.filter(|found| !session.settings(&found.giver).excludes(&found.giver));
    let finding = checked.map(|found| {
        let text = session.vfs.text(&found.giver);
        let text = text.as_ref().map_or("", |file| &*file.text);
        let range = quoted(text, found.range, &found.name, &found.value).unwrap_or(found.range);
        let span = Span {
            file: session.vfs.file_id(&found.giver),
            range,
        };
        let near = nearest(&found.value, found.choices.iter().map(String::as_str));
        value_outside_choices(span, &found.name, &found.value, &found.choices, near)
    });
    finding.collect()
}

/// What the calls of a robot give to arguments that it only compares with other values, and the arguments that no call gives.
pub(super) fn value_findings(
    session: &Session,
    robot: &Path,
    known: &KnownArguments,
    calls: &[&RobotCall],
) -> Vec<Finding> {
    if !known.complete {
        return Vec::new();
    }
    let mut found = never_compared(session, robot, known, calls);
    found.extend(never_set(session, robot, known));
    found
}

fn never_compared(
    session: &Session,
    robot: &Path,
    known: &KnownArguments,
    calls: &[&RobotCall],
) -> Vec<Finding> {
    let compared = comparisons(known);
    let mut found = Vec::new();
    for call in calls {
        for argument in &call.call.args {
            let Some(compared) = compared.get(argument.name.as_str()) else {
                continue;
            };
            let Some(value) = argument.value.literal() else {
                continue;
            };
            if is_expected(&value, compared) {
                continue;
            }
            let span = argument_place(&session.vfs, &call.call, argument);
            let near = nearest(&value, compared.words.iter().map(String::as_str));
            let what = (argument.name.as_str(), value.as_str());
            found.push(value_never_compared(
                span,
                what,
                robot,
                &compared.words,
                near,
            ));
        }
    }
    let mut seen = FastSet::default();
    found.retain(|finding| seen.insert((finding.span, finding.message.clone())));
    found
}

fn never_set(session: &Session, robot: &Path, known: &KnownArguments) -> Vec<Finding> {
    // calls in launch files that are not checked give arguments too
    let mut all = session.robot_calls(robot);
    all.retain(|call| call.target.as_deref() == Some(robot));
    if all.iter().any(|call| call.call.open) {
        return Vec::new();
    }
    let given = all
        .iter()
        .flat_map(|call| &call.call.args)
        .map(|argument| argument.name.as_str());
    let mut given: FastSet<&str> = given.collect();
    let settings = session.settings(robot);
    let is_of = |root: &&Root| root.files(&session.vfs).iter().any(|file| file == robot);
    let configured = settings
        .config
        .roots
        .iter()
        .filter(is_of)
        .flat_map(|root| &root.given);
    given.extend(configured.map(|(name, _)| name.as_str()));
    let mut places: FastSet<(PathBuf, TextRange)> = FastSet::default();
    for call in &all {
        places.insert((call.call.caller.clone(), call.call.range));
    }
    let mut found = Vec::new();
    for file in known.files.iter().filter(|file| *file.path == *robot) {
        for (start, item) in file.document.parts() {
            let facts = facts_of(item);
            let declared = facts
                .named
                .iter()
                .filter(|fact| fact.kind == FactKind::Argument);
            for fact in declared.filter(|fact| !given.contains(fact.name.as_str())) {
                let span = Span {
                    file: file.id,
                    range: fact.range.shift(start),
                };
                found.push(argument_never_set(span, &fact.name, places.len()));
            }
        }
    }
    found
}

/// Whether a robot that compares an argument with some words is made for another value.
fn is_expected(value: &str, compared: &ComparedWords) -> bool {
    let other_case = |word: &String| word.eq_ignore_ascii_case(value);
    compared.words.iter().any(|word| word == value)
        || NEUTRAL.contains(&value.to_ascii_lowercase().as_str())
            && !compared.words.iter().any(other_case)
}

/// The arguments that a robot does nothing with but compare them with words, and these words. The default of an
/// argument counts as one.
fn comparisons(known: &KnownArguments) -> FastMap<EcoString, ComparedWords> {
    let mut found = all_comparisons(known);
    let mut mentions: FastMap<EcoString, usize> = FastMap::default();
    for (_, item) in known.files.iter().flat_map(|file| file.document.parts()) {
        let facts = facts_of(item);
        for mention in facts
            .mentions()
            .filter(|mention| mention.kind == MentionKind::Argument)
        {
            *mentions.entry(mention.name.clone()).or_default() += 1;
        }
    }
    found.retain(|name, compared| mentions.get(name) == Some(&compared.comparisons));
    for (name, default) in known.defaults() {
        let default = default.unwrap_or_default();
        if let Some(compared) = found.get_mut(name.as_str())
            && !compared.words.contains(&default)
        {
            compared.words.push(default);
        }
    }
    found
}

/// The words that a robot compares an argument with, whatever else it does with it.
pub(super) fn compared_words(known: &KnownArguments, name: &str) -> Vec<String> {
    all_comparisons(known)
        .remove(name)
        .map(|compared| compared.words)
        .unwrap_or_default()
}

/// The comparisons of all arguments.
fn all_comparisons(known: &KnownArguments) -> FastMap<EcoString, ComparedWords> {
    let mut found: FastMap<EcoString, ComparedWords> = FastMap::default();
    for file in &known.files {
        for node in file.document.parts().flat_map(|(_, item)| item.all_nodes()) {
            for attr in node.attrs().filter(|attr| attr.raw().contains("$(arg ")) {
                compare(&attr.value(file.document.entities()), &mut found);
            }
        }
    }
    found
}

/// Add what an expression compares arguments with: `'$(arg name)' == 'word'`, and the same with `!=`, `in` and turned around.
fn compare(text: &str, found: &mut FastMap<EcoString, ComparedWords>) {
    for (at, start) in text.match_indices("$(arg ") {
        let words = || {
            let before = text.get(..at)?;
            let quote = before
                .chars()
                .next_back()
                .filter(|c| matches!(c, '\'' | '"'))?;
            let (name, after) = text.get(at + start.len()..)?.split_once(')')?;
            let before = before.strip_suffix(quote)?.trim_end();
            let after = after.strip_prefix(quote)?.trim_start();
            let words = words_behind(before, after).or_else(|| words_before(before, after))?;
            Some((name.trim(), words))
        };
        if let Some((name, words)) = words() {
            let compared = found.entry(name.into()).or_default();
            compared.comparisons += 1;
            let is_new = |word: &String| !word.contains(['$', '\\']);
            compared.words.extend(words.into_iter().filter(is_new));
            compared.words.sort();
            compared.words.dedup();
        }
    }
}

fn words_behind(before: &str, after: &str) -> Option<Vec<String>> {
    if !begins(before) {
        return None;
    }
    if let Some(rest) = after
        .strip_prefix("==")
        .or_else(|| after.strip_prefix("!="))
    {
        let (word, rest) = literal(rest.trim_start())?;
        return ends(rest).then(|| vec![word]);
    }
    let rest = after
        .strip_prefix("not")
        .map_or(after, str::trim_start)
        .strip_prefix("in")?
        .trim_start();
    let close = match rest.chars().next()? {
        '[' => ']',
        '(' => ')',
        _ => return None,
    };
    let (mut rest, mut words) = (rest.get(1..)?.trim_start(), Vec::new());
    while let Some((word, next)) = literal(rest) {
        words.push(word);
        let next = next.trim_start();
        rest = next.strip_prefix(',').unwrap_or(next).trim_start();
    }
    ends(rest.strip_prefix(close)?).then_some(words)
}

fn words_before(before: &str, after: &str) -> Option<Vec<String>> {
    let rest = before
        .strip_suffix("==")
        .or_else(|| before.strip_suffix("!="))?
        .trim_end();
    let quote = rest
        .chars()
        .next_back()
        .filter(|c| matches!(c, '\'' | '"'))?;
    let (before, word) = rest.strip_suffix(quote)?.rsplit_once(quote)?;
    (begins(before.trim_end()) && ends(after)).then(|| vec![word.to_owned()])
}

/// A word in quotes at the start of a text, and what is behind it.
fn literal(text: &str) -> Option<(String, &str)> {
    let quote = text.chars().next().filter(|c| matches!(c, '\'' | '"'))?;
    let (word, rest) = text.get(1..)?.split_once(quote)?;
    Some((word.to_owned(), rest))
}

/// Whether a comparison may begin behind a text.
fn begins(before: &str) -> bool {
    let words = ["{", "(", " and", " or", " not", "{not", "(not", " if"];
    words.iter().any(|word| before.ends_with(word))
}

/// Whether a comparison may end in front of a text.
fn ends(after: &str) -> bool {
    let words = ["}", ")", "and ", "or ", "else "];
    words
        .iter()
        .any(|word| after.trim_start().starts_with(word))
}

/// Where a text in a range is written in quotes: the last one behind the name of the argument.
fn quoted(text: &str, range: TextRange, name: &str, value: &str) -> Option<TextRange> {
    let code = range.slice(text);
    let after = ['\'', '"'].iter().find_map(|&quote| {
        let form = format!("{quote}{name}{quote}");
        Some(code.find(&form)? + form.len())
    })?;
    ['\'', '"'].iter().find_map(|&quote| {
        let form = format!("{quote}{value}{quote}");
        let at = range.start + (after + code.get(after..)?.find(&form)?) as u32;
        Some(TextRange::new(at, at + form.len() as u32))
    })
}
