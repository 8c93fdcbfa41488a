//! The tags of xacro itself, as they are typed.

use facts::{XacroTag, xacro_tag};

/// The tag of a name with its prefix.
pub(super) fn directive(name: &str) -> Option<&'static XacroTag> {
    xacro_tag(name.strip_prefix("xacro:")?)
}

/// What to insert, behind the name.
pub(super) fn snippet(tag: &XacroTag) -> &'static str {
    match tag.name {
        "property" => " name=\"$1\" value=\"$2\"/>$0",
        "arg" => " name=\"$1\" default=\"$2\"/>$0",
        "include" => " filename=\"$1\"/>$0",
        "macro" => " name=\"$1\" params=\"$2\">\n\t$0\n</xacro:macro>",
        "if" => " value=\"${1:\\${$2\\}}\">\n\t$0\n</xacro:if>",
        "unless" => " value=\"${1:\\${$2\\}}\">\n\t$0\n</xacro:unless>",
        "insert_block" => " name=\"$1\"/>$0",
        "call" => " macro=\"$1\"/>$0",
        "element" => " xacro:name=\"$1\"/>$0",
        "attribute" => " name=\"$1\" value=\"$2\"/>$0",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use super::snippet;

    #[test]
    fn all_tags_have_snippets() {
        let bare = facts::XACRO_TAGS.iter().find(|tag| snippet(tag).is_empty());
        assert_eq!(bare.map(|tag| tag.name), None);
    }
}
