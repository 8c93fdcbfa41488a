//! What a `package.xml` says about dependencies.
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use roxmltree::{Document, Node, ParsingOptions};

use base::limits::MANIFEST_NODES;
use base::{FastMap, FileId, Span, TextRange};
use packages::Package;
use vfs::TextFile;

/// The elements that make a package come along with another one at run time.
const RUNTIME: [&str; 4] = ["depend", "exec_depend", "run_depend", "build_export_depend"];

/// Manifests, read once for each text they have.
#[derive(Default)]
pub struct Manifests(Mutex<FastMap<FileId, CachedManifest>>);

/// A manifest and the hash of its text; none when it cannot be understood.
type CachedManifest = (u64, Option<Arc<Manifest>>);

impl Manifests {
    pub(super) fn get(
        &self,
        id: FileId,
        text: &TextFile,
        package: Package,
    ) -> Option<Arc<Manifest>> {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, manifest)) = known.get(&id).filter(|(hash, _)| *hash == text.hash) {
            return manifest.clone();
        }
        let manifest = Manifest::read(&text.text, id, package.folder, package.name).map(Arc::new);
        known.insert(id, (text.hash, manifest.clone()));
        manifest
    }
}

/// The manifest of the package that a file belongs to.
pub(super) struct Manifest {
    /// The name of the package.
    pub name: String,
    /// The folder that holds the manifest.
    pub folder: PathBuf,
    file: FileId,
    /// Packages that come along at run time.
    pub runtime: Vec<String>,
    /// Packages that are there when it is built.
    build: Vec<String>,
    /// What comments hold: dependencies that were taken out on purpose, among others.
    comments: Vec<String>,
    /// The tag of the root element, from `<` to the end of its name.
    root: TextRange,
    /// The text of the name.
    name_range: TextRange,
    /// Where a dependency can be added, and what to write around its name.
    insertion: (u32, String, String),
}

impl Manifest {
    /// Whether a package comes along at run time.
    pub fn declares(&self, package: &str) -> bool {
        self.runtime.iter().any(|known| known == package)
    }

    /// Whether a package is declared for the build alone: who builds the package from its sources has it.
    pub fn builds_with(&self, package: &str) -> bool {
        self.build.iter().any(|known| known == package)
    }

    /// Whether a comment holds an element with the name of a package: somebody took it out.
    pub fn leaves_out(&self, package: &str) -> bool {
        let element = format!(">{package}<");
        self.comments.iter().any(|text| text.contains(&element))
    }

    fn read(text: &str, file: FileId, folder: PathBuf, name: String) -> Option<Self> {
        let options = ParsingOptions {
            allow_dtd: true,
            nodes_limit: MANIFEST_NODES,
            ..ParsingOptions::default()
        };
        let document = Document::parse_with_options(text, options).ok()?;
        let root = document.root_element();
        let declared = |tags: &[&str]| -> Vec<String> {
            root.children()
                .filter(|node| node.is_element() && tags.contains(&node.tag_name().name()))
                .filter_map(|node| Some(node.text()?.trim().to_owned()))
                .collect()
        };
        let comments = root.descendants().filter(Node::is_comment);
        let comments = comments
            .filter_map(|node| Some(node.text()?.to_owned()))
            .collect();
        let start = root.range().start as u32;
        let name_node = root
            .children()
            .find(|node| node.is_element() && node.tag_name().name() == "name");
        let name_text = name_node
            .and_then(|node| node.first_child())
            .map_or(0..0, |text| text.range());
        Some(Self {
            name,
            folder,
            file,
            runtime: declared(&RUNTIME),
            build: declared(&["build_depend"]),
            comments,
            root: TextRange::new(start, start + 1 + root.tag_name().name().len() as u32),
            name_range: TextRange::new(name_text.start as u32, name_text.end as u32),
            insertion: insertion(text, root),
        })
    }

    /// The start of the manifest.
    pub fn start(&self) -> Span {
        Span {
            file: self.file,
            range: self.root,
        }
    }

    /// The name of the package.
    pub fn name_span(&self) -> Span {
        Span {
            file: self.file,
            range: self.name_range,
        }
    }

    /// The text that adds a dependency, and where it goes.
    pub fn addition(&self, package: &str) -> (Span, String) {
        let (at, before, behind) = &self.insertion;
        let span = Span {
            file: self.file,
            range: TextRange::empty(*at),
        };
        (span, format!("{before}{package}{behind}"))
    }
}

/// Behind the last dependency in its style, else in front of the end tag.
fn insertion(text: &str, root: Node<'_, '_>) -> (u32, String, String) {
    let old = root
        .attribute("format")
        .is_none_or(|format| format.trim() == "1");
    let tag = if old { "run_depend" } else { "exec_depend" };
    let elements: Vec<Node<'_, '_>> = root.children().filter(Node::is_element).collect();
    let last = elements
        .iter()
        .rev()
        .find(|node| node.tag_name().name().ends_with("depend"));
    let (at, indent) = match last.or(elements.last()) {
        Some(last) => {
            let start = last.range().start;
            let line = text
                .get(..start)
                .unwrap_or_default()
                .rsplit('\n')
                .next()
                .unwrap_or_default();
            (
                last.range().end,
                if line.trim().is_empty() { line } else { "  " },
            )
        }
        None => (root.range().end.saturating_sub("</package>".len()), "  "),
    };
    (at as u32, format!("\n{indent}<{tag}>"), format!("</{tag}>"))
}

#[cfg(test)]
mod tests {
    use super::Manifest;
    use base::FileId;

    fn added(text: &str) -> String {
        let manifest = Manifest::read(text, FileId(0), "p".into(), "p".to_owned()).unwrap();
        let (span, addition) = manifest.addition("x");
        let at = span.range.start as usize;
        format!("{}{addition}{}", &text[..at], &text[at..])
    }

    #[test]
    fn a_dependency_is_added_in_the_style_of_the_file() {
        let modern = "<package format='3'>\n    <name>p</name>\n    <depend>a</depend>\n    <export/>\n</package>";
        let expected = modern.replace("</depend>", "</depend>\n    <exec_depend>x</exec_depend>");
        assert_eq!(added(modern), expected);
        let old = "<package>\n <name>p</name>\n</package>";
        assert_eq!(
            added(old),
            "<package>\n <name>p</name>\n <run_depend>x</run_depend>\n</package>"
        );
    }

    #[test]
    fn what_comes_along_at_run_time() {
        let text = "<package><name>p</name><depend>a</depend><build_depend>b</build_depend>\
                    <exec_depend condition=\"$ROS_VERSION == 2\"> c </exec_depend></package>";
        let manifest = Manifest::read(text, FileId(0), "p".into(), "p".to_owned()).unwrap();
        assert_eq!(manifest.runtime, ["a", "c"]);
        let name = manifest.name_span().range;
        assert_eq!(name.slice(text), "p");
    }
}
