//! The expanded document seen through the schema.
use super::super::context::{DocumentCx, RootKind};
use super::super::schema::{self, ElementSpec};
use super::super::vocabulary::{is_forgotten_prefix, is_free_zone};
use super::super::xml::seen::CheckedElement;
use base::{FastSet, TextRange};
use expand::{Expansion, FileIdx, Origin, XId, XKind};
use model::AttrValue;
use packages::edit_distance;
use xml::Node;

/// The element that a document is about, as the schema sees it.
pub(in super::super) fn root_element(cx: &DocumentCx<'_>) -> CheckedElement {
    let root = cx.expansion.tree.get(cx.element);
    let is_container = root.kind == XKind::Container;
    let is_robot = is_container || root.text == schema::robot().name;
    let spec = Some(schema::robot()).filter(|_| is_robot);
    CheckedElement {
        id: cx.element,
        spec,
        parent: None,
        known: spec.filter(|_| !is_container),
    }
}

/// A child of the root and all elements in it, except what stands inside of unknown elements and free zones; parents first.
pub(in super::super) fn each_below(
    cx: &DocumentCx<'_>,
    root: &CheckedElement,
    child: XId,
    mut each: impl FnMut(&CheckedElement),
) {
    let tree = &cx.expansion.tree;
    let Some(parent) = root.spec else { return };
    let mut open = vec![of_root(cx, parent, child)];
    while let Some(element) = open.pop() {
        let Some(element) = element else { continue };
        each(&element);
        if let Some(spec) = element.known {
            let start = open.len();
            open.extend(
                tree.elements(element.id)
                    .map(|id| Some(checked(id, spec, spec.child(&tree.get(id).text)))),
            );
            open.get_mut(start..).into_iter().for_each(<[_]>::reverse);
        }
    }
}

/// A child of the root; none when it is meant for the inside of a free zone.
fn of_root(cx: &DocumentCx<'_>, root: &'static ElementSpec, id: XId) -> Option<CheckedElement> {
    let name = cx.expansion.tree.get(id).text.as_str();
    // a library may be meant for the inside of a link or a joint
    let anywhere = cx.kind == RootKind::Library;
    let elsewhere = || schema::urdf_element(name).filter(|_| anywhere);
    let element = checked(id, root, root.child(name).or_else(elsewhere));
    (!anywhere || !is_foreign(cx, id)).then_some(element)
}

fn checked(
    id: XId,
    parent: &'static ElementSpec,
    spec: Option<&'static ElementSpec>,
) -> CheckedElement {
    CheckedElement {
        id,
        spec,
        parent: Some(parent),
        known: spec.filter(|spec| !is_free_zone(spec.name)),
    }
}

/// Whether an element of a library is meant for the inside of a free zone: SDF holds text, ros2_control
/// interfaces, URDF neither.
fn is_foreign(cx: &DocumentCx<'_>, element: XId) -> bool {
    const INTERFACES: [&str; 3] = ["command_interface", "state_interface", "param"];
    let tree = &cx.expansion.tree;
    let mut open = vec![element];
    while let Some(id) = open.pop() {
        let node = tree.get(id);
        let has_text = node.kind == XKind::Text && !node.text.trim().is_empty();
        if has_text || INTERFACES.contains(&node.text.as_str()) {
            return true;
        }
        open.extend(tree.children(id));
    }
    false
}

/// All elements that the schema knows, without the blocks that are meant for other tools.
pub(in super::super) fn known(cx: &DocumentCx<'_>) -> Vec<(XId, &'static ElementSpec)> {
    let root = root_element(cx);
    let mut found: Vec<_> = root.known.map(|spec| (root.id, spec)).into_iter().collect();
    for child in cx.expansion.tree.elements(root.id) {
        each_below(cx, &root, child, |element| {
            found.extend(element.known.map(|spec| (element.id, spec)));
        });
    }
    found
}

/// What an element belongs to, for messages: "joint `elbow`".
pub(super) fn owner(cx: &DocumentCx<'_>, element: XId) -> String {
    let tree = &cx.expansion.tree;
    let around = std::iter::successors(Some(element), |&id| tree.parent(id));
    let named = |id: XId| {
        let node = tree.get(id);
        let is_owner = matches!(node.text.as_str(), "link" | "joint" | "material" | "robot");
        let name = AttrValue::attr(tree, id, "name").filter(|_| is_owner)?;
        Some(name.name().map_or_else(
            || format!("a {}", node.text),
            |name| format!("{} `{name}`", node.text),
        ))
    };
    around
        .filter_map(named)
        .next()
        .unwrap_or_else(|| "this file".to_owned())
}

/// The message's beginning for an element: "`limit` of joint `elbow`".
pub(in super::super) fn described(cx: &DocumentCx<'_>, element: XId) -> String {
    let tree = &cx.expansion.tree;
    let name = &tree.get(element).text;
    let owner = owner(cx, element);
    let kind = owner.split(" `").next().unwrap_or_default();
    let own =
        tree.attr(element, "name").is_some() && kind.trim_start_matches("a ") == name.as_str();
    // what a macro that nothing calls has at its top is in no element
    if own || name.is_empty() {
        owner
    } else {
        format!("`{name}` of {owner}")
    }
}

