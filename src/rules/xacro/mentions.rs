//! What the texts of a description mention, whether expansion came by or not.

use ecow::EcoString;
use memchr::memchr;

use super::super::context::DocumentCx;
use super::untaken;
use base::FastSet;
use expand::FileIdx;
use vfs::SourceFile;
use xml::{Item, Node, NodeKind};

/// The words inside of `${}` and `$()`, the names that parameters forward, and the macros that are called.
///
/// A branch that is not taken with these arguments is taken with others: what it mentions is used.
#[derive(Debug, Default)]
pub struct Mentions {
    words: FastSet<EcoString>,
    /// Names of tags behind `xacro:`.
    pub tags: FastSet<EcoString>,
    /// Names of inserted blocks, where they are written out.
    pub blocks: FastSet<EcoString>,
    /// Whether something is computed that could be any macro or block.
    pub computed: bool,
}

impl Mentions {
    fn of_file(file: &SourceFile) -> Self {
        let mut mentions = Self::default();
        file.document
            .parts()
            .for_each(|(_, item)| mentions.add_item(item));
        mentions
    }

    /// Those inside of an element, the element itself not counted.
    pub fn inside(node: Node<'_>) -> Self {
        let mut mentions = Self::default();
        let inside = node.range();
        let nodes = node
            .item()
            .all_nodes()
            .filter(|other| *other != node && inside.contains_range(other.range()));
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
        if let Some(tag) = tag {
            insert(&mut self.tags, tag);
        }
        self.computed |= matches!(tag, Some("call" | "element"));
        for attr in node.attrs() {
            match (tag, attr.name()) {
                (Some("macro"), "params") => self.add_params(attr.raw()),
                (Some("insert_block"), "name") => {
                    self.computed |= attr.raw().contains('$');
                    insert(&mut self.blocks, attr.raw());
                }
                _ => {}
            }
            self.add_text(attr.raw());
        }
    }

    /// `name:=^` reads `name` where the macro is called.
    fn add_params(&mut self, params: &str) {
        for word in params.split_whitespace() {
            let forwarded = word
                .split_once('=')
                .filter(|(_, value)| value.trim_start_matches('\'').starts_with('^'));
            self.words
                .extend(forwarded.map(|(name, _)| name.trim_end_matches(':').into()));
        }
    }

    fn add_text(&mut self, text: &str) {
        if memchr(b'$', text.as_bytes()).is_none() {
            return;
        }
        // nearly all texts are ASCII, where letters are told at once
        let ends_word = |c: char| match c.is_ascii() {
            true => !c.is_ascii_alphanumeric() && c != '_',
            false => !c.is_alphanumeric(),
        };
        // no name begins like a number
        let is_name = |word: &&str| {
            word.bytes()
                .next()
                .is_some_and(|first| !first.is_ascii_digit())
        };
        for word in text.split(ends_word).filter(is_name) {
            insert(&mut self.words, word);
        }
    }

    /// Whether an expression mentions a name.
    pub fn word(&self, name: &str) -> bool {
        self.words.contains(name)
    }

    /// Whether a macro may be called.
    pub fn tag(&self, name: &str) -> bool {
        self.tags.contains(name) || self.computed
    }

    /// Whether a block may be inserted.
    pub fn block(&self, name: &str) -> bool {
        self.blocks.contains(name) || self.computed
    }
}

/// The mentions of the files of an expansion, in their order, and of those that other arguments would bring in;
/// none when it cannot be told which.
pub(super) fn everywhere<'a>(cx: &'a DocumentCx<'_>) -> Option<&'a [Mentions]> {
    let mentions = cx.mentions.get_or_init(|| {
        let untaken = untaken::files(cx)?;
        let read = cx.expansion.files.iter().map(|file| &file.source);
        Some(
            read.chain(&untaken)
                .map(|file| Mentions::of_file(file))
                .collect(),
        )
    });
    mentions.as_deref()
}

/// The same without some files.
pub(super) fn outside<'a>(
    cx: &'a DocumentCx<'_>,
    without: &'a FastSet<FileIdx>,
) -> Option<impl Iterator<Item = &'a Mentions> + Clone> {
    let files = (0..)
        .map(FileIdx)
        .zip(everywhere(cx)?)
        .filter(|(file, _)| !without.contains(file));
    Some(files.map(|(_, mentions)| mentions))
}

/// Most names are met many times.
fn insert(names: &mut FastSet<EcoString>, name: &str) {
    if !names.contains(name) {
        names.insert(name.into());
    }
}

#[cfg(test)]
mod tests {
    use super::Mentions;
    use xml::Document;

    #[test]
    fn what_is_mentioned() {
        let text = "<r><xacro:macro name='m' params='a b:=^ c:=^|2 d:=3'><x y='${a * f(e)}' z='g'/>h ${i}\
                    <!-- ${j} --><xacro:arm.part/><xacro:insert_block name='k'/></xacro:macro></r>";
        let document = Document::parse(text);
        let item = document.items().next().unwrap().1.clone();
        let mut mentions = Mentions::default();
        mentions.add_item(&item);
        let found: String = "abcdefghijk"
            .chars()
            .filter(|c| mentions.word(&c.to_string()))
            .collect();
        assert_eq!(found, "abcefhi");
        assert!(
            mentions.tags.contains("arm.part")
                && mentions.blocks.contains("k")
                && !mentions.computed
        );
        let inside = Mentions::inside(item.element().unwrap());
        assert!(!inside.word("b") && inside.word("a"));
    }
}
