//! A package that nothing knows.
use std::collections::BTreeSet;
use std::path::Path;

use indexmap::IndexMap;

use super::super::context::{DocumentCx, RuleEnv};
use super::super::finding::{Finding, Help};
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::dependencies;
use base::{Span, TextRange, counted};
use expand::{Expansion, FileIdx, Origin, Read, XAttr, XId};
use facts::may_hold;
use packages::NotFound;

pub(in super::super) static RULE: Rule = Rule {
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
fn is_news(world: RuleEnv<'_>, nearest: Option<&str>) -> bool {
    world.has_ros || nearest.is_some()
}

/// A package that is missing, and where one file names it.
struct MissingPackage {
    error: NotFound,
    /// The package that is meant.
    nearest: Option<String>,
    /// The package of the description, if it has what is named: it had the other name once.
    own: Option<String>,
    places: Vec<Origin>,
    /// Whether a folder around the file has what is named: programs that know no packages look there.
    lies_around: bool,
}

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let mut missing: IndexMap<(FileIdx, String), Option<MissingPackage>> = IndexMap::new();
    for attr in file_names(cx.expansion, cx.element) {
        look_up(cx, attr, &mut missing);
    }
    for missing in missing.into_values().flatten() {
        report(cx, &missing, out);
    }
}

/// Where a robot names packages and not one of them is found, that is one warning, at the first of these names: the
/// packages are not looked for where they are.
pub(in super::super) fn warn_once(
    findings: &mut [Finding],
    expansion: &Expansion,
    world: RuleEnv<'_>,
) {
    let first = findings.iter_mut().find(|finding| *finding.rule == RULE);
    let Some(first) = first.filter(|first| first.severity == Severity::Info) else {
        return;
    };
    let mut missing: Vec<&str> = Vec::new();
    for read in expansion.record.iter() {
        match read {
            Read::Package(_, Some(_)) => return,
            Read::Package(name, None) => missing.push(name),
            _ => {}
        }
    }
    let from = expansion.files.first().map(|file| file.source.path.clone());
    for attr in all_file_names(expansion) {
        let Some(name) = package(attr).filter(|name| !missing.contains(name)) else {
            continue;
        };
        if from
            .as_ref()
            .is_some_and(|from| world.packages.find(name, from).is_ok())
        {
            return;
        }
        missing.push(name);
    }
    // where the own package is found, packages are looked for in the right places, and this one is of others: unless what
    // it should hold is here
    if from.as_ref().is_some_and(|from| {
        world.packages.containing(from).is_some()
            && !all_file_names(expansion).any(|attr| has_file_of(world, attr, from))
            || is_fetched(world, expansion, from)
    }) {
        return;
    }
    // what the package declares is installed along with it, and only not here; a folder around the file with the name of
    // a package is a copy of it
    let manifest = dependencies::of_file(world, expansion, FileIdx(0));
    let is_around = |name: &&str| {
        from.as_ref()
            .is_some_and(|from| from.iter().any(|part| part == *name))
    };
    if missing.iter().any(is_around)
        || manifest.is_some_and(|manifest| missing.iter().any(|name| manifest.declares(name)))
    {
        return;
    }
    let names = missing
        .iter()
        .take(MOST_PLACES)
        .map(|name| format!("`{name}`"))
        .collect::<Vec<_>>()
        .join(", ");
    first.severity = Severity::Warning;
    first.message = "none of the packages of this robot were found".to_owned();
    // what is missing is the same for all robots of a check
    first.group = Some(Group::Thing("packages".into()));
    first.help = Some(format!(
        "source the ROS installation, or pass --package-path (or set `package-path` \
         in xacro-lint.toml); not found: {names}"
    ));
}

/// The packages that an expansion names and that were not found.
pub fn missing_packages(expansion: &Expansion, world: RuleEnv<'_>) -> BTreeSet<String> {
    let named = expansion.record.iter().filter_map(|read| match read {
        Read::Package(name, None) => Some(name.to_string()),
        _ => None,
    });
    let from = expansion.files.first().map(|file| file.source.path.clone());
    let uris = all_file_names(expansion);
    let is_missing = |name: &&str| {
        from.as_ref()
            .is_some_and(|from| world.packages.find(name, from).is_err())
    };
    let names: BTreeSet<&str> = uris.filter_map(package).collect();
    named
        .chain(names.into_iter().filter(is_missing).map(str::to_owned))
        .collect()
}

