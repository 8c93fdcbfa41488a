//! An attribute that URDF does not know on its element.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::schema::ElementSpec;
use super::super::sink::Sink;
use super::walk;
use crate::expand::{Origin, XAttr, XId};

pub(super) const RULE: Rule = Rule {
    code: "XML007",
    name: "unknown-attribute",
    category: Category::Xml,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page!("unknown-attribute"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (id, spec) in walk::known(cx) {
        for attr in &cx.expansion.tree.get(id).attrs {
            if spec.attribute(&attr.name).is_none() && !is_admitted(cx, &attr.name) {
                report(cx, id, spec, attr, out);
            }
        }
    }
}

/// Names that any element may have.
fn is_admitted(cx: &DocumentCx<'_>, name: &str) -> bool {
    let allowed = || cx.world.config.allow_attributes.iter().any(|allowed| allowed == name);
    name.contains(':') || matches!(name, "id" | "xmlns") || allowed()
}

/// The attribute that `name` seems to be meant for, of those that `element` does not have.
pub(super) fn meant(
    cx: &DocumentCx<'_>,
    element: XId,
    spec: &ElementSpec,
    name: &str,
) -> Option<(&'static str, bool)> {
    let absent = spec.attributes.iter().map(|attribute| attribute.name);
    let absent = absent.filter(|name| cx.expansion.tree.attr(element, name).is_none());
    walk::meant(name, absent)
}

fn report(cx: &DocumentCx<'_>, id: XId, spec: &ElementSpec, attr: &XAttr, out: &mut Sink<'_>) {
    let name = &attr.name;
    let message = format!("{}: URDF knows no attribute `{name}` here", walk::described(cx, id));
    let report = out.report(name_of(cx, attr), message);
    let taken: Vec<String> = spec.attributes.iter().map(|known| format!("`{}`", known.name)).collect();
    match meant(cx, id, spec, name) {
        Some((near, sure)) => {
            let safety = if sure { Safety::Safe } else { Safety::Unsafe };
            report
                .help(format!("`{near}` is meant, it seems; readers skip `{name}` in silence"))
                .replace_with(safety, format!("rename it to `{near}`"), near)
                .done();
        }
        None if taken.is_empty() => {
            report.help(format!("`{}` has no attributes; readers skip it in silence", spec.name)).done();
        }
        None => {
            let help = format!("readers skip it in silence; `{}` has {}", spec.name, taken.join(", "));
            report.help(help).done();
        }
    }
}

/// The name of an attribute in the source; its value, where the name stands somewhere else.
fn name_of(cx: &DocumentCx<'_>, attr: &XAttr) -> Origin {
    let origin = attr.origin;
    let source = cx.expansion.sources.get(origin.src.0 as usize);
    let mut attrs =
        source.into_iter().flat_map(|source| source.item.all_nodes()).flat_map(|node| node.attrs());
    let named = attrs.find(|other| other.value_range() == origin.range && other.name() == attr.name);
    named.map_or(origin, |named| Origin { range: named.name_range(), ..origin })
}
