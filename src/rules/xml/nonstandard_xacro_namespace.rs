//! `xmlns:xacro` bound to something else than the documented namespace.
use super::super::context::FileCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::XACRO_URI;

pub(in super::super) static RULE: Rule = Rule {
    code: "XML003",
    name: "nonstandard-xacro-namespace",
    category: Category::Xml,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("nonstandard-xacro-namespace"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    let Some(attr) = cx.root_attrs().find(|attr| attr.name() == "xmlns:xacro") else {
        return;
    };
    let uri = attr.raw();
    if uri == XACRO_URI {
        return;
    }
    let package = cx.world.packages.containing(&cx.source.path);
    let group = package.map_or(Group::File, |own| {
        Group::Thing(own.folder.to_string_lossy().into())
    });
    // the root stands in the header, which begins the file
    out.report_in(
        cx.file,
        attr.range(),
        format!("nonstandard URI for `xmlns:xacro`: `{uri}`"),
    )
    .group(group)
    .help(format!("write xmlns:xacro=\"{XACRO_URI}\""))
    .fix(
        Safety::Safe,
        format!("change namespace to `{XACRO_URI}`"),
        cx.file,
        [(attr.value_range(), XACRO_URI.to_owned())],
    )
    .done();
}
