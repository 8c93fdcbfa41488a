//! Definitions that stand in other files than descriptions, and what names stand for: files, keys of YAML, the
//! declarations of parameters and arguments, and what a macro makes.

use std::path::{Path, PathBuf};

use super::context::Cx;
use super::expressions::{ExprText, parsed, path_to};
use super::instances::{frames_of_macro, is_within};
use super::locate::{LocatedNode, locate};
use super::names::{NavigationTarget, definition_of};
use super::paths::{FileKind, FileTarget, file_name_at, file_names};
use base::TextRange;
use expand::{DefinitionId, SymbolKind, Written};
use expr::TemplateToken;
use expr::ast::{Const, Expr, ExprKind};
use rules::RuleEnv;

/// A place in a file that need not be a description.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileLocation {
    /// The file.
    pub path: PathBuf,
    /// Bytes in its text; an empty range at its start means all of it.
    pub range: TextRange,
}

impl FileLocation {
    fn start(path: PathBuf) -> Self {
        Self {
            path,
            range: TextRange::default(),
        }
    }
}

/// Values that lead to values, at most.
const MOST_STEPS: u32 = 8;

/// The file, the manifest of a package, or the key of a YAML file that the text at an offset names.
pub fn file_definition(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    offset: u32,
) -> Option<(TextRange, FileLocation)> {
    let at = locate(&cx.source.document, offset);
    package(cx, world, &at)
        .or_else(|| key(cx, world, &at))
        .or_else(|| {
            let name = file_name_at(cx, world, &at)?;
            match name.target {
                FileTarget::Found(path) if world.vfs.is_file(&path) => {
                    Some((name.range, FileLocation::start(path)))
                }
                _ => None,
            }
        })
}

/// `$(find package)`
fn package(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    at: &LocatedNode<'_>,
) -> Option<(TextRange, FileLocation)> {
    let text = ExprText::at(&cx.source.document, at)?;
    let (range, name) = super::hover::package_at(&text, at.offset)?;
    let found = world.packages.find(name, &cx.source.path).ok()?;
    let manifest = world.vfs.absolute(&found.path).join("package.xml");
    world
        .vfs
        .is_file(&manifest)
        .then(|| (range, FileLocation::start(manifest)))
}

/// A key of a value that came from YAML: `cam['mass']`, `cam.mass`.
fn key(cx: &Cx<'_>, world: RuleEnv<'_>, at: &LocatedNode<'_>) -> Option<(TextRange, FileLocation)> {
    let text = ExprText::at(&cx.source.document, at)?;
    let (expr, start) = parsed(text.token_at(at.offset)?)?;
    let inside = text.offset(at.offset).checked_sub(start)?;
    let path = path_to(expr, inside);
    let last = *path.last()?;
    let (chain, range) = match &last.kind {
        ExprKind::Attribute { name_range, .. } if name_range.touches(inside) => (last, *name_range),
        ExprKind::Const(Const::Str(_)) => (*path.get(path.len().checked_sub(2)?)?, last.range),
        _ => return None,
    };
    let value =
        YamlTarget::of(cx, world, chain, MOST_STEPS).filter(|value| !value.keys.is_empty())?;
    Some((text.range(range.shift(start)), value.place(world)?))
}

/// What stands for a part of a YAML file.
struct YamlTarget {
    path: PathBuf,
    keys: Vec<String>,
}

impl YamlTarget {
    /// Follow names and keys of an expression back to the file they were read from.
    fn of(cx: &Cx<'_>, world: RuleEnv<'_>, expr: &Expr, steps: u32) -> Option<Self> {
        let (inner, key) = match &expr.kind {
            ExprKind::Subscript { value, index } => match &index.kind {
                ExprKind::Const(Const::Str(key)) => (value, key.to_string()),
                _ => return None,
            },
            ExprKind::Attribute { value, name, .. } => (value, name.to_string()),
            ExprKind::Name(name) => return Self::of_property(cx, world, name, steps),
            _ => return None,
        };
        let mut value = Self::of(cx, world, inner, steps)?;
        value.keys.push(key);
        Some(value)
    }

    /// The file that the only property of this name was read from.
    fn of_property(cx: &Cx<'_>, world: RuleEnv<'_>, name: &str, steps: u32) -> Option<Self> {
        let mut given = cx
            .expansion
            .index
            .symbols
            .iter()
            .filter(|(_, given)| given.name == name && given.kind == SymbolKind::Property);
        let ((id, _), None) = (given.next()?, given.next()) else {
            return None;
        };
        Self::of_definition(cx, world, id, steps)
    }

