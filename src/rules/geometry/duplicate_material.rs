//! Two materials of one name.
use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastMap;
use model::AttrValue;

pub(in super::super) static RULE: Rule = Rule {
    code: "GEO027",
    name: "duplicate-material",
    category: Category::Geometry,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("duplicate-material"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let mut first: FastMap<&str, &AttrValue> = FastMap::default();
    for name in cx
        .robot
        .into_iter()
        .flat_map(|robot| &robot.materials)
        .filter_map(|material| material.name.as_ref())
    {
        let Some(value) = name.name() else { continue };
        match first.get(value.as_str()) {
            None => {
                first.insert(value, name);
            }
            Some(earlier) => out
                .report(name.origin, format!("duplicate material `{value}`"))
                .also(earlier.origin, "first defined here")
                // a file of colors that is included twice, or written out twice
                .group(Group::File)
                .help("remove one of them; urdfdom rejects the robot even if both are equal")
                .done(),
        }
    }
}
