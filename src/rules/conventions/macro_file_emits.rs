//! A file of macros that also gives elements, or a top-level file that defines macros.
use super::super::context::FileCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use base::TextRange;

pub(super) static RULE: Rule = Rule {
    code: "CNV008",
    name: "macro-file-emits",
    category: Category::Conventions,
    severity: Severity::Info,
    default: Activation::Profiles(&["ros-industrial"]),
    since: "0.1",
    fix: None,
    docs: page("macro-file-emits"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    let Some(name) = cx.source.path.file_name().and_then(|name| name.to_str()) else {
        return;
    };
    let Some(stem) = name.strip_suffix(".xacro") else {
        return;
    };
    let is_macro_file = stem.ends_with("_macro");
    let beside = cx
        .source
        .path
        .with_file_name(format!("{}_macro.xacro", stem.trim_end_matches(".urdf")));
    if !is_macro_file && !cx.world.vfs.is_file(&beside) {
        return;
    }
    for (base, item) in cx.source.document.items() {
        let Some(element) = item.element() else {
            continue;
        };
        let tag = element.name().strip_prefix("xacro:");
        let gives = !matches!(
            tag,
            Some("macro" | "property" | "arg" | "include" | "if" | "unless")
        );
        let message = match (is_macro_file, tag) {
            (true, _) if gives => {
                format!("`{}` is in a macro file, outside any macro", element.name())
            }
            (false, Some("macro")) => {
                "a macro is defined here instead of in a macro file".to_owned()
            }
            _ => continue,
        };
        let name = element.name_range().shift(base);
        out.report_in(cx.file, TextRange::new(name.start - 1, name.end), message)
            .help("put macros in `NAME_macro.xacro` and the robot that calls them in `NAME.xacro`")
            .done();
    }
}