/// Whether a file of the name that a URI ends with is in the workspace.
fn has_file_of(world: RuleEnv<'_>, attr: &XAttr, from: &Path) -> bool {
    path_in_package(attr).is_some_and(|path| {
        world
            .packages
            .namesake(Path::new(path), None, from)
            .is_some()
    })
}

/// Whether what is missing comes with the sources that a list of repositories brings, or lies in a folder around the file by its path,
/// with the name of the package or without: the folder is the package, and gets its manifest elsewhere.
fn is_fetched(world: RuleEnv<'_>, expansion: &Expansion, from: &Path) -> bool {
    let top = world.packages.sources_around(from);
    let inside = |folder: &&Path| top.as_ref().is_some_and(|top| folder.starts_with(top));
    let folders: Vec<&Path> = from.ancestors().skip(1).take_while(inside).collect();
    let has_list = |folder: &&Path| {
        world
            .vfs
            .list_dir(folder)
            .iter()
            .any(|entry| is_list(&entry.name))
    };
    let is_there = |path: &str| {
        folders
            .iter()
            .any(|folder| world.vfs.is_file(&folder.join(path)))
    };
    let has_file = |attr: &XAttr| {
        path_in_package(attr).is_some_and(is_there) || lies_around(world, &attr.value, from)
    };
    folders.iter().any(has_list) || all_file_names(expansion).any(has_file)
}

/// Whether a file of this name lists the sources that a workspace fetches.
fn is_list(name: &str) -> bool {
    name.ends_with(".repos") || name.ends_with(".rosinstall") || name == ".gitmodules"
}

/// The `filename` attributes of meshes and textures of the whole robot, in document order.
fn all_file_names(expansion: &Expansion) -> impl Iterator<Item = &XAttr> {
    let root = expansion.tree.root();
    root.into_iter()
        .flat_map(|root| file_names(expansion, root))
}

/// The `filename` attributes of meshes and textures, in document order.
fn file_names(expansion: &Expansion, root: XId) -> impl Iterator<Item = &XAttr> {
    let tree = &expansion.tree;
    // where no text has such an element, the document has none
    let mut documents = expansion.files.iter().map(|file| &file.source.document);
    let are_there = documents.any(|document| may_hold(document, |marks| marks.file_tag));
    let is_file = move |&id: &XId| matches!(tree.get(id).text.as_str(), "mesh" | "texture");
    let below = are_there.then(|| std::iter::once(root).chain(tree.below(root)));
    let elements = below.into_iter().flatten().filter(is_file);
    elements.filter_map(move |id| tree.attr(id, "filename"))
}

/// Look for the package that an element names, once for each file and name.
fn look_up(
    cx: &DocumentCx<'_>,
    attr: &XAttr,
    missing: &mut IndexMap<(FileIdx, String), Option<MissingPackage>>,
) {
    let Some(name) = package(attr) else { return };
    let Some(place) = cx.expansion.place(attr.origin) else {
        return;
    };
    let slot = missing
        .entry((place.file, name.to_owned()))
        .or_insert_with(|| {
            let from = cx.expansion.files.get(place.file)?.source.path.clone();
            let error = cx.world.packages.find(name, &from).err()?;
            Some(MissingPackage {
                error,
                nearest: cx.world.packages.meant(name, &from),
                own: own_with(cx.world, attr, &from),
                places: Vec::new(),
                lies_around: lies_around(cx.world, &attr.value, &from),
            })
        });
    if let Some(missing) = slot {
        missing.places.push(name_in_source(attr, name));
    }
}

/// The package of a description, if it has the file that a URI names in another one, which it does not depend on.
fn own_with(world: RuleEnv<'_>, attr: &XAttr, from: &Path) -> Option<String> {
    own_instead(world, package(attr)?, path_in_package(attr)?, from)
}

/// The package of a file, if it has a path that the file names in another package, which it does not depend on: it had that name
/// once, or was copied.
pub fn own_instead(world: RuleEnv<'_>, name: &str, path: &str, from: &Path) -> Option<String> {
    let own = world.packages.containing(from)?;
    let is_here = world.vfs.is_file(&own.folder.join(path));
    let manifest = dependencies::manifest_around(world, from);
    let is_declared = manifest.is_some_and(|manifest| manifest.declares(name));
    (is_here && !is_declared).then(|| own.name.to_string())
}

