//! A texture that is not there.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::missing::{MissingFiles, shown};
use super::resources::resolve;
use super::shapes::{materials, visual_materials};
use super::target::FileLookup;
use base::FastSet;

pub(super) static RULE: Rule = Rule {
    code: "GEO030",
    name: "texture-not-found",
    category: Category::Geometry,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("texture-not-found"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let mut missing = MissingFiles::default();
    let visuals = cx.robot.into_iter().flat_map(visual_materials);
    let used: FastSet<&str> = visuals
        .filter_map(|(_, material)| Some(&*material.name.as_ref()?.value))
        .collect();
    for material in materials(cx) {
        // nobody reads the texture of a material that no visual names
        if material
            .name
            .as_ref()
            .is_some_and(|name| !used.contains(&*name.value))
        {
            continue;
        }
        let Some(file) = material
            .texture_file
            .as_ref()
            // the exporter of SolidWorks writes `package://name/textures/` where there is no texture
            .filter(|file| file.is_known() && !file.value.trim().ends_with('/'))
        else {
            continue;
        };
        let name = material
            .name
            .as_ref()
            .map_or("", |name| name.value.as_str());
        match resolve(cx.expansion, cx.world, file) {
            FileLookup::Missing(path, package) => {
                let what = format!("texture of material `{name}`");
                missing.add(file, what, &path, package.as_deref());
            }
            FileLookup::OtherCase(found) => {
                let message =
                    format!("texture of material `{name}` differs in case from the file on disk");
                out.report(file.origin, message)
                    .help(format!("write `{}`", shown(cx, file, &found)))
                    .done();
            }
            _ => {}
        }
    }
    missing.report(cx, out);
}
