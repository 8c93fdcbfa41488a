//! Where an offset lies in the tree of a document, as one who types there sees it: what is begun in front of the
//! offset and has no end yet is what is typed, with the blanks behind it.
//!
//! Only the item around the offset is looked at, and the one in front of it where a tag was left open at its end.

use super::Typing;
use super::tag::{TypedTag, has_bracket};
use base::TextRange;
use xml::{Document, DocumentPart, Item, Node, NodeKind};

/// What is typed, and where that begins in the document.
pub(super) struct TypedText<'a> {
    pub what: Typing<'a>,
    /// Where the text begins that was typed of it.
    pub start: u32,
    /// The start tag that it is in.
    pub tag: Option<TypedTag<'a>>,
    /// Where the thing begins that is around it: the elements that are open there are those around.
    pub around: u32,
}

/// A place in an item, and the last node that begins in front of it.
pub(super) struct Spot<'a> {
    pub part: DocumentPart,
    pub base: u32,
    pub item: &'a Item,
    pub inside: u32,
    pub last: Option<Node<'a>>,
}

impl<'a> Spot<'a> {
    /// The place directly in front of `offset`.
    pub fn of(document: &'a Document, offset: u32) -> Self {
        let place = document.item_at(offset.saturating_sub(1));
        let inside = offset - place.start;
        let begun = |node: &Node<'_>| node.range().start < inside;
        Self {
            part: place.part,
            base: place.start,
            item: place.item,
            inside,
            last: place.item.all_nodes().take_while(begun).last(),
        }
    }

    /// The last node and the elements around it, the innermost first.
    pub fn ancestors(&self) -> impl Iterator<Item = Node<'a>> {
        std::iter::successors(self.last, |node| node.parent())
    }

    pub fn text(&self, start: u32, end: u32) -> &'a str {
        let text = self.item.text();
        text.get(start as usize..end as usize).unwrap_or("")
    }

    /// What is typed where nothing stands between the last node and the offset but `gap`, which are blanks.
    fn in_last(&self, gap: &str) -> Option<TypedText<'a>> {
        let node = self.last?;
        let range = node.range();
        let is_inside = self.inside < range.end;
        let text = node.range().slice(self.item.text());
        match node.kind() {
            NodeKind::Element => self.in_tag(node, gap),
            NodeKind::Text => None,
            NodeKind::Comment => {
                let raw = node.raw_range();
                let is_open = is_inside || raw.end == range.end;
                let what = if self.inside < raw.start {
                    Typing::Nothing
                } else {
                    Typing::Comment
                };
                is_open.then(|| self.found(what, raw.start.min(self.inside), range.start))
            }
            NodeKind::Junk if self.inside <= range.end => self.in_junk(node, gap),
            NodeKind::Junk => None,
            NodeKind::CData => {
                let is_open = is_inside || !text.ends_with("]]>");
                is_open.then(|| self.found(Typing::Nothing, self.inside, range.start))
            }
            _ => {
                let is_open = is_inside || !text.ends_with('>');
                is_open.then(|| self.found(Typing::Nothing, self.inside, range.start))
            }
        }
    }

    pub fn found(&self, what: Typing<'a>, start: u32, around: u32) -> TypedText<'a> {
        TypedText {
            what,
            start: self.base + start,
            tag: None,
            around: self.base + around,
        }
    }

    /// What is typed in text that is no XML: a `<` without a name, an end tag that closes nothing.
    fn in_junk(&self, junk: Node<'a>, gap: &str) -> Option<TypedText<'a>> {
        let start = junk.range().start;
        let typed = self.text(start, self.inside);
        if let Some(name) = typed.strip_prefix("</") {
            let is_name = !name.contains(|c: char| c.is_whitespace() || c == '>');
            return if is_name {
                Some(self.found(Typing::EndTag, start + 2, start))
            } else if name.contains('>') {
                None
            } else {
                Some(self.found(Typing::Nothing, self.inside, start))
            };
        }
        let is_markup = typed.starts_with("<!") && !typed.contains('>');
        match typed {
            "<" if gap.is_empty() => Some(self.found(Typing::Tag, self.inside, start)),
            _ if is_markup || typed.starts_with("<<") => {
                Some(self.found(Typing::Nothing, self.inside, start))
            }
            _ => None,
        }
    }
}

/// Whether the content of an element lies around a place in its item, or begins or ends there.
fn is_open(node: Node<'_>, inside: u32) -> bool {
    let (range, start) = (node.range(), node.start_tag_range().end);
    // a tag without an end that nothing stands in was given up by the parser
    let has_content = !node.is_self_closing() && (has_bracket(node) || start < range.end);
    let end = node.end_tag().map_or(range.end, |tag| tag.start);
    node.kind() == NodeKind::Element && has_content && start <= inside && inside <= end
}

/// The elements whose content is around an offset, the outermost first.
pub(super) fn open_at<'a>(document: &'a Document, offset: u32) -> Vec<Node<'a>> {
    let spot = Spot::of(document, offset);
    let in_header = spot.part == DocumentPart::Header;
    let is_root_open = |root: &Node<'_>| {
        let tag = root.start_tag_range();
        !root.is_self_closing() && tag.end <= offset && (!in_header || has_bracket(*root))
    };
    let root = document.root().filter(is_root_open);
    let is_around = |node: &Node<'_>| !in_header && is_open(*node, spot.inside);
    let mut open: Vec<Node<'a>> = spot.ancestors().filter(is_around).chain(root).collect();
    open.reverse();
    open
}

