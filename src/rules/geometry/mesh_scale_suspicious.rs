//! A mesh in another unit than metres.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::thresholds::{MAX_EXTENT, MIN_EXTENT};
use super::resources::MeshUse;
use base::TextRange;
use expand::{FileIdx, Origin};
use model::{Robot, tag_start};

pub(super) const RULE: Rule = Rule {
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

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let (most, least) = (MAX_EXTENT.value(cx.world.config), MIN_EXTENT.value(cx.world.config));
    for mesh in cx.meshes() {
        let surface = mesh.mesh.and_then(|mesh| mesh.surface);
        let (Some(surface), Some(factors)) = (surface, mesh.factors()) else { continue };
        let extent = surface.bounds.scaled(factors).extent();
        // what a factor of zero makes is another defect
        let flat = factors.contains(&0.0) || extent == 0.0;
        if flat || least <= extent && extent <= most {
            continue;
        }
        let message =
            format!("mesh `{}` of link `{}` is {} large", mesh.name(), mesh.link.shown(), metres(extent));
        let is_millimetres = extent > most && (0.001..=most).contains(&(extent / 1000.0));
        let help = match is_millimetres {
            true => "it seems to be in millimetres: scale it by 0.001",
            false => "meshes are in metres: check its unit and `scale`",
        };
        // an object without joints may be a building or a floor
        let is_object = cx.robot.is_some_and(Robot::is_rigid);
        let may_be_meant = is_object && most < extent && extent < 10.0 * most;
        let severity = if may_be_meant { Severity::Info } else { Severity::Warning };
        let report = out.report(mesh.file.origin, message).severity(severity).help(help);
        match rescaled(cx, &mesh).filter(|_| is_millimetres) {
            Some((origin, content)) => {
                let edit = cx.expansion.place(origin).map(|place| (place.file, place.range));
                let (file, range) = edit.unwrap_or((FileIdx(0), TextRange::default()));
                report.fix(Safety::Unsafe, "scale it from millimetres", file, [(range, content)]).done();
            }
            None => report.done(),
        }
    }
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
            Some((Origin { range: behind, ..tag }, r#" scale="0.001 0.001 0.001""#.to_owned()))
        }
    }
}

/// A length for people.
fn metres(length: f64) -> String {
    let digits = (2 - length.log10().floor() as i32).clamp(0, 9) as usize;
    match length {
        0.001..1e6 => format!("{length:.digits$} m"),
        _ => format!("{length:.1e} m"),
    }
}
