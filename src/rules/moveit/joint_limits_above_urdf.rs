//! A limit of velocity above that of the URDF.
use super::super::beside::BesideCx;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use base::Span;

pub(super) static RULE: Rule = Rule::beside(
    "MOV002",
    "joint-limits-above-urdf",
    Category::Moveit,
    Severity::Info,
    page("joint-limits-above-urdf"),
    check,
);

/// Limits that are rounded up are not above.
const ROUNDED: f64 = 1.01;

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    for limit in cx
        .settings()
        .into_iter()
        .flat_map(|settings| &settings.limits)
    {
        let Some((value, range)) = limit
            .value("max_velocity")
            .filter(|_| limit.has("has_velocity_limits"))
        else {
            continue;
        };
        let of_robots: Vec<_> = cx
            .joints(&limit.joint.name)
            .map(|(paired, joint)| {
                let text = joint
                    .limit
                    .as_ref()
                    .and_then(|limit| limit.velocity.as_ref());
                text.and_then(|text| Some((text.number()?, paired.span(text.origin))))
            })
            .collect();
        let is_above = |known: &Option<(f64, Option<Span>)>| {
            known.is_some_and(|(most, _)| most > 0.0 && value > most * ROUNDED)
        };
        if !of_robots.iter().all(is_above) {
            continue;
        }
        let Some(Some((most, place))) = of_robots.into_iter().next() else {
            continue;
        };
        let message = format!(
            "velocity limit {value} of joint `{}` is above {most} in the URDF",
            limit.joint.name
        );
        let report = out.report_span(
            Span {
                file: cx.file,
                range,
            },
            message,
        );
        let help = format!("write at most {most}, or raise the limit in the URDF");
        report
            .help(help)
            .also_span(place, "limit of the URDF")
            .done();
    }
}
