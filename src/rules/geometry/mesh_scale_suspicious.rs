//! A mesh in another unit than meters.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::thresholds::{MAX_EXTENT, MIN_EXTENT};
use super::bodies::extent_of;
use super::resources::MeshUse;
use base::TextRange;
use expand::{FileIdx, Origin};
use model::{AttrValue, Body, Bounds, Inertial, Joint, Link, Robot, tag_start};

pub(super) static RULE: Rule = Rule {
    code: "GEO007",
    name: "mesh-scale-suspicious",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("mesh-scale-suspicious"),
    check: Check::Document(check),
};

/// What a mesh in another unit is that has a collision or a visual beside it in the right one: a thousandth.
const THOUSANDTH: std::ops::Range<f64> = 0.0005..0.002;

/// Whether a mesh is too large or too small for any link.
pub(super) fn is_suspicious(cx: &DocumentCx<'_>, mesh: &MeshUse<'_>) -> bool {
    let admitted = admitted(cx);
    extent(mesh).is_some_and(|extent| {
        extent < *admitted.start() || extent > *admitted.end() && !cx.is_static()
    })
}

/// Whether a mesh of a link is: nothing else that rests on its size is right.
pub(in super::super) fn is_scaled_wrong(cx: &DocumentCx<'_>, link: &Link) -> bool {
    let own = |mesh: &MeshUse<'_>| mesh.link.element == link.element;
    cx.meshes().filter(own).any(|mesh| is_suspicious(cx, &mesh)) || shrunk(cx, link).is_some()
}

/// The extents that are admitted, meters.
fn admitted(cx: &DocumentCx<'_>) -> std::ops::RangeInclusive<f64> {
    MIN_EXTENT.value(cx.world.config)..=MAX_EXTENT.value(cx.world.config)
}

/// The extent of a mesh; none where it is not known, or a factor of zero, which is another defect, makes it flat.
fn extent(mesh: &MeshUse<'_>) -> Option<f64> {
    let surface = mesh.mesh.and_then(|mesh| mesh.surface)?;
    let factors = mesh.factors().filter(|factors| !factors.contains(&0.0))?;
    Some(surface.bounds.scaled(factors).extent()).filter(|&extent| extent > 0.0)
}

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for mesh in cx.meshes().filter(|mesh| is_suspicious(cx, mesh)) {
        report(cx, &mesh, out);
    }
    for link in cx.links() {
        if let Some(bodies) = shrunk(cx, link) {
            report_shrunk(cx, link, bodies, out);
        }
    }
}

/// The visuals or the collisions of a link, when they are a thousandth of the others, and only a mesh decides.
fn shrunk<'a>(cx: &DocumentCx<'_>, link: &'a Link) -> Option<&'a [Body]> {
    let extent = |bodies| {
        extent_of(cx, bodies)
            .bounds()
            .map(Bounds::extent)
            .filter(|&extent| extent > 0.0)
    };
    let ratio = extent(&link.visuals)? / extent(&link.collisions)?;
    let small = match ratio {
        ratio if THOUSANDTH.contains(&ratio) => &link.visuals,
        ratio if THOUSANDTH.contains(&ratio.recip()) => &link.collisions,
        _ => return None,
    };
    let is_known =
        |mesh: MeshUse<'_>| mesh.link.element == link.element && is_suspicious(cx, &mesh);
    (!cx.meshes().any(is_known)).then_some(small)
}

fn report_shrunk(cx: &DocumentCx<'_>, link: &Link, bodies: &[Body], out: &mut Sink<'_>) {
    let is_own = |mesh: &MeshUse<'_>| {
        bodies.iter().any(|body| {
            body.shape()
                .is_some_and(|shape| shape.element == mesh.element)
        })
    };
    let Some(mesh) = cx.meshes().find(is_own) else {
        return;
    };
    let other = if mesh.is_collision {
        "visual"
    } else {
        "collision"
    };
    let message = format!(
        "mesh `{}` is 1000 times smaller than the {other} of link `{}`",
        mesh.name(),
        link.shown()
    );
    let small = mesh
        .scale
        .and_then(|scale| scale.numbers::<3>().map(|factors| (scale, factors)));
    match small.filter(|(scale, _)| scale.is_literal()) {
        Some((scale, factors)) => {
            let [x, y, z] = factors.map(|factor| (factor * 1000.0 * 1e6).round() / 1e6);
            let text = format!("{x} {y} {z}");
            out.report(scale.origin, message)
                .help(format!("write scale=\"{text}\"; the mesh is in meters"))
                .replace_with(Safety::Unsafe, format!("replace with `{text}`"), text)
                .done();
        }
        None => out
            .report(mesh.file.origin, message)
            .help(format!(
                "export the mesh in meters, or correct the size of the {other}"
            ))
            .done(),
    }
}

