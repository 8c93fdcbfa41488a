//! The files that the text of a file names: includes, meshes, textures, YAML, packages.

use std::path::{Path, PathBuf};
use vfs::without_parents;

use super::context::Cx;
use super::expressions::ExprText;
use super::locate::{LocatedNode, NodePart};
use super::values::{distinct, instances};
use base::TextRange;
use expr::{self, Subst, TemplateToken, Value, WordKind, display, parse_substitution, words};
use packages::UriOutcome;
use rules::RuleEnv;
use xml::{Attr, Node, NodeKind};

/// A name of a file, and where it leads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileName {
    /// The name's text in the file.
    pub range: TextRange,
    /// Where it leads.
    pub target: FileTarget,
    /// What names it.
    pub kind: FileKind,
}

/// Where a name leads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileTarget {
    /// To a file or folder.
    Found(PathBuf),
    /// To nothing: the places looked at.
    Missing(Vec<PathBuf>),
}

/// What names a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// `xacro:include`
    Include,
    /// `mesh`
    Mesh,
    /// `load_yaml`
    Yaml,
    /// Something else.
    Other,
}

/// All names of files in a file, in document order.
pub fn file_names(cx: &Cx<'_>, world: RuleEnv<'_>) -> Vec<FileName> {
    let document = &cx.source.document;
    let mut found = Vec::new();
    for (base, item) in document.parts() {
        for node in item.all_nodes() {
            match node.kind() {
                NodeKind::Element => {
                    for attr in node.attrs().filter(|attr| !attr.raw().is_empty()) {
                        found.extend(of_attr(cx, world, base, node, attr));
                    }
                }
                NodeKind::Text if may_name(node.raw()) => {
                    found.extend(of_text(cx, world, &ExprText::of_text(document, base, node)));
                }
                _ => {}
            }
        }
    }
    found
}

/// The name of a file at a place.
pub fn file_name_at(cx: &Cx<'_>, world: RuleEnv<'_>, at: &LocatedNode<'_>) -> Option<FileName> {
    let node = at.node?;
    let names = match at.part {
        NodePart::AttrValue(attr) => of_attr(cx, world, at.base, node, attr),
        NodePart::Text => of_text(
            cx,
            world,
            &ExprText::of_text(&cx.source.document, at.base, node),
        ),
        _ => return None,
    };
    names.into_iter().find(|name| name.range.touches(at.offset))
}

fn may_name(raw: &str) -> bool {
    raw.contains("package://") || raw.contains("$(find ") || raw.contains("load_yaml")
}

fn of_attr(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    base: u32,
    node: Node<'_>,
    attr: Attr<'_>,
) -> Vec<FileName> {
    let is_known = matches!(
        (node.name(), attr.name()),
        ("xacro:include" | "mesh" | "texture", "filename")
    );
    if !is_known && !may_name(attr.raw()) && !attr.raw().starts_with("file://") {
        return Vec::new();
    }
    let text = ExprText::of_attr(&cx.source.document, base, attr);
    let name = match (node.name(), attr.name()) {
        ("xacro:include", "filename") => include(cx, world, &text),
        ("mesh", "filename") => resource(cx, world, &text, FileKind::Mesh),
        ("texture", "filename") => resource(cx, world, &text, FileKind::Other),
        _ => return of_text(cx, world, &text),
    };
    name.into_iter().collect()
}

/// Names in a text of any kind: what begins with a package, and what `load_yaml` reads.
fn of_text(cx: &Cx<'_>, world: RuleEnv<'_>, text: &ExprText<'_>) -> Vec<FileName> {
    let mut found: Vec<FileName> = text
        .template
        .tokens
        .iter()
        .filter_map(|token| yaml(cx, world, text, token))
        .collect();
    let trimmed = text.text.trim();
    let starts = ["package://", "file://", "$(find "]
        .iter()
        .any(|lead| trimmed.starts_with(lead));
    if found.is_empty()
        && starts
        && !trimmed.contains(char::is_whitespace) | trimmed.starts_with("$(find ")
    {
        found.extend(resource(cx, world, text, FileKind::Other));
    }
    found
}

/// The text without the blanks around it, when it is one name.
fn trimmed(text: &ExprText<'_>) -> TextRange {
    let whole = text.text.as_ref();
    let start = whole.len() - whole.trim_start().len();
    text.range(TextRange::new(
        start as u32,
        (start + whole.trim().len()) as u32,
    ))
}

fn include(cx: &Cx<'_>, world: RuleEnv<'_>, text: &ExprText<'_>) -> Option<FileName> {
    let name = folded(cx, world, text, TextRange::new(0, text.text.len() as u32))?;
    if name.is_empty() || name.contains(['*', '?', '[']) {
        return None;
    }
    Some(FileName {
        range: text.whole(),
        target: beside(cx, world, &name),
        kind: FileKind::Include,
    })
}

