//! xacro's namespace bound to a prefix other than `xacro`.

use super::super::context::FileCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::is_xacro_uri;

pub(super) const RULE: Rule = Rule {
    code: "XML004",
    name: "inconsistent-xacro-prefix",
    category: Category::Xml,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page!("inconsistent-xacro-prefix"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    for attr in cx.root_attrs() {
        let Some(prefix) = attr.name().strip_prefix("xmlns:").filter(|&prefix| prefix != "xacro") else {
            continue;
        };
        if is_xacro_uri(attr.raw()) {
            let message =
                format!("xacro's namespace is bound to `{prefix}`: tags `{prefix}:...` are not expanded");
            out.report_in(cx.file, attr.range(), message)
                .help("xacro compares the letters `xacro:`, not namespaces: name the prefix `xacro`")
                .done();
        }
    }
}