fn report(cx: &DocumentCx<'_>, mesh: &MeshUse<'_>, out: &mut Sink<'_>) {
    let (Some(extent), Some(surface)) = (extent(mesh), mesh.mesh.and_then(|mesh| mesh.surface))
    else {
        return;
    };
    let bounds = surface.bounds.scaled(mesh.factors().unwrap_or([1.0; 3]));
    let most = MAX_EXTENT.value(cx.world.config);
    let is_millimeters = extent > most && (0.001..=most).contains(&(extent / 1000.0));
    let (cause, help) = if is_millimeters {
        (
            "; this looks like millimeters",
            "add scale=\"0.001 0.001 0.001\", or export the mesh in meters",
        )
    } else {
        (
            "",
            "check the unit of the mesh and `scale`; meshes are in meters",
        )
    };
    let size = meters(extent);
    let message = format!(
        "mesh `{}` of link `{}` is {size} across{cause}",
        mesh.name(),
        mesh.link.shown()
    );
    // an object without joints may be a building or a floor
    let is_object = cx.robot.is_some_and(Robot::is_rigid);
    let may_be_meant = most < extent
        && (is_object && (extent < 10.0 * most || is_ground(bounds.size()))
            || extent < 3.0 * most && (is_around(cx, mesh, extent) || is_heavy(mesh, extent)))
        || is_point(mesh);
    let severity = if may_be_meant {
        Severity::Info
    } else {
        Severity::Warning
    };
    let report = out
        .report(mesh.file.origin, message)
        .severity(severity)
        .help(help);
    match rescaled(cx, mesh).filter(|_| is_millimeters) {
        Some((origin, content)) => {
            let edit = cx
                .expansion
                .place(origin)
                .map(|place| (place.file, place.range));
            let (file, range) = edit.unwrap_or((FileIdx(0), TextRange::default()));
            report
                .fix(
                    Safety::Unsafe,
                    "scale mesh from millimeters to meters",
                    file,
                    [(range, content)],
                )
                .done();
        }
        None => report.done(),
    }
}

/// Whether a link weighs more than anything of a thousandth of its size can: the mesh is as large as it says.
fn is_heavy(mesh: &MeshUse<'_>, extent: f64) -> bool {
    /// More than that of every material, kg / m^3.
    const DENSITY: f64 = 25_000.0;
    let mass = mesh.link.inertial.as_ref().and_then(Inertial::mass);
    mass.is_some_and(|mass| mass > DENSITY * (extent / 1000.0).powi(3))
}

/// Whether a mesh is scaled to a point on purpose: no unit is that small.
fn is_point(mesh: &MeshUse<'_>) -> bool {
    /// Less than a millionth of a meter in millimeters.
    const LEAST: f64 = 1e-5;
    let factors = mesh.scale.and(mesh.factors());
    factors.is_some_and(|factors| factors.iter().all(|factor| factor.abs() < LEAST))
}

/// Whether a mesh is what a robot stands in: that of a root link without a mass, larger than the robot, while a thousandth of it
/// would be smaller than a part of the robot.
fn is_around(cx: &DocumentCx<'_>, mesh: &MeshUse<'_>, extent: f64) -> bool {
    let is_child = |joint: &Joint| {
        let child = joint.child.as_ref().and_then(AttrValue::name);
        child.is_some() && child == mesh.link.name.as_ref().and_then(AttrValue::name)
    };
    let is_part = |other: MeshUse<'_>| {
        other.link.element != mesh.link.element
            && !is_suspicious(cx, &other)
            && self::extent(&other).is_some_and(|part| extent / 1000.0 < part)
    };
    mesh.link.inertial.is_none() && !cx.joints().iter().any(is_child) && cx.meshes().any(is_part)
}

/// Whether a size is that of a floor: wide in two directions, and thin in the third.
fn is_ground(mut size: [f64; 3]) -> bool {
    /// The part of its width that a floor is thick.
    const THIN: f64 = 0.01;
    size.sort_by(f64::total_cmp);
    let [thickness, width, _] = size;
    thickness < THIN * width
}

/// Where a scale of 0.001 goes, and what is written there.
fn rescaled(cx: &DocumentCx<'_>, mesh: &MeshUse<'_>) -> Option<(Origin, String)> {
    match mesh.scale {
        Some(scale) => {
            let factors = mesh.factors().filter(|_| scale.is_literal())?;
            let [x, y, z] = factors.map(|factor| factor / 1000.0);
            Some((scale.origin, format!("{x} {y} {z}")))
        }
        None => {
            let tag = tag_start(cx.expansion, mesh.element);
            let behind = TextRange::empty(tag.range.end);
            Some((
                Origin {
                    range: behind,
                    ..tag
                },
                r#" scale="0.001 0.001 0.001""#.to_owned(),
            ))
        }
    }
}

/// A length for people.
pub(super) fn meters(length: f64) -> String {
    let digits = (2 - length.log10().floor() as i32).clamp(0, 9) as usize;
    match length {
        0.001..1e6 => format!("{length:.digits$} m"),
        _ => format!("{length:.1e} m"),
    }
}