/// What is typed at an offset.
pub(super) fn find<'a>(document: &'a Document, offset: u32) -> TypedText<'a> {
    let spot = Spot::of(document, offset);
    if let Some(found) = in_root_end(document, &spot, offset) {
        return found;
    }
    let found = behind_open(document, &spot)
        .or_else(|| spot.in_last(""))
        .or_else(|| in_end_tag(&spot))
        .unwrap_or_else(|| spot.found(Typing::Content, start_of_text(&spot), spot.inside));
    let is_behind_root = document.root_is_closed_empty() && offset >= document.header().len();
    if is_behind_root && found.what != Typing::Comment {
        spot.found(Typing::Nothing, spot.inside, spot.inside)
    } else {
        found
    }
}

/// What is typed in the end tag of the root; nothing can be typed behind it.
fn in_root_end<'a>(document: &Document, spot: &Spot<'a>, offset: u32) -> Option<TypedText<'a>> {
    let tag = document.root_end_tag().filter(|tag| tag.start < offset)?;
    let typed = document.slice(TextRange::new(tag.start, offset.min(tag.end)));
    let name = typed.strip_prefix("</").filter(|_| offset <= tag.end);
    let is_name = name.is_some_and(|name| !name.contains(|c: char| c.is_whitespace() || c == '>'));
    Some(if is_name {
        TypedText {
            what: Typing::EndTag,
            start: tag.start + 2,
            tag: None,
            around: tag.start,
        }
    } else {
        spot.found(Typing::Nothing, spot.inside, spot.inside)
    })
}

/// Where the text begins that is in front of a place, behind the last thing that is or looks like a tag.
fn start_of_text(spot: &Spot<'_>) -> u32 {
    let Some(node) = spot.last.filter(|node| spot.inside <= node.range().end) else {
        return spot.inside;
    };
    let start = node.range().start;
    let text = spot.text(start, spot.inside);
    match node.kind() {
        NodeKind::Text => start,
        NodeKind::Junk if !text.starts_with('<') => start,
        NodeKind::Junk => start + text.find('>').map_or(1, |end| end + 1) as u32,
        _ => spot.inside,
    }
}

/// What is typed in blanks behind something without an end.
fn behind_open<'a>(document: &'a Document, spot: &Spot<'a>) -> Option<TypedText<'a>> {
    let node = spot.last?;
    let range = node.range();
    let (begin, gap) = match node.kind() {
        NodeKind::Text => (range.start, spot.text(range.start, spot.inside)),
        // outside of the root, blanks are no text
        NodeKind::Comment | NodeKind::Pi | NodeKind::Doctype => {
            return spot.in_last(spot.text(range.end, spot.inside));
        }
        _ => return None,
    };
    if gap.is_empty() || !gap.trim().is_empty() || spot.base + begin == 0 {
        return None;
    }
    let outer = Spot::of(document, spot.base + begin);
    let found = outer.in_last(gap).or_else(|| in_end_tag(&outer))?;
    Some(match found.what {
        // behind the name of a tag without an end
        Typing::EndTag | Typing::Tag => TypedText {
            what: Typing::Nothing,
            ..found
        },
        Typing::Attribute(_) => TypedText {
            start: spot.base + spot.inside,
            ..found
        },
        _ => found,
    })
}

/// What is typed in the end tag of the last node or of an element around it.
fn in_end_tag<'a>(spot: &Spot<'a>) -> Option<TypedText<'a>> {
    let is_around = |node: &Node<'_>| {
        node.end_tag().is_some_and(|tag| {
            let is_open = !tag.slice(spot.item.text()).ends_with('>');
            tag.start < spot.inside && (spot.inside < tag.end || spot.inside == tag.end && is_open)
        })
    };
    let node = spot.ancestors().find(is_around)?;
    let (tag, name) = (node.end_tag()?, node.end_name_range()?);
    let is_name = name.start <= spot.inside && spot.inside <= name.end;
    Some(if is_name {
        spot.found(Typing::EndTag, name.start, tag.start)
    } else {
        spot.found(Typing::Nothing, spot.inside, tag.start)
    })
}
