//! The name in a `package.xml`.

use std::path::Path;

use vfs::Vfs;
use xml::{Document, NodeKind};

/// File that makes a folder a package.
pub const MANIFEST: &str = "package.xml";

/// The `<name>` of the package whose folder is `folder`; `None` when it holds no usable `package.xml`.
pub(super) fn package_name(vfs: &Vfs, folder: &Path) -> Option<String> {
    // read and parsed once, however often it is asked
    let file = vfs.document(&folder.join(MANIFEST)).ok()?;
    name_of(&file.document)
}

/// The name a manifest declares. One that is not well-formed is searched for the first `<name>`.
pub(super) fn name_in(text: &str) -> Option<String> {
    name_of(&Document::parse(text))
}

fn name_of(document: &Document) -> Option<String> {
    let name = if document.errors().is_empty() {
        declared_name(document)?
    } else {
        first_name(&document.text())?.to_owned()
    };
    let name = name.trim();
    is_package_name(name).then(|| name.to_owned())
}

/// The text of the first `<name>` of a package, as far as the next markup.
fn declared_name(document: &Document) -> Option<String> {
    document
        .root()
        .filter(|root| root.local_name() == "package")?;
    let mut elements = document.items().filter_map(|(_, item)| item.element());
    let name = elements.find(|element| element.local_name() == "name")?;
    let is_text = |kind| matches!(kind, NodeKind::Text | NodeKind::CData);
    let texts = name.children().take_while(|node| is_text(node.kind()));
    Some(texts.map(|node| node.text(document.entities())).collect())
}

fn first_name(text: &str) -> Option<&str> {
    let mut rest = text;
    loop {
        let (at, comment) = (rest.find("<name>")?, rest.find("<!--"));
        match comment.filter(|&comment| comment < at) {
            Some(comment) => {
                let behind = rest.get(comment..)?;
                rest = behind.get(behind.find("-->")?..)?;
            }
            None => return rest.get(at + "<name>".len()..)?.split('<').next(),
        }
    }
}

/// Whether a text can be the name of a package at all: one path component that says where it is.
pub(super) fn is_package_name(name: &str) -> bool {
    !name.is_empty() && name != "." && !name.contains("..") && !name.contains(['/', '\\', '\0'])
}

#[cfg(test)]
mod tests {
    use super::{is_package_name, name_in};

    #[test]
    fn names() {
        let table = [
            ("<package><name>a_b</name></package>", Some("a_b")),
            (
                "<?xml version='1.0'?>\n<package format='3'>\n<name>\n a \n</name></package>",
                Some("a"),
            ),
            ("<package><name>a</name><name>b</name></package>", Some("a")),
            (
                "<package><export><name>x</name></export><name>a</name></package>",
                Some("a"),
            ),
            (
                "<package><!-- <name>no</name> --><name>yes</name>",
                Some("yes"),
            ),
            ("<package><name>a & b</name></package>", Some("a & b")),
            ("<package><name>half", Some("half")),
            (
                "<!DOCTYPE package [<!ENTITY x 'b'>]><package><name>a&x;<![CDATA[c]]><!-- d -->e</name></package>",
                Some("abc"),
            ),
            ("<package><name><!-- a -->b</name></package>", None),
            (
                "<p:package xmlns:p='p'><p:name>a</p:name></p:package>",
                Some("a"),
            ),
            ("<package><name/></package>", None),
            ("<package/>", None),
            ("<stack><name>a</name></stack>", None),
            ("<package><!-- <name>no", None),
            ("", None),
            ("<package><name>../x</name></package>", None),
        ];
        for (text, expected) in table {
            assert_eq!(name_in(text).as_deref(), expected, "{text}");
        }
    }

    #[test]
    fn sanity() {
        for bad in ["", ".", "..", "a/b", "../a", "/", "a\0", "a\\b"] {
            assert!(!is_package_name(bad), "{bad:?}");
        }
        for good in ["a", "ur_description", "a-b", "a.b", "é"] {
            assert!(is_package_name(good), "{good}");
        }
    }
}
