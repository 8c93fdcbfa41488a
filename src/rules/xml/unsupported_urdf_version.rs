//! A version of URDF that parsers do not admit.

use super::super::context::DocumentCx;
use super::super::place;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::Text;

pub(super) const RULE: Rule = Rule {
    code: "XML015",
    name: "unsupported-urdf-version",
    category: Category::Xml,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("unsupported-urdf-version"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot else { return };
    let version =
        Text::attr(&cx.expansion.tree, robot.element, "version").filter(|version| version.is_known());
    let Some(version) = version else { return };
    let admitted = &cx.world.config.urdf_version;
    let value = version.value.trim();
    let long = format!("{value}.0");
    if admitted.iter().any(|admitted| admitted == value || *admitted == long) {
        return;
    }
    let Some(at) = cx.expansion.place(version.origin) else { return };
    let Some(file) = cx.expansion.files.get(at.file.0 as usize) else { return };
    let range = place::whole_attribute(&file.source.document, at.range);
    let message = format!("version `{value}` of URDF is not admitted, only `{}`", admitted.join("`, `"));
    out.report_in(at.file, range, message)
        .help("write version=\"1.0\", or list the version under `urdf-version` in xacro-lint.toml")
        .done();
}
