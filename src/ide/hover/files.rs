//! Files and packages: where names lead, and what is there.

use super::super::context::Cx;
use super::super::expressions::ExprText;
use super::super::locate::{LocatedNode, NodePart};
use super::super::paths::{FileKind, FileName, FileTarget, file_name_at};
use super::super::values::number_text;
use super::page::{Page, code};
use base::{TextRange, counted};
use model::{AttrValue, Mesh};
use rules::RuleEnv;

/// Most places that are listed.
const MOST_PLACES: usize = 8;

/// The name of a file at a place.
pub(super) fn about(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    at: &LocatedNode<'_>,
) -> Option<(TextRange, Page)> {
    let name = file_name_at(cx, world, at)?;
    Some((name.range, page(cx, world, at, &name)))
}

/// The file that `load_yaml` reads, when its name stands at an offset of an expression.
pub(super) fn loaded(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    text: &ExprText<'_>,
    offset: u32,
) -> Option<(TextRange, Page)> {
    let at = super::super::locate::locate(&cx.source.document, offset);
    let name = file_name_at(cx, world, &at).filter(|name| name.kind == FileKind::Yaml)?;
    text.whole()
        .contains_range(name.range)
        .then(|| (name.range, page(cx, world, &at, &name)))
}

fn page(cx: &Cx<'_>, world: RuleEnv<'_>, at: &LocatedNode<'_>, name: &FileName) -> Page {
    let path = match &name.target {
        FileTarget::Found(path) => path,
        FileTarget::Missing(places) => {
            let mut page = Page::titled("not found; searched");
            page.list(
                places
                    .iter()
                    .take(MOST_PLACES)
                    .map(|place| code(&vfs::slashed(place))),
            );
            return page;
        }
    };
    let mut page = Page::titled(code(&vfs::slashed(path)));
    if name.kind == FileKind::Mesh && world.vfs.is_file(path) {
        let mesh = world.meshes.get(world.vfs, path);
        mesh_lines(&mesh, factors(cx, at))
            .into_iter()
            .for_each(|line| page.add(line));
    } else if let Some(bytes) = world.vfs.size(path) {
        page.add(size(bytes));
    }
    page
}

/// The scale of a mesh, when it is known.
fn factors(cx: &Cx<'_>, at: &LocatedNode<'_>) -> Option<[f64; 3]> {
    let (NodePart::AttrValue(attr), Some(node)) = (at.part, at.node) else {
        return None;
    };
    if node.attr("scale").is_none() {
        return Some([1.0; 3]);
    }
    let place = cx.source_range(attr.value_range().shift(at.base))?;
    let tree = &cx.expansion.tree;
    let is_named = |id: &expand::XId| {
        tree.attr(*id, "filename")
            .is_some_and(|file| expand::SourceRange::from(file.origin) == place)
    };
    let mesh = tree.below(expand::XId::DOCUMENT).find(is_named)?;
    AttrValue::attr(tree, mesh, "scale")?.numbers()
}

fn mesh_lines(mesh: &Mesh, factors: Option<[f64; 3]>) -> Vec<String> {
    let mut lines = Vec::new();
    if let Some(surface) = &mesh.surface {
        lines.push(format!(
            "{:?}, {}",
            mesh.format,
            counted(surface.triangles, "triangle")
        ));
        match factors {
            Some(factors) => {
                let bounds = surface.bounds.scaled(factors);
                lines.push(format!("{} m", lengths(bounds.size())));
                if bounds.extent() > 10.0 {
                    lines.push(
                        "this looks like millimeters: `scale=\"0.001 0.001 0.001\"` converts to meters"
                            .to_owned(),
                    );
                }
            }
            None => lines.push(format!("{} before scaling", lengths(surface.bounds.size()))),
        }
    }
    lines.extend(
        mesh.defect
            .as_ref()
            .map(|defect| format!("**{}**", defect.message)),
    );
    lines
}

/// `0.1 × 0.2 × 0.3`, three digits that count
pub(super) fn lengths(size: [f64; 3]) -> String {
    size.map(three_digits).join(" × ")
}

/// A number with three digits that count.
pub(super) fn three_digits(number: f64) -> String {
    let rounded: f64 = format!("{number:.2e}").parse().unwrap_or(number);
    let text = number_text(rounded);
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}

fn size(bytes: u64) -> String {
    match bytes {
        0..10_000 => format!("{bytes} bytes"),
        10_000..10_000_000 => format!("{} kB", bytes / 1000),
        _ => format!("{} MB", bytes / 1_000_000),
    }
}

/// A package.
pub(super) fn package(cx: &Cx<'_>, world: RuleEnv<'_>, name: &str) -> Page {
    match world.packages.find(name, &cx.source.path) {
        Ok(found) => {
            let path = world.vfs.absolute(&found.path);
            let mut page = Page::titled(format!("**package** {}", code(name)));
            page.add(code(&vfs::slashed(&path)));
            page
        }
        Err(missing) => {
            let mut page = Page::titled(format!("**package** {} not found; searched", code(name)));
            let places = missing.tried.iter().take(MOST_PLACES);
            page.list(places.map(|(_, place)| code(&vfs::slashed(place))));
            if let Some(near) = world.packages.meant(name, &cx.source.path) {
                page.add(format!("did you mean {}?", code(&near)));
            }
            page
        }
    }
}