/// The package of a file that has what `$(find name)` starts the path to. `name`: the place of the name.
fn own_behind_find(world: RuleEnv<'_>, name: Span) -> Option<String> {
    let from = world.vfs.path(name.file);
    let file = world.vfs.text(&from).ok()?;
    let behind = file.text.get(name.range.end as usize..)?.trim_start();
    let path = behind.strip_prefix(')')?.trim_start_matches('/');
    let end = path.find(|c: char| c.is_whitespace() || "\"'$<>".contains(c))?;
    let path = path.get(..end).filter(|path| !path.is_empty())?;
    own_instead(world, name.range.slice(&file.text), path, &from)
}

/// What is missing on a machine without ROS is an info; where the own package has what is named, that may be meant.
pub(in super::super) fn excuse_find(world: RuleEnv<'_>, finding: &mut Finding) {
    // the expander offers a replacement when another package seems to be meant
    if finding.fix.is_some() {
        return;
    }
    if let Some(own) = own_behind_find(world, finding.span) {
        finding.help = Some(format!(
            "if `{own}` is meant, write that: it has the file at the same path"
        ));
    }
    if !is_news(world, None) {
        finding.severity = Severity::Info;
    }
}

/// Whether a folder around a file has what a `package://` URI names, taken as a path.
fn lies_around(world: RuleEnv<'_>, uri: &str, from: &Path) -> bool {
    let top = world.packages.sources_around(from);
    let inside = |folder: &&Path| top.as_ref().is_some_and(|top| folder.starts_with(top));
    let mut folders = from.ancestors().skip(1).take_while(inside);
    uri.strip_prefix("package://")
        .is_some_and(|path| folders.any(|folder| world.vfs.is_file(&folder.join(path))))
}

fn report(cx: &DocumentCx<'_>, missing: &MissingPackage, out: &mut Sink<'_>) {
    let Some((&first, others)) = missing.places.split_first() else {
        return;
    };
    let meant = missing.nearest.as_ref().or(missing.own.as_ref());
    let news = is_news(cx.world, meant.map(String::as_str));
    let severity = if news && !missing.lies_around {
        Severity::Warning
    } else {
        Severity::Info
    };
    let mut report = out
        .report(first, message(&missing.error))
        .severity(severity);
    for &other in others.iter().take(MOST_PLACES) {
        report = report.also(other, "also used here");
    }
    match (&missing.nearest, &missing.own) {
        (Some(near), _) => report
            .help(Help::did_you_mean(near))
            .replace_with(Safety::Unsafe, format!("rename to `{near}`"), near)
            .done(),
        (None, Some(own)) => report
            .help(format!(
                "write `{own}`: the package of this description has the file at the same path"
            ))
            .replace_with(Safety::Unsafe, format!("rename to `{own}`"), own)
            .done(),
        (None, None) => report
            .help("pass its folder with --package-path, or source its workspace")
            .done(),
    }
}

/// The package of a `package://` URI whose beginning is known.
fn package(attr: &XAttr) -> Option<&str> {
    // without a path, it is the name of a file, and the URI is wrong
    let (name, _) = attr.value.strip_prefix("package://")?.split_once('/')?;
    let end = ("package://".len() + name.len()) as u32;
    let known = attr
        .pieces
        .iter()
        .all(|piece| !piece.unknown || piece.out.start > end);
    (known && !name.is_empty()).then_some(name)
}

/// The path behind the package of a `package://` URI.
fn path_in_package(attr: &XAttr) -> Option<&str> {
    let path = attr
        .value
        .strip_prefix("package://")?
        .strip_prefix(package(attr)?)?;
    Some(path.trim_start_matches('/')).filter(|path| !path.is_empty())
}

/// The name in the source; the whole value, or the expression, where the source does not spell it.
fn name_in_source(attr: &XAttr, name: &str) -> Origin {
    let start = "package://".len() as u32;
    let range = TextRange::new(start, start + name.len() as u32);
    match attr.pieces.iter().find(|piece| piece.out.start < range.end) {
        None => Origin {
            range: range.shift(attr.origin.range.start),
            ..attr.origin
        },
        Some(piece) if piece.out.contains_range(range) => piece.source,
        Some(_) => attr.origin,
    }
}

fn message(missing: &NotFound) -> String {
    format!(
        "package `{}` not found (searched {})",
        missing.name,
        counted(missing.tried.len(), "folder")
    )
}
