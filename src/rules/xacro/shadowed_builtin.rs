//! A property that hides a built-in symbol: whether that is news.
use super::super::rule::{Category, Rule, Severity, page};
use super::source;
use expand::{Expansion, FileRange, Problem};
use expr::{Value, global_symbol};
use model::decimal;
use packages::RosVersion;
use xml::Node;

pub(in super::super) static RULE: Rule = Rule::found(
    "XAC018",
    "shadowed-builtin",
    Category::Xacro,
    Severity::Warning,
    page("shadowed-builtin"),
);

/// Whether a name that hides a built-in symbol means something else from there on. A parameter does so in its macro
/// only, where everybody sees it, and a property with the very value of the symbol changes nothing.
pub(in super::super) fn is_news(expansion: &Expansion, problem: &Problem) -> bool {
    let Some(node) = definition(expansion, problem) else {
        return true;
    };
    match node.name() {
        "xacro:property" => !has_value(expansion, problem.place, node, ROUNDING),
        "xacro:include" => true,
        _ => false,
    }
}

/// Part of a value that a symbol written with ten digits may differ in.
const ROUNDING: f64 = 1e-9;
/// Part of a value that nobody misses.
const ROUGH: f64 = 1e-3;

/// Whether a property is the symbol that it hides, in fewer digits, and the xacro that a file is for says so without harm: in
/// ROS 2, launch files fail with what xacro writes to its error output.
pub(in super::super) fn is_harmless(
    expansion: &Expansion,
    problem: &Problem,
    generation: Option<RosVersion>,
) -> bool {
    generation == Some(RosVersion::Ros1)
        && definition(expansion, problem)
            .is_some_and(|node| has_value(expansion, problem.place, node, ROUGH))
}

/// The tag of the property that hides a symbol.
fn definition<'a>(expansion: &'a Expansion, problem: &Problem) -> Option<Node<'a>> {
    let document = &expansion.files.get(problem.place.file)?.source.document;
    let item = document.item_at(problem.place.range.start);
    item.item.all_nodes().find(|node| {
        let tag = node.start_tag_range().shift(item.start);
        tag.contains_range(problem.place.range)
    })
}

/// Whether a property has the value of the symbol that it hides, up to a part of it.
fn has_value(expansion: &Expansion, place: FileRange, node: Node<'_>, rounding: f64) -> bool {
    let name = node
        .attr("name")
        .map(|name| name.raw().to_owned())
        .unwrap_or_default();
    let Some(Value::Float(known)) = global_symbol(&name) else {
        return false;
    };
    let written = node
        .attr("value")
        .and_then(|value| decimal(value.raw().trim()));
    let computed = expansion.index.bindings.iter().find_map(|binding| {
        let definition = expansion.index.symbols.get(binding.definition?)?;
        match binding.value {
            Some(Value::Float(value)) => {
                (source::place(expansion, definition.place) == Some(place)).then_some(value)
            }
            _ => None,
        }
    });
    written
        .or(computed)
        .is_some_and(|value| (value - known).abs() <= rounding * known.abs())
}
