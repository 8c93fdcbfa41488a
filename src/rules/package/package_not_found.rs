//! A package that nothing knows.

use indexmap::IndexMap;

use super::super::context::{DocumentCx, Surroundings};
use super::super::finding::Finding;
use super::super::grouping::Group;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::manifest;
use base::TextRange;
use expand::{Expansion, FileIdx, Origin, Read, XAttr, XId};
use workspace::NotFound;

pub(super) const RULE: Rule = Rule {
    code: "PKG001",
    name: "package-not-found",
    category: Category::Package,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("package-not-found"),
    // that of `$(find)` is said by the expander
    check: Check::Document(check),
};

/// Further places listed with a finding.
const MOST_PLACES: usize = 10;

/// Whether a missing package is a defect: without any ROS, packages of others are missing everywhere, and only a name
/// that seems misspelled is one.
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
    for attr in file_names(cx.expansion, cx.element) {
        look_up(cx, attr, &mut missing);
    }
    for Missing { error, places } in missing.into_values().flatten() {
        report(cx, &error, &places, out);
    }
}

/// Where a robot names packages and not one of them is found, that is one warning, at the first of these names: the
/// packages are not looked for where they are.
pub(in super::super) fn warn_once(findings: &mut [Finding], expansion: &Expansion, world: Surroundings<'_>) {
    let mut missing: Vec<&str> = Vec::new();
    for read in expansion.record.iter() {
        match read {
            Read::Package(_, Some(_)) => return,
            Read::Package(name, None) => missing.push(name),
            _ => {}
        }
    }
    let from = expansion.files.first().map(|file| file.source.path.clone());
    for attr in expansion.tree.root().into_iter().flat_map(|root| file_names(expansion, root)) {
        let Some(name) = package(attr).filter(|name| !missing.contains(name)) else { continue };
        if from.as_ref().is_some_and(|from| world.packages.find(name, from).is_ok()) {
            return;
        }
        missing.push(name);
    }
    // what the package declares is installed along with it, and only not here; a folder around the file with the name of
    // a package is a copy of it
    let manifest = manifest::of_file(world, expansion, FileIdx(0));
    let is_around = |name: &&str| from.as_ref().is_some_and(|from| from.iter().any(|part| part == *name));
    if missing.iter().any(is_around)
        || manifest.is_some_and(|manifest| missing.iter().any(|name| manifest.declares(name)))
    {
        return;
    }
    let first = findings.iter_mut().find(|finding| finding.rule.code == RULE.code);
    let Some(first) = first.filter(|first| first.severity == Severity::Info) else { return };
    let names =
        missing.iter().take(MOST_PLACES).map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    first.severity = Severity::Warning;
    first.message = "no package that this robot names is found".to_owned();
    // what is missing is the same for all robots of a check
    first.group = Some(Group::Thing("packages".into()));
    first.help = Some(format!(
        "looked for {names}: packages are found in the workspace, in the folders of --package-path (or `package-path` \
         in xacro-lint.toml) and in a sourced ROS"
    ));
}

/// The `filename` attributes of meshes and textures, in document order.
fn file_names(expansion: &Expansion, root: XId) -> Vec<&XAttr> {
    let mut found = Vec::new();
    let mut open = vec![root];
    while let Some(element) = open.pop() {
        let node = expansion.tree.get(element);
        if matches!(node.text.as_str(), "mesh" | "texture") {
            found.extend(expansion.tree.attr(element, "filename"));
        }
        let start = open.len();
        open.extend(expansion.tree.elements(element));
        open.get_mut(start..).into_iter().for_each(<[XId]>::reverse);
    }
    found
}

/// Look for the package that an element names, once for each file and name.
fn look_up(cx: &DocumentCx<'_>, attr: &XAttr, missing: &mut IndexMap<(FileIdx, String), Option<Missing>>) {
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
