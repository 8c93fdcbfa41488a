//! Comments that hide a finding.

use super::place::{element_at, line_end, margin};
use super::{Action, edit, fix};
use base::TextRange;
use vfs::SourceFile;
use xml::NodeKind;

/// Hide a finding of a rule where it stands, or in the whole file.
pub(super) fn suppress(source: &SourceFile, rule: &str, range: TextRange) -> Vec<Action> {
    // only the name of a rule is written into the file
    let Some(rule) = rules::find(rule).find(|known| known.name == rule) else {
        return Vec::new();
    };
    here(source, rule.name, range)
        .into_iter()
        .chain([in_file(source, rule.name)])
        .collect()
}

/// A comment in front of the element whose start tag, or whose text, holds the finding.
fn here(source: &SourceFile, rule: &str, range: TextRange) -> Option<Action> {
    let document = &source.document;
    let (base, element) = element_at(document, range.start)?;
    let tag = element.start_tag_range().shift(base);
    if range.start >= tag.end && element.child_elements().next().is_some() {
        return None;
    }
    let (end, margin) = (line_end(document), margin(document, tag.start));
    let stands_alone = document
        .slice(TextRange::new(0, tag.start))
        .ends_with(&format!("\n{margin}"));
    let behind = if stands_alone || tag.start == 0 {
        format!("{end}{margin}")
    } else {
        " ".to_owned()
    };
    let comment = format!("<!-- xacro-lint: disable-next-line {rule} -->{behind}");
    let edits = vec![edit(source, TextRange::empty(tag.start), comment)];
    Some(fix(format!("disable `{rule}` for this line"), edits))
}

/// A comment at the top of the file.
fn in_file(source: &SourceFile, rule: &str) -> Action {
    let document = &source.document;
    let end = line_end(document);
    let mut nodes = document.header().nodes();
    let declaration = nodes.find(|node| node.kind() == NodeKind::Declaration);
    let comment = format!("<!-- xacro-lint: disable-file {rule} -->");
    let (at, text) = match declaration {
        Some(declaration) => (declaration.range().end, format!("{end}{comment}")),
        None => (0, format!("{comment}{end}")),
    };
    fix(
        format!("disable `{rule}` for this file"),
        vec![edit(source, TextRange::empty(at), text)],
    )
}

/// Switch a rule off in the text of a configuration file: the range that is replaced, and by what.
pub fn ignored_in_config(text: &str, rule: &str) -> Option<(TextRange, String)> {
    let rule = rules::find(rule).find(|known| known.name == rule)?.name;
    let mut offset = 0;
    for line in text.split_inclusive('\n') {
        let key = line
            .trim_start()
            .strip_prefix("ignore")
            .map(str::trim_start);
        if let Some(value) = key
            .and_then(|rest| rest.strip_prefix('='))
            .map(str::trim_start)
        {
            let list = value.strip_prefix('[')?;
            let at = TextRange::empty((offset + line.len() - list.len()) as u32);
            let comma = if list.trim_start().starts_with(']') {
                ""
            } else {
                ", "
            };
            return Some((at, format!("\"{rule}\"{comma}")));
        }
        if line.trim_start().starts_with('[') {
            break;
        }
        offset += line.len();
    }
    // keys of the file itself stand in front of all tables
    Some((TextRange::empty(0), format!("ignore = [\"{rule}\"]\n")))
}

/// Give a rule a severity in the text of a configuration file: the range that is replaced, and by what. All else of the
/// file stays as it is.
pub fn severity_in_config(text: &str, rule: &str, severity: &str) -> Option<(TextRange, String)> {
    let rule = rules::find(rule).find(|known| known.name == rule)?.name;
    let given = format!("{rule} = \"{severity}\"");
    let (mut offset, mut table, mut behind_header) = (0, "", None);
    for line in text.split_inclusive('\n') {
        let (at, bare) = (offset, line.trim());
        offset += line.len();
        if bare.starts_with('[') {
            table = bare;
            if is_header(bare) {
                behind_header = Some(offset);
            }
            continue;
        }
        let key = match bare.split_once('=') {
            Some((key, value)) if table.is_empty() && key.trim() == "severity" => {
                // a table within a line: in front of all that it holds
                let open = at + line.find('{')? + 1;
                let comma = if value.trim_start_matches([' ', '{']).starts_with('}') {
                    " "
                } else {
                    ","
                };
                return Some((TextRange::empty(open as u32), format!(" {given}{comma}")));
            }
            Some((key, _)) => key.trim(),
            None => continue,
        };
        let dotted = table
            .is_empty()
            .then(|| key.strip_prefix("severity."))
            .flatten();
        let own = dotted.or_else(|| is_header(table).then_some(key));
        if own.is_some_and(|key| key.trim_matches(['"', '\'']) == rule) {
            let value = at + line.find('=')? + 1;
            return Some((value_range(text, value)?, format!(" \"{severity}\"")));
        }
        if dotted.is_some() {
            return Some((TextRange::empty(at as u32), format!("severity.{given}\n")));
        }
    }
    let text_end = TextRange::empty(text.len() as u32);
    let line_end = if text.is_empty() || text.ends_with('\n') {
        ""
    } else {
        "\n"
    };
    match behind_header {
        Some(at) if text.get(..at)?.ends_with('\n') => {
            Some((TextRange::empty(at as u32), format!("{given}\n")))
        }
        Some(_) => Some((text_end, format!("\n{given}\n"))),
        None => {
            let space = if text.trim().is_empty() { "" } else { "\n" };
            Some((text_end, format!("{line_end}{space}[severity]\n{given}\n")))
        }
    }
}

