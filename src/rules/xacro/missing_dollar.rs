//! A name in braces that xacro leaves as it is, because the `$` before it is missing.
use super::super::context::FileCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use base::{FastSet, TextRange};
use expand::{SymbolKind, XId, XKind};
use facts::parts_where;
use xml::{Node, NodeKind};

pub(in super::super) static RULE: Rule = Rule {
    code: "XAC043",
    name: "missing-dollar",
    category: Category::Xacro,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("missing-dollar"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    let mut places = Vec::new();
    for (base, item) in parts_where(&cx.source.document, |marks| marks.bare_brace) {
        for node in item.all_nodes() {
            match node.kind() {
                NodeKind::Element => places.extend(
                    node.attrs()
                        .map(|attr| (attr.value_range(), attr.raw(), node))
                        .flat_map(|(range, raw, node)| found(raw, range, node))
                        .map(|found| found.shift(base)),
                ),
                NodeKind::Text => places.extend(
                    found(node.range().slice(item.text()), node.range(), node)
                        .map(|found| found.shift(base)),
                ),
                _ => {}
            }
        }
    }
    if places.is_empty() {
        return;
    }
    let names = names(cx);
    let reached = bare_in_robot(cx);
    for Bare { range, name, .. } in places
        .into_iter()
        .filter(|bare| names.contains(bare.name) || bare.params.contains(&bare.name))
    {
        let text = cx.source.document.slice(range);
        // in a branch or macro that no call reaches, nobody gets it
        let severity = if reached.contains(text.as_str()) {
            RULE.severity
        } else {
            Severity::Info
        };
        out.report_in(
            cx.file,
            range,
            format!("`{text}` is not an expression; xacro leaves it as it is"),
        )
        .severity(severity)
        .help(format!("write `${{{name}}}`"))
        .replace_with(
            Safety::Unsafe,
            "make it an expression",
            format!("${{{name}}}"),
        )
        .done();
    }
}

/// The names in braces without `$` that texts and attributes of the robot have, with the braces.
fn bare_in_robot<'a>(cx: &FileCx<'a>) -> FastSet<&'a str> {
    let tree = &cx.expansion.tree;
    let nodes = tree.below(XId::DOCUMENT).map(|id| tree.get(id));
    let texts = nodes.flat_map(|node| {
        let text = (node.kind == XKind::Text).then_some(&node.text);
        text.into_iter()
            .chain(node.attrs.iter().map(|attr| &attr.value))
    });
    texts
        .flat_map(|text| {
            let starts = text.match_indices(['{', '(']);
            starts.filter_map(|(at, _)| Some(bare(text, at)?.0.slice(text)))
        })
        .collect()
}

/// The properties of the robot.
fn names<'a>(cx: &FileCx<'a>) -> FastSet<&'a str> {
    let all = cx.expansion.index.symbols.definitions.iter();
    all.filter(|definition| definition.kind == SymbolKind::Property)
        .map(|definition| definition.name.as_str())
        .collect()
}

/// A name in braces without `$`.
struct Bare<'a> {
    range: TextRange,
    name: &'a str,
    /// The parameters of the macro around it.
    params: Vec<&'a str>,
}

impl Bare<'_> {
    fn shift(self, base: u32) -> Self {
        Self {
            range: self.range.shift(base),
            ..self
        }
    }
}

/// The names in braces without `$`, and in brackets with one, in the text of a node: `{name}` and `($name)`.
fn found<'a>(
    text: &'a str,
    range: TextRange,
    node: Node<'a>,
) -> impl Iterator<Item = Bare<'a>> + 'a {
    let mut depth = 0_u32;
    let mut before = ' ';
    let mut places = Vec::new();
    for (at, c) in text.char_indices() {
        match c {
            // what stands in an expression is Python's
            '{' if before == '$' || depth > 0 => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            '{' | '(' => places.extend(bare(text, at)),
            _ => {}
        }
        before = c;
    }
    places.into_iter().map(move |(place, name)| Bare {
        range: place.shift(range.start),
        name,
        params: params(node),
    })
}

/// `{name}` or `($name)` at a place.
fn bare(text: &str, at: usize) -> Option<(TextRange, &str)> {
    let rest = text.get(at..)?;
    let (open, close) = if rest.starts_with('{') {
        ("{", '}')
    } else {
        ("($", ')')
    };
    let (name, _) = rest.strip_prefix(open)?.split_once(close)?;
    let is_name = name.len() > 1
        && !name.starts_with(|c: char| c.is_ascii_digit())
        && name.chars().all(|c| c.is_alphanumeric() || c == '_');
    let end = at + open.len() + name.len() + 1;
    is_name.then(|| (TextRange::new(at as u32, end as u32), name))
}

/// The parameters of the macros around a node.
fn params<'a>(node: Node<'a>) -> Vec<&'a str> {
    let all = std::iter::successors(Some(node), |node| node.parent());
    let texts = all
        .filter(|node| node.name() == "xacro:macro")
        .filter_map(|node| Some(node.attr("params")?.raw()));
    texts
        .flat_map(str::split_whitespace)
        .filter_map(|word| word.split([':', '=']).next())
        .collect()
}
