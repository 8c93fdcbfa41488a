//! Who may include whom, read off the texts alone: conditions and arguments are not looked at.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use rayon::prelude::*;

use base::FastMap;
use facts::{Fact, FactKind, facts, parts_where};
use packages::Packages;
use vfs::{SourceFile, Vfs};
use workspace::config::Pattern;
use workspace::{include_pattern, included_files, reached_files};
use xml::{Document, Node};

/// The arguments that are the whole name of a file that a file includes: `extra` of `$(arg extra)`.
fn given_whole(source: &SourceFile) -> Vec<String> {
    let nodes =
        parts_where(&source.document, |marks| marks.include).flat_map(|(_, item)| item.all_nodes());
    let includes = nodes.filter(|node| node.name() == "xacro:include");
    let whole = |node: Node<'_>| {
        let name = node
            .attr("filename")?
            .raw()
            .trim()
            .strip_prefix("$(arg ")?
            .strip_suffix(')')?
            .trim()
            .to_owned();
        (!name.contains(['$', '(', ' '])).then_some(name)
    };
    includes.filter_map(whole).collect()
}

/// The files that a file may include, as patterns of absolute paths.
pub(super) fn patterns(source: &SourceFile, packages: &Packages) -> Vec<Pattern> {
    read(source, packages).flatten().collect()
}

/// What a file may include.
pub(super) struct IncludeTargets {
    patterns: Vec<Pattern>,
    /// Whether one of its includes may be any file, as far as the text says.
    pub(super) anything: bool,
}

impl IncludeTargets {
    /// Whether `path` may be included.
    pub(super) fn has(&self, path: &Path) -> bool {
        self.patterns.iter().any(|pattern| pattern.matches(path))
    }

    /// The files that are there, for each include.
    pub(super) fn files(&self, vfs: &vfs::Vfs) -> impl Iterator<Item = Vec<std::path::PathBuf>> {
        self.patterns
            .iter()
            .map(|pattern| included_files(pattern, vfs))
    }

    /// The files that it may include in whatever folder.
    pub(super) fn reached(&self, vfs: &Vfs) -> Vec<PathBuf> {
        let patterns = self.patterns.iter();
        patterns
            .flat_map(|pattern| reached_files(pattern, vfs))
            .collect()
    }
}

/// What a file may include, unclear includes too.
pub(super) fn reach(source: &SourceFile, packages: &Packages) -> IncludeTargets {
    let all: Vec<Option<Pattern>> = read(source, packages).collect();
    IncludeTargets {
        anything: all.iter().any(Option::is_none),
        patterns: all.into_iter().flatten().collect(),
    }
}

/// The includes of a file; none: the text does not say which file that is.
fn read(source: &SourceFile, packages: &Packages) -> impl Iterator<Item = Option<Pattern>> {
    let document = &source.document;
    // one whose prefix was forgotten is meant to include the file as well
    let is_include = |node: &Node<'_>| ["xacro:include", "include"].contains(&node.name());
    let nodes = parts_where(document, |marks| marks.include)
        .flat_map(|(_, item)| item.all_nodes())
        .filter(is_include);
    let names = nodes.filter_map(|node| {
        Some(
            node.attr("filename")?
                .value(document.entities())
                .into_owned(),
        )
    });
    names.flat_map(move |name| {
        let given = with_defaults(document, &name, MOST_DEFAULTS).into_iter();
        let given = given.filter_map(|name| include_pattern(&name, &source.path, packages));
        let own = include_pattern(&name, &source.path, packages);
        std::iter::once(own).chain(given.map(Some))
    })
}

/// Arguments and properties in the values of others that are followed.
const MOST_DEFAULTS: u32 = 4;
/// Values of one argument or property that are followed: each may have as many again.
const MOST_VALUES: usize = 4;

/// A file name that begins with an argument or a property, as in `$(arg folder)/arm.xacro`, with the values that the document gives
/// that: a folder is often named in this way, and may be anywhere.
fn with_defaults(document: &Document, name: &str, left: u32) -> Vec<String> {
    let name = name.trim();
    let argument = name.strip_prefix("$(arg ");
    let argument = argument.and_then(|rest| rest.split_once(')'));
    let property = name.strip_prefix("${");
    let property = property.and_then(|rest| rest.split_once('}'));
    let (tag, (given, rest)) = match (argument, property) {
        (Some(argument), _) => ("xacro:arg", argument),
        (_, Some(property)) => ("xacro:property", property),
        _ => return Vec::new(),
    };
    let nodes = document.parts().flat_map(|(_, item)| item.all_nodes());
    let is_it = |node: &Node<'_>| {
        node.name() == tag
            && node
                .attr("name")
                .is_some_and(|attr| attr.raw() == given.trim())
    };
    let value = |node: Node<'_>| {
        let attr = node.attr("default").or_else(|| node.attr("value"))?;
        Some(attr.value(document.entities()).into_owned())
    };
    let values = nodes.filter(is_it).filter_map(value).take(MOST_VALUES);
    values
        .flat_map(|value| match left.checked_sub(1) {
            Some(left) if value.starts_with('$') && !value.starts_with("$(find ") => {
                with_defaults(document, &value, left)
            }
            _ => vec![value],
        })
        .map(|value| format!("{value}{rest}"))
        .collect()
}

