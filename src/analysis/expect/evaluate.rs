//! One expectation and one robot: each thing that is not as expected, with the source text that is responsible.
use super::context::ExpectationContext;
use super::expands_to::compare_with_file;
use expand::{Origin, XId};
use model::{AttrValue, ControlJoint, Joint, JointType, Link};
use packages::nearest;
use workspace::config::ExpectedJoint;

/// Compare everything.
pub(super) fn evaluate(cx: &mut ExpectationContext<'_>, update: bool) {
    let expected = cx.expected;
    check_names(cx);
    check_counts(cx);
    if let Some(root) = &expected.root {
        check_root(cx, root);
    }
    for chain in &expected.chains {
        check_chain(cx, chain);
    }
    if let Some(mass) = expected.mass {
        check_mass(cx, mass);
    }
    for (name, joint) in &expected.joint {
        check_joint(cx, name, joint);
    }
    for (kind, interfaces) in [
        ("command", &expected.command_interfaces),
        ("state", &expected.state_interfaces),
    ] {
        for (joint, names) in interfaces {
            check_interfaces(cx, kind, joint, names);
        }
    }
    if let Some(file) = &expected.expands_to {
        compare_with_file(cx, file, update);
    }
}

fn check_names(cx: &mut ExpectationContext<'_>) {
    let expected = cx.expected;
    for name in &expected.links {
        find_link(cx, name);
    }
    for name in &expected.joints {
        find_joint(cx, name);
    }
    for name in &expected.no_links {
        let Some(name) = cx.filled(name) else {
            continue;
        };
        if let Some(link) = cx.robot.link(&name) {
            cx.fail(
                name_of(cx, link.element, &link.name),
                format!("link `{name}` is not expected"),
                None,
            );
        }
    }
    for name in &expected.no_joints {
        let Some(name) = cx.filled(name) else {
            continue;
        };
        if let Some(joint) = cx.robot.joint(&name) {
            let at = name_of(cx, joint.element, &joint.name);
            cx.fail(at, format!("joint `{name}` is not expected"), None);
        }
    }
}

fn name_of(cx: &ExpectationContext<'_>, element: XId, name: &Option<AttrValue>) -> Origin {
    name.as_ref().map_or_else(|| cx.tag(element), whole)
}

/// The link of an expected name; that it is missing is reported.
fn find_link<'a>(cx: &mut ExpectationContext<'a>, name: &str) -> Option<&'a Link> {
    let name = cx.filled(name)?;
    let found = cx.robot.link(&name);
    if found.is_none() {
        let names = cx.robot.links.iter().filter_map(|link| link.name.as_ref());
        let help = similar(&name, names);
        cx.fail_robot(format!("missing link `{name}`"), help);
    }
    found
}

/// The joint of an expected name; that it is missing is reported.
fn find_joint<'a>(cx: &mut ExpectationContext<'a>, name: &str) -> Option<&'a Joint> {
    let name = cx.filled(name)?;
    let found = cx.robot.joint(&name);
    if found.is_none() {
        let names = cx
            .robot
            .joints
            .iter()
            .filter_map(|joint| joint.name.as_ref());
        let help = similar(&name, names);
        cx.fail_robot(format!("missing joint `{name}`"), help);
    }
    found
}

fn check_counts(cx: &mut ExpectationContext<'_>) {
    let is_moving = |joint: &&Joint| !joint.is(&[JointType::Fixed]);
    let moving = cx.robot.joints.iter().filter(is_moving).count();
    for (what, count, expected) in [
        ("links", cx.robot.links.len(), cx.expected.link_count),
        ("joints", cx.robot.joints.len(), cx.expected.joint_count),
        ("moving joints", moving, cx.expected.moving_joint_count),
    ] {
        if let Some(expected) = expected.filter(|expected| *expected != count) {
            cx.fail_robot(
                format!("robot has {count} {what}, expected {expected}"),
                None,
            );
        }
    }
}

