//! `xacro:if`, `xacro:unless`, `xacro:arg` and `xacro:insert_block`.
use ecow::EcoString;

use super::binding_info::{BindingInfo, BindingKind};
use super::expander::Expander;
use super::kind::ProblemKind;
use super::names::EvalContext;
use super::node::{XAttr, XId, XKind};
use super::origin::{FrameKind, Origin};
use super::request::Forced;
use super::scope::{Block, PropertyState, TextOrigin};
use super::symbols::{SymbolKind, UseKind};
use super::tag::Tag;
use super::undefined::UndefinedKind;
use base::limits::BLOCK_DEPTH;
use expr::{Value, display};
use xml::Attr;

impl Expander<'_> {
    /// `xacro:if` (`wanted` true) and `xacro:unless`.
    pub fn conditional(
        &mut self,
        tag: Tag<'_>,
        wanted: bool,
        has_next: bool,
        out: XId,
        cx: EvalContext,
    ) {
        self.drop_comments(out, has_next);
        let Some((text, place)) = self.required_attr(tag, "value", cx) else {
            return self.unknown_branch(tag, cx);
        };
        self.check_attrs(tag, &["value"], cx);
        let mark = self.names.reads.len();
        let value = self.eval_text(&text, place, cx.scope);
        let truth = self.truth(&value, &text, place.origin, mark);
        match self.forced(tag).or(truth.map(|truth| truth == wanted)) {
            None => self.unknown_branch(tag, cx),
            Some(true) => {
                let content = self.container(self.tag_origin(tag, cx));
                // the reference evaluates the attributes, the condition once more; seen only when that changes something
                let is_code = |attr: Attr<'_>| attr.value(self.entities(tag.src)).contains('$');
                let others = tag
                    .attrs()
                    .filter(|attr| attr.name() != "value")
                    .any(is_code);
                if others || text.contains('$') && text.contains('(') {
                    self.eval_attributes(tag, content, cx);
                }
                self.flow.conditions += 1;
                self.eval_children(tag.node, tag.src, content, cx);
                self.flow.conditions -= 1;
                self.splice(content, out);
            }
            Some(false) => {}
        }
    }

    /// Whether the content of a condition is taken, when the request says so.
    fn forced(&self, tag: Tag<'_>) -> Option<bool> {
        if self.request.forced.is_empty() {
            return None;
        }
        let source = self.result.sources.get(tag.src)?;
        let path = &self.result.files.get(source.file)?.source.path;
        let at = source.base + tag.node.range().start;
        let is_it = |forced: &&Forced| forced.at == at && forced.file == **path;
        self.request
            .forced
            .iter()
            .find(is_it)
            .map(|forced| forced.taken)
    }

    /// A branch that may or may not be taken: what it defines is not missed later, what it holds is not kept.
    fn unknown_branch(&mut self, tag: Tag<'_>, cx: EvalContext) {
        self.flow.unknown_conditions += 1;
        self.flow.conditions += 1;
        self.skip_unknown(tag, cx);
        self.flow.conditions -= 1;
        self.flow.unknown_conditions -= 1;
    }

    /// `xacro:arg`
    pub fn arg(&mut self, tag: Tag<'_>, has_next: bool, out: XId, cx: EvalContext) {
        self.note_unclear();
        let name = self.required_attr(tag, "name", cx);
        let default = self.required_attr(tag, "default", cx);
        self.check_attrs(tag, &["name", "default"], cx);
        if let Some((name, place)) = name {
            let name = EcoString::from(name.as_ref());
            self.defined(UndefinedKind::Arg, &name, cx.scope, place.origin);
            let definition = self.define(SymbolKind::Argument, &name, place.origin);
            if let Some(&(_, info)) = self.names.args.get(&name) {
                self.declare_given(info, definition);
            } else {
                let mark = self.names.reads.len();
                let value = default.as_ref().and_then(|(text, place)| {
                    let value = self.eval_text(text, *place, cx.scope);
                    display::to_str(&value)
                });
                let reads = self.take_reads(mark);
                let origin = default.map_or(place.origin, |(_, place)| place.origin);
                let info = BindingInfo {
                    reads,
                    value: Some(value.clone().map_or(Value::Unknown, Value::Str)),
                    ..BindingInfo::new(name.clone(), BindingKind::Argument, origin).of(definition)
                };
                let info = self.add_binding(info);
                self.result
                    .record
                    .add(super::Read::Arg(name.to_string(), None));
                let given = (value, info);
                self.note_declared(&name, &given);
                self.names.args.insert(name, given);
            }
        }
        self.drop_comments(out, has_next);
    }

    /// `xacro:insert_block`
    pub fn insert_block(&mut self, tag: Tag<'_>, out: XId, cx: EvalContext) {
        let Some((name, place)) = self.required_attr(tag, "name", cx) else {
            return;
        };
        self.check_attrs(tag, &["name"], cx);
        let mut unknown = None;
        let found = ["**", "*"].into_iter().find_map(|stars| {
            let key = format!("{stars}{name}");
            let (_, binding) = self.names.scopes.find(cx.scope, &key)?;
            if matches!(binding.state, PropertyState::Ready(Value::Unknown)) {
                unknown = Some(stars);
            }
            let PropertyState::Block(block) = binding.state else {
                return None;
            };
            let info = binding.info;
            let origin = self
                .result
                .index
                .bindings
                .get(info)
                .and_then(|info| info.origin);
            Some((block, stars == "**", origin, info))
        });
        let Some((block, content_only, definition, info)) = found else {
            // a block that the call forgot was reported there
            return match unknown {
                Some(stars) => self.unknown_block(stars, self.tag_origin(tag, cx), out),
                None => self.undefined_block(&name, place, cx),
            };
        };
        self.note_read(place.origin, info, UseKind::Insert);
        let at = self.tag_origin(tag, cx);
        if self.guards.block_depth >= BLOCK_DEPTH {
            let message = format!("block `{name}` inserts itself (more than {BLOCK_DEPTH} levels)");
            return self.stop(at, message, None);
        }
        self.guards.block_depth += 1;
        let frame = self.push_frame(FrameKind::Block, name.as_ref().into(), at, definition);
        let cx = EvalContext { frame, ..cx };
        match block {
            Block::Source(at) => {
                self.note_source(at.src);
                if let Some(item) = self.item(at.src) {
                    let node = item.node(at.node);
                    let content = self.container(Origin {
                        src: at.src,
                        range: node.range(),
                        frame,
                    });
                    let tag = Tag {
                        node,
                        src: at.src,
                        name: node.name(),
                        used: &[],
                    };
                    self.eval_attributes(tag, content, cx);
                    self.eval_children(node, at.src, content, cx);
                    // no comments vanish in front of this tag, so the marker stays in front of the block
                    self.result.tree.move_children(content, out);
                }
            }
            Block::Built(block) if content_only => {
                let content = self.container(at);
                self.rebuild_attrs(block, content, cx);
                self.rebuild_children(block, content, cx);
                self.result.tree.move_children(content, out);
            }
            Block::Built(block) => self.rebuild(block, out, cx),
        }
        self.guards.block_depth -= 1;
    }

    /// A block whose content is not known: in its place goes an empty container, which counts where a call looks for
    /// its blocks. Its text says how many elements the block is: one (`*`) or any number (`**`).
    fn unknown_block(&mut self, stars: &str, at: Origin, out: XId) {
        self.result.complete = false;
        if self.request.probe {
            let hole = self.result.tree.add(XKind::Container, stars.into(), at);
            self.result.tree.append(out, hole);
        }
    }

    fn undefined_block(&mut self, name: &str, place: TextOrigin, cx: EvalContext) {
        // a call around it gives fewer blocks than it was meant to
        self.gaps.losses += 1;
        let Some(missing) = self.missing_name(UndefinedKind::Block, name, |expander| {
            expander.names.scopes.visible_blocks(cx.scope)
        }) else {
            return;
        };
        let mut problem = self
            .problem(
                ProblemKind::UndefinedBlock,
                place.origin,
                format!("block `{name}` is not defined"),
            )
            .says(format!("Undefined block \"{name}\""));
        if let Some(near) = &missing.near {
            problem = problem
                .help(format!("did you mean `{near}`?"))
                .replace_with(near);
        } else if self.names.scopes.find(cx.scope, name).is_some() {
            problem = problem.help(format!(
                "declare the parameter as `*{name}`; `{name}` is a value, not a block"
            ));
        } else {
            problem = problem.help(format!(
                "add `*{name}` to `params` of the macro, or define a property `{name}` without `value`"
            ));
        }
        self.push_undefined(missing, cx.scope, problem);
    }

    /// Copy an evaluated node to the end of `out`, evaluating its texts once more: the reference
    /// inserts a copy of the block and evaluates that again.
    fn rebuild(&mut self, from: XId, out: XId, cx: EvalContext) {
        let node = self.result.tree.get(from);
        let (kind, origin, text) = (node.kind, node.origin, node.text.clone());
        if self.tick(origin) {
            return;
        }
        let text = match kind {
            XKind::Text => {
                self.eval_pieces(
                    &text,
                    TextOrigin {
                        origin,
                        is_attr: false,
                    },
                    cx,
                )
                .0
            }
            _ => text,
        };
        let id = self.result.tree.add(kind, text, origin);
        self.result.tree.append(out, id);
        if kind == XKind::Element {
            self.rebuild_attrs(from, id, cx);
            self.rebuild_children(from, id, cx);
        }
    }

    fn rebuild_children(&mut self, from: XId, out: XId, cx: EvalContext) {
        let mut next = self.result.tree.first_child(from);
        while let Some(child) = next {
            self.rebuild(child, out, cx);
            next = self.result.tree.next_sibling(child);
        }
    }

    fn rebuild_attrs(&mut self, from: XId, to: XId, cx: EvalContext) {
        let attrs = self.result.tree.get(from).attrs.clone();
        let is_final = |attr: &XAttr| !attr.name.starts_with("xacro:") && !attr.value.contains('$');
        if attrs.iter().all(is_final) {
            self.result.tree.get_mut(to).attrs = attrs;
            return;
        }
        let rebuilt = attrs
            .iter()
            .filter(|a| !a.name.starts_with("xacro:"))
            .cloned()
            .map(|attr| {
                if !attr.value.contains('$') {
                    return attr;
                }
                let place = TextOrigin {
                    origin: attr.origin,
                    is_attr: true,
                };
                let (value, pieces) = self.eval_pieces(&attr.value, place, cx);
                XAttr {
                    value,
                    pieces,
                    ..attr
                }
            });
        let rebuilt = rebuilt.collect();
        self.result.tree.get_mut(to).attrs = rebuilt;
    }
}
