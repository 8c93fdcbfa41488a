//! Which file may include which, over a whole workspace: what decides under which root a file is shown.
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::includes;
use base::{FastMap, FastSet};
use facts::{FactKind, facts};
use packages::Packages;
use vfs::{SourceFile, Vfs};
use workspace::config::Pattern;
use xml::Document;

/// What the graph knows of a file.
#[derive(Clone, Debug)]
struct GraphNode {
    hash: u64,
    /// Whether it looks like a robot: a root element with a name, and a link or a call outside of macros.
    is_root: bool,
    /// What it may include.
    includes: Vec<Pattern>,
}

/// The files of a workspace and their includes, by text alone.
#[derive(Debug, Default)]
pub(super) struct Graph {
    nodes: BTreeMap<PathBuf, GraphNode>,
    /// Who includes a path that is written out.
    literal: FastMap<PathBuf, BTreeSet<PathBuf>>,
    /// The files whose includes are partly computed.
    computed: BTreeSet<PathBuf>,
}

impl Graph {
    /// Look at a file, again only when it changed.
    pub fn update(&mut self, vfs: &Vfs, packages: &Packages, path: &Path) {
        let Ok(source) = vfs.document(path) else {
            return self.remove(path);
        };
        if self
            .nodes
            .get(path)
            .is_none_or(|node| node.hash != source.hash)
        {
            self.remove(path);
            self.insert(path.to_path_buf(), node(&source, packages));
        }
    }

    fn insert(&mut self, path: PathBuf, node: GraphNode) {
        for pattern in &node.includes {
            let (target, is_whole) = pattern.start();
            if is_whole {
                self.literal.entry(target).or_default().insert(path.clone());
            } else {
                self.computed.insert(path.clone());
            }
        }
        self.nodes.insert(path, node);
    }

    fn remove(&mut self, path: &Path) {
        let Some(node) = self.nodes.remove(path) else {
            return;
        };
        self.computed.remove(path);
        for pattern in &node.includes {
            let (target, _) = pattern.start();
            if let Some(from) = self.literal.get_mut(&target) {
                from.remove(path);
                if from.is_empty() {
                    self.literal.remove(&target);
                }
            }
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

    /// The files with an include that may mean this one by a name that is computed.
    pub fn computed_includers(&self, path: &Path) -> Vec<PathBuf> {
        let may_mean = |from: &&PathBuf| {
            let includes = self
                .nodes
                .get(*from)
                .into_iter()
                .flat_map(|node| &node.includes);
            includes
                .filter(|pattern| !pattern.start().1)
                .any(|pattern| pattern.matches(path))
        };
        self.computed
            .iter()
            .filter(|from| **from != *path)
            .filter(may_mean)
            .cloned()
            .collect()
    }

    /// The files that may include `path`.
    fn includers(&self, path: &Path) -> BTreeSet<&PathBuf> {
        let written = path
            .ancestors()
            .filter_map(|path| self.literal.get(path))
            .flatten();
        let includes = |from: &&PathBuf| {
            self.nodes
                .get(*from)
                .is_some_and(|node| node.includes.iter().any(|pattern| pattern.matches(path)))
        };
        written
            .chain(self.computed.iter().filter(includes))
            .filter(|from| **from != path)
            .collect()
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

/// Whether a document looks like a robot: a root element with a name, and a link or a call outside of macros.
pub(super) fn gives_robot(document: &Document) -> bool {
    let named = document.root().is_some_and(|root| {
        root.name() == "robot" && root.attr("name").is_some_and(|name| !name.raw().is_empty())
    });
    named
        && facts(document).any(|(_, facts)| {
            facts
                .named
                .iter()
                .any(|fact| matches!(fact.kind, FactKind::Link | FactKind::Call) && !fact.in_macro)
        })
}

fn node(source: &Arc<SourceFile>, packages: &Packages) -> GraphNode {
    let is_root = gives_robot(&source.document);
    GraphNode {
        hash: source.hash,
        is_root,
        includes: includes::patterns(source, packages),
    }
}
