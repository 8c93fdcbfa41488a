//! Files and folders in values that name a file.

use std::path::{Path, PathBuf};

use super::evaluate::Evaluator;
use super::item::{Completion, Completions, ItemKind, escaped};
use super::scope::CompletionScope;
use super::substitutions;
use crate::typed::Typed;
use vfs::without_parents;

/// Which files are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum WantedFile {
    Mesh,
    Picture,
    Description,
    Yaml,
}

impl WantedFile {
    fn endings(self) -> &'static [&'static str] {
        match self {
            WantedFile::Mesh => &["stl", "dae", "obj", "glb"],
            WantedFile::Picture => &["png", "jpg", "jpeg"],
            WantedFile::Description => &[
                "xacro",
                "urdf",
                "xml",
                "gazebo",
                "transmission",
                "trans",
                "sdf",
                "srdf",
            ],
            WantedFile::Yaml => &["yaml", "yml"],
        }
    }

    /// Whether it may be the file of the name.
    fn takes(self, name: &str) -> bool {
        let ending = name
            .rsplit_once('.')
            .map_or("", |(_, ending)| ending)
            .to_ascii_lowercase();
        self.endings().contains(&ending.as_str()) && name != "package.xml"
    }

    fn takes_uris(self) -> bool {
        matches!(self, WantedFile::Mesh | WantedFile::Picture)
    }
}

impl CompletionScope<'_> {
    /// Whether the names in a folder may be told: it belongs to the workspace or to a package.
    pub(super) fn may_list(&self, folder: &Path) -> bool {
        let folder = without_parents(folder);
        self.sources
            .folders
            .iter()
            .any(|own| folder.starts_with(own))
            || self
                .sources
                .packages
                .containing(&folder.join("package.xml"))
                .is_some()
            || [&*self.sources.source.path, self.sources.root]
                .iter()
                .any(|file| file.parent() == Some(&folder))
    }
}

/// Files for a value, or a part of one, of which `text` was typed so far.
pub(super) fn in_text(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    text: &str,
    wanted: WantedFile,
) -> Completions {
    if let Some(name) = text
        .strip_prefix("package://")
        .filter(|rest| !rest.contains('/'))
    {
        let rest = typed.rest_of_word(is_file_char);
        let closed = typed
            .after
            .get(rest as usize..)
            .is_some_and(|after| after.starts_with('/'));
        let end = if closed { "" } else { "/" };
        let packages = substitutions::packages(scope).into_iter().map(|item| {
            let text = format!("{}{end}", item.label);
            item.text(text)
        });
        return Completions::new(
            typed.offset - name.len() as u32,
            typed.offset,
            rest,
            packages.collect(),
        );
    }
    let (folder, word) = match text.rsplit_once('/') {
        Some((folder, word)) => (Some(folder), word),
        None => (None, text),
    };
    let mut items = match listed(scope, typed, folder) {
        Some(path) => from_last_named(typed, entries(scope, &path, wanted)),
        None => Vec::new(),
    };
    if folder.is_none() {
        items.extend(beginnings(scope, wanted));
    }
    let rest = typed.rest_of_word(is_file_char);
    Completions::new(typed.offset - word.len() as u32, typed.offset, rest, items)
}

fn is_file_char(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '-' | '.')
}

/// The folder that the first part of a value names.
fn listed(scope: &CompletionScope<'_>, typed: &Typed<'_>, folder: Option<&str>) -> Option<PathBuf> {
    let own = &scope.sources.source.path;
    let Some(folder) = folder else {
        return own.parent().map(Path::to_path_buf);
    };
    let folder = if folder.contains('$') {
        Evaluator::new(scope, typed.offset).string(folder)?
    } else {
        folder.to_owned()
    };
    let path = match folder.strip_prefix("package://") {
        Some(rest) => {
            let (package, inside) = rest.split_once('/').unwrap_or((rest, ""));
            scope
                .sources
                .packages
                .find(package, own)
                .ok()?
                .path
                .join(inside)
        }
        None => own
            .parent()?
            .join(folder.strip_prefix("file://").unwrap_or(&folder)),
    };
    let path = scope
        .sources
        .packages
        .present(&without_parents(&path))
        .into_owned();
    scope.may_list(&path).then_some(path)
}

/// What lies in a folder and can be named.
fn entries(scope: &CompletionScope<'_>, folder: &Path, wanted: WantedFile) -> Vec<Completion> {
    let vfs = scope.sources.vfs;
    let names = vfs.list_dir(folder);
    let visible = names.iter().filter(|entry| !entry.name.starts_with('.'));
    visible
        .filter(|entry| entry.is_dir || wanted.takes(&entry.name))
        .filter(|entry| *folder.join(&entry.name) != *scope.sources.source.path)
        .map(|entry| {
            if entry.is_dir {
                let text = format!("{}/", entry.name);
                Completion::new(ItemKind::Folder, entry.name.clone())
                    .text(text)
                    .rank(3)
            } else {
                let size = vfs
                    .size(&folder.join(&entry.name))
                    .map(readable)
                    .unwrap_or_default();
                Completion::new(ItemKind::File, entry.name.clone())
                    .note(size)
                    .rank(1)
            }
        })
        .collect()
}

/// Entries in an order that begins with the one that the text in front named last: what follows it in the folder mostly follows it in
/// the robot, too.
fn from_last_named(typed: &Typed<'_>, mut items: Vec<Completion>) -> Vec<Completion> {
    let text = typed.text_before.strip_suffix(typed.before).unwrap_or("");
    let named = items
        .iter()
        .enumerate()
        .filter(|(_, item)| item.kind == ItemKind::File);
    let named =
        named.filter_map(|(place, item)| Some((text.rfind(&format!("/{}", item.label))?, place)));
    if let Some((_, place)) = named.max() {
        items.rotate_left(place);
    }
    items
}

/// How a value can begin.
fn beginnings(scope: &CompletionScope<'_>, wanted: WantedFile) -> Vec<Completion> {
    let own = scope
        .sources
        .packages
        .containing(&scope.sources.source.path)
        .map(|package| package.name);
    let mut items = Vec::new();
    if wanted.takes_uris() {
        items.push(beginning(
            "package://".to_owned(),
            "package://$1".to_owned(),
        ));
        items.extend(
            own.iter().map(|name| {
                beginning(format!("package://{name}/"), format!("package://{name}/$1"))
            }),
        );
    }
    items.extend(own.iter().map(|name| {
        let text = format!("$(find {name})/");
        let lead = if wanted.takes_uris() { "file://" } else { "" };
        beginning(
            format!("{lead}{text}"),
            format!("{lead}{}$1", escaped(&text)),
        )
    }));
    items.push(beginning(
        "$(find )/".to_owned(),
        "\\$(find $1)/$2".to_owned(),
    ));
    items
}

fn beginning(text: String, snippet: String) -> Completion {
    Completion::new(ItemKind::Snippet, text)
        .snippet(snippet)
        .rank(2)
}

/// A number of bytes for people.
fn readable(bytes: u64) -> String {
    match bytes {
        0..1024 => format!("{bytes} B"),
        1024..1_048_576 => format!("{:.1} KiB", bytes as f64 / 1024.0),
        _ => format!("{:.1} MiB", bytes as f64 / 1_048_576.0),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn sizes() {
        assert_eq!(
            [600, 2048, 3 << 20].map(super::readable),
            ["600 B", "2.0 KiB", "3.0 MiB"]
        );
    }
}