/// What the files of a workspace include, arranged so that nobody has to try every pattern on every file.
#[derive(Clone, Default)]
pub(super) struct Included {
    files: Vec<Arc<SourceFile>>,
    /// By the beginning that is sure: who includes what.
    by_start: FastMap<PathBuf, Vec<Include>>,
    /// By file: the arguments that are the whole name of a file that it includes.
    given: FastMap<Arc<Path>, Vec<String>>,
}

/// What a file includes.
#[derive(Clone)]
pub(super) struct Include {
    from: Arc<Path>,
    start: PathBuf,
    /// None: the start is the whole path.
    pattern: Option<Pattern>,
}

impl Included {
    /// The includes of one file.
    pub(super) fn by(source: &SourceFile, packages: &Packages) -> Vec<Include> {
        let include = |pattern: Pattern| {
            let (start, is_whole) = pattern.start();
            Include {
                from: source.path.clone(),
                start,
                pattern: (!is_whole).then_some(pattern),
            }
        };
        patterns(source, packages)
            .into_iter()
            .map(include)
            .collect()
    }

    /// What these files include.
    pub(super) fn of_files(files: Vec<Arc<SourceFile>>, packages: &Packages) -> Self {
        let includes = files
            .par_iter()
            .map(|source| Self::by(source, packages))
            .collect();
        let mut all = Self::of(includes);
        for source in &files {
            all.add_given(source);
        }
        Self { files, ..all }
    }

    fn add_given(&mut self, source: &SourceFile) {
        let given = given_whole(source);
        if !given.is_empty() {
            self.given.insert(source.path.clone(), given);
        }
    }

    /// Put what a file says now in place of what it said before; none where it is gone.
    fn replace(&mut self, path: &Path, source: Option<&Arc<SourceFile>>, packages: &Packages) {
        // letter by letter: all of them are absolute, and comparing part by part takes long
        let is_other = |other: &Path| other.as_os_str() != path.as_os_str();
        self.files.retain(|file| is_other(&file.path));
        self.given.remove(path);
        self.by_start
            .values_mut()
            .for_each(|includes| includes.retain(|include| is_other(&include.from)));
        if let Some(source) = source {
            self.files.push(source.clone());
            self.add_given(source);
            self.add(Self::by(source, packages));
        }
    }

    /// Whether a file defines a property of that name outside of macros.
    pub(super) fn defines(&self, property: &str) -> bool {
        self.files.iter().any(|file| {
            let mut facts = facts(&file.document);
            let is_it = |fact: &Fact| !fact.in_macro && fact.name == property;
            facts.any(|(_, facts)| facts.of(FactKind::Property).any(is_it))
        })
    }

    /// The arguments that are the whole name of a file that somebody includes.
    pub(super) fn given(&self) -> impl Iterator<Item = &str> {
        self.given.values().flatten().map(String::as_str)
    }

    /// Those of many.
    fn of(includes: Vec<Vec<Include>>) -> Self {
        let mut all = Self::default();
        includes.into_iter().for_each(|includes| all.add(includes));
        all
    }

    fn add(&mut self, includes: Vec<Include>) {
        for include in includes {
            self.by_start
                .entry(include.start.clone())
                .or_default()
                .push(include);
        }
    }

    /// Whether another file may include `file`.
    pub(super) fn has(&self, file: &Path) -> bool {
        self.includers(file).next().is_some()
    }

    /// The other files that may include `file`.
    pub(super) fn includers(&self, file: &Path) -> impl Iterator<Item = &Path> {
        let near = file
            .ancestors()
            .filter_map(|start| self.by_start.get(start))
            .flatten();
        let matching = near.filter(move |include| match &include.pattern {
            Some(pattern) => pattern.matches(file),
            None => include.start == *file,
        });
        matching
            .map(|include| &*include.from)
            .filter(move |from| *from != file)
    }
}

/// What the descriptions below folders include, brought up to date where some were edited.
#[derive(Default)]
pub(super) struct IncludedCache {
    below: FastMap<PathBuf, Arc<Included>>,
    /// The descriptions that were edited since.
    edited: BTreeSet<PathBuf>,
}

impl IncludedCache {
    /// A description says something else now.
    pub(super) fn edit(&mut self, path: &Path) {
        self.edited.insert(path.to_owned());
    }

