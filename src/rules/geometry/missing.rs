//! Reporting a file that is not there.

use std::path::Path;

use super::super::context::DocumentCx;
use super::super::registry::Safety;
use super::super::sink::Sink;
use crate::model::Text;

/// Report that the file `name` leads to is missing; `what` is what needs it.
pub(super) fn report(
    cx: &DocumentCx<'_>,
    out: &mut Sink<'_>,
    name: &Text,
    what: &str,
    missing: &Path,
    package: Option<&Path>,
) {
    let place = cx.expansion.place(name.origin);
    let source = place.and_then(|place| cx.expansion.files.get(place.file.0 as usize));
    let from = source.map(|file| file.source.path.clone());
    let found = from.and_then(|from| cx.world.packages.namesake(missing, package, &from));
    let report = out.report(name.origin, format!("{what} is not found at `{}`", missing.display()));
    let Some(found) = found else {
        return report.help("correct the path, or add the file").done();
    };
    let report = report.help(format!("a file of this name is at `{}`", found.display()));
    match uri_of(cx, name, &found).filter(|_| name.literal) {
        Some(uri) => report.replace_with(Safety::Unsafe, format!("write `{uri}`"), uri).done(),
        None => report.done(),
    }
}

/// How a file is named in place of `name`.
fn uri_of(cx: &DocumentCx<'_>, name: &Text, file: &Path) -> Option<String> {
    if !name.value.starts_with("package://") && name.value.contains("://") {
        return None;
    }
    let package = cx.world.packages.containing(file);
    if let Some(package) = package.filter(|_| name.value.starts_with("package://")) {
        let inside = file.strip_prefix(&package.folder).ok()?.to_str()?;
        return Some(format!("package://{}/{inside}", package.name));
    }
    let place = cx.expansion.place(name.origin)?;
    let source = &cx.expansion.files.get(place.file.0 as usize)?.source.path;
    Some(file.strip_prefix(source.parent()?).ok()?.to_str()?.to_owned())
}
