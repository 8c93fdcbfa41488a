//! A folder that is used and not installed.
use super::super::context::FileCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::mentions;
use base::{FastSet, TextRange};

pub(super) static RULE: Rule = Rule {
    code: "PKG003",
    name: "resource-not-installed",
    category: Category::Package,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("resource-not-installed"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    let mentions = mentions::packages(cx);
    let Some(package) = cx
        .world
        .packages
        .containing(&cx.source.path)
        .filter(|_| !mentions.is_empty())
    else {
        return;
    };
    let own = mentions
        .iter()
        .filter(|mention| mention.name == package.name);
    let mut folders =
        own.filter_map(|mention| mention.path.as_ref())
            .filter_map(|(path, range)| {
                let (folder, _) = path
                    .rsplit_once('/')
                    .filter(|(folder, _)| !folder.is_empty())?;
                Some((
                    folder,
                    TextRange::new(range.start, range.start + folder.len() as u32),
                ))
            });
    let Some(first) = folders.next() else { return };
    // what is installed by rules that cannot be worked out may be anything
    let build = cx
        .world
        .packages
        .build_around(&cx.source.path)
        .filter(|build| !build.is_opaque);
    let Some(build) = build else { return };
    let Some(file) = build.files.iter().find(|file| cx.world.vfs.is_file(file)) else {
        return;
    };
    let file = file.file_name().unwrap_or_default().to_string_lossy();
    let mut said: FastSet<&str> = FastSet::default();
    for (folder, range) in std::iter::once(first).chain(folders) {
        if said.insert(folder) && !build.covers(&package.name, folder) {
            out.report_in(
                cx.file,
                range,
                format!("package `{}` does not install `{folder}`", package.name),
            )
            .help(format!("add `{folder}` to the install rules in {file}"))
            .done();
        }
    }
}