fn check_root(cx: &mut ExpectationContext<'_>, name: &str) {
    let Some(name) = cx.filled(name) else {
        return;
    };
    let roots = cx.kinematics.roots(cx.robot);
    let Some(root) = roots.first().and_then(|&root| cx.robot.links.get(root)) else {
        return;
    };
    let own = root.name.as_ref().map_or("", |name| name.value.as_str());
    if own != name {
        let at = name_of(cx, root.element, &root.name);
        cx.fail(at, format!("root link is `{own}`, expected `{name}`"), None);
    }
}

/// Each link of a chain is below the one before.
fn check_chain(cx: &mut ExpectationContext<'_>, names: &[String]) {
    let links: Vec<Option<&Link>> = names.iter().map(|name| find_link(cx, name)).collect();
    for pair in links.windows(2) {
        let [Some(above), Some(below)] = pair else {
            continue;
        };
        let (Some(top), Some(end)) = (&above.name, &below.name) else {
            continue;
        };
        let ends = cx
            .kinematics
            .link(&top.value)
            .zip(cx.kinematics.link(&end.value));
        let Some((from, to)) = ends else { continue };
        let mut parents = cx
            .kinematics
            .ancestor_joints(to)
            .filter_map(|joint| cx.kinematics.ends(joint));
        if !parents.any(|(parent, _)| parent == from) {
            let message = format!("link `{}` is not below link `{}`", end.value, top.value);
            let joint = cx
                .kinematics
                .ancestor_joints(to)
                .next()
                .and_then(|joint| cx.robot.joints.get(joint));
            let parent = joint.and_then(|joint| joint.parent.as_ref());
            let help = parent.map(|parent| format!("its parent link is `{}`", parent.value));
            cx.fail(name_of(cx, below.element, &below.name), message, help);
        }
    }
}

fn check_mass(cx: &mut ExpectationContext<'_>, expected: f64) {
    const SHOWN: usize = 3;
    let mass = |link: &Link| {
        link.inertial
            .as_ref()
            .and_then(|inertial| inertial.mass())
            .unwrap_or(0.0)
    };
    let total: f64 = cx.robot.links.iter().map(mass).sum();
    let tolerance = cx.expected.mass_tolerance;
    if is_near(total, expected, tolerance) {
        return;
    }
    let mut heaviest: Vec<(f64, &str)> = (cx.robot.links.iter())
        .filter_map(|link| Some((mass(link), link.name.as_ref()?.value.as_str())))
        .filter(|(mass, _)| *mass > 0.0)
        .collect();
    heaviest.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(b.1)));
    let shown = heaviest
        .iter()
        .take(SHOWN)
        .map(|(mass, name)| format!("`{name}` {} kg", short(*mass)));
    let shown = shown.collect::<Vec<_>>().join(", ");
    let help = (!shown.is_empty()).then(|| format!("the links with the most mass are {shown}"));
    let message = format!(
        "total mass is {} kg, expected {} kg{}",
        short(total),
        short(expected),
        within(tolerance)
    );
    cx.fail_robot(message, help);
}

