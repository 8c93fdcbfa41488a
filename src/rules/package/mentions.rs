//! The packages that a file names.
use std::sync::LazyLock;

use memchr::memchr2;
use memchr::memmem::Finder;

use super::super::context::FileCx;
use super::super::package::mention::PackageMention;
use base::TextRange;
use facts::parts_where;
use xml::{Node, NodeKind};

/// The packages in `package://` URIs and in `$(find)` of a file, comments left out.
pub(super) fn packages<'a>(cx: &'a FileCx<'_>) -> &'a [PackageMention] {
    cx.packages.get_or_init(|| of_file(cx))
}

fn of_file(cx: &FileCx<'_>) -> Vec<PackageMention> {
    let mut found: Vec<PackageMention> = Vec::new();
    for (base, item) in parts_where(&cx.source.document, |marks| marks.package) {
        for node in item.all_nodes() {
            let known = found.len();
            match node.kind() {
                NodeKind::Element => {
                    for attr in node.attrs() {
                        in_text(attr.raw(), attr.value_range().start + base, &mut found);
                    }
                }
                NodeKind::Text | NodeKind::CData => {
                    in_text(node.raw(), node.raw_range().start + base, &mut found)
                }
                _ => {}
            }
            if found.len() > known && is_conditional(node) {
                found
                    .iter_mut()
                    .skip(known)
                    .for_each(|mention| mention.is_conditional = true);
            }
        }
    }
    found
}

fn is_conditional(node: Node<'_>) -> bool {
    let around = std::iter::successors(node.parent(), |node| node.parent());
    around
        .into_iter()
        .any(|node| matches!(node.name(), "xacro:if" | "xacro:unless"))
}

static URI: LazyLock<Finder<'_>> = LazyLock::new(|| Finder::new("package://"));
static FIND: LazyLock<Finder<'_>> = LazyLock::new(|| Finder::new("$(find "));

fn in_text(text: &str, base: u32, found: &mut Vec<PackageMention>) {
    if memchr2(b':', b'(', text.as_bytes()).is_none() {
        return;
    }
    for (lead, is_uri) in [(&*URI, true), (&*FIND, false)] {
        let lead_len = lead.needle().len();
        for at in lead.find_iter(text.as_bytes()) {
            let rest = text.get(at + lead_len..).unwrap_or_default();
            let blanks = rest.len() - rest.trim_start_matches(' ').len();
            let (start, rest) = (at + lead_len + blanks, rest.trim_start_matches(' '));
            let end = rest
                .find(|c: char| !c.is_alphanumeric() && !matches!(c, '_' | '-' | '.'))
                .unwrap_or(rest.len());
            let behind = rest.get(end..).unwrap_or_default();
            let closed = if is_uri {
                behind.starts_with('/')
            } else {
                behind.trim_start().starts_with(')')
            };
            if end == 0 || !closed || (is_uri && blanks > 0) {
                continue;
            }
            let path = behind.strip_prefix('/').filter(|_| is_uri).map(|path| {
                let length = path
                    .find(['$', '<', '&', ' ', '"', '\''])
                    .unwrap_or(path.len());
                let from = start + end + 1;
                (
                    path.get(..length).unwrap_or_default().to_owned(),
                    range(from, from + length).shift(base),
                )
            });
            let name = rest.get(..end).unwrap_or_default().to_owned();
            found.push(PackageMention {
                name,
                range: range(start, start + end).shift(base),
                is_conditional: false,
                path,
            });
        }
    }
}

fn range(start: usize, end: usize) -> TextRange {
    TextRange::new(start as u32, end as u32)
}

#[cfg(test)]
mod tests {
    use super::in_text;

    #[test]
    fn names_in_texts() {
        let table = [
            ("package://arm_description/meshes/a.stl", "arm_description"),
            ("file://$(find arm)/a.stl", "arm"),
            ("$(find  arm )/a $(find b)/c", "arm b"),
            ("package://${pkg}/a", ""),
            ("package://a$(arg b)/c", ""),
            ("$(find $(arg pkg))/a", ""),
            ("package:///a", ""),
            ("package://arm", ""),
        ];
        for (text, expected) in table {
            let mut found = Vec::new();
            in_text(text, 0, &mut found);
            let names: Vec<&str> = found.iter().map(|found| found.range.slice(text)).collect();
            assert_eq!(names.join(" "), expected, "{text}");
        }
    }

    #[test]
    fn paths_end_where_something_is_computed() {
        let text = "package://arm/meshes/${part}.stl";
        let mut found = Vec::new();
        in_text(text, 0, &mut found);
        assert_eq!(
            found[0].path.as_ref().map(|(path, _)| path.as_str()),
            Some("meshes/")
        );
    }
}
