//! A file without an XML declaration.
use super::super::context::FileCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use base::TextRange;

pub(super) static RULE: Rule = Rule {
    code: "STY003",
    name: "missing-xml-declaration",
    category: Category::Style,
    severity: Severity::Hint,
    default: Activation::Profiles(&["pedantic"]),
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("missing-xml-declaration"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    let header = cx.source.document.header().text();
    // a byte order mark may stand in front
    if header.trim_start_matches('\u{feff}').starts_with("<?xml") {
        return;
    }
    let length = header.lines().next().map_or(0, str::len) as u32;
    let edit = (TextRange::empty(0), "<?xml version=\"1.0\"?>\n".to_owned());
    out.report_in(
        cx.file,
        TextRange::new(0, length),
        "file has no XML declaration",
    )
    .help("add <?xml version=\"1.0\"?> at the start of the file")
    .fix(Safety::Safe, "add the XML declaration", cx.file, [edit])
    .done();
}
