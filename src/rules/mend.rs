//! Fixes of what expansion reports, where more than the reported text is to be changed.

use std::path::Path;

use super::finding::{Edit, Fix};
use super::registry::Safety;
use base::{Span, TextRange};
use expand::Problem;
use expr::is_identifier;
use vfs::Vfs;
use workspace::nearest;
use xml::{Document, Node};

/// How to mend a problem in a file, if there is a way.
pub(super) fn fix(problem: &Problem, document: &Document, span: Span, vfs: &Vfs) -> Option<Fix> {
    match problem.code {
        "XML001" => blanks_in_front(document, span)
            .or_else(|| straight_quotes(document, span))
            .or_else(|| other_text(document, span)),
        "XML002" => declare_namespace(document, span),
        "XAC005" => add_parameters(problem, span),
        "XAC006" => remove_attribute(document, span, Safety::Unsafe),
        "XAC031" => remove_attribute(document, span, Safety::Safe),
        "XAC008" => other_file(problem, document, span, vfs),
        "XAC017" => call_instead(problem, document, span),
        "XAC022" => identifier(document, span),
        "XAC033" => remove_children(document, span),
        _ => None,
    }
}

/// The XML declaration must be the first thing in a file.
fn blanks_in_front(document: &Document, span: Span) -> Option<Fix> {
    let text = document.text();
    let blank = text.len() - text.trim_start().len();
    let declared = text.trim_start().starts_with("<?xml");
    let only_this = document.errors().len() == 1 && span.range.start as usize == blank;
    let range = TextRange::new(0, blank as u32);
    (declared && blank > 0 && only_this).then(|| Fix {
        safety: Safety::Safe,
        message: "remove everything before the XML declaration".to_owned(),
        edits: vec![Edit { span: Span { range, ..span }, content: String::new() }],
    })
}

/// Quotes of a word processor in a tag, if there is less to complain about with plain ones.
fn straight_quotes(document: &Document, span: Span) -> Option<Fix> {
    let text = document.text();
    let rest = text.get(span.range.start as usize..)?;
    let tag = rest.get(..rest.find('>')?)?;
    let new = tag.replace(['“', '”', '„', '‟', '″'], "\"");
    let whole = format!("{}{new}{}", text.get(..span.range.start as usize)?, rest.get(tag.len()..)?);
    let mends = new != tag && Document::parse(&whole).errors().len() < document.errors().len();
    let range = TextRange::new(span.range.start, span.range.start + tag.len() as u32);
    mends.then(|| Fix {
        safety: Safety::Safe,
        message: "replace with plain quotes".to_owned(),
        edits: vec![Edit { span: Span { range, ..span }, content: new }],
    })
}

/// `&&` in an expression, and an end tag too many.
fn other_text(document: &Document, span: Span) -> Option<Fix> {
    let text = document.text();
    let (start, end) = (span.range.start as usize, span.range.end as usize);
    let (end, content, message) = match text.get(start..end)? {
        "&" if text.get(start..)?.starts_with("&&") => (start + 2, "and", "replace `&&` with `and`"),
        extra if extra.starts_with("</") && extra.ends_with('>') => (end, "", "remove the end tag"),
        _ => return None,
    };
    let whole = format!("{}{content}{}", text.get(..start)?, text.get(end..)?);
    let left = Document::parse(&whole).errors().len();
    // an end tag is one too many when all is well without it: else it may belong to an element that is misspelled
    let mends = if content.is_empty() { left == 0 } else { left < document.errors().len() };
    let range = TextRange::new(span.range.start, end as u32);
    mends.then(|| Fix {
        safety: Safety::Safe,
        message: message.to_owned(),
        edits: vec![Edit { span: Span { range, ..span }, content: content.to_owned() }],
    })
}

fn declare_namespace(document: &Document, span: Span) -> Option<Fix> {
    let root = document.root().filter(|root| root.attr("xmlns:xacro").is_none())?;
    let range = TextRange::empty(root.name_range().end);
    Some(Fix {
        safety: Safety::Safe,
        message: "declare the prefix `xacro`".to_owned(),
        edits: vec![Edit {
            span: Span { range, ..span },
            content: " xmlns:xacro=\"http://www.ros.org/wiki/xacro\"".to_owned(),
        }],
    })
}

