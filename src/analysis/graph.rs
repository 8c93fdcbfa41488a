//! Which file may include which, over a whole workspace: what decides under which root a file is shown.

use std::collections::{BTreeMap, VecDeque};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::includes;
use crate::base::FastSet;
use crate::facts::{FactKind, facts};
use crate::vfs::{SourceFile, Vfs};
use crate::workspace::Packages;
use crate::workspace::config::Pattern;

/// What the graph knows of a file.
#[derive(Clone, Debug)]
struct Node {
    hash: u64,
    /// Whether it looks like a robot: a root element with a name, and a link or a call outside of macros.
    is_root: bool,
    /// What it may include.
    includes: Vec<Pattern>,
}

/// The files of a workspace and their includes, by text alone.
#[derive(Debug, Default)]
pub(super) struct Graph {
    nodes: BTreeMap<PathBuf, Node>,
}

impl Graph {
    /// Look at a file, again only when it changed.
    pub fn update(&mut self, vfs: &Vfs, packages: &Packages, path: &Path) {
        let Ok(source) = vfs.document(path) else {
            self.nodes.remove(path);
            return;
        };
        if self.nodes.get(path).is_none_or(|node| node.hash != source.hash) {
            self.nodes.insert(path.to_path_buf(), node(&source, packages));
        }
    }

    /// The files that were looked at, in the order of their paths.
    pub fn files(&self) -> impl Iterator<Item = &PathBuf> {
        self.nodes.keys()
    }

    /// Whether a file was looked at.
    pub fn knows(&self, path: &Path) -> bool {
        self.nodes.contains_key(path)
    }

    /// Whether a file looks like a robot.
    pub fn is_root(&self, path: &Path) -> bool {
        self.nodes.get(path).is_some_and(|node| node.is_root)
    }

    /// The files that may include `path`.
    fn includers<'a>(&'a self, path: &'a Path) -> impl Iterator<Item = &'a PathBuf> {
        let includes = move |node: &Node| node.includes.iter().any(|pattern| pattern.matches(path));
        self.nodes.iter().filter(move |(from, node)| *from != path && includes(node)).map(|(from, _)| from)
    }

    /// The robots that reach `path` through includes, with the number of includes between; the nearest first,
    /// those of one distance by path. The file itself is left out.
    pub fn roots_of(&self, path: &Path) -> Vec<(PathBuf, u32)> {
        let mut seen: FastSet<PathBuf> = FastSet::from_iter([path.to_path_buf()]);
        let mut found = Vec::new();
        let mut open = VecDeque::from([(path.to_path_buf(), 0)]);
        while let Some((file, distance)) = open.pop_front() {
            for from in self.includers(&file) {
                if seen.insert(from.clone()) {
                    if self.is_root(from) {
                        found.push((from.clone(), distance + 1));
                    }
                    open.push_back((from.clone(), distance + 1));
                }
            }
        }
        found.sort_by(|(a, near), (b, far)| near.cmp(far).then_with(|| a.cmp(b)));
        found
    }
}

fn node(source: &Arc<SourceFile>, packages: &Packages) -> Node {
    let document = &source.document;
    let named = document.root().is_some_and(|root| {
        root.name() == "robot" && root.attr("name").is_some_and(|name| !name.raw().is_empty())
    });
    let gives = |kind: FactKind| matches!(kind, FactKind::Link | FactKind::Call);
    let is_root = named
        && facts(document)
            .any(|(_, facts)| facts.named.iter().any(|fact| gives(fact.kind) && !fact.in_macro));
    Node { hash: source.hash, is_root, includes: includes::patterns(source, packages) }
}
