//! Bytes that are no text in the declared encoding.

use super::super::context::FileCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use crate::base::TextRange;

pub(super) const RULE: Rule = Rule {
    code: "XML016",
    name: "xml-encoding-mismatch",
    category: Category::Xml,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page!("xml-encoding-mismatch"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    let Some((offset, message)) = &cx.source.encoding_error else { return };
    out.report_in(cx.file, TextRange::empty(*offset), message.clone())
        .help("save the file as UTF-8, or declare its encoding in the first line")
        .done();
}