/// Whether xacro may put something into an element that the tree does not show: in a macro that nothing calls,
/// conditions and blocks are not known.
pub(super) fn may_get_more(cx: &DocumentCx<'_>, element: XId) -> bool {
    let node = source_node(cx.expansion, cx.expansion.tree.get(element).origin);
    let is_probe = cx.expansion.tree.get(cx.element).kind == XKind::Container;
    is_probe
        && node.is_none_or(|node| {
            node.child_elements()
                .any(|child| child.name().starts_with("xacro:"))
        })
}

/// The element of the source whose start tag is at `origin`.
pub(super) fn source_node(expansion: &Expansion, origin: Origin) -> Option<Node<'_>> {
    let item = &expansion.sources.get(origin.src)?.item;
    item.element_at(origin.range.start)
        .filter(|node| node.start_tag_range() == origin.range)
}

/// Where the name stands in the start tag and in the end tag, when the source spells it.
pub(in super::super) fn tag_names(
    expansion: &Expansion,
    id: XId,
) -> Option<(FileIdx, Vec<TextRange>)> {
    let node = expansion.tree.get(id);
    let source = source_node(expansion, node.origin).filter(|source| source.name() == node.text)?;
    let base = expansion.sources.get(node.origin.src)?.base;
    let names = [Some(source.name_range()), source.end_name_range()];
    let file = expansion.place(node.origin)?.file;
    Some((
        file,
        names
            .into_iter()
            .flatten()
            .map(|range| range.shift(base))
            .collect(),
    ))
}

/// The candidate that a wrong word is meant to be, and whether that is sure: the only one at distance 1.
pub(in super::super) fn meant<'a>(
    word: &str,
    candidates: impl Iterator<Item = &'a str>,
) -> Option<(&'a str, bool)> {
    const LONGEST: usize = 40;
    if word.len() > LONGEST {
        return None;
    }
    let near: Vec<(usize, &str)> = candidates
        .map(|candidate| (edit_distance(word, candidate), candidate))
        .filter(|(distance, candidate)| *distance <= 2 && distance * 2 < candidate.len())
        .collect();
    let &(distance, best) = near.iter().min_by_key(|(distance, _)| *distance)?;
    let sure = distance == 1 && near.iter().filter(|(distance, _)| *distance == 1).count() == 1;
    Some((best, sure))
}

/// The macros that the files of an expansion define somewhere, with or without the prefix.
fn macros<'a, 'e>(cx: &'a DocumentCx<'e>) -> &'a FastSet<&'e str> {
    cx.macros.get_or_init(|| defined_macros(cx.expansion))
}

fn defined_macros(expansion: &Expansion) -> FastSet<&str> {
    let items = expansion
        .files
        .iter()
        .flat_map(|file| file.source.document.parts());
    let is_macro = |node: &Node<'_>| matches!(node.name(), "xacro:macro" | "macro");
    let macros = items
        .flat_map(|(_, item)| item.all_nodes())
        .filter(is_macro);
    macros
        .filter_map(|node| Some(node.attr("name")?.raw()))
        .collect()
}

/// Whether an element is one that a rule about forgotten `xacro:` speaks about.
pub(super) fn lacks_prefix(cx: &DocumentCx<'_>, element: XId) -> bool {
    cx.look_beyond();
    let node = cx.expansion.tree.get(element);
    let name = node.text.as_str();
    macros(cx).contains(name) || is_forgotten_prefix(name) && is_in_xacro(cx.expansion, node.origin)
}

/// Whether the file of an element declares the prefix of xacro.
fn is_in_xacro(expansion: &Expansion, origin: Origin) -> bool {
    let place = expansion.place(origin);
    let file = place.and_then(|place| expansion.files.get(place.file));
    let root = file.and_then(|file| file.source.document.root());
    root.is_some_and(|root| root.attr("xmlns:xacro").is_some())
}

/// The attributes that an element could have and does not.
pub(super) fn absent(cx: &DocumentCx<'_>, element: XId, spec: &ElementSpec) -> Vec<&'static str> {
    let names = spec.attributes.iter().map(|attribute| attribute.name);
    names
        .filter(|name| cx.expansion.tree.attr(element, name).is_none())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::meant;

    #[test]
    fn what_is_meant() {
        let words = ["lower", "upper", "effort", "velocity", "xyz", "rpy"];
        let table = [
            ("lowr", Some(("lower", true))),
            ("low", Some(("lower", false))),
            ("xyzz", Some(("xyz", true))),
            ("rxy", Some(("rpy", true))),
            ("zyx", None),
            ("speed", None),
        ];
        for (word, expected) in table {
            assert_eq!(meant(word, words.into_iter()), expected, "{word}");
        }
        assert_eq!(
            meant("ab12", ["ab13", "ab14"].into_iter()),
            Some(("ab13", false))
        );
    }
}