/// A path that counts from the folder of the file.
fn beside(cx: &Cx<'_>, world: RuleEnv<'_>, name: &str) -> FileTarget {
    let folder = cx.source.path.parent().unwrap_or(Path::new(""));
    existing(
        world,
        without_parents(&world.vfs.absolute(&folder.join(name))),
    )
}

fn existing(world: RuleEnv<'_>, path: PathBuf) -> FileTarget {
    let present = world.packages.present(&path);
    if world.vfs.exists(&present) {
        FileTarget::Found(present.into_owned())
    } else {
        FileTarget::Missing(vec![path])
    }
}

fn resource(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    text: &ExprText<'_>,
    kind: FileKind,
) -> Option<FileName> {
    let name = folded(cx, world, text, TextRange::new(0, text.text.len() as u32))?;
    let name = name.trim();
    if name.is_empty() || name.contains('$') {
        return None;
    }
    let result = world.packages.resolve_uri(name, &cx.source.path);
    let target = match result.outcome {
        UriOutcome::Found(path) => FileTarget::Found(without_parents(&world.vfs.absolute(&path))),
        UriOutcome::Missing(path) => {
            FileTarget::Missing(vec![without_parents(&world.vfs.absolute(&path))])
        }
        UriOutcome::UnknownPackage(_) => FileTarget::Missing(result.tried),
        _ => return None,
    };
    Some(FileName {
        range: trimmed(text),
        target,
        kind,
    })
}

/// The name that `load_yaml` reads in an expression.
fn yaml(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    text: &ExprText<'_>,
    token: &TemplateToken,
) -> Option<FileName> {
    let TemplateToken::Expr { inner, .. } = token else {
        return None;
    };
    let range = loaded_name(inner.slice(&text.text))?.shift(inner.start);
    let path = folded(cx, world, text, range)?;
    Some(FileName {
        range: text.range(range),
        target: beside(cx, world, &path),
        kind: FileKind::Yaml,
    })
}

/// Where the name stands that code gives to `load_yaml`, if that is a string.
fn loaded_name(code: &str) -> Option<TextRange> {
    if !code.contains("load_yaml") {
        return None;
    }
    let words = words(code);
    words.windows(3).find_map(|three| {
        let [called, bracket, (name, kind)] = three else {
            return None;
        };
        let is_call = called.0.slice(code) == "load_yaml" && bracket.0.slice(code) == "(";
        let string = name.slice(code);
        let quote = string
            .get(..1)
            .filter(|first| is_call && matches!(*first, "'" | "\""))?;
        let end = match kind {
            WordKind::String if string.ends_with(quote) => name.end - 1,
            _ => name.end,
        };
        Some(TextRange::new(name.start + 1, end))
    })
}

/// What a part of a text reads once its expressions are evaluated; none when that is unknown or differs by call.
fn folded(cx: &Cx<'_>, world: RuleEnv<'_>, text: &ExprText<'_>, part: TextRange) -> Option<String> {
    let mut out = String::new();
    let template = expr::split(part.slice(&text.text));
    for token in &template.tokens {
        let range = token.range().shift(part.start);
        match token {
            TemplateToken::Text(_) => out.push_str(range.slice(&text.text)),
            TemplateToken::Expr { .. } | TemplateToken::Subst { .. } => {
                let values = instances(cx, text.range(range));
                let values = distinct(values.iter().map(|instance| &instance.value));
                match values.as_slice() {
                    [value] if !matches!(value, Value::Unknown) => {
                        out.push_str(&display::to_str(value)?)
                    }
                    // where nothing is evaluated, packages can be found all the same
                    [] | [Value::Unknown] => {
                        out.push_str(&found_package(cx, world, range.slice(&text.text))?)
                    }
                    _ => return None,
                }
            }
            _ => return None,
        }
    }
    Some(out)
}

fn found_package(cx: &Cx<'_>, world: RuleEnv<'_>, token: &str) -> Option<String> {
    let inner = token.strip_prefix("$(")?.strip_suffix(')')?;
    let Subst::Find(package) = parse_substitution(inner) else {
        return None;
    };
    let found = world.packages.find(&package.text, &cx.source.path).ok()?;
    Some(vfs::slashed(&world.vfs.absolute(&found.path)))
}

#[cfg(test)]
mod tests {
    use super::loaded_name;

    #[test]
    fn names_that_are_loaded() {
        for (code, expected) in [
            ("xacro.load_yaml('a.yaml')['k']", Some("a.yaml")),
            ("load_yaml( \"a.yaml\" )", Some("a.yaml")),
            ("load_yaml('$(find p)/a.yaml')", Some("$(find p)/a.yaml")),
            ("load_yaml('it\\'s.yaml')", Some("it\\'s.yaml")),
            ("load_yaml('a", Some("a")),
            ("load_yaml(name)", None),
            ("'load_yaml(' + 'a'", None),
        ] {
            let found = loaded_name(code).map(|range| range.slice(code));
            assert_eq!(found, expected, "{code}");
        }
    }
}
