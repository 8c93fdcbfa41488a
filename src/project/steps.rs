//! Which keys and lists of YAML are around an offset, read line by line: the text may be broken.

/// A step from the root of a document to a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum PathStep {
    /// The value of a key.
    Key(String),
    /// An item of a list.
    Item,
}

impl PathStep {
    pub fn key(&self) -> Option<&str> {
        match self {
            PathStep::Key(key) => Some(key),
            PathStep::Item => None,
        }
    }
}

/// What is around an offset.
#[derive(Debug)]
pub(super) struct YamlContext {
    /// The steps to what is typed; of a key, to the mapping that it is in.
    pub steps: Vec<PathStep>,
    /// Whether a key is typed.
    pub is_key: bool,
    /// Where what is typed begins, behind a quote.
    pub start: usize,
    /// The other items of the list, or keys of the mapping.
    pub taken: Vec<String>,
}

/// A step, and the column of what says it.
struct IndentedStep {
    indent: usize,
    step: PathStep,
}

/// What is around an offset; none inside of comments.
pub(super) fn around(text: &str, offset: usize) -> Option<YamlContext> {
    let before = text.get(..offset)?;
    let line_start = before.rfind('\n').map_or(0, |at| at + 1);
    let mut levels: Vec<IndentedStep> = Vec::new();
    let mut start = 0;
    while start < line_start {
        let end = before
            .get(start..)?
            .find('\n')
            .map_or(offset, |at| start + at + 1);
        let line = without_comment(before.get(start..end)?);
        if line.trim().is_empty() {
            start = end;
            continue;
        }
        if line.starts_with("---") {
            levels.clear();
        }
        let (content, column) = enter(&mut levels, line);
        let value = match split_key(content) {
            Some((key, value)) => {
                levels.push(IndentedStep {
                    indent: column,
                    step: PathStep::Key(key),
                });
                value
            }
            None => content,
        };
        let begin = start + line.trim_end().len() - value.trim_end().len();
        start = match value.starts_with(['[', '{']).then(|| flow_end(text, begin)) {
            Some(Some(close)) if close <= offset => before
                .get(close..)?
                .find('\n')
                .map_or(offset, |at| close + at + 1),
            Some(_) => return in_flow(text, begin, offset, levels),
            None => end,
        };
    }
    if start > line_start {
        return None;
    }
    in_line(text, line_start, offset, levels)
}

/// What is around an offset in the line that begins at `line_start`.
fn in_line(
    text: &str,
    line_start: usize,
    offset: usize,
    mut levels: Vec<IndentedStep>,
) -> Option<YamlContext> {
    let head = text.get(line_start..offset)?;
    if without_comment(head).len() < head.len() {
        return None;
    }
    let (content, indent) = enter(&mut levels, head);
    let is_item = matches!(levels.last(), Some(IndentedStep { step: PathStep::Item, indent: own }) if *own < indent);
    let begin = offset - content.len();
    if let Some((key, value)) = split_key(content) {
        levels.push(IndentedStep {
            indent,
            step: PathStep::Key(key),
        });
        let begin = offset - value.len();
        if value.starts_with(['[', '{']) {
            return in_flow(text, begin, offset, levels);
        }
        return Some(YamlContext {
            steps: steps(levels),
            is_key: false,
            start: unquoted(value, begin),
            taken: Vec::new(),
        });
    }
    if content.starts_with(['[', '{']) {
        return in_flow(text, begin, offset, levels);
    }
    let taken = siblings(
        text,
        line_start,
        offset,
        is_item,
        if is_item {
            levels.last()?.indent
        } else {
            indent
        },
    );
    Some(YamlContext {
        steps: steps(levels),
        is_key: !is_item,
        start: unquoted(content, begin),
        taken,
    })
}

/// Leave the levels that a line ends, and add those of the lists that it begins items of; the rest of the line with its column.
fn enter<'t>(levels: &mut Vec<IndentedStep>, line: &'t str) -> (&'t str, usize) {
    let mut content = line.trim_start_matches(' ');
    let mut indent = line.len() - content.len();
    content = content.trim_end_matches(['\n', '\r']);
    loop {
        let is_item = content == "-" || content.starts_with("- ");
        // a list may stand at the column of its key
        let ends = |level: &IndentedStep| {
            level.indent > indent
                || level.indent == indent && !(is_item && level.step != PathStep::Item)
        };
        while levels.last().is_some_and(ends) {
            levels.pop();
        }
        if !is_item {
            return (content, indent);
        }
        levels.push(IndentedStep {
            indent,
            step: PathStep::Item,
        });
        let inner = content.get(1..).unwrap_or("").trim_start_matches(' ');
        indent += content.len() - inner.len();
        content = inner;
    }
}

/// A key and what stands behind its colon.
fn split_key(content: &str) -> Option<(String, &str)> {
    let quote = content.chars().next().filter(|c| ['"', '\''].contains(c));
    let from = match quote {
        Some(quote) => content.get(1..)?.find(quote)? + 2,
        None if content.starts_with(['[', '{']) => return None,
        None => 0,
    };
    let is_end = |at: &usize| {
        content
            .get(at + 1..)
            .is_some_and(|rest| rest.is_empty() || rest.starts_with(' '))
    };
    let colon = content
        .match_indices(':')
        .map(|(at, _)| at)
        .filter(|at| *at >= from)
        .find(is_end)?;
    let key = content
        .get(..colon)?
        .trim()
        .trim_matches(['"', '\''])
        .to_owned();
    Some((key, content.get(colon + 1..)?.trim_start_matches(' ')))
}

