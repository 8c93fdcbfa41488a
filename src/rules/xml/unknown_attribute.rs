//! An attribute that URDF does not know on its element.
use super::super::context::DocumentCx;
use super::super::edits::source_text;
use super::super::finding::Help;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::schema::{self, ElementSpec};
use super::super::sink::Sink;
use super::super::xml::walk::absent;
use super::seen::CheckedElement;
use super::{meant, walk};
use expand::{Origin, XAttr, XId};
use model::Version;
use xml::Node;

pub(in super::super) static RULE: Rule = Rule {
    code: "XML007",
    name: "unknown-attribute",
    category: Category::Xml,
    severity: Severity::Hint,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("unknown-attribute"),
    check: Check::Element(check),
};

/// Findings about one element.
const MOST: usize = 50;

fn check(
    cx: &DocumentCx<'_>,
    &CheckedElement { id, known, .. }: &CheckedElement,
    out: &mut Sink<'_>,
) {
    let Some(spec) = known else {
        return;
    };
    let attrs = &cx.expansion.tree.get(id).attrs;
    let unknown: Vec<&XAttr> = attrs
        .iter()
        .filter(|attr| spec.attribute(&attr.name).is_none() && !is_admitted(cx, &attr.name))
        .take(MOST)
        .collect();
    let unknown = report_parts(cx, id, spec, unknown, out);
    if !unknown.is_empty() {
        let absent = absent(cx, id, spec);
        let unknown = report_several(cx, id, spec, &absent, unknown, out);
        unknown
            .into_iter()
            .for_each(|attr| report(cx, id, spec, &absent, attr, out));
    }
}

/// Vectors whose numbers some write as attributes of their own.
const PARTS: [(&str, [&str; 3]); 2] = [("xyz", ["x", "y", "z"]), ("rpy", ["roll", "pitch", "yaw"])];

/// Report `x`, `y` and `z` where `xyz` is meant, as one; the other attributes.
fn report_parts<'a>(
    cx: &DocumentCx<'_>,
    id: XId,
    spec: &ElementSpec,
    mut unknown: Vec<&'a XAttr>,
    out: &mut Sink<'_>,
) -> Vec<&'a XAttr> {
    for (vector, parts) in PARTS {
        let is_meant =
            spec.attribute(vector).is_some() && cx.expansion.tree.attr(id, vector).is_none();
        let is_first = |attr: &&&XAttr| is_meant && is_part(attr, &parts);
        let Some(&first) = unknown.iter().find(is_first) else {
            continue;
        };
        let number = |part: &str| {
            let text = unknown.iter().find(|attr| attr.name == part);
            text.map_or_else(
                || Some("0".to_owned()),
                |attr| Some(source_text(cx.expansion, attr.origin)?.2),
            )
        };
        let numbers: Option<Vec<String>> = parts.into_iter().map(number).collect();
        let names: Vec<&str> = unknown
            .iter()
            .filter(|attr| is_part(attr, &parts))
            .map(|attr| attr.name.as_str())
            .collect();
        let plural = if names.len() == 1 {
            "attribute"
        } else {
            "attributes"
        };
        let message = format!(
            "unknown {plural} `{}` in {}",
            names.join("`, `"),
            walk::described(cx, id)
        );
        let text = numbers.map_or_else(|| "...".to_owned(), |numbers| numbers.join(" "));
        let help = format!(
            "write {vector}=\"{text}\"; parsers silently ignore `{}`",
            first.name
        );
        out.report(name_of(cx, first), message)
            .severity(Severity::Warning)
            .help(help)
            .done();
        unknown.retain(|attr| !is_part(attr, &parts));
    }
    unknown
}

/// Whether an attribute is one of the parts of a vector.
fn is_part(attr: &XAttr, parts: &[&str]) -> bool {
    parts.contains(&attr.name.as_str())
}

