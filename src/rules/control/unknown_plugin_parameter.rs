//! A parameter of a plugin of Gazebo that the plugin does not read, as it is called otherwise.
use super::super::context::DocumentCx;
use super::super::finding::Help;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::xml::tag_names;
use super::plugin_parameters::{KnownPlugin, is_default};
use super::plugins::plugins;
use expand::XId;
use model::{AttrValue, tag_start};
use packages::{RosVersion, nearest};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL040",
    name: "unknown-plugin-parameter",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("unknown-plugin-parameter"),
    check: Check::Document(check),
};

/// A plugin has some twenty parameters.
const MOST: usize = 100;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    for plugin in plugins(cx) {
        let library = AttrValue::attr(tree, plugin, "filename").filter(AttrValue::is_known);
        let Some(library) = library else { continue };
        let Some(known) = KnownPlugin::of(&library.value, version(cx, &library)) else {
            continue;
        };
        let given: Vec<XId> = tree.elements(plugin).take(MOST).collect();
        let is_given = |name: &str| given.iter().any(|&id| tree.get(id).text == name);
        for &parameter in &given {
            let name = tree.get(parameter).text.as_str();
            if known.may_read(name) {
                continue;
            }
            let classic = known.instead_of(name);
            let meant = classic.or_else(|| nearest(name, known.names_like(name)));
            let Some(meant) = meant.filter(|meant| !is_given(meant)) else {
                continue;
            };
            let value = AttrValue::content(tree, parameter);
            let value = value.as_ref().map_or("", |value| value.value.trim());
            if !is_default(meant, value) {
                report(cx, (&library.value, parameter), meant, out);
            }
        }
    }
}

fn report(cx: &DocumentCx<'_>, (library, parameter): (&str, XId), meant: &str, out: &mut Sink<'_>) {
    let name = &cx.expansion.tree.get(parameter).text;
    let message = format!("`{library}` does not read `{name}`");
    let is_halved = name.to_lowercase().ends_with("diameter") && meant == "wheel_radius";
    let help = if is_halved {
        Help::from("write half of it in `wheel_radius`; the plugin silently takes its default")
    } else {
        Help::did_you_mean(meant).and("The plugin silently takes its default")
    };
    let report = out
        .report(tag_start(cx.expansion, parameter), message)
        .group(Group::Name(format!("{library} {name}").into()))
        .help(help);
    match tag_names(cx.expansion, parameter).filter(|_| !is_halved) {
        Some((file, names)) => {
            let edits = names.into_iter().map(|range| (range, meant.to_owned()));
            let what = format!("rename to `{meant}`");
            report.fix(Safety::Unsafe, what, file, edits).done();
        }
        None => report.done(),
    }
}

/// The ROS for which the file is that names a library.
fn version(cx: &DocumentCx<'_>, library: &AttrValue) -> Option<RosVersion> {
    let place = cx.expansion.place(library.origin)?;
    let file = cx.expansion.files.get(place.file)?;
    cx.world.packages.generation_around(&file.source.path)
}
