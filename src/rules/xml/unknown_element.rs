//! An element that URDF does not know at its place.
use super::super::context::{DocumentCx, RootKind};
use super::super::finding::Help;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::schema::{self, ElementSpec};
use super::super::sink::Sink;
use super::super::vocabulary::SDF_SURFACE;
use super::duplicate_element::is_same;
use super::missing_element::bare_shape;
use super::seen::CheckedElement;
use super::walk;
use expand::XId;
use model::{AttrValue, Pose, tag_start, transform};

pub(in super::super) static RULE: Rule = Rule {
    code: "XML006",
    name: "unknown-element",
    category: Category::Xml,
    severity: Severity::Hint,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("unknown-element"),
    check: Check::Element(check),
};

fn check(cx: &DocumentCx<'_>, element: &CheckedElement, out: &mut Sink<'_>) {
    let &CheckedElement {
        id, spec, parent, ..
    } = element;
    let (None, Some(parent)) = (spec, parent) else {
        return;
    };
    let name = cx.expansion.tree.get(id).text.as_str();
    // shapes and surfaces have rules of their own
    let has_rule = parent.name == "geometry" || parent.name == "collision" && name == SDF_SURFACE;
    let elsewhere = name.contains(':') || has_rule;
    if elsewhere || is_allowed(cx, name) || walk::lacks_prefix(cx, id) {
        return;
    }
    let around = cx.expansion.tree.parent(id);
    if cx.complete && around.and_then(|around| bare_shape_once(cx, around)) == Some(name) {
        return; // it is said that the geometry is missing
    }
    let near = walk::meant(name, parent.children().map(|child| child.name));
    let near = near.or_else(|| Some((former(cx, id, parent)?, false)));
    if cx.kind == RootKind::Library && parent.name == "robot" && near.is_none() {
        return; // the file may be meant for the inside of a free zone
    }
    report(cx, id, parent, near, out);
}

/// What `dynamics` was called in the first years of URDF.
const FORMER: &str = "joint_properties";

/// What an element is called now that URDF called otherwise in its first years, unless nothing is lost without it.
fn former(cx: &DocumentCx<'_>, id: XId, parent: &ElementSpec) -> Option<&'static str> {
    const NOW: &str = "dynamics";
    let tree = &cx.expansion.tree;
    // an element may have a million others beside it
    if parent.name != "joint" || tree.get(id).text != FORMER {
        return None;
    }
    let joint = tree.parent(id)?;
    let values = ["damping", "friction"].into_iter();
    let mut values = values.filter_map(|name| AttrValue::attr(tree, id, name));
    let is_fixed = tree
        .attr(joint, "type")
        .is_some_and(|kind| kind.value == "fixed");
    let mut children = tree.elements(joint).take(MOST_CHILDREN);
    let is_there = children.any(|child| tree.get(child).text == NOW);
    let is_lost = !is_fixed && !is_there && values.any(|text| text.number() != Some(0.0));
    is_lost.then_some(NOW)
}

/// Whether damping and friction would be more than a drive of the robot can move at one radian per second: it drives because they
/// are ignored. One that sets the speed of its wheels does not feel them.
fn holds_drive(cx: &DocumentCx<'_>, id: XId) -> bool {
    let tree = &cx.expansion.tree;
    let values = ["damping", "friction"].into_iter();
    let values = values.filter_map(|name| AttrValue::attr(tree, id, name)?.number());
    let resistance: f64 = values.sum();
    let kind = tree.parent(id).and_then(|joint| tree.attr(joint, "type"));
    let is_wheel = kind.is_some_and(|kind| kind.value == "continuous");
    let drives = cx.drives();
    drives.torque.is_some_and(|torque| torque < resistance) || is_wheel && drives.sets_speed
}

/// The shape without a geometry in an element that may hold many unknown ones.
fn bare_shape_once<'a>(cx: &DocumentCx<'a>, around: XId) -> Option<&'a str> {
    let mut known = cx.bare_shapes.borrow_mut();
    *known
        .entry(around)
        .or_insert_with(|| bare_shape(&cx.expansion.tree, around))
}

fn is_allowed(cx: &DocumentCx<'_>, name: &str) -> bool {
    cx.world
        .config
        .allow_elements
        .iter()
        .any(|allowed| allowed == name)
}