/// Report several attributes that are meant to be others (`min` and `max` of a limit) as one; the attributes that are left.
fn report_several<'a>(
    cx: &DocumentCx<'_>,
    id: XId,
    spec: &ElementSpec,
    absent: &[&'static str],
    unknown: Vec<&'a XAttr>,
    out: &mut Sink<'_>,
) -> Vec<&'a XAttr> {
    let meant: Vec<(&XAttr, &str)> = unknown
        .iter()
        .filter_map(|attr| Some((*attr, meant_by(attr, spec, absent)?)))
        .collect();
    let ([(first, _), _, ..], true) = (meant.as_slice(), are_different(&meant)) else {
        return unknown;
    };
    let (names, near): (Vec<&str>, Vec<&str>) = meant
        .iter()
        .map(|(attr, near)| (attr.name.as_str(), near))
        .unzip();
    let names = names.join("`, `");
    let message = format!(
        "unknown attributes `{names}` in {}",
        walk::described(cx, id)
    );
    let is_needed = meant.iter().any(|(_, near)| is_needed(cx, id, spec, near));
    let help = format!(
        "did you mean `{}`? Parsers silently ignore `{names}`",
        near.join("`, `")
    );
    let is_idle = meant.iter().all(|(attr, near)| is_idle(cx, id, near, attr));
    let report = out
        .report(name_of(cx, first), message)
        .severity(severity(is_needed, is_idle))
        .help(help);
    let places: Option<Vec<_>> = meant
        .iter()
        .map(|(attr, near)| Some((cx.expansion.place(name_of(cx, attr))?, near.to_string())))
        .collect();
    let file = places
        .as_ref()
        .and_then(|places| Some(places.first()?.0.file));
    match (places, file) {
        (Some(places), Some(file)) if places.iter().all(|(place, _)| place.file == file) => {
            let edits = places.into_iter().map(|(place, near)| (place.range, near));
            report
                .fix(Safety::Unsafe, "rename the attributes", file, edits)
                .done();
        }
        _ => report.done(),
    }
    unknown
        .into_iter()
        .filter(|attr| meant_by(attr, spec, absent).is_none())
        .collect()
}

/// Which of the attributes that are absent an unknown one is meant to be.
fn meant_by<'a>(attr: &XAttr, spec: &ElementSpec, absent: &[&'a str]) -> Option<&'a str> {
    Some(meant::of_attribute(spec.name, &attr.name, absent.iter().copied())?.0)
}

/// Whether no two attributes are meant to be the same one.
fn are_different(meant: &[(&XAttr, &str)]) -> bool {
    let mut names: Vec<&str> = meant.iter().map(|(_, near)| *near).collect();
    names.sort_unstable();
    names.windows(2).all(|pair| pair.first() != pair.last())
}

/// Names that any element may have.
fn is_admitted(cx: &DocumentCx<'_>, name: &str) -> bool {
    let allowed = || {
        cx.world
            .config
            .allow_attributes
            .iter()
            .any(|allowed| allowed == name)
    };
    name.contains(':') || matches!(name, "id" | "xmlns") || allowed()
}

