//! Which fixes can be made together, and texts with edits made.
use std::collections::BTreeMap;

use base::{FileId, TextRange};
use rules::{Edit, Finding};

/// Edits that can be made together.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// By file: replacements in order, which neither overlap nor touch.
    pub edits: BTreeMap<FileId, Vec<(TextRange, String)>>,
    /// Numbers of the findings that they settle.
    pub settles: Vec<usize>,
}

/// The fixes that can be made together: each with all its edits or not at all, the first of those that get
/// in each other's way. The same edit wanted by several findings is made once. Findings come with their numbers.
pub fn choose<'f>(findings: impl IntoIterator<Item = (usize, &'f Finding)>) -> Plan {
    let mut plan = Plan::default();
    for (number, finding) in findings {
        let Some(fix) = finding.fix.as_ref().filter(|fix| !fix.edits.is_empty()) else {
            continue;
        };
        let new: Vec<&Edit> = fix.edits.iter().filter(|edit| !plan.has(edit)).collect();
        let among = new
            .iter()
            .enumerate()
            .any(|(i, edit)| new.iter().skip(i + 1).any(|o| touch(edit, o)));
        if among || new.iter().any(|edit| plan.is_in_the_way(edit)) {
            continue;
        }
        for edit in new {
            let edits = plan.edits.entry(edit.span.file).or_default();
            let at = edits.partition_point(|(range, _)| range.start < edit.span.range.start);
            edits.insert(at, (edit.span.range, edit.content.clone()));
        }
        plan.settles.push(number);
    }
    plan
}

impl Plan {
    fn has(&self, edit: &Edit) -> bool {
        let edits = self.edits.get(&edit.span.file);
        edits.is_some_and(|edits| {
            edits
                .iter()
                .any(|(r, c)| *r == edit.span.range && *c == edit.content)
        })
    }

    fn is_in_the_way(&self, edit: &Edit) -> bool {
        let Some(edits) = self.edits.get(&edit.span.file) else {
            return false;
        };
        edits
            .iter()
            .any(|(range, _)| touches(*range, edit.span.range))
    }
}

fn touch(a: &Edit, b: &Edit) -> bool {
    a.span.file == b.span.file && touches(a.span.range, b.span.range)
}

/// Edits that touch wait for the next round, when what stands there is known.
fn touches(a: TextRange, b: TextRange) -> bool {
    a.start <= b.end && b.start <= a.end
}

/// A text with replacements made; they are in order and do not overlap. Everything else stays as it is.
pub fn apply(text: &str, edits: &[(TextRange, String)]) -> String {
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    for (range, content) in edits {
        out.push_str(TextRange::new(at, range.start).slice(text));
        out.push_str(content);
        at = range.end;
    }
    out.push_str(TextRange::new(at, text.len() as u32).slice(text));
    out
}

#[cfg(test)]
mod tests {
    use super::{apply, choose};
    use base::{FileId, Span, TextRange};
    use rules::{Edit, Finding, Fix, Safety, by_code};

    /// A finding whose fix makes these edits: file, start, end, new text.
    fn finding(edits: &[(u32, u32, u32, &str)]) -> Finding {
        let span = |file, start, end| Span {
            file: FileId(file),
            range: TextRange::new(start, end),
        };
        let edits = edits
            .iter()
            .map(|&(file, start, end, content)| Edit {
                span: span(file, start, end),
                content: content.into(),
            })
            .collect();
        let fix = Fix {
            safety: Safety::Safe,
            message: String::new(),
            edits,
        };
        Finding {
            fix: Some(fix),
            ..Finding::new(by_code("XML001").unwrap(), span(0, 0, 0), "")
        }
    }

    #[test]
    fn whole_fixes_that_do_not_touch() {
        for (fixes, settles, expected) in [
            (
                vec![vec![(0, 1, 2, "X")], vec![(0, 4, 4, "Y")]],
                vec![0, 1],
                "0X23Y456789",
            ),
            (
                vec![vec![(0, 4, 4, "Y")], vec![(0, 1, 2, "X")]],
                vec![0, 1],
                "0X23Y456789",
            ),
            // the same edit twice, and one beside it
            (
                vec![vec![(0, 1, 2, "X")], vec![(0, 1, 2, "X"), (0, 5, 6, "")]],
                vec![0, 1],
                "0X2346789",
            ),
            // overlapping, touching, inserted at one place
            (
                vec![vec![(0, 1, 4, "X")], vec![(0, 3, 5, "Y")]],
                vec![0],
                "0X456789",
            ),
            (
                vec![vec![(0, 1, 4, "X")], vec![(0, 4, 4, "Y")]],
                vec![0],
                "0X456789",
            ),
            (
                vec![vec![(0, 4, 4, "X")], vec![(0, 4, 4, "Y")]],
                vec![0],
                "0123X456789",
            ),
            // half of a fix is no fix
            (
                vec![vec![(0, 1, 4, "X")], vec![(0, 2, 3, "Y"), (0, 8, 9, "Z")]],
                vec![0],
                "0X456789",
            ),
            // a fix that gets into its own way
            (
                vec![vec![(0, 1, 4, "X"), (0, 2, 3, "Y")], vec![(0, 0, 1, "")]],
                vec![1],
                "123456789",
            ),
            // another file
            (
                vec![vec![(0, 1, 4, "X")], vec![(1, 2, 3, "Y")]],
                vec![0, 1],
                "0X456789",
            ),
        ] {
            let findings: Vec<Finding> = fixes.iter().map(|edits| finding(edits)).collect();
            let plan = choose(findings.iter().enumerate());
            assert_eq!(plan.settles, settles, "{fixes:?}");
            assert_eq!(
                apply("0123456789", &plan.edits[&FileId(0)]),
                expected,
                "{fixes:?}"
            );
        }
        assert!(choose([(0, &finding(&[]))]).settles.is_empty());
    }
}
