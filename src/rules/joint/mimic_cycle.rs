//! Joints that mimic each other in a circle.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::mimics::targets;
use base::{FastMap, FastSet};
use model::{AttrValue, Joint, Robot};

pub(in super::super) static RULE: Rule = Rule {
    code: "JNT022",
    name: "mimic-cycle",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("mimic-cycle"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let targets = targets(cx.robot);
    if targets.iter().all(Option::is_none) {
        return;
    }
    for circle in circles(&targets) {
        let Some(&last) = circle.iter().max() else {
            continue;
        };
        let Some((own, at)) = mimicking(cx.robot, last) else {
            continue;
        };
        let message = match circle.len() {
            1 => format!("joint `{}` mimics itself", own.shown()),
            _ => format!(
                "joint `{}` mimics `{}`, which mimics it in turn",
                own.shown(),
                at.value
            ),
        };
        let mut report = out
            .report(at.origin, message)
            .help("remove one <mimic> of the cycle");
        for &other in circle.iter().filter(|&&other| other != last) {
            if let Some((other, at)) = mimicking(cx.robot, other) {
                report = report.also(
                    at.origin,
                    format!("joint `{}` mimics `{}`", other.shown(), at.value),
                );
            }
        }
        report.done();
    }
}

/// A joint that mimics another one, and the name it gives.
fn mimicking(robot: &Robot, joint: usize) -> Option<(&Joint, &AttrValue)> {
    let joint = robot.joints.get(joint)?;
    Some((joint, joint.mimic.as_ref()?.joint.as_ref()?))
}

/// The circles among joints that each mimic one other at most.
fn circles(targets: &[Option<usize>]) -> Vec<Vec<usize>> {
    let next = |&joint: &usize| targets.get(joint).copied().flatten();
    let mut circles = Vec::new();
    // by joint: where the walk began that came by first
    let mut walks: FastMap<usize, usize> = FastMap::default();
    for start in 0..targets.len() {
        let mut seen = std::iter::successors(Some(start), next).map(|joint| {
            let walk = *walks.entry(joint).or_insert(start);
            (joint, walk, walk != start)
        });
        let mut own: FastSet<usize> = FastSet::default();
        let Some((back, walk, _)) = seen.find(|&(joint, _, old)| old || !own.insert(joint)) else {
            continue;
        };
        if walk == start {
            let behind =
                std::iter::successors(next(&back), next).take_while(|&joint| joint != back);
            circles.push(std::iter::once(back).chain(behind).collect());
        }
    }
    circles
}

#[cfg(test)]
mod tests {
    use super::circles;

    #[test]
    fn circles_are_found_once_and_without_what_leads_into_them() {
        assert_eq!(circles(&[Some(1), Some(2), Some(1), None]), [[1, 2]]);
        assert_eq!(
            circles(&[Some(0), Some(3), None, Some(1)]),
            [vec![0], vec![1, 3]]
        );
        assert!(circles(&[None, Some(0), Some(1)]).is_empty());
    }
}
