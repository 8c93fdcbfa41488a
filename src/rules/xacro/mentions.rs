//! What the texts of a description mention, whether expansion came by or not.

use super::super::context::DocumentCx;
use super::untaken;
use crate::base::FastSet;
use crate::expand::FileIdx;
use crate::xml::{Item, Node, NodeKind};

/// The words inside of `${}` and `$()`, the names that parameters forward, and the macros that are called.
///
/// A branch that is not taken with these arguments is taken with others: what it mentions is used.
#[derive(Default)]
pub(super) struct Mentions {
    words: FastSet<String>,
    /// Names of tags behind `xacro:`.
    pub tags: FastSet<String>,
    /// Names of inserted blocks, where they are written out.
    pub blocks: FastSet<String>,
    /// Whether something is computed that could be any macro or block.
    pub computed: bool,
}

impl Mentions {
    /// Those of all files of an expansion, and of those that other arguments would bring in; none when it
    /// cannot be told which.
    pub fn of(cx: &DocumentCx<'_>) -> Option<Self> {
        Self::outside(cx, &FastSet::default())
    }

    /// The same without some files.
    pub fn outside(cx: &DocumentCx<'_>, without: &FastSet<FileIdx>) -> Option<Self> {
        let mut mentions = Self::default();
        let files = (0..).map(FileIdx).zip(&cx.expansion.files).filter(|(file, _)| !without.contains(file));
        let parts = files.flat_map(|(_, file)| file.source.document.parts());
        parts.for_each(|(_, item)| mentions.add_item(item));
        for file in untaken::files(cx)? {
            file.document.parts().for_each(|(_, item)| mentions.add_item(item));
        }
        Some(mentions)
    }

    /// Those inside of an element, the element itself not counted.
    pub fn inside(node: Node<'_>) -> Self {
        let mut mentions = Self::default();
        let inside = node.range();
        let nodes =
            node.item().all_nodes().filter(|other| *other != node && inside.contains_range(other.range()));
        nodes.for_each(|node| mentions.add_node(node));
        mentions
    }

    fn add_item(&mut self, item: &Item) {
        item.all_nodes().for_each(|node| self.add_node(node));
    }

    fn add_node(&mut self, node: Node<'_>) {
        match node.kind() {
            NodeKind::Element => {}
            NodeKind::Text | NodeKind::CData => return self.add_text(node.raw()),
            _ => return,
        }
        let tag = node.name().strip_prefix("xacro:");
        self.tags.extend(tag.map(str::to_owned));
        self.computed |= matches!(tag, Some("call" | "element"));
        for attr in node.attrs() {
            match (tag, attr.name()) {
                (Some("macro"), "params") => self.add_params(attr.raw()),
                (Some("insert_block"), "name") => {
                    self.computed |= attr.raw().contains('$');
                    self.blocks.insert(attr.raw().to_owned());
                }
                _ => {}
            }
            self.add_text(attr.raw());
        }
    }

    /// `name:=^` reads `name` where the macro is called.
    fn add_params(&mut self, params: &str) {
        for word in params.split_whitespace() {
            let forwarded =
                word.split_once('=').filter(|(_, value)| value.trim_start_matches('\'').starts_with('^'));
            self.words.extend(forwarded.map(|(name, _)| name.trim_end_matches(':').to_owned()));
        }
    }

    fn add_text(&mut self, text: &str) {
        if text.contains('$') {
            let words =
                text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty());
            self.words.extend(words.map(str::to_owned));
        }
    }

    /// Whether an expression mentions a name.
    pub fn word(&self, name: &str) -> bool {
        self.words.contains(name)
    }
}

#[cfg(test)]
mod tests {
    use super::Mentions;
    use crate::xml::Document;

    #[test]
    fn what_is_mentioned() {
        let text = "<r><xacro:macro name='m' params='a b:=^ c:=^|2 d:=3'><x y='${a * f(e)}' z='g'/>h ${i}\
                    <!-- ${j} --><xacro:arm.part/><xacro:insert_block name='k'/></xacro:macro></r>";
        let document = Document::parse(text);
        let item = document.items().next().unwrap().1.clone();
        let mut mentions = Mentions::default();
        mentions.add_item(&item);
        let found: String = "abcdefghijk".chars().filter(|c| mentions.word(&c.to_string())).collect();
        assert_eq!(found, "abcefhi");
        assert!(mentions.tags.contains("arm.part") && mentions.blocks.contains("k") && !mentions.computed);
        let inside = Mentions::inside(item.element().unwrap());
        assert!(!inside.word("b") && inside.word("a"));
    }
}
