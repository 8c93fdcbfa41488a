//! A file that is not well-formed.
use super::super::finding::{Edit, Fix};
use super::super::problem_cx::ProblemCx;
use super::super::rule::{Category, Rule, Safety, Severity, page};
use base::{Span, TextRange};
use xml::Document;

pub(in super::super) static RULE: Rule = Rule::found(
    "XML001",
    "xml-syntax-error",
    Category::Xml,
    Severity::Error,
    page("xml-syntax-error"),
)
.fixed(Safety::Safe);

/// What to do about the slips that many make.
pub(in super::super) fn fix(cx: &ProblemCx<'_>) -> Option<Fix> {
    let (document, span) = (cx.document, cx.span);
    text_before_declaration(document, span)
        .or_else(|| straight_quotes(document, span))
        .or_else(|| other_text(document, span))
}

/// The XML declaration must be the first thing in a file.
fn text_before_declaration(document: &Document, span: Span) -> Option<Fix> {
    let text = document.text();
    let blank = text.len() - text.trim_start().len();
    let declared = text.trim_start().starts_with("<?xml");
    let only_this = document.errors().len() == 1 && span.range.start as usize == blank;
    let range = TextRange::new(0, blank as u32);
    (declared && blank > 0 && only_this).then(|| Fix {
        safety: Safety::Safe,
        message: "remove everything before the XML declaration".to_owned(),
        edits: vec![Edit {
            span: Span { range, ..span },
            content: String::new(),
        }],
    })
}

/// Quotes of a word processor in a tag, if there is less to complain about with plain ones.
fn straight_quotes(document: &Document, span: Span) -> Option<Fix> {
    let text = document.text();
    let rest = text.get(span.range.start as usize..)?;
    let tag = rest.get(..rest.find('>')?)?;
    let new = tag.replace(['“', '”', '„', '‟', '″'], "\"");
    let whole = format!(
        "{}{new}{}",
        text.get(..span.range.start as usize)?,
        rest.get(tag.len()..)?
    );
    let helps = new != tag && Document::parse(&whole).errors().len() < document.errors().len();
    let range = TextRange::new(span.range.start, span.range.start + tag.len() as u32);
    helps.then(|| Fix {
        safety: Safety::Safe,
        message: "replace with plain quotes".to_owned(),
        edits: vec![Edit {
            span: Span { range, ..span },
            content: new,
        }],
    })
}

/// `&&` in an expression, and an end tag too many.
fn other_text(document: &Document, span: Span) -> Option<Fix> {
    let text = document.text();
    let (start, end) = (span.range.start as usize, span.range.end as usize);
    let (end, content, message) = match text.get(start..end)? {
        "&" if text.get(start..)?.starts_with("&&") => {
            (start + 2, "and", "replace `&&` with `and`")
        }
        extra if extra.starts_with("</") && extra.ends_with('>') => (end, "", "remove the end tag"),
        _ => return None,
    };
    let whole = format!("{}{content}{}", text.get(..start)?, text.get(end..)?);
    let left = Document::parse(&whole).errors().len();
    // an end tag is one too many when all is well without it: else it may belong to an element that is misspelled
    let helps = if content.is_empty() {
        left == 0
    } else {
        left < document.errors().len()
    };
    let range = TextRange::new(span.range.start, end as u32);
    helps.then(|| Fix {
        safety: Safety::Safe,
        message: message.to_owned(),
        edits: vec![Edit {
            span: Span { range, ..span },
            content: content.to_owned(),
        }],
    })
}