fn report(
    cx: &DocumentCx<'_>,
    id: XId,
    parent: &ElementSpec,
    near: Option<(&str, bool)>,
    out: &mut Sink<'_>,
) {
    let name = &cx.expansion.tree.get(id).text;
    let around = cx
        .expansion
        .tree
        .parent(id)
        .map_or(String::new(), |id| walk::described(cx, id));
    let message = format!("unknown element `{name}` in {around}");
    // all that another language writes as elements is one mistake
    let group = match parent.attribute(name) {
        Some(_) => format!("attributes of {}", parent.name),
        None => format!("{name} in {}", parent.name),
    };
    let group = Group::Value(group.into());
    let report = out
        .report(tag_start(cx.expansion, id), message)
        .group(group);
    let Some((near, sure)) = near else {
        let (severity, help) = unlike_all(name, parent);
        let is_idle = is_identity(cx, id, name) || is_bare(cx, id) || is_zero_pose(cx, id, name);
        let severity = match severity {
            _ if is_idle => Severity::Hint,
            Severity::Warning if loses_nothing(cx, id, parent) => Severity::Info,
            severity => severity,
        };
        return report.severity(severity).help(help).done();
    };
    let severity = if is_needed(cx, id, parent, near) {
        Severity::Error
    } else if is_identity(cx, id, near) {
        Severity::Hint
    } else if name == FORMER && holds_drive(cx, id) {
        Severity::Info
    } else {
        Severity::Warning
    };
    let report = report
        .severity(severity)
        .help(Help::did_you_mean(near).and(&format!("Parsers silently ignore `{name}`")));
    let Some((file, names)) = walk::tag_names(cx.expansion, id) else {
        return report.done();
    };
    let safety = if sure { Safety::Safe } else { Safety::Unsafe };
    let edits = names.into_iter().map(|range| (range, near.to_owned()));
    report
        .fix(safety, format!("rename to `{near}`"), file, edits)
        .done();
}

/// Whether parsers reject the element around without the one that is meant, which no other finding says then.
fn is_needed(cx: &DocumentCx<'_>, id: XId, parent: &ElementSpec, near: &str) -> bool {
    let tree = &cx.expansion.tree;
    let Some(around) = tree.parent(id) else {
        return false;
    };
    let is_required = parent.required.contains(&near)
        || parent.name == "joint"
            && near == "limit"
            && tree
                .attr(around, "type")
                .is_some_and(|kind| matches!(kind.value.as_str(), "revolute" | "prismatic"));
    is_required
        && !tree
            .elements(around)
            .any(|child| tree.get(child).text == near)
}

/// The severity and the advice for a name that is close to none that may stand there.
fn unlike_all(name: &str, parent: &ElementSpec) -> (Severity, String) {
    if name == "pose" && parent.child("origin").is_some() {
        let help = "write <origin xyz=\"...\" rpy=\"...\"/>; `pose` is SDF, and URDF parsers silently ignore it";
        return (Severity::Warning, help.to_owned());
    }
    if name == "plugin" {
        let help = "put it in `<gazebo>`, and one for a sensor in the `<sensor>` there; Gazebo reads no `plugin` elsewhere";
        return (Severity::Warning, help.to_owned());
    }
    if matches!(name, "link" | "joint") && parent.name != "robot" {
        let help = format!(
            "move it out of `{}`, to be a child of `robot`; parsers silently ignore it here",
            parent.name
        );
        return (Severity::Warning, help);
    }
    // the version of URDF is a number; others write that of their robot so
    if let Some(attribute) = parent.attribute(name).filter(|_| name != "version") {
        let help = format!(
            "write {0}=\"...\" in <{1}>: `{0}` is an attribute, and parsers silently ignore the element",
            attribute.name, parent.name
        );
        return (Severity::Warning, help);
    }
    // an element of URDF in the wrong place has no effect; other names are meant for other programs
    let is_misplaced = schema::is_urdf(name) && !(name == "material" && parent.name == "collision");
    let severity = if is_misplaced {
        Severity::Warning
    } else {
        Severity::Hint
    };
    let children: Vec<String> = parent
        .children()
        .map(|child| format!("`{}`", child.name))
        .collect();
    let help = if children.is_empty() {
        format!(
            "remove it; `{}` has no child elements, and parsers silently ignore it",
            parent.name
        )
    } else {
        format!(
            "use a child element of `{}`: {}; parsers silently ignore others",
            parent.name,
            children.join(", ")
        )
    };
    (severity, help)
}

/// Whether an element has no content and no attribute: nothing is lost without it.
fn is_bare(cx: &DocumentCx<'_>, id: XId) -> bool {
    let tree = &cx.expansion.tree;
    tree.get(id).attrs.is_empty()
        && tree.elements(id).next().is_none()
        && AttrValue::content(tree, id).is_none_or(|text| text.value.trim().is_empty())
}