fn report(
    cx: &DocumentCx<'_>,
    id: XId,
    spec: &ElementSpec,
    absent: &[&'static str],
    attr: &XAttr,
    out: &mut Sink<'_>,
) {
    let name = &attr.name;
    let message = format!("unknown attribute `{name}` in {}", walk::described(cx, id));
    let group = Group::Name(format!("{name} of {}", spec.name).into());
    let report = out.report(name_of(cx, attr), message).group(group);
    let taken: Vec<String> = spec
        .attributes
        .iter()
        .map(|known| format!("`{}`", known.name))
        .collect();
    match meant::of_attribute(spec.name, name, absent.iter().copied()) {
        Some((near, sure)) => {
            let safety = if sure { Safety::Safe } else { Safety::Unsafe };
            let is_needed = is_needed(cx, id, spec, near);
            report
                .severity(severity(is_needed, is_idle(cx, id, near, attr)))
                .help(Help::did_you_mean(near).and(&format!("Parsers silently ignore `{name}`")))
                .replace_with(safety, format!("rename to `{near}`"), near)
                .done();
        }
        None if taken.is_empty() => {
            report
                .help(format!(
                    "remove it; `{}` has no attributes, and parsers silently ignore it",
                    spec.name
                ))
                .done();
        }
        None => {
            let help = format!(
                "use an attribute of `{}`: {}; parsers silently ignore others",
                spec.name,
                taken.join(", ")
            );
            let severity = if is_of_other_shape(spec, name) && !is_scale_of_ones(attr) {
                Severity::Warning
            } else {
                Severity::Hint
            };
            report.severity(severity).help(help).done();
        }
    }
}

/// Whether parsers reject the element without this attribute, which no other finding says then.
fn is_needed(cx: &DocumentCx<'_>, id: XId, spec: &ElementSpec, name: &str) -> bool {
    let tree = &cx.expansion.tree;
    let is_strength = spec.name == "limit" && matches!(name, "effort" | "velocity");
    // urdfdom rejects dynamics without any of its attributes
    let is_only = spec.name == "dynamics" && tree.get(id).attrs.len() == 1;
    spec.requires(name)
        || is_only
        || is_strength
            && !Version::V1_2.is_in(tree)
            && tree
                .parent(id)
                .and_then(|joint| tree.attr(joint, "type"))
                .is_none_or(|kind| kind.value != "fixed")
}

/// How bad it is that an attribute is not read.
const fn severity(is_needed: bool, is_idle: bool) -> Severity {
    match (is_needed, is_idle) {
        (true, _) => Severity::Error,
        (false, true) => Severity::Info,
        (false, false) => Severity::Warning,
    }
}

/// Whether nothing would change if an attribute were read as the one that is meant: a joint of this type has no use for it, or it
/// has the value that is taken without it.
fn is_idle(cx: &DocumentCx<'_>, id: XId, meant: &str, attr: &XAttr) -> bool {
    let tree = &cx.expansion.tree;
    let kind = tree.parent(id).and_then(|joint| tree.attr(joint, "type"));
    let is_unused = kind.is_some_and(|kind| match kind.value.as_str() {
        "fixed" => ["axis", "limit", "dynamics"].contains(&tree.get(id).text.as_str()),
        "continuous" => ["lower", "upper"].contains(&meant),
        _ => false,
    });
    let is_default =
        ["damping", "friction", "xyz", "rpy"].contains(&meant) && tree.get(id).text != "axis" && {
            let mut numbers = attr.value.split_whitespace().map(str::parse::<f64>);
            numbers.all(|number| number == Ok(0.0))
        };
    is_unused || is_default
}

/// Whether an attribute would scale nothing if it were read.
fn is_scale_of_ones(attr: &XAttr) -> bool {
    let mut numbers = attr.value.split_whitespace().map(str::parse::<f64>);
    attr.name == "scale" && numbers.all(|number| number == Ok(1.0))
}

/// Whether another shape has an attribute of this name.
fn is_of_other_shape(spec: &ElementSpec, name: &str) -> bool {
    is_shape(spec)
        && schema::elements().any(|other| is_shape(other) && other.attribute(name).is_some())
}

fn is_shape(spec: &ElementSpec) -> bool {
    spec.parents.contains(&"geometry")
}

/// The name of an attribute in the source; its value, where the name stands somewhere else.
fn name_of(cx: &DocumentCx<'_>, attr: &XAttr) -> Origin {
    let origin = attr.origin;
    let source = cx.expansion.sources.get(origin.src);
    let holds = |node: &Node<'_>| node.start_tag_range().contains_range(origin.range);
    let node = source.and_then(|source| source.item.all_nodes().find(holds));
    let mut attrs = node.into_iter().flat_map(|node| node.attrs());
    let named =
        attrs.find(|other| other.value_range() == origin.range && other.name() == attr.name);
    named.map_or(origin, |named| Origin {
        range: named.name_range(),
        ..origin
    })
}
