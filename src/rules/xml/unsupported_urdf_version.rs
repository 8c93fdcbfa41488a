//! A version of URDF that parsers do not admit.
use super::super::context::DocumentCx;
use super::super::place;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::{AttrValue, Version};

pub(super) static RULE: Rule = Rule {
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
    let version = AttrValue::attr(&cx.expansion.tree, robot.element, "version")
        .filter(|version| version.is_known());
    let Some(version) = version else { return };
    let admitted = &cx.world.config.urdf_version;
    let value = version.value.as_str();
    let read = Version::parse(value);
    let is_same =
        |admitted: &String| admitted == value || read.is_some() && read == Version::parse(admitted);
    if admitted.iter().any(is_same) {
        return;
    }
    let Some(at) = cx.expansion.place(version.origin) else {
        return;
    };
    let Some(file) = cx.expansion.files.get(at.file) else {
        return;
    };
    let range = place::whole_attribute(&file.source.document, at.range);
    let (severity, message) = judged(value, read, admitted);
    out.report_in(at.file, range, message)
        .severity(severity)
        .help("write version=\"1.0\", or add the version to `urdf-version` in xacro-lint.toml")
        .done();
}

/// What there is to say about a version that is not admitted, and how bad it is.
fn judged(value: &str, read: Option<Version>, admitted: &[String]) -> (Severity, String) {
    match read {
        Some(Version::V1_1) => (Severity::Warning, needs(value, "urdfdom 5.1")),
        Some(Version::V1_2) => (Severity::Warning, needs(value, "urdfdom 6.0")),
        Some(_) => {
            let admitted = admitted.join("`, `");
            (
                Severity::Error,
                format!("unsupported URDF version `{value}`; supported: `{admitted}`"),
            )
        }
        None => (
            Severity::Error,
            format!("invalid URDF version `{value}`; expected a version such as `1.0`"),
        ),
    }
}

fn needs(value: &str, reader: &str) -> String {
    format!("URDF version `{value}` needs {reader}; older parsers reject the robot")
}
