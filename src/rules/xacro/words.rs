//! The words that the texts of a description mention.
use ecow::EcoString;
use memchr::memchr;

use base::FastSet;
use vfs::SourceFile;
use xml::{Item, Node, NodeKind};

/// The words inside of `${}` and `$()`, the names that parameters forward, and the macros that are called.
///
/// A branch that is not taken with these arguments is taken with others: what it mentions is used.
#[derive(Debug, Default)]
pub struct MentionedWords {
    words: FastSet<EcoString>,
    /// Names of tags behind `xacro:`.
    pub tags: FastSet<EcoString>,
    /// Names of inserted blocks, where they are written out.
    pub blocks: FastSet<EcoString>,
    /// Whether something is computed that could be any macro or block.
    pub computed: bool,
}

impl MentionedWords {
    pub fn of_file(file: &SourceFile) -> Self {
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

    pub fn add_item(&mut self, item: &Item) {
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
        let ends_word = |c: char| {
            if c.is_ascii() {
                !c.is_ascii_alphanumeric() && c != '_'
            } else {
                !c.is_alphanumeric()
            }
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

/// Most names are met many times.
fn insert(names: &mut FastSet<EcoString>, name: &str) {
    if !names.contains(name) {
        names.insert(name.into());
    }
}