/// Whether an element of URDF has nothing to act on at its place: a color where no visual lacks one, what Gazebo is told of a link
/// without any body, or a shape where none is.
fn loses_nothing(cx: &DocumentCx<'_>, id: XId, parent: &ElementSpec) -> bool {
    let tree = &cx.expansion.tree;
    let Some(around) = tree.parent(id) else {
        return false;
    };
    let bodies = |kinds: &'static [&'static str]| {
        let children = tree.elements(around).take(MOST_CHILDREN);
        children.filter(|&child| kinds.contains(&tree.get(child).text.as_str()))
    };
    let has_color = |visual: XId| {
        let mut children = tree.elements(visual).take(MOST_CHILDREN);
        children.any(|child| tree.get(child).text == "material")
    };
    match (tree.get(id).text.as_str(), parent.name) {
        ("material", "joint") => true,
        ("material", "link") => bodies(&["visual"]).all(has_color),
        ("gazebo", "link") => bodies(&["visual", "collision", "inertial"])
            .next()
            .is_none(),
        ("geometry", "inertial") => true,
        // no program for ROS 2 reads it in its right place either
        ("transmission", "joint") => is_for_ament(cx, id),
        ("origin", "link") => is_pose_of_joint(cx, id, around),
        ("link" | "joint", _) => is_elsewhere(cx, id),
        ("collision" | "inertial" | "visual", "collision" | "visual") => {
            let link = tree.parent(around);
            let mut beside = link
                .into_iter()
                .flat_map(|link| tree.elements(link).take(MOST_CHILDREN));
            beside
                .any(|other| tree.get(other).text == tree.get(id).text && is_same(tree, other, id))
        }
        _ => false,
    }
}

/// Whether an element is in a file of a package for ROS 2.
fn is_for_ament(cx: &DocumentCx<'_>, id: XId) -> bool {
    let place = cx.expansion.place(cx.expansion.tree.get(id).origin);
    let file = place.and_then(|place| cx.expansion.files.get(place.file));
    file.is_some_and(|file| cx.world.packages.is_for_ament(&file.source.path))
}

/// An element may have a million others inside.
const MOST_CHILDREN: usize = 100;

/// Whether the robot has a link or joint of the same name in the right place.
fn is_elsewhere(cx: &DocumentCx<'_>, id: XId) -> bool {
    let tree = &cx.expansion.tree;
    let Some(name) = tree.attr(id, "name").map(|name| name.value.as_str()) else {
        return false;
    };
    match tree.get(id).text.as_str() {
        "link" => cx.links_named(name).any(|link| link.element != id),
        // there may be thousands of joints: those of its child
        _ => {
            let mut children = tree.elements(id).take(MOST_CHILDREN);
            let child = children.find(|&child| tree.get(child).text == "child");
            let link = child.and_then(|child| tree.attr(child, "link"));
            link.is_some_and(|link| {
                let mut same = cx.joints_above(&link.value);
                same.any(|joint| joint.element != id && joint.shown() == name)
            })
        }
    }
}

/// Whether the `origin` of a link is that of the joint that carries it.
fn is_pose_of_joint(cx: &DocumentCx<'_>, id: XId, link: XId) -> bool {
    let name = cx.expansion.tree.attr(link, "name");
    let joint = name.and_then(|name| cx.joint_above(&name.value));
    let pose = Pose::of(&cx.expansion.tree, id).transform();
    joint.is_some_and(|joint| pose.is_some() && pose == transform(joint.origin.as_ref()))
}

/// Whether an element is the pose of SDF and moves nothing.
fn is_zero_pose(cx: &DocumentCx<'_>, id: XId, name: &str) -> bool {
    let text =
        AttrValue::content(&cx.expansion.tree, id).filter(|text| !text.value.trim().is_empty());
    let is_zero = |text: AttrValue| {
        text.numbers::<6>()
            .is_some_and(|numbers| numbers == [0.0; 6])
    };
    name == "pose" && text.map_or_else(|| is_identity(cx, id, "origin"), is_zero)
}

/// Whether an element is meant as an `origin` that moves nothing: without it, all is the same.
fn is_identity(cx: &DocumentCx<'_>, id: XId, meant: &str) -> bool {
    let vectors = ["xyz", "rpy"].into_iter();
    let mut vectors = vectors.filter_map(|name| AttrValue::attr(&cx.expansion.tree, id, name));
    meant == "origin" && vectors.all(|text| text.numbers() == Some([0.0; 3]))
}
