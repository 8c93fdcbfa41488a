//! A color outside of 0 to 1.
use ecow::EcoString;

use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::shapes::{materials, visual_materials};

pub(super) static RULE: Rule = Rule {
    code: "GEO025",
    name: "color-out-of-range",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("color-out-of-range"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot else { return };
    for material in materials(cx) {
        let Some(text) = &material.rgba else { continue };
        let Some(numbers) = text.numbers::<4>() else {
            continue;
        };
        if numbers.iter().all(|number| (0.0..=1.0).contains(number)) {
            continue;
        }
        let name = material
            .name
            .as_ref()
            .map_or("", |name| name.value.as_str());
        // what no visual has is not drawn
        let is_drawn = robot.links.is_empty()
            || visual_materials(robot).any(|(_, own)| {
                std::ptr::eq(own, material)
                    || own.name.as_ref().is_some_and(|own| own.value == name)
            });
        let severity = if is_drawn {
            Severity::Warning
        } else {
            Severity::Info
        };
        let message = format!("color of material `{name}` is outside the range 0 to 1");
        let report = out
            .report(text.origin, message)
            .severity(severity)
            // who writes 255 once does so everywhere
            .group(Group::Value(EcoString::new()))
            .help("write red, green, blue and alpha from 0 to 1");
        match from_bytes(numbers).filter(|_| text.is_literal()) {
            Some(content) => report
                .replace_with(Safety::Unsafe, "divide color values by 255", content)
                .done(),
            None => report.done(),
        }
    }
}

/// The color when it was given as 0 to 255; an alpha of at most 1 stays.
fn from_bytes([red, green, blue, alpha]: [f64; 4]) -> Option<String> {
    let colors = [red, green, blue];
    let fits = |number: &f64| (0.0..=255.0).contains(number) && number.fract() == 0.0;
    let alpha = if alpha > 1.0 { alpha / 255.0 } else { alpha };
    let meant = colors.iter().all(fits) && (0.0..=1.0).contains(&alpha);
    let [red, green, blue] = colors.map(|color| color / 255.0);
    let rounded = [red, green, blue, alpha].map(|part| (part * 1e4).round() / 1e4);
    let [red, green, blue, alpha] = rounded;
    meant.then(|| format!("{red} {green} {blue} {alpha}"))
}
