//! A suppression that hides nothing.
use super::super::finding::{Edit, Finding, Fix};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::directive::{Directive, Selector, Suppression};
use base::{FastSet, Span, TextRange};
use vfs::SourceFile;
use xml::Document;

pub(in super::super) static RULE: Rule = Rule {
    code: "LNT001",
    name: "unused-suppression",
    category: Category::Linter,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("unused-suppression"),
    check: Check::Analysis,
};

/// The finding about a suppression whose rules `unused` hide nothing. Only whoever has all findings knows, and whether
/// it is safe to remove it.
pub fn unused_suppression(
    source: &SourceFile,
    suppression: &Suppression,
    unused: &[&Selector],
    safety: Safety,
) -> Finding {
    let (file, document) = (source.id, &source.document);
    let names: Vec<String> = unused
        .iter()
        .map(|selector| format!("`{}`", selector.text))
        .collect();
    let names = names.join(", ");
    let message = match suppression.directive {
        Directive::Enable => format!("`enable` of {names} has no matching `disable`"),
        _ => format!("unused suppression of {names}"),
    };
    let starts: FastSet<u32> = unused.iter().map(|selector| selector.range.start).collect();
    let is_used = |selector: &&Selector| !starts.contains(&selector.range.start);
    let used: Vec<&Selector> = suppression.rules.iter().filter(is_used).collect();
    let (message_of_fix, range, content) = match (
        used.is_empty(),
        suppression.rules.first(),
        suppression.rules.last(),
    ) {
        (false, Some(first), Some(last)) => {
            let range = TextRange::new(first.range.start, last.range.end);
            let kept: Vec<&str> = used.iter().map(|selector| selector.text.as_str()).collect();
            (format!("remove {names}"), range, kept.join(", "))
        }
        _ => {
            let range = with_its_line(document, suppression.comment);
            ("remove the comment".to_owned(), range, String::new())
        }
    };
    let edit = Edit {
        span: Span { file, range },
        content,
    };
    let help = Some(format!("{message_of_fix}; it suppresses nothing"));
    let fix = Fix {
        safety,
        message: message_of_fix,
        edits: vec![edit],
    };
    let span = Span {
        file,
        range: suppression.comment,
    };
    Finding {
        fix: Some(fix),
        help,
        ..Finding::new(&RULE, span, message)
    }
}

/// A comment that has its lines for itself, with these lines.
fn with_its_line(document: &Document, comment: TextRange) -> TextRange {
    let (before, behind) = document.beside(comment, 1000);
    let blanks = [' ', '\t'];
    let indent = before.len() - before.trim_end_matches(blanks).len();
    let begins = before.trim_end_matches(blanks);
    let tail = behind.trim_start_matches(blanks);
    let line_end = if tail.starts_with("\r\n") {
        2
    } else {
        usize::from(tail.starts_with('\n'))
    };
    if line_end == 0 {
        return comment;
    }
    if !(comment.start == indent as u32 || begins.ends_with('\n')) {
        // behind something else: the blanks between go with it
        return TextRange::new(comment.start - indent as u32, comment.end);
    }
    let end = comment.end as usize + (behind.len() - tail.len()) + line_end;
    TextRange::new(comment.start - indent as u32, end as u32)
}
