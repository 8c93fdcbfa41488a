//! A material that says nothing.
use super::super::context::{DocumentCx, RootKind};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::shapes::{is_defined, visual_materials};
use model::{AttrValue, Material, source_has_elements, tag_start};

pub(super) static RULE: Rule = Rule {
    code: "GEO031",
    name: "material-without-color",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("material-without-color"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for material in cx
        .robot
        .into_iter()
        .flat_map(|robot| &robot.materials)
        .filter(|material| !is_defined(material))
    {
        if is_of_gazebo(cx, material) {
            continue;
        }
        // what xacro tags inside would have given may be lost
        let certain =
            cx.kind == RootKind::Robot && cx.expansion.whole && cx.expansion.problems.is_empty();
        if certain || !source_has_elements(cx.expansion, material.element) {
            let name = material
                .name
                .as_ref()
                .map_or("", |name| name.value.as_str());
            let message = format!("material `{name}` has neither color nor texture");
            let origin = tag_start(cx.expansion, material.element);
            out.report(origin, message)
                .severity(if is_shown(cx, name) {
                    RULE.severity
                } else {
                    Severity::Hint
                })
                .help("add <color rgba=\"...\"/>; urdfdom leaves the material out otherwise")
                .done();
        }
    }
}

/// Whether a visual has the material. Those of collisions, and all but the first of a visual, are not read.
fn is_shown(cx: &DocumentCx<'_>, name: &str) -> bool {
    let robot = cx.robot.into_iter();
    robot.flat_map(visual_materials).any(|(_, material)| {
        let own = material.name.as_ref();
        own.is_some_and(|own| own.value == name)
    })
}

/// Whether a macro that nothing calls gives the color of a `gazebo` element: without a name, and with the color as text.
fn is_of_gazebo(cx: &DocumentCx<'_>, material: &Material) -> bool {
    let is_root = cx.expansion.tree.root() == Some(cx.element);
    !is_root
        && material.name.is_none()
        && AttrValue::content(&cx.expansion.tree, material.element).is_some()
}
