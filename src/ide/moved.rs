//! Names of files after files or folders were moved.

use std::path::{Path, PathBuf};

use super::context::Cx;
use super::paths::{FileTarget, file_names};
use base::TextRange;
use rules::RuleEnv;
use vfs::{relative, slashed};

/// A file or folder that gets another path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Move {
    /// The path it has.
    pub old: PathBuf,
    /// The path it will have.
    pub new: PathBuf,
}

/// The path that a path will be after the moves.
fn moved(path: &Path, moves: &[Move]) -> PathBuf {
    let by = |each: &Move| {
        let rest = path.strip_prefix(&each.old).ok()?;
        Some(if rest.as_os_str().is_empty() {
            each.new.clone()
        } else {
            each.new.join(rest)
        })
    };
    moves
        .iter()
        .find_map(by)
        .unwrap_or_else(|| path.to_path_buf())
}

/// The texts of the file that name other files, as they have to read after the moves.
pub fn renamed_files(cx: &Cx<'_>, world: RuleEnv<'_>, moves: &[Move]) -> Vec<(TextRange, String)> {
    let mut found = Vec::new();
    for name in file_names(cx, world) {
        let FileTarget::Found(target) = name.target else {
            continue;
        };
        let text = cx.source.document.slice(name.range);
        let (head, tail) = split(&text);
        let new = moved(&target, moves);
        // what stands in front of the written path: the folder of the file, of a package, or what an expression gives
        let folder = match head {
            "" => cx.source.path.parent().map(Path::to_path_buf),
            _ => stripped(&target, tail),
        };
        let Some(folder) = folder else { continue };
        let base = match head {
            "" => moved(&cx.source.path, moves)
                .parent()
                .map(Path::to_path_buf),
            _ => Some(moved(&folder, moves)),
        };
        let Some(base) = base.filter(|base| new != target || *base != folder) else {
            continue;
        };
        let renamed = match (
            tail.starts_with('/') && head.is_empty(),
            new.strip_prefix(&base),
        ) {
            (true, _) => Some(slashed(&new)),
            (_, Ok(rest)) => Some(format!("{head}{}", slashed(rest))),
            _ if head.is_empty() => Some(slashed(&relative(&base, &new))),
            _ => in_package(world, head, &new),
        };
        found.extend(
            renamed
                .filter(|renamed| *renamed != text)
                .map(|renamed| (name.range, renamed)),
        );
    }
    found
}

/// A name in what leads to a folder, with the slash behind it, and the path from there.
fn split(text: &str) -> (&str, &str) {
    let at = match text
        .strip_prefix("package://")
        .and_then(|rest| rest.find('/'))
    {
        Some(end) => "package://".len() + end + 1,
        None if text.starts_with("file://") => "file://".len(),
        None => match text.rfind(['}', ')']) {
            Some(close) => {
                let rest = text.get(close + 1..).unwrap_or("");
                close + 1 + rest.find('/').map_or(0, |slash| slash + 1)
            }
            None => 0,
        },
    };
    (text.get(..at).unwrap_or(""), text.get(at..).unwrap_or(""))
}

/// The folder from which `tail` leads to a path.
fn stripped(target: &Path, tail: &str) -> Option<PathBuf> {
    if tail.starts_with('/') {
        return Some(PathBuf::from("/"));
    }
    let mut folder = target.to_path_buf();
    for part in tail
        .split('/')
        .rev()
        .filter(|part| !part.is_empty() && *part != ".")
    {
        if folder.file_name()?.to_str()? != part || !folder.pop() {
            return None;
        }
    }
    Some(folder)
}

/// The name of a path in the package that holds it, written as `head` is.
fn in_package(world: RuleEnv<'_>, head: &str, path: &Path) -> Option<String> {
    let package = world.packages.containing(path)?;
    if head.starts_with("package://") {
        return package.uri(path);
    }
    let is_find =
        head.starts_with("$(find ") && head.ends_with(")/") && head.matches('$').count() == 1;
    let inside = package.inside(path).filter(|_| is_find)?;
    Some(format!("$(find {})/{inside}", package.name))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{split, stripped};

    #[test]
    fn names_are_split_behind_what_leads_to_a_folder() {
        for (text, head) in [
            ("unit.xacro", ""),
            ("../a/unit.xacro", ""),
            ("package://arm/meshes/a.stl", "package://arm/"),
            ("$(find arm)/urdf/a.xacro", "$(find arm)/"),
            // the name itself is computed: what is left leads nowhere
            ("$(find arm)/urdf/${name}.xacro", "$(find arm)/urdf/${name}"),
            ("file:///a/b.stl", "file://"),
        ] {
            assert_eq!(split(text).0, head);
        }
    }

    #[test]
    fn folders_in_front_of_a_path() {
        assert_eq!(
            stripped(Path::new("/w/arm/m/a.stl"), "m/a.stl").unwrap(),
            Path::new("/w/arm")
        );
        assert_eq!(stripped(Path::new("/w/arm/m/a.stl"), "n/a.stl"), None);
    }
}
