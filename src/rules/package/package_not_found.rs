//! A package that nothing knows.

use indexmap::IndexMap;

use super::super::context::{DocumentCx, Surroundings};
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use crate::base::TextRange;
use crate::expand::{FileIdx, Origin, XAttr, XId};
use crate::workspace::NotFound;

pub(super) const RULE: Rule = Rule {
    code: "PKG001",
    name: "package-not-found",
    category: Category::Package,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page!("package-not-found"),
    // that of `$(find)` is said by the expander
    check: Check::Document(check),
};

/// Further places listed with a finding.
const MOST_PLACES: usize = 10;

/// Whether a missing package is a defect: without any ROS, packages of others are missing everywhere.
pub(in super::super) fn is_news(world: Surroundings<'_>, nearest: Option<&str>) -> bool {
    world.has_ros || nearest.is_some()
}

/// A package that is missing, and where one file names it.
struct Missing {
    error: NotFound,
    places: Vec<Origin>,
}

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let mut missing: IndexMap<(FileIdx, String), Option<Missing>> = IndexMap::new();
    let mut open = vec![cx.element];
    while let Some(element) = open.pop() {
        let node = cx.expansion.tree.get(element);
        if matches!(node.text.as_str(), "mesh" | "texture") {
            look_up(cx, element, &mut missing);
        }
        let start = open.len();
        open.extend(cx.expansion.tree.elements(element));
        open.get_mut(start..).into_iter().for_each(<[XId]>::reverse);
    }
    for Missing { error, places } in missing.into_values().flatten() {
        report(cx, &error, &places, out);
    }
}

/// Look for the package that an element names, once for each file and name.
fn look_up(cx: &DocumentCx<'_>, element: XId, missing: &mut IndexMap<(FileIdx, String), Option<Missing>>) {
    let Some(attr) = cx.expansion.tree.attr(element, "filename") else { return };
    let Some(name) = package(attr) else { return };
    let Some(place) = cx.expansion.place(attr.origin) else { return };
    let slot = missing.entry((place.file, name.to_owned())).or_insert_with(|| {
        let from = cx.expansion.files.get(place.file.0 as usize)?.source.path.clone();
        let error = cx.world.packages.find(name, &from).err()?;
        Some(Missing { error, places: Vec::new() })
    });
    if let Some(missing) = slot {
        missing.places.push(name_in_source(attr, name));
    }
}

fn report(cx: &DocumentCx<'_>, missing: &NotFound, places: &[Origin], out: &mut Sink<'_>) {
    let Some((&first, others)) = places.split_first() else { return };
    let news = is_news(cx.world, missing.nearest.as_deref());
    let severity = if news { Severity::Warning } else { Severity::Info };
    let mut report = out.report(first, message(missing)).severity(severity);
    for &other in others.iter().take(MOST_PLACES) {
        report = report.also(other, "named here too");
    }
    match &missing.nearest {
        Some(near) => report
            .help(format!("a package with a similar name exists: `{near}`"))
            .replace_with(Safety::Unsafe, format!("rename it to `{near}`"), near)
            .done(),
        None => report.help("name its folder with --package-path, or source its workspace").done(),
    }
}

/// The package of a `package://` URI whose beginning is known.
fn package(attr: &XAttr) -> Option<&str> {
    let name = attr.value.strip_prefix("package://")?.split('/').next()?;
    let end = ("package://".len() + name.len()) as u32;
    let known = attr.pieces.iter().all(|piece| !piece.unknown || piece.out.start > end);
    (known && !name.is_empty()).then_some(name)
}

/// The name in the source; the whole value, or the expression, where the source does not spell it.
fn name_in_source(attr: &XAttr, name: &str) -> Origin {
    let start = "package://".len() as u32;
    let range = TextRange::new(start, start + name.len() as u32);
    match attr.pieces.iter().find(|piece| piece.out.start < range.end) {
        None => Origin { range: range.shift(attr.origin.range.start), ..attr.origin },
        Some(piece) if piece.out.contains_range(range) => piece.source,
        Some(_) => attr.origin,
    }
}

fn message(missing: &NotFound) -> String {
    format!("package `{}` is not found (looked in {} places)", missing.name, missing.tried.len())
}