    /// What is known of a folder.
    pub(super) fn get(
        &mut self,
        folder: &Path,
        vfs: &Vfs,
        packages: &Packages,
    ) -> Option<Arc<Included>> {
        for path in std::mem::take(&mut self.edited) {
            let source = vfs.document(&path).ok();
            let around = self.below.iter_mut();
            for (_, included) in around.filter(|(folder, _)| path.starts_with(folder)) {
                Arc::make_mut(included).replace(&path, source.as_ref(), packages);
            }
        }
        self.below.get(folder).cloned()
    }

    /// Keep what is known of a folder, unless somebody was faster.
    pub(super) fn keep(&mut self, folder: &Path, made: Arc<Included>) -> Arc<Included> {
        let kept = self.below.entry(folder.to_owned());
        kept.or_insert(made).clone()
    }

    /// Forget everything.
    pub(super) fn clear(&mut self) {
        *self = Self::default();
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;
    use std::sync::Arc;

    use super::{Included, IncludedCache};
    use packages::{PackageOptions, Packages};
    use vfs::testing::Tree;

    #[test]
    fn included_by_another_file() {
        let tree = Tree::new();
        let include = |name: &str| format!("<robot><xacro:include filename=\"{name}\"/></robot>");
        tree.write("p/package.xml", "<package><name>p</name></package>");
        tree.write("p/robots/r.xacro", &include("$(find p)/urdf/a.xacro"));
        tree.write("p/robots/s.xacro", &include("../urdf/arm_$(arg arm).xacro"));
        tree.write("p/robots/t.xacro", &include("../$(arg kind)/parts/u.xacro"));
        tree.write("p/robots/self.xacro", &include("self.xacro"));
        let elsewhere = include("$(arg folder)/offsets.xacro").replace(
            "<robot>",
            "<robot><xacro:property name=\"own\" value=\"$(find p)/calibration\"/><xacro:arg name=\"folder\" default=\"${own}\"/>",
        );
        tree.write("p/robots/v.xacro", &elsewhere);
        // values that name themselves, each in many ways
        let again = "<xacro:property name=\"own\" value=\"${own}\"/>".repeat(200);
        let endless =
            include("${own}/offsets.xacro").replace("<robot>", &format!("<robot>{again}"));
        tree.write("p/robots/w.xacro", &endless);
        let packages = Packages::new(
            tree.vfs().clone(),
            &tree.environment(&[]),
            PackageOptions::default(),
        );
        let of = |name: &str| {
            let source = tree.vfs().document(&tree.path(name)).unwrap();
            Included::by(&source, &packages)
        };
        let names =
            ["r", "s", "t", "v", "w", "self"].map(|name| of(&format!("p/robots/{name}.xacro")));
        let included = Included::of(names.into());
        for (file, expected) in [
            ("p/urdf/a.xacro", true),
            ("p/urdf/b.xacro", false),
            ("p/urdf/arm_left.xacro", true),
            ("p/urdf/deep/arm_left.xacro", false),
            ("p/hands/parts/u.xacro", true),
            ("p/hands/left/parts/u.xacro", true),
            ("p/hands/u.xacro", false),
            ("p/calibration/offsets.xacro", true),
            ("p/calibration/other.xacro", false),
            ("p/offsets.xacro", false),
            ("p/robots/self.xacro", false),
            ("p/robots/r.xacro", false),
        ] {
            assert_eq!(included.has(&tree.path(file)), expected, "{file}");
        }
        assert!(!included.has(Path::new("/")));
    }

    #[test]
    fn what_was_edited_counts_as_it_is_now() {
        let tree = Tree::new();
        let vfs = tree.vfs();
        let text = |file: &str, property: &str| {
            format!(
                "<robot><xacro:include filename=\"{file}\"/><xacro:property name=\"{property}\" value=\"1\"/></robot>"
            )
        };
        tree.write("p/r.xacro", &text("a.xacro", "mass"));
        tree.write("p/s.xacro", "<robot/>");
        let packages = Packages::new(
            vfs.clone(),
            &tree.environment(&[]),
            PackageOptions::default(),
        );
        let files = ["p/r.xacro", "p/s.xacro"].map(|file| vfs.document(&tree.path(file)).unwrap());
        let mut cache = IncludedCache::default();
        let made = Included::of_files(files.into(), &packages);
        cache.keep(tree.root(), Arc::new(made));
        let mut check = |expected: (bool, bool, bool)| {
            let now = cache.get(tree.root(), vfs, &packages).unwrap();
            let has = |file: &str| now.has(&tree.path(file));
            let found = (has("p/a.xacro"), has("p/b.xacro"), now.defines("mass"));
            assert_eq!(found, expected);
            vfs.set_buffer(&tree.path("p/r.xacro"), Some(text("b.xacro", "weight")));
            cache.edit(&tree.path("p/r.xacro"));
        };
        check((true, false, true));
        check((false, true, false));
    }
}
