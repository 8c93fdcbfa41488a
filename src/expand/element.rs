//! The pass over the document: which tag does what.
use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

use ecow::EcoString;

use super::expander::Expander;
use super::kind::ProblemKind;
use super::names::EvalContext;
use super::node::{XAttr, XId, XKind};
use super::origin::{FileIdx, Origin, SrcId};
use super::params::strip;
use super::scope::TextOrigin;
use super::stack::with_stack;
use super::tag::{SiblingState, Tag};
use base::TextRange;
use base::limits::ELEMENT_DEPTH;
use expr::{Value, display, literal};
use xml::{Entities, Item, Node, NodeKind, normalize_line_ends, printed_doctype};

impl Expander<'_> {
    /// The whole root document.
    pub fn eval_document(&mut self, file: FileIdx, cx: EvalContext) {
        let Some(used) = self.result.files.get(file) else {
            return;
        };
        let document = used.source.document.clone();
        let header = used.first_source;
        let footer = SrcId(header.0 + 1 + used.items);
        if let Some(entry) = self.resume(file) {
            let mut siblings = SiblingState::new(header, entry.root, cx);
            siblings.eval_comments = entry.eval_comments;
            self.eval_items(file, entry.item, siblings);
        } else {
            for node in document.header().nodes() {
                if Some(node.id()) == document.root().map(|r| r.id()) {
                    self.eval_root(node, header, file, cx);
                } else {
                    self.copy_verbatim(node, header, XId::DOCUMENT, cx);
                }
            }
        }
        for node in document.epilog() {
            self.copy_verbatim(node, footer, XId::DOCUMENT, cx);
        }
    }

    fn eval_root(&mut self, node: Node<'_>, src: SrcId, file: FileIdx, cx: EvalContext) {
        let origin = Origin {
            src,
            range: node.start_tag_range(),
            frame: cx.frame,
        };
        let root = self
            .result
            .tree
            .add(XKind::Element, node.name().into(), origin);
        self.result.tree.append(XId::DOCUMENT, root);
        let tag = Tag {
            node,
            src,
            name: node.name(),
            used: &[],
        };
        self.eval_attributes(tag, root, cx);
        let namespace = self
            .attr(tag, "xacro:targetNamespace", cx)
            .filter(|(value, _)| !value.is_empty());
        if let Some((text, place)) = namespace {
            let (value, pieces) = self.eval_pieces(&text, place, cx);
            self.result.tree.set_attr(
                root,
                XAttr {
                    name: "xmlns".into(),
                    value,
                    origin: place.origin,
                    pieces,
                },
            );
        }
        self.eval_root_content(file, root, cx);
    }

    /// The children of a file's root element, item by item.
    pub fn eval_root_content(&mut self, file: FileIdx, out: XId, cx: EvalContext) {
        let Some(used) = self.result.files.get(file) else {
            return;
        };
        let siblings = SiblingState::new(used.first_source, out, cx);
        self.eval_items(file, 0, siblings);
    }

    /// The children of a file's root element from an item on.
    fn eval_items(&mut self, file: FileIdx, first: usize, mut siblings: SiblingState) {
        let Some(used) = self.result.files.get(file) else {
            return;
        };
        let document = used.source.document.clone();
        let (header, count) = (used.first_source, used.items);
        let has_tail = document.footer_content().next().is_some();
        let mut next = first;
        while next < count as usize {
            if self.has_checkpoints(&siblings) {
                if let Some(behind) = self.leave_out(next, &mut siblings) {
                    next = behind;
                    continue;
                }
                self.add_checkpoint(next, &siblings);
            }
            let i = next as u32;
            next += 1;
            siblings.src = SrcId(header.0 + 1 + i);
            let Some(item) = self
                .result
                .sources
                .get(siblings.src)
                .map(|source| source.item.clone())
            else {
                continue;
            };
            let more = i + 1 < count || has_tail;
            self.eval_nodes(item.nodes(), more, &mut siblings);
        }
        siblings.src = SrcId(header.0 + 1 + count);
        self.eval_nodes(document.footer_content(), false, &mut siblings);
    }

    /// The children of an element inside an item.
    pub fn eval_children(&mut self, node: Node<'_>, src: SrcId, out: XId, cx: EvalContext) {
        let mut siblings = SiblingState::new(src, out, cx);
        self.eval_nodes(node.children(), false, &mut siblings);
    }

    /// A run of siblings; `more`: siblings in another item follow.
    fn eval_nodes<'a>(
        &mut self,
        nodes: impl Iterator<Item = Node<'a>>,
        more: bool,
        siblings: &mut SiblingState,
    ) {
        let SiblingState { src, out, cx, .. } = *siblings;
        let mut joined = None;
        for node in nodes {
            if self.tick(Origin {
                src,
                range: node.range(),
                frame: cx.frame,
            }) {
                return;
            }
            if joined == Some(node.id()) {
                // its text was taken together with the one in front of an empty CDATA section
                joined = behind_empty_cdata(node).map(|text| text.id());
                continue;
            }
            match node.kind() {
                NodeKind::CData if node.raw().is_empty() => {}
                NodeKind::Text if behind_empty_cdata(node).is_some() => {
                    joined = behind_empty_cdata(node).map(|text| text.id());
                    let texts = std::iter::successors(Some(node), |&text| behind_empty_cdata(text));
                    let text: String = texts
                        .map(|text| text.text(self.entities(src)).into_owned())
                        .collect();
                    self.push_text(&text, node, siblings);
                }
                NodeKind::Element => {
                    siblings.eval_comments = false;
                    let has_next = more || node.next_sibling().is_some();
                    let tag = Tag {
                        node,
                        src,
                        name: node.name(),
                        used: &[],
                    };
                    self.eval_tag(tag, has_next, out, cx);
                }
                NodeKind::Text => self.eval_text_node(node, siblings),
                NodeKind::Comment => self.eval_comment(node, siblings),
                _ => self.copy_verbatim(node, src, out, cx),
            }
        }
    }

    fn eval_text_node(&mut self, node: Node<'_>, siblings: &mut SiblingState) {
        let src = siblings.src;
        if let Some(name) = self
            .entities(src)
            .markup_entity(node.raw())
            .map(str::to_owned)
        {
            self.refuse_markup(
                &name,
                Origin {
                    src,
                    range: node.raw_range(),
                    frame: siblings.cx.frame,
                },
            );
        }
        let text = node.text(self.entities(src));
        self.push_text(&text, node, siblings);
    }

    /// An entity that stands for elements: the tree does not show them.
    fn refuse_markup(&mut self, name: &str, at: Origin) {
        let message = format!("entity `{name}` contains markup, which is not supported");
        let problem = self
            .problem(ProblemKind::XmlSyntaxError, at, message.clone())
            .says(message);
        self.push(problem.help("write the elements in place of `&{name};`, or use a macro"));
        self.result.complete = false;
        self.gaps.content_lost = true;
    }

    fn push_text(&mut self, text: &str, node: Node<'_>, siblings: &mut SiblingState) {
        // references to empty entities only: an XML parser makes no node of that
        if text.is_empty() {
            return;
        }
        let SiblingState { src, out, cx, .. } = *siblings;
        let origin = Origin {
            src,
            range: node.range(),
            frame: cx.frame,
        };
        let value = self
            .eval_pieces(
                text,
                TextOrigin {
                    origin,
                    is_attr: false,
                },
                cx,
            )
            .0;
        if !strip(&value).is_empty() {
            siblings.eval_comments = false;
        }
        let id = self.result.tree.add(XKind::Text, value, origin);
        self.result.tree.append(out, id);
    }

    fn eval_comment(&mut self, node: Node<'_>, siblings: &mut SiblingState) {
        let raw = node.raw();
        if raw.contains("xacro:eval-comments") {
            siblings.eval_comments = !raw.contains("xacro:eval-comments:off");
            return;
        }
        let SiblingState { src, out, cx, .. } = *siblings;
        let whole = node.range();
        // the data stands between `<!--` and `-->`
        let range = TextRange::new(whole.start + 4, whole.start + 4 + raw.len() as u32);
        let origin = Origin {
            src,
            range,
            frame: cx.frame,
        };
        let data = normalize_line_ends(raw);
        let text = if siblings.eval_comments && data.contains('$') {
            self.eval_pieces(
                &data,
                TextOrigin {
                    origin,
                    is_attr: false,
                },
                cx,
            )
            .0
        } else {
            data.as_ref().into()
        };
        let id = self.result.tree.add(
            XKind::Comment,
            text,
            Origin {
                range: whole,
                ..origin
            },
        );
        self.result.tree.append(out, id);
    }

    /// What xacro never looks into.
    fn copy_verbatim(&mut self, node: Node<'_>, src: SrcId, out: XId, cx: EvalContext) {
        let (kind, text) = match node.kind() {
            NodeKind::Comment => (XKind::Comment, normalize_line_ends(node.raw())),
            NodeKind::CData => (XKind::CData, normalize_line_ends(node.raw())),
            NodeKind::Doctype => {
                let text = normalize_line_ends(node.raw());
                (
                    XKind::Doctype,
                    Cow::Owned(printed_doctype(&text, self.keeps_subset(src))),
                )
            }
            NodeKind::Pi => {
                let data = normalize_line_ends(node.raw());
                (XKind::Pi, Cow::Owned(format!("{} {data}", node.name())))
            }
            _ => return,
        };
        let origin = Origin {
            src,
            range: node.range(),
            frame: cx.frame,
        };
        let id = self.result.tree.add(kind, text.as_ref().into(), origin);
        self.result.tree.append(out, id);
    }

    /// Whether the internal subset of a document is printed. minidom looks for it only when the first portion of
    /// the text that it reads holds the whole start tag of the root.
    fn keeps_subset(&self, header: SrcId) -> bool {
        const PORTION: usize = 16 * 1024;
        let text = self.item(header).map_or(0, |item| {
            let text = item.text();
            text.chars().count() - text.matches("\r\n").count()
        });
        text <= PORTION
    }

    /// One element, by the name it has now.
    pub fn eval_tag(&mut self, tag: Tag<'_>, has_next: bool, out: XId, cx: EvalContext) {
        with_stack(|| self.eval_tag_here(tag, has_next, out, cx));
    }

    fn eval_tag_here(&mut self, tag: Tag<'_>, has_next: bool, out: XId, cx: EvalContext) {
        let Some(xacro) = tag.name.strip_prefix("xacro:") else {
            return self.eval_plain(tag, out, cx);
        };
        match xacro {
            "insert_block" => self.insert_block(tag, out, cx),
            "include" => self.include(tag, has_next, out, cx),
            "property" => self.property(tag, has_next, out, cx),
            "macro" => self.define_macro(tag, has_next, out, cx),
            "arg" => self.arg(tag, has_next, out, cx),
            "element" => self.renamed_element(tag, has_next, out, cx),
            "attribute" => self.set_attribute(tag, out, cx),
            "if" | "unless" => self.conditional(tag, xacro == "if", has_next, out, cx),
            "call" => self.dynamic_call(tag, has_next, out, cx),
            name => self.call(tag, name, has_next, out, cx),
        }
    }

    fn eval_plain(&mut self, tag: Tag<'_>, out: XId, cx: EvalContext) {
        let origin = Origin {
            src: tag.src,
            range: tag.node.start_tag_range(),
            frame: cx.frame,
        };
        let id = self
            .result
            .tree
            .add(XKind::Element, tag.name.into(), origin);
        self.result.tree.append(out, id);
        self.eval_attributes(tag, id, cx);
        if self.guards.nesting >= ELEMENT_DEPTH {
            let message = format!("elements are nested more than {ELEMENT_DEPTH} levels deep");
            self.stop(origin, message, None);
            return;
        }
        self.guards.nesting += 1;
        self.eval_children(tag.node, tag.src, id, cx);
        self.guards.nesting -= 1;
    }

    /// Evaluate the attributes of a tag onto `out`; those of xacro itself are dropped.
    pub fn eval_attributes(&mut self, tag: Tag<'_>, out: XId, cx: EvalContext) {
        let mut attrs = std::mem::take(&mut self.attrs);
        for attr in tag.attrs() {
            let name = attr.name();
            if name.starts_with("xacro:") {
                continue;
            }
            let origin = Origin {
                src: tag.src,
                range: attr.value_range(),
                frame: cx.frame,
            };
            let text = attr.value(self.entities(tag.src));
            let (value, pieces) = if text.contains('$') {
                self.eval_pieces(
                    &text,
                    TextOrigin {
                        origin,
                        is_attr: true,
                    },
                    cx,
                )
            } else {
                (EcoString::from(text.as_ref()), Box::default())
            };
            // evaluated as any other, and only then dropped
            if name != "xmlns:xacro" {
                attrs.push(XAttr {
                    name: name.into(),
                    value,
                    origin,
                    pieces,
                });
            }
        }
        self.result.tree.get_mut(out).attrs = attrs.drain(..).collect();
        self.attrs = attrs;
    }

    /// `xacro:element`: go on under the computed name.
    fn renamed_element(&mut self, tag: Tag<'_>, has_next: bool, out: XId, cx: EvalContext) {
        let Some((text, place)) = self.required_attr(tag, "xacro:name", cx) else {
            return;
        };
        let at = place.origin;
        let value = self.eval_text(&text, place, cx.scope);
        let name = match value {
            Value::Unknown => return self.skip_unknown(tag, cx),
            Value::Str(name) if !name.is_empty() => name,
            Value::Str(_) | Value::None => {
                self.error(
                    ProblemKind::ExpressionError,
                    at,
                    "empty name in `xacro:element`",
                    "xacro:element: empty name",
                );
                return;
            }
            other => {
                let shown = display::repr(&other).unwrap_or_default();
                let message = format!("name in `xacro:element` is {shown}, which is not a string");
                self.error(
                    ProblemKind::ExpressionError,
                    at,
                    message,
                    format!("xacro:element: invalid name {shown}"),
                );
                return;
            }
        };
        self.eval_tag(
            Tag {
                name: &name,
                used: &["xacro:name"],
                ..tag
            },
            has_next,
            out,
            cx,
        );
    }

    /// `xacro:attribute`: onto the element around it.
    fn set_attribute(&mut self, tag: Tag<'_>, out: XId, cx: EvalContext) {
        let Some((name, name_place)) = self.required_attr(tag, "name", cx) else {
            return;
        };
        let Some((value, value_place)) = self.required_attr(tag, "value", cx) else {
            return;
        };
        let name = self.eval_text(&name, name_place, cx.scope);
        let (value, pieces) = self.eval_pieces(&value, value_place, cx);
        let at = name_place.origin;
        match name {
            Value::Str(name) if !name.is_empty() => {
                self.result.tree.set_attr(
                    out,
                    XAttr {
                        name,
                        value,
                        origin: value_place.origin,
                        pieces,
                    },
                );
            }
            Value::Unknown => {}
            name if literal::truth(&name) == Some(false) => {
                let message = "empty name in `xacro:attribute`";
                self.error(
                    ProblemKind::ExpressionError,
                    at,
                    message,
                    "xacro:attribute: empty name",
                );
            }
            name => {
                let message = match display::repr(&name) {
                    Some(shown) => {
                        format!("name in `xacro:attribute` is {shown}, which is not a string")
                    }
                    None => "name in `xacro:attribute` is not a string".to_owned(),
                };
                let reference = format!("'{}' object has no attribute 'split'", name.type_name());
                self.error(ProblemKind::ExpressionError, at, message, reference);
            }
        }
    }

    /// A tag whose meaning could not be computed: look inside for further causes, keep nothing.
    pub fn skip_unknown(&mut self, tag: Tag<'_>, cx: EvalContext) {
        self.result.complete = false;
        self.gaps.content_lost = true;
        self.gaps.losses += 1;
        let nowhere = self
            .result
            .tree
            .add(XKind::Container, EcoString::new(), Origin::NOWHERE);
        self.eval_children(tag.node, tag.src, nowhere, cx);
    }

    /// The entities declared in the file of a source item.
    pub fn entities(&self, src: SrcId) -> &Entities {
        let source = self.result.sources.get(src);
        let file = source.and_then(|s| self.result.files.get(s.file));
        match file {
            Some(file) => file.source.document.entities(),
            None => no_entities(),
        }
    }

    /// The item of a source.
    pub fn item(&self, src: SrcId) -> Option<Arc<Item>> {
        self.result.sources.get(src).map(|s| s.item.clone())
    }
}

/// The text behind `node` and an empty CDATA section: an XML parser makes no node of the section, so both
/// texts are one.
fn behind_empty_cdata(node: Node<'_>) -> Option<Node<'_>> {
    let section = node
        .next_sibling()
        .filter(|n| n.kind() == NodeKind::CData && n.raw().is_empty())?;
    let mut next = section.next_sibling();
    while let Some(empty) = next.filter(|n| n.kind() == NodeKind::CData && n.raw().is_empty()) {
        next = empty.next_sibling();
    }
    next.filter(|n| n.kind() == NodeKind::Text)
}

fn no_entities() -> &'static Entities {
    static NONE: OnceLock<Entities> = OnceLock::new();
    NONE.get_or_init(Entities::default)
}
