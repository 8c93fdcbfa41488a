//! A fixed name in a macro that gives its other names a prefix.
use super::super::context::{FileCx, elements_where};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::outside_free_zones;
use base::TextRange;
use expand::{FrameKind, XId};
use xml::{Attr, Node, NodeKind};

pub(super) static RULE: Rule = Rule {
    code: "CNV004",
    name: "unprefixed-name-in-macro",
    category: Category::Conventions,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("unprefixed-name-in-macro"),
    check: Check::File(check),
};

/// Parameters that make names unique.
const PREFIXES: [&str; 5] = ["prefix", "tf_prefix", "name", "ns", "side"];

/// Frames of which there is one, whatever robots stand in it.
const SHARED: [&str; 3] = ["world", "map", "odom"];

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    let elements = elements_where(&cx.source.document, |marks| marks.macro_tag);
    for (base, node) in elements.filter(|(_, node)| node.name() == "xacro:macro") {
        let Some((prefix, names)) = prefix(node).map(|prefix| (prefix, definitions(node))) else {
            continue;
        };
        let uses = |name: &Attr<'_>| mentions(name.raw(), prefix);
        if !names.iter().any(uses) || is_called_without(cx, base, node, prefix) {
            continue;
        }
        let fixed = |name: &&Attr<'_>| {
            !name.has_dollar()
                && !name.raw().contains('{')
                && !name.raw().is_empty()
                && !SHARED.contains(&name.raw())
        };
        // a name that is there twice already is an error of its own
        for name in names
            .iter()
            .filter(fixed)
            .filter(|name| !is_duplicate(cx, name.raw()))
        {
            report(cx, base, node, *name, prefix, out);
        }
    }
}

/// The parameter of a macro that makes its names unique.
fn prefix<'a>(node: Node<'a>) -> Option<&'a str> {
    let params = node.attr("params")?.raw();
    let mut names = params
        .split_whitespace()
        .map(|word| word.split([':', '=']).next().unwrap_or(word));
    names.find(|name| PREFIXES.contains(name))
}

/// The names of the links and joints in a macro.
fn definitions(of: Node<'_>) -> Vec<Attr<'_>> {
    let elements = of
        .item()
        .all_nodes()
        .filter(|node| node.kind() == NodeKind::Element);
    let elements = outside_free_zones(elements.map(|node| (0, node))).map(|(_, node)| node);
    let defines = |node: &Node<'_>| {
        matches!(node.name(), "link" | "joint") && of.range().contains_range(node.range())
    };
    elements
        .filter(defines)
        .filter_map(|node| node.attr("name"))
        .collect()
}

/// Whether several links, or several joints, of the robot have a name.
fn is_duplicate(cx: &FileCx<'_>, name: &str) -> bool {
    let tree = &cx.expansion.tree;
    let Some(root) = tree.root() else {
        return false;
    };
    let is_named = |id: &XId| {
        tree.attr(*id, "name")
            .is_some_and(|attr| attr.value == name)
    };
    ["link", "joint"].into_iter().any(|kind| {
        let same = tree
            .elements(root)
            .filter(|&id| tree.get(id).text == kind)
            .filter(is_named);
        same.count() > 1
    })
}

/// Whether an expression in a text reads a name.
fn mentions(text: &str, name: &str) -> bool {
    let words = text
        .split("${")
        .skip(1)
        .filter_map(|part| part.split('}').next());
    words
        .flat_map(|code| code.split(|c: char| !c.is_alphanumeric() && c != '_'))
        .any(|word| word == name)
}

/// Whether the only call of a macro passes no prefix: then there is nothing to keep apart.
fn is_called_without(cx: &FileCx<'_>, base: u32, node: Node<'_>, prefix: &str) -> bool {
    let Some(name) = node.attr("name").map(|name| name.value_range().shift(base)) else {
        return false;
    };
    let calls = cx.expansion.frames.iter().filter(|frame| {
        let definition = frame
            .definition
            .and_then(|definition| cx.expansion.place(definition));
        let here = definition.is_some_and(|place| place.file == cx.file && place.range == name);
        frame.kind == FrameKind::Macro && here
    });
    // a second call settles it
    let given: Vec<Option<&str>> = calls
        .take(2)
        .map(|frame| {
            let item = &cx.expansion.sources.get(frame.call.src)?.item;
            let call = item
                .all_nodes()
                .find(|node| node.name_range().end == frame.call.range.end)?;
            Some(call.attr(prefix)?.raw())
        })
        .collect();
    given.as_slice() == [Some("")]
}

fn report(
    cx: &FileCx<'_>,
    base: u32,
    of: Node<'_>,
    name: Attr<'_>,
    prefix: &str,
    out: &mut Sink<'_>,
) {
    let old = name.raw();
    let new = format!(
        "${{{prefix}}}{}{old}",
        if prefix == "prefix" || prefix == "tf_prefix" {
            ""
        } else {
            "_"
        }
    );
    let message = format!("name `{old}` does not use `{prefix}`, unlike other names in this macro");
    let mut places: Vec<TextRange> = vec![name.value_range().shift(base)];
    for node in of
        .item()
        .all_nodes()
        .filter(|node| of.range().contains_range(node.range()))
    {
        let attr = match node.name() {
            "parent" | "child" => "link",
            "mimic" => "joint",
            "gazebo" => "reference",
            _ => continue,
        };
        let refers = node.attr(attr).filter(|attr| attr.raw() == old);
        places.extend(refers.map(|attr| attr.value_range().shift(base)));
    }
    let edits = places.into_iter().map(|range| (range, new.clone()));
    out.report_in(cx.file, name.value_range().shift(base), message)
        .help(format!(
            "write `{new}`; a second call of the macro creates the same name again"
        ))
        .fix(
            Safety::Unsafe,
            format!("replace with `{new}`"),
            cx.file,
            edits,
        )
        .done();
}
