//! The symbols of a file as a tree, from its text alone: broken files have an outline too.

use base::TextRange;
use base::limits::SYMBOL_DEPTH;
use facts::is_keyword;
use xml::{Document, Entities, Node, NodeKind};

/// What a symbol is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum OutlineKind {
    Link,
    Joint,
    Macro,
    Property,
    Argument,
    Include,
    Call,
    Material,
    Condition,
    /// `gazebo`, `transmission`, `ros2_control` and the like.
    Block,
}

/// A symbol with those inside of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outline {
    /// What it is called.
    pub name: String,
    /// More about it: a value, parameters, a type.
    pub detail: String,
    /// What it is.
    pub kind: OutlineKind,
    /// All of its text.
    pub range: TextRange,
    /// Its name's text, inside of `range`.
    pub name_range: TextRange,
    /// The symbols inside.
    pub children: Vec<Outline>,
}

/// The symbols of a document, in document order.
pub fn outline(document: &Document) -> Vec<Outline> {
    let entities = document.entities();
    let mut found = Vec::new();
    for (base, item) in document.items() {
        let tops = item.nodes().filter(|node| node.kind() == NodeKind::Element);
        found.extend(tops.flat_map(|node| symbols(node, base, entities)));
    }
    // of a file whose root is cut off, the footer holds what was typed last
    let base = document.footer_start();
    let rest = document
        .footer_content()
        .filter(|node| node.kind() == NodeKind::Element);
    found.extend(rest.flat_map(|node| symbols(node, base, entities)));
    found
}

/// The symbol of an element, or those inside of it when it is none. Elements may be nested deeper than the call
/// stack is, so the tree is put together bottom up.
fn symbols(top: Node<'_>, base: u32, entities: &Entities) -> Vec<Outline> {
    enum OutlineStep<'a> {
        Enter(Node<'a>),
        Leave(Outline, usize),
    }
    let mut steps = vec![OutlineStep::Enter(top)];
    let mut found: Vec<Outline> = Vec::new();
    let mut open = 0;
    while let Some(step) = steps.pop() {
        match step {
            OutlineStep::Enter(node) => {
                match symbol(node, base, entities) {
                    Some(symbol) if open < SYMBOL_DEPTH => {
                        steps.push(OutlineStep::Leave(symbol, found.len()));
                        open += 1;
                    }
                    flat => found.extend(flat),
                }
                let start = steps.len();
                steps.extend(node.child_elements().map(OutlineStep::Enter));
                steps.get_mut(start..).into_iter().for_each(<[_]>::reverse);
            }
            OutlineStep::Leave(mut symbol, first) => {
                open -= 1;
                symbol.children = found.split_off(first);
                found.push(symbol);
            }
        }
    }
    found
}

fn symbol(node: Node<'_>, base: u32, entities: &Entities) -> Option<Outline> {
    let (kind, attr, detail) = match node.name() {
        "link" => (OutlineKind::Link, "name", ""),
        "joint" => (OutlineKind::Joint, "name", "type"),
        "material" if node.child_elements().next().is_some() => (OutlineKind::Material, "name", ""),
        "gazebo" => (OutlineKind::Block, "reference", ""),
        // of SRDF
        "group" if node.child_elements().next().is_some() => (OutlineKind::Block, "name", ""),
        "group_state" => (OutlineKind::Block, "name", "group"),
        "end_effector" | "virtual_joint" | "passive_joint" => (OutlineKind::Block, "name", ""),
        "transmission" | "ros2_control" => (OutlineKind::Block, "name", "type"),
        "xacro:macro" => (OutlineKind::Macro, "name", "params"),
        "xacro:property" => (OutlineKind::Property, "name", "value"),
        "xacro:arg" => (OutlineKind::Argument, "name", "default"),
        "xacro:include" => (OutlineKind::Include, "filename", "ns"),
        "xacro:if" | "xacro:unless" => (OutlineKind::Condition, "value", ""),
        name if is_call(name) => (OutlineKind::Call, "name", ""),
        _ => return None,
    };
    let named = node.attr(attr).filter(|attr| !attr.raw().is_empty());
    let tag = node.name().strip_prefix("xacro:").unwrap_or(node.name());
    let value = text_of(node, attr, entities);
    let name = match kind {
        OutlineKind::Call if named.is_some() => format!("{tag} name={value}"),
        OutlineKind::Condition => format!("{tag} {value}"),
        OutlineKind::Block if named.is_some() => format!("{tag} {value}"),
        _ if named.is_some() => value,
        _ => tag.to_owned(),
    };
    // the protocol forbids symbols without a name
    let name = Some(name)
        .filter(|name| !name.trim().is_empty())
        .unwrap_or_else(|| node.name().to_owned());
    let own = matches!(
        kind,
        OutlineKind::Call | OutlineKind::Condition | OutlineKind::Block
    ) || named.is_none();
    let name_range = if own {
        node.name_range()
    } else {
        named.map_or(node.name_range(), |a| a.value_range())
    };
    Some(Outline {
        name,
        detail: if detail.is_empty() {
            String::new()
        } else {
            text_of(node, detail, entities)
        },
        kind,
        range: node.range().shift(base),
        name_range: name_range.shift(base),
        children: Vec::new(),
    })
}

/// The text of an attribute; empty without it.
fn text_of(node: Node<'_>, name: &str, entities: &Entities) -> String {
    node.attr(name)
        .map(|attr| attr.value(entities).into_owned())
        .unwrap_or_default()
}

fn is_call(name: &str) -> bool {
    name.strip_prefix("xacro:")
        .is_some_and(|called| !is_keyword(called))
}

#[cfg(test)]
mod tests {
    use super::outline;
    use xml::Document;

    #[test]
    fn every_symbol_has_a_name() {
        let text = "<!DOCTYPE robot [<!ENTITY none \"\">]><robot><xacro: a=\"1\"/><xacro:xacro:/><link/><link name=\"\"/>\
                    <link name=\"&none;\"/><joint name=\" \"/><xacro:if value=\"\"/><xacro:m/></robot>";
        let names: Vec<String> = outline(&Document::parse(text))
            .into_iter()
            .map(|symbol| symbol.name)
            .collect();
        assert_eq!(
            names,
            [
                "xacro:", "xacro:", "link", "link", "link", "joint", "if ", "m"
            ]
        );
        // while it is typed, too
        for end in 0..text.len() {
            let symbols = outline(&Document::parse(text.get(..end).unwrap()));
            assert!(
                symbols.iter().all(|symbol| !symbol.name.trim().is_empty()),
                "{end}: {symbols:?}"
            );
        }
    }
}