/// Whether a line begins the table of severities.
fn is_header(line: &str) -> bool {
    let inner = line.strip_prefix('[').and_then(|rest| rest.split_once(']'));
    inner.is_some_and(|(name, _)| name.trim() == "severity")
}

/// The text in quotes behind an equals sign, with the space in front of it. This is the text of a configuration file, of which
/// there is no tree that knows its offsets.
fn value_range(text: &str, start: usize) -> Option<TextRange> {
    let rest = text.get(start..)?;
    let quote = rest.trim_start_matches([' ', '\t']).chars().next()?;
    let open = rest.find(quote).filter(|_| matches!(quote, '"' | '\''))?;
    let end = open + 1 + rest.get(open + 1..)?.find(quote)? + 1;
    Some(TextRange::new(start as u32, (start + end) as u32))
}

#[cfg(test)]
mod tests {
    use super::{ignored_in_config, severity_in_config};

    #[test]
    fn severities_are_set_where_severities_are() {
        for (text, expected) in [
            ("", "[severity]\norphan-link = \"off\"\n"),
            (
                "target = 'ros1' # ours",
                "target = 'ros1' # ours\n\n[severity]\norphan-link = \"off\"\n",
            ),
            (
                "[severity] # quiet\nzero-mass = \"info\"\n[format]\n",
                "[severity] # quiet\norphan-link = \"off\"\nzero-mass = \"info\"\n[format]\n",
            ),
            ("[severity]", "[severity]\norphan-link = \"off\"\n"),
            (
                "[severity]\n\"orphan-link\" = 'hint' # why\n",
                "[severity]\n\"orphan-link\" = \"off\" # why\n",
            ),
            (
                "severity = { zero-mass = \"info\" }\n",
                "severity = { orphan-link = \"off\", zero-mass = \"info\" }\n",
            ),
            ("severity = {}\n", "severity = { orphan-link = \"off\" }\n"),
            (
                "severity.zero-mass = \"info\"\n[format]\n",
                "severity.orphan-link = \"off\"\nseverity.zero-mass = \"info\"\n[format]\n",
            ),
        ] {
            let (range, new) = severity_in_config(text, "orphan-link", "off").unwrap();
            let mut changed = text.to_owned();
            changed.replace_range(range.start as usize..range.end as usize, &new);
            assert_eq!(changed, expected);
        }
        assert_eq!(severity_in_config("", "no-such-rule", "off"), None);
    }

    #[test]
    fn rules_are_ignored_in_the_list_that_is_there() {
        for (text, expected) in [
            ("", "ignore = [\"orphan-link\"]\n"),
            (
                "target = 'ros1'\nignore = []\n",
                "target = 'ros1'\nignore = [\"orphan-link\"]\n",
            ),
            (
                "ignore=[\n  'STY',\n]\n",
                "ignore=[\"orphan-link\", \n  'STY',\n]\n",
            ),
            (
                "[x]\nignore = [1]\n",
                "ignore = [\"orphan-link\"]\n[x]\nignore = [1]\n",
            ),
        ] {
            let (range, new) = ignored_in_config(text, "orphan-link").unwrap();
            let mut changed = text.to_owned();
            changed.replace_range(range.start as usize..range.end as usize, &new);
            assert_eq!(changed, expected);
        }
        assert_eq!(ignored_in_config("ignore = 7", "orphan-link"), None);
        assert_eq!(ignored_in_config("", "no-such-rule"), None);
    }
}
