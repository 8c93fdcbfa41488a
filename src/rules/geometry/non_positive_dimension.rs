//! A length of a shape that is zero or less.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::shapes::bodies;
use model::{AttrValue, Link, ShapeKind};

pub(in super::super) static RULE: Rule = Rule {
    code: "GEO013",
    name: "non-positive-dimension",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("non-positive-dimension"),
    check: Check::Link(check),
};

fn check(_: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    for (body, is_collision) in bodies(link) {
        for shape in body.geometry.iter().flat_map(|geometry| &geometry.shapes) {
            let lengths: Vec<(&str, &AttrValue, Vec<f64>)> = match &shape.kind {
                ShapeKind::Box { size } => {
                    length("size", size, |text| Some(text.numbers::<3>()?.to_vec()))
                }
                ShapeKind::Cylinder {
                    radius,
                    length: along,
                }
                | ShapeKind::Capsule {
                    radius,
                    length: along,
                } => {
                    let mut found = length("radius", radius, |text| Some(vec![text.number()?]));
                    found.extend(length("length", along, |text| Some(vec![text.number()?])));
                    found
                }
                ShapeKind::Sphere { radius } => {
                    length("radius", radius, |text| Some(vec![text.number()?]))
                }
                ShapeKind::Mesh { .. } | ShapeKind::Other => Vec::new(),
            };
            // a shape without any extent is a stand-in that hits nothing, and a box with one is a floor: both on purpose
            let zeros = lengths
                .iter()
                .flat_map(|(_, _, numbers)| numbers)
                .filter(|&&number| number == 0.0)
                .count();
            let all: usize = lengths.iter().map(|(_, _, numbers)| numbers.len()).sum();
            let is_meant =
                zeros == all || zeros == 1 && matches!(shape.kind, ShapeKind::Box { .. });
            for (name, text, numbers) in lengths {
                if numbers.iter().all(|&number| number > 0.0) {
                    continue;
                }
                // readers accept a length of zero, and nothing is drawn or hit; a negative one is never meant
                let is_negative = numbers.iter().any(|&number| number < 0.0);
                let is_defect = is_negative || is_collision && !is_meant;
                let severity = if is_defect {
                    Severity::Warning
                } else {
                    Severity::Info
                };
                let message = format!(
                    "`{name}` of a shape of link `{}` is not positive",
                    link.shown()
                );
                out.report(text.origin, message)
                    .severity(severity)
                    .help("write a length greater than 0, in meters")
                    .done();
            }
        }
    }
}

fn length<'a>(
    name: &'static str,
    text: &'a Option<AttrValue>,
    numbers: impl Fn(&AttrValue) -> Option<Vec<f64>>,
) -> Vec<(&'static str, &'a AttrValue, Vec<f64>)> {
    text.iter()
        .filter_map(|text| Some((name, text, numbers(text)?)))
        .collect()
}
