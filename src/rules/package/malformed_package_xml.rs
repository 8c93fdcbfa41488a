//! A `package.xml` that is not well-formed.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::dependencies::packages_of;
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG008",
    name: "malformed-package-xml",
    category: Category::Package,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("malformed-package-xml"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for package in packages_of(cx.world, cx.expansion) {
        let path = package.folder.join("package.xml");
        let Ok(source) = cx.world.vfs.document(&path) else {
            continue;
        };
        let errors = source.document.errors();
        let Some(error) = errors.iter().min_by_key(|error| error.expat_offset) else {
            continue;
        };
        let span = Span {
            file: source.id,
            range: error.range,
        };
        out.report_span(
            span,
            format!(
                "package.xml of `{}` is malformed: {}",
                package.name, error.message
            ),
        )
        .help("correct the XML; dependencies are not checked until then")
        .done();
    }
}