    /// The file that the value of a property was read from.
    fn of_definition(
        cx: &Cx<'_>,
        world: RuleEnv<'_>,
        id: DefinitionId,
        steps: u32,
    ) -> Option<Self> {
        let target = definition_of(cx, id)?;
        let inner = Cx {
            source: cx.file_of(target.whole.file)?,
            ..*cx
        };
        let names = file_names(&inner, world).into_iter();
        let mut loaded = names.filter(|name| {
            name.kind == FileKind::Yaml && target.whole.range.contains_range(name.range)
        });
        let document = &inner.source.document;
        let place = document.item_at(target.whole.range.start);
        let is_it = |node: &xml::Node<'_>| node.range().shift(place.start) == target.whole.range;
        let node = place.item.all_nodes().find(is_it)?;
        let text = ExprText::of_attr(document, place.start, node.attr("value")?);
        let [token] = text.template.tokens.as_slice() else {
            return None;
        };
        // with a package in it, the code is put together when it is evaluated
        let TemplateToken::Expr { inner: range, .. } = token else {
            return None;
        };
        let code = range.slice(&text.text).trim();
        let is_load = ["xacro.load_yaml(", "load_yaml("]
            .iter()
            .any(|call| code.starts_with(call));
        if let Some(name) = loaded
            .next()
            .filter(|_| is_load && code.ends_with(['\'', '"', ')']))
        {
            let FileTarget::Found(path) = name.target else {
                return None;
            };
            return Some(Self {
                path,
                keys: Vec::new(),
            });
        }
        let (expr, _) = parsed(token)?;
        Self::of(&inner, world, expr, steps.checked_sub(1)?)
    }

    /// Where the value of the last key is named.
    fn place(self, world: RuleEnv<'_>) -> Option<FileLocation> {
        let file = world.vfs.yaml(&self.path, &vfs::slashed(&self.path)).ok()?;
        let mut node = file.value.as_ref().ok()?;
        let mut range = TextRange::default();
        for key in &self.keys {
            let yaml::YamlKind::Map(entries) = &node.kind else {
                return None;
            };
            let is_it = |(name, _): &&(yaml::YamlNode, yaml::YamlNode)| matches!(&name.kind, yaml::YamlKind::Str(name) if name == key);
            let (name, value) = entries.iter().find(is_it)?;
            (range, node) = (name.range, value);
        }
        Some(FileLocation {
            path: self.path,
            range,
        })
    }
}

/// What a value is made of: the file that a name leads to, or the YAML file behind a property.
pub fn type_definition(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    offset: u32,
) -> Option<(TextRange, FileLocation)> {
    if let Some((id, range)) = cx.symbol_at(offset) {
        let own = cx
            .expansion
            .index
            .symbols
            .get(id)
            .filter(|given| given.kind == SymbolKind::Property);
        let value = own.and_then(|_| YamlTarget::of_definition(cx, world, id, MOST_STEPS))?;
        return Some((range, value.place(world)?));
    }
    file_definition(cx, world, offset)
}

/// The text that declares the parameter, block or argument at an offset.
pub fn declaration(cx: &Cx<'_>, offset: u32) -> Option<(TextRange, NavigationTarget)> {
    use SymbolKind::{Argument, BlockParameter, Parameter};
    let (id, range) = cx.symbol_at(offset)?;
    let given = cx.expansion.index.symbols.get(id)?;
    matches!(given.kind, Parameter | BlockParameter | Argument).then_some(())?;
    Some((range, definition_of(cx, id)?))
}

/// The elements in the expanded text that the macro at an offset makes, call by call.
pub fn implementations(
    cx: &Cx<'_>,
    written: &Written,
    offset: u32,
) -> Option<(TextRange, Vec<TextRange>)> {
    let (id, range) = cx.symbol_at(offset)?;
    cx.expansion
        .index
        .symbols
        .get(id)
        .filter(|given| given.kind == SymbolKind::Macro)?;
    let tree = &cx.expansion.tree;
    let mut found: Vec<TextRange> = Vec::new();
    for frame in frames_of_macro(cx.expansion, id) {
        let mut end = 0;
        for entry in &written.map {
            let node = tree.get(entry.node);
            let own = node.kind == expand::XKind::Element
                && is_within(cx.expansion, node.origin.frame, frame);
            if own && entry.out.start >= end {
                end = entry.out.end;
                found.push(entry.out);
            }
        }
    }
    Some((range, found))
}

/// Whether the text of a file can be shown by lines.
pub fn is_text(path: &Path) -> bool {
    let ending = path
        .extension()
        .map(|ending| ending.to_string_lossy().to_lowercase());
    matches!(
        ending.as_deref(),
        Some("xacro" | "urdf" | "srdf" | "sdf" | "xml" | "yaml" | "yml")
    )
}
