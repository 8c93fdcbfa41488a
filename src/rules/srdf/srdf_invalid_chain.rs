//! A chain that does not lead from its base down to its tip.
use super::super::beside::{BesideCx, PairedRobot};
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use model::AttrValue;
use project::Chain;

pub(super) static RULE: Rule = Rule::beside(
    "SRD005",
    "srdf-invalid-chain",
    Category::Srdf,
    Severity::Error,
    page("srdf-invalid-chain"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let groups = cx.srdf().into_iter().flat_map(|srdf| &srdf.groups);
    for chain in groups.flat_map(|group| &group.chains) {
        let (Some(base), Some(tip)) = (&chain.base, &chain.tip) else {
            continue;
        };
        if !cx.robots.iter().all(|paired| is_reversed(paired, chain)) {
            continue;
        }
        let (message, help) = if base.value == tip.value {
            (
                format!("chain begins and ends at link `{}`", base.value),
                "write the last link of the chain as `tip_link`".to_owned(),
            )
        } else {
            (
                format!(
                    "chain from `{}` to `{}` leads up the tree",
                    base.value, tip.value
                ),
                format!(
                    "exchange them: base_link=\"{}\" tip_link=\"{}\"",
                    tip.value, base.value
                ),
            )
        };
        // of a chain that leads up, MoveIt makes the group of the same joints
        let severity = if base.value == tip.value {
            RULE.severity
        } else {
            Severity::Warning
        };
        out.report(tip.origin, message)
            .severity(severity)
            .help(help)
            .done();
    }
}

/// Whether both links are there, and the base is the tip or below it.
fn is_reversed(paired: &PairedRobot<'_>, chain: &Chain) -> bool {
    let kinematics = paired.kinematics;
    let links = [&chain.base, &chain.tip]
        .map(|text| kinematics.link(text.as_ref().and_then(AttrValue::name)?));
    let [Some(base), Some(tip)] = links else {
        return false;
    };
    base == tip
        || kinematics
            .ancestor_joints(base)
            .filter_map(|joint| kinematics.ends(joint))
            .any(|(parent, _)| parent == tip)
}