/// The text of a line without its comment.
fn without_comment(line: &str) -> &str {
    let mut quote = None;
    let mut before = ' ';
    for (at, c) in line.char_indices() {
        match (quote, c) {
            (None, '#') if before.is_whitespace() => return line.get(..at).unwrap_or(line),
            (None, '"' | '\'') if !before.is_alphanumeric() => quote = Some(c),
            (Some(open), _) if open == c => quote = None,
            _ => {}
        }
        before = c;
    }
    line
}

/// Behind the bracket that closes the one at `begin`.
fn flow_end(text: &str, begin: usize) -> Option<usize> {
    let mut depth = 0usize;
    for (at, c) in outside_comments(text, begin, text.len()) {
        match c {
            '[' | '{' => depth += 1,
            ']' | '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return Some(at + 1);
        }
    }
    None
}

/// The characters of a part of a text with their places, without comments.
fn outside_comments(
    text: &str,
    from: usize,
    to: usize,
) -> impl Iterator<Item = (usize, char)> + '_ {
    let mut before = ' ';
    let mut in_comment = false;
    let part = text.get(from..to).unwrap_or("");
    part.char_indices().filter_map(move |(at, c)| {
        in_comment = c != '\n' && (in_comment || c == '#' && before.is_whitespace());
        before = c;
        (!in_comment).then_some((from + at, c))
    })
}

/// What is around an offset between brackets that open at `begin`.
fn in_flow(
    text: &str,
    begin: usize,
    offset: usize,
    levels: Vec<IndentedStep>,
) -> Option<YamlContext> {
    // brackets with their key, and the words in them
    let mut open: Vec<(char, Option<String>, Vec<String>)> = Vec::new();
    let mut word = begin;
    for (at, c) in outside_comments(text, begin, offset) {
        match c {
            '[' | '{' => open.push((c, None, Vec::new())),
            ']' | '}' => drop(open.pop()),
            ',' => {
                let (_, key, words) = open.last_mut()?;
                words.extend(key.take().or_else(|| text.get(word..at).and_then(said)));
            }
            ':' if open.last().is_some_and(|(bracket, ..)| *bracket == '{') => {
                let key = text.get(word..at).and_then(said);
                open.last_mut()?.1 = key;
            }
            _ => continue,
        }
        word = at + 1;
    }
    let (bracket, key, mut taken) = open.pop()?;
    let mut steps = steps(levels);
    steps.extend(
        open.into_iter()
            .map(|(_, key, _)| key.map_or(PathStep::Item, PathStep::Key)),
    );
    let is_key = bracket == '{' && key.is_none();
    if !is_key {
        steps.push(key.map_or(PathStep::Item, PathStep::Key));
    }
    let rest = text.get(offset..)?;
    let rest = rest.get(..rest.find([']', '}', '\n']).unwrap_or(rest.len()))?;
    let others = rest
        .split(',')
        .skip(1)
        .map(|word| word.split(':').next().unwrap_or(word));
    taken.extend(others.map(|word| word.trim().trim_matches(['"', '\'']).to_owned()));
    let mut typed = text.get(word..offset)?.trim_start();
    while typed.starts_with('#') {
        typed = typed.split_once('\n')?.1.trim_start();
    }
    Some(YamlContext {
        steps,
        is_key,
        start: unquoted(typed, offset - typed.len()),
        taken,
    })
}

/// A word without its quotes; none when nothing is left.
fn said(text: &str) -> Option<String> {
    let word = text.trim().trim_matches(['"', '\'']);
    (!word.is_empty()).then(|| word.to_owned())
}

fn steps(levels: Vec<IndentedStep>) -> Vec<PathStep> {
    levels.into_iter().map(|level| level.step).collect()
}

/// Where a word begins that may be quoted.
fn unquoted(word: &str, begin: usize) -> usize {
    begin + usize::from(word.starts_with(['"', '\'']))
}

/// The other items of a list whose dashes are at a column, or the other keys of a mapping.
fn siblings(
    text: &str,
    line_start: usize,
    offset: usize,
    is_item: bool,
    indent: usize,
) -> Vec<String> {
    let said = |line: &str| -> Option<Option<String>> {
        let line = without_comment(line).trim_end();
        let content = line.trim_start_matches(' ');
        let own = line.len() - content.len();
        if content.is_empty() || own > indent {
            return Some(None);
        }
        let is_other = own < indent || content.starts_with('-') != is_item;
        if is_other {
            return None;
        }
        let content = content.trim_start_matches('-').trim_start();
        let word = if is_item {
            content.to_owned()
        } else {
            split_key(content)?.0
        };
        Some(Some(word.trim_matches(['"', '\'']).to_owned()))
    };
    let above = text
        .get(..line_start)
        .unwrap_or("")
        .lines()
        .rev()
        .map_while(said);
    let below = text
        .get(offset..)
        .unwrap_or("")
        .lines()
        .skip(1)
        .map_while(said);
    above
        .chain(below)
        .flatten()
        .filter(|word| !word.is_empty())
        .collect()
}