fn check_joint(cx: &mut ExpectationContext<'_>, name: &str, expected: &ExpectedJoint) {
    let Some(joint) = find_joint(cx, name) else {
        return;
    };
    let name = joint.shown().to_owned();
    for (what, own, wanted) in [
        ("type", &joint.kind, &expected.kind),
        ("parent link", &joint.parent, &expected.parent),
        ("child link", &joint.child, &expected.child),
        (
            "mimicked joint",
            &joint.mimic.as_ref().and_then(|mimic| mimic.joint.clone()),
            &expected.mimic,
        ),
    ] {
        let Some(wanted) = wanted.as_ref().and_then(|wanted| cx.filled(wanted)) else {
            continue;
        };
        let value = own.as_ref().map_or("", |own| own.value.as_str());
        if value != wanted {
            let at = own.as_ref().map_or_else(|| cx.tag(joint.element), whole);
            let value = if value.is_empty() {
                "missing".to_owned()
            } else {
                format!("`{value}`")
            };
            cx.fail(
                at,
                format!("{what} of joint `{name}` is {value}, expected `{wanted}`"),
                None,
            );
        }
    }
    let limit = joint.limit.as_ref();
    let is_linear = joint.is(&[JointType::Prismatic]);
    let units = if is_linear {
        ["m", "N", "m/s"]
    } else {
        ["rad", "N m", "rad/s"]
    };
    let [position, force, speed] = units;
    for (what, unit, own, wanted) in [
        (
            "lower limit",
            position,
            limit.and_then(|limit| limit.lower.as_ref()),
            expected.lower,
        ),
        (
            "upper limit",
            position,
            limit.and_then(|limit| limit.upper.as_ref()),
            expected.upper,
        ),
        (
            "effort limit",
            force,
            limit.and_then(|limit| limit.effort.as_ref()),
            expected.effort,
        ),
        (
            "velocity limit",
            speed,
            limit.and_then(|limit| limit.velocity.as_ref()),
            expected.velocity,
        ),
    ] {
        let Some(wanted) = wanted else { continue };
        let value = own.and_then(AttrValue::number);
        if value.is_some_and(|value| is_near(value, wanted, expected.tolerance)) {
            continue;
        }
        let element = limit.map_or(joint.element, |limit| limit.element);
        let at = own.map_or_else(|| cx.tag(element), whole);
        let shown = value.map_or_else(
            || "missing".to_owned(),
            |value| format!("{} {unit}", short(value)),
        );
        let wanted = format!("{} {unit}{}", short(wanted), within(expected.tolerance));
        cx.fail(
            at,
            format!("{what} of joint `{name}` is {shown}, expected {wanted}"),
            None,
        );
    }
}

/// The interfaces of a joint in all `ros2_control` elements.
fn check_interfaces(cx: &mut ExpectationContext<'_>, kind: &str, joint: &str, expected: &[String]) {
    let Some(joint) = cx.filled(joint) else {
        return;
    };
    let expected: Vec<Option<String>> = expected.iter().map(|name| cx.filled(name)).collect();
    let Some(mut expected): Option<Vec<String>> = expected.into_iter().collect() else {
        return;
    };
    let all = cx.robot.controls.iter().flat_map(|control| &control.joints);
    let own: Vec<&ControlJoint> = all.filter(|own| own.shown() == joint).collect();
    let interfaces = own.iter().flat_map(|own| {
        if kind == "command" {
            &own.commands
        } else {
            &own.states
        }
    });
    let name = |text: &AttrValue| text.value.to_string();
    let mut names: Vec<String> = interfaces
        .filter_map(|interface| interface.name.as_ref().map(name))
        .collect();
    for list in [&mut names, &mut expected] {
        list.sort();
        list.dedup();
    }
    if names == expected {
        return;
    }
    let at = own.first().map_or(cx.robot.element, |own| own.element);
    let message = format!(
        "{kind} interfaces of joint `{joint}` are {}, expected {}",
        listed(&names),
        listed(&expected)
    );
    let help = own
        .is_empty()
        .then(|| format!("add joint `{joint}` to a `ros2_control` element"));
    cx.fail(cx.tag(at), message, help);
}

/// The source of a whole value.
fn whole(text: &AttrValue) -> Origin {
    text.part(0..text.value.len())
}

fn similar<'t>(name: &str, names: impl Iterator<Item = &'t AttrValue>) -> Option<String> {
    let near = nearest(name, names.map(|text| text.value.as_str()));
    near.map(|near| format!("did you mean `{near}`?"))
}

fn is_near(value: f64, expected: f64, tolerance: f64) -> bool {
    // numbers that are written the same are the same
    (value - expected).abs() <= tolerance + f64::EPSILON * expected.abs().max(1.0)
}

/// A number with as many digits as people want to read.
fn short(number: f64) -> String {
    let text = format!("{number:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

fn within(tolerance: f64) -> String {
    if tolerance > 0.0 {
        format!(" ± {tolerance}")
    } else {
        String::new()
    }
}

fn listed(names: &[String]) -> String {
    match names {
        [] => "none".to_owned(),
        _ => names
            .iter()
            .map(|name| format!("`{name}`"))
            .collect::<Vec<_>>()
            .join(", "),
    }
}