/// Missing parameters, where an empty text is a value that makes sense: only a person knows the values of others. The
/// detail of the problem is the attributes to add.
fn add_parameters(problem: &Problem, span: Span) -> Option<Fix> {
    let attributes = problem.detail.as_deref()?.replace("\"...\"", "\"\"");
    let may_be_empty = |attribute: &str| {
        let name = attribute.split('=').next().unwrap_or_default();
        name == "ns" || ["prefix", "suffix", "namespace"].iter().any(|word| name.contains(word))
    };
    if !attributes.split_whitespace().all(may_be_empty) {
        return None;
    }
    let range = TextRange::empty(span.range.end);
    Some(Fix {
        safety: Safety::Unsafe,
        message: "add the missing parameters with empty values".to_owned(),
        edits: vec![Edit { span: Span { range, ..span }, content: format!(" {attributes}") }],
    })
}

/// Without the attribute whose name stands at the span, and the blanks in front of it.
fn remove_attribute(document: &Document, span: Span, safety: Safety) -> Option<Fix> {
    let place = document.item_at(span.range.start);
    let mut attrs = place.item.all_nodes().flat_map(|node| node.attrs());
    let attr = attrs.find(|attr| attr.name_range().shift(place.start) == span.range)?;
    let whole = attr.range().shift(place.start);
    let before = document.slice(TextRange::new(place.start, whole.start));
    let blanks = (before.len() - before.trim_end().len()) as u32;
    let range = TextRange::new(whole.start - blanks, whole.end);
    Some(Fix {
        safety,
        message: format!("remove `{}`", attr.name()),
        edits: vec![Edit { span: Span { range, ..span }, content: String::new() }],
    })
}

/// The detail of the problem is the path; a file in the same folder may have almost its name.
fn other_file(problem: &Problem, document: &Document, span: Span, vfs: &Vfs) -> Option<Fix> {
    let path = Path::new(problem.detail.as_deref()?);
    let old = path.file_name()?.to_str()?;
    let written = document.slice(span.range);
    let names = vfs.list_dir(path.parent()?);
    let files = names.iter().filter(|entry| !entry.is_dir);
    let new = nearest(old, files.map(|file| file.name.as_str()))?;
    let start = span.range.end - written.strip_suffix(old).map(|_| old.len() as u32)?;
    Some(Fix {
        safety: Safety::Unsafe,
        message: format!("include `{new}`"),
        edits: vec![Edit {
            span: Span { range: TextRange::new(start, span.range.end), ..span },
            content: new.to_owned(),
        }],
    })
}

/// The nearest name that is an identifier.
fn identifier(document: &Document, span: Span) -> Option<Fix> {
    let old = document.slice(span.range);
    let admitted = |c: char| if c.is_alphanumeric() { c } else { '_' };
    let mut new: String = old.trim().chars().map(admitted).collect();
    if new.starts_with("__") || new.is_empty() {
        new = new.trim_start_matches('_').to_owned();
    } else if new.starts_with(|c: char| c.is_numeric()) {
        new.insert(0, '_');
    } else if !is_identifier(&new) {
        new.push('_');
    }
    let mended = is_identifier(&new) && !old.contains('$');
    mended.then(|| Fix {
        safety: Safety::Unsafe,
        message: format!("rename to `{new}`"),
        edits: vec![Edit { span, content: new }],
    })
}

/// Leave the tag of the include alone.
fn remove_children(document: &Document, span: Span) -> Option<Fix> {
    let place = document.item_at(span.range.start);
    let at = |node: &Node<'_>| node.name_range().shift(place.start).end == span.range.end;
    let include = place.item.all_nodes().find(at)?.parent()?;
    let (start, end) = (include.start_tag_range(), include.end_tag()?);
    let range = TextRange::new(start.end, end.start).shift(place.start);
    Some(Fix {
        safety: Safety::Safe,
        message: "remove the content of the include".to_owned(),
        edits: vec![Edit { span: Span { range, ..span }, content: String::new() }],
    })
}

/// The detail of the problem is the macro that was meant to be called: its name goes into the tags.
fn call_instead(problem: &Problem, document: &Document, span: Span) -> Option<Fix> {
    let call = format!("xacro:{}", problem.detail.as_deref()?);
    let place = document.item_at(span.range.start);
    let at = |node: &Node<'_>| node.start_tag_range().shift(place.start).start == span.range.start;
    let node = place.item.all_nodes().find(at)?;
    let name = node.attrs().next().filter(|attr| attr.name() == "name")?;
    let tag = TextRange::new(node.name_range().start, name.range().end).shift(place.start);
    let end = node.end_name_range()?.shift(place.start);
    let edit = |range| Edit { span: Span { range, ..span }, content: call.clone() };
    Some(Fix {
        safety: Safety::Unsafe,
        message: format!("call macro `{}`", call.trim_start_matches("xacro:")),
        edits: vec![edit(tag), edit(end)],
    })
}
