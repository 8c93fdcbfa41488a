//! A joint in an SRDF that the robot does not have.
use super::super::beside::{BesideCx, unknown};
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use project::ProjectNameKind;

/// What Pinocchio calls the joint of a base that moves freely, in the postures that it reads from an SRDF; no URDF has it.
const FREE_FLYER: &str = "root_joint";

pub(super) static RULE: Rule = Rule::beside(
    "SRD003",
    "srdf-unknown-joint",
    Category::Srdf,
    Severity::Error,
    page("srdf-unknown-joint"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(srdf) = cx.srdf() else { return };
    for (text, kind, _) in srdf.names() {
        let Some(name) = text
            .name()
            .filter(|name| kind == ProjectNameKind::Joint && cx.lacks(kind, name))
        else {
            continue;
        };
        let is_passive = || srdf.passive.iter().any(|joint| std::ptr::eq(joint, text));
        let severity = if name == FREE_FLYER {
            Severity::Info
        } else if is_passive() {
            // nothing moves it anyhow
            Severity::Warning
        } else {
            RULE.severity
        };
        unknown(
            cx,
            out,
            (text, kind),
            severity,
            format!("SRDF refers to unknown joint `{name}`"),
        );
    }
}
