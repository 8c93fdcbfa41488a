//! A length of a shape that is zero or less.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::shapes::bodies;
use crate::model::{ShapeKind, Text};

pub(super) const RULE: Rule = Rule {
    code: "GEO013",
    name: "non-positive-dimension",
    category: Category::Geometry,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page!("non-positive-dimension"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (link, body, is_collision) in bodies(cx) {
        for shape in body.geometry.iter().flat_map(|geometry| &geometry.shapes) {
            let lengths: Vec<(&str, &Text, Vec<f64>)> = match &shape.kind {
                ShapeKind::Box { size } => length("size", size, |text| Some(text.numbers::<3>()?.to_vec())),
                ShapeKind::Cylinder { radius, length: along } => {
                    let mut found = length("radius", radius, |text| Some(vec![text.number()?]));
                    found.extend(length("length", along, |text| Some(vec![text.number()?])));
                    found
                }
                ShapeKind::Sphere { radius } => length("radius", radius, |text| Some(vec![text.number()?])),
                ShapeKind::Mesh { .. } | ShapeKind::Other => Vec::new(),
            };
            for (name, text, numbers) in lengths {
                if numbers.iter().all(|&number| number > 0.0) {
                    continue;
                }
                // a box without height is drawn as a plane
                let is_plane =
                    !is_collision && numbers.len() == 3 && numbers.iter().all(|&number| number >= 0.0);
                let severity = if is_plane { Severity::Warning } else { Severity::Error };
                let message = format!("link `{}`: `{name}` of a shape is not positive", link.shown());
                out.report(text.origin, message)
                    .severity(severity)
                    .help("lengths are greater than zero, in metres")
                    .done();
            }
        }
    }
}

fn length<'a>(
    name: &'static str,
    text: &'a Option<Text>,
    numbers: impl Fn(&Text) -> Option<Vec<f64>>,
) -> Vec<(&'static str, &'a Text, Vec<f64>)> {
    text.iter().filter_map(|text| Some((name, text, numbers(text)?))).collect()
}
