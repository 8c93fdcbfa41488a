//! `xacro:macro` and macro calls.
use std::sync::Arc;

use ecow::EcoString;

use super::binding::{GivenBlock, MacroCall};
use super::expander::Expander;
use super::kind::ProblemKind;
use super::macro_table::{MacroDef, MacrosId};
use super::meant;
use super::names::EvalContext;
use super::node::{XId, XKind};
use super::origin::{FrameKind, Origin};
use super::symbols::UseKind;
use super::tag::Tag;
use super::undefined::{UndefinedKind, UndefinedName};
use base::TextRange;
use expr::{ScopeId, Value, display};

/// A macro and the scopes its body sees.
struct Resolved {
    def: Arc<MacroDef>,
    macros: MacrosId,
    scope: ScopeId,
}

impl Expander<'_> {
    /// `xacro:call`: the macro's name is computed.
    pub fn dynamic_call(&mut self, tag: Tag<'_>, has_next: bool, out: XId, cx: EvalContext) {
        let Some((text, place)) = self.required_attr(tag, "macro", cx) else {
            return;
        };
        if text.is_empty() {
            let message = "missing attribute `macro` in `xacro:call`";
            return self.error(
                ProblemKind::MissingXacroAttribute,
                place.origin,
                message,
                "xacro:call is missing the 'macro' attribute",
            );
        }
        let value = self.eval_text(&text, place, cx.scope);
        let Some(name) = display::to_str(&value) else {
            return self.skip_unknown(tag, cx);
        };
        let tag_name = format!("xacro:{name}");
        // `xacro:element` may have made it a call
        let used: &[&str] = if tag.used.is_empty() {
            &["macro"]
        } else {
            &["xacro:name", "macro"]
        };
        let tag = Tag {
            name: &tag_name,
            used,
            ..tag
        };
        // a computed name can end a recursion just as a condition can
        self.flow.conditions += 1;
        self.call(tag, &name, has_next, out, cx);
        self.flow.conditions -= 1;
    }

    /// A macro call.
    pub fn call(&mut self, tag: Tag<'_>, name: &str, has_next: bool, out: XId, cx: EvalContext) {
        if !self.is_step(tag, out, cx) {
            if let Some(body) = self.call_body(tag, name, cx) {
                self.place_body(body, has_next, out, cx);
            }
        } else if !self.replay(tag, has_next, out, cx) {
            self.recorded_call(tag, name, has_next, out, cx);
        }
    }

    /// What a call gives, in a container.
    #[inline]
    pub(super) fn call_body(&mut self, tag: Tag<'_>, name: &str, cx: EvalContext) -> Option<XId> {
        let at = self.tag_origin(tag, cx);
        let Some(Resolved { def, macros, scope }) = self.find_macro(name, cx, at) else {
            self.unknown_macro(tag, name, cx);
            return None;
        };
        self.note_use(
            self.called_name(tag, &def, cx),
            Some(def.definition),
            UseKind::Call,
        );
        if self.is_endless(&def, at) {
            return None;
        }
        let frame = self.push_frame(FrameKind::Macro, def.name.clone(), at, Some(def.origin));
        let body_cx = EvalContext {
            scope: self.names.scopes.push(scope, false),
            macros: self.names.macros.push(Some(macros)),
            frame,
        };
        let call = MacroCall {
            tag,
            def: &def,
            at,
            cx,
            body: body_cx,
        };
        let mut open = self.bind_attributes(call);
        let (content, losses) = (self.container(at), self.gaps.losses);
        self.eval_children(tag.node, tag.src, content, cx);
        let given = if self.gaps.losses > losses {
            Vec::new()
        } else {
            self.given_blocks(content)
        };
        let is_sure = self.gaps.losses == losses && !given.contains(&GivenBlock::Any);
        self.bind_blocks(call, given, is_sure, &mut open);
        self.bind_defaults(call, &mut open);
        if !open.is_empty() {
            self.missing_params(call, &open);
        }
        let body = self.container(at);
        self.guards
            .calls
            .push((Arc::as_ptr(&def) as usize, self.flow.conditions));
        self.eval_body(&def, body, body_cx);
        self.guards.calls.pop();
        Some(body)
    }

    /// Put what a call gives in its place.
    #[inline]
    pub(super) fn place_body(&mut self, body: XId, has_next: bool, out: XId, cx: EvalContext) {
        self.drop_comments(out, has_next);
        self.lift_namespaces(body, out, cx);
        self.splice(body, out);
    }

    /// The text that names the macro of a call.
    fn called_name(&self, tag: Tag<'_>, def: &MacroDef, cx: EvalContext) -> Origin {
        // `xacro:call`, and a macro called through `xacro:element`
        let range = tag
            .used
            .last()
            .and_then(|name| tag.node.attr(name))
            .map(|attr| attr.value_range());
        let name = tag.node.name_range();
        let own = TextRange::new(
            name.end
                .saturating_sub(def.name.len() as u32)
                .max(name.start),
            name.end,
        );
        Origin {
            src: tag.src,
            range: range.unwrap_or(own),
            frame: cx.frame,
        }
    }

    pub(super) fn eval_body(&mut self, def: &MacroDef, body: XId, cx: EvalContext) {
        let Some(item) = self.item(def.body.src) else {
            return;
        };
        self.note_source(def.body.src);
        let node = item.node(def.body.node);
        // the reference evaluates the attributes of the macro tag as well
        self.eval_attributes(
            Tag {
                node,
                src: def.body.src,
                name: node.name(),
                used: &[],
            },
            body,
            cx,
        );
        self.eval_children(node, def.body.src, body, cx);
    }

    /// A node whose content will be spliced elsewhere.
    pub fn container(&mut self, origin: Origin) -> XId {
        self.result
            .tree
            .add(XKind::Container, EcoString::new(), origin)
    }

    pub(super) fn push_with_definition(&mut self, mut problem: super::Problem, def: &MacroDef) {
        let message = format!("macro `{}` is defined here", def.name);
        let place = self.result.place(def.origin);
        problem
            .trace
            .extend(place.map(|place| super::TraceStep { place, message }));
        self.push(problem);
    }

    /// The macro called `name`: as a whole, else through its namespaces.
    fn find_macro(&mut self, name: &str, cx: EvalContext, at: Origin) -> Option<Resolved> {
        if let Some(def) = self.names.macros.find(cx.macros, name) {
            return Some(Resolved {
                def,
                macros: cx.macros,
                scope: cx.scope,
            });
        }
        let (path, name) = name.rsplit_once('.')?;
        let (mut macros, mut scope) = (cx.macros, cx.scope);
        let mut start = at.range.start + self.text_of(at).find(path).unwrap_or(0) as u32;
        for step in path.split('.') {
            macros = self.names.macros.namespace(macros, step)?;
            let range = TextRange::new(start, start + step.len() as u32);
            start = range.end + 1;
            scope = match self.resolve(scope, step, Origin { range, ..at }) {
                Some(Value::Scope(id)) => id,
                _ => return None,
            };
        }
        let def = self.names.macros.find(macros, name)?;
        Some(Resolved { def, macros, scope })
    }

    /// The text at an origin.
    pub(super) fn text_of(&self, at: Origin) -> &str {
        self.result
            .sources
            .get(at.src)
            .map_or("", |source| at.range.slice(source.item.text()))
    }

    fn unknown_macro(&mut self, tag: Tag<'_>, name: &str, cx: EvalContext) {
        let at = self.tag_origin(tag, cx);
        let (table, path, own) = self.names.macros.inside(cx.macros, name);
        let known = self.missing_name(UndefinedKind::Macro, own, |expander| {
            expander.names.macros.visible_names(table)
        });
        if let Some(missing) = known.map(|missing| UndefinedName { name, ..missing }) {
            let message = format!("macro `{name}` is not defined");
            let mut problem = self
                .problem(ProblemKind::UndefinedMacro, at, message)
                .says(format!("unknown macro name: {}", tag.name));
            if let Some(keyword) = meant::by_tag(name) {
                // what it would have included or defined is missing
                self.gaps.include_missing |= ["include", "macro", "property"].contains(&keyword);
                problem = problem
                    .help(format!("did you mean `xacro:{keyword}`?"))
                    .replace_with(format!("<xacro:{keyword}"));
            } else if let Some(help) = meant::by_foreign_tag(name) {
                problem = problem.help(help);
            } else if let Some(near) = &missing.near {
                problem = problem
                    .help(format!("did you mean `{path}{near}`?"))
                    .replace_with(format!("<xacro:{path}{near}"));
            } else {
                problem = problem.help("include the file that defines the macro before this call");
            }
            self.push_undefined(missing, cx.scope, problem);
        }
        // what the call would have been given may hold causes of its own
        let nowhere = self.container(at);
        self.eval_attributes(tag, nowhere, cx);
        self.skip_unknown(tag, cx);
    }

    /// Whether calling `def` once more can never end; reports it.
    fn is_endless(&mut self, def: &Arc<MacroDef>, at: Origin) -> bool {
        let key = Arc::as_ptr(def) as usize;
        let same = self
            .guards
            .calls
            .iter()
            .rev()
            .find(|(other, _)| *other == key);
        let Some(&(_, conditions)) = same else {
            return self.too_deep(def, at);
        };
        if self.flow.unknown_conditions > 0 || self.gaps.include_missing {
            // whether to go on cannot be known, so the recursion ends here: a file that is missing may define the macro again
            self.result.complete = false;
            self.gaps.content_lost = true;
            return true;
        }
        if conditions == self.flow.conditions {
            let message = format!("macro `{}` calls itself without an end condition", def.name);
            let problem = self
                .problem(ProblemKind::InfiniteMacroRecursion, at, message)
                .says("maximum recursion depth exceeded")
                .help("put the inner call in <xacro:if value=\"...\">");
            self.push_with_definition(problem, def);
            self.result.complete = false;
            return true;
        }
        self.too_deep(def, at)
    }

    fn too_deep(&mut self, def: &MacroDef, at: Origin) -> bool {
        let most = self.request.limits.macro_depth;
        let deep = self.guards.calls.len() as u32 >= most;
        if deep {
            let message = format!(
                "macro calls are nested more than {most} levels deep: `{}`",
                def.name
            );
            self.stop(at, message, Some("macro-depth"));
        }
        deep
    }

    /// Copy the `xmlns:*` attributes of a spliced tag to the element around it.
    pub fn lift_namespaces(&mut self, from: XId, to: XId, cx: EvalContext) {
        let attrs = std::mem::take(&mut self.result.tree.get_mut(from).attrs);
        for attr in attrs
            .iter()
            .filter(|a| a.name.starts_with("xmlns:"))
            .cloned()
        {
            let old = self
                .result
                .tree
                .attr(to, &attr.name)
                .map(|a| a.value.clone());
            match old {
                Some(old) if old != attr.value => {
                    let message = format!(
                        "namespace `{}` is redefined from `{old}` to `{1}`",
                        attr.name, attr.value
                    );
                    let reference = format!(
                        "inconsistent namespace redefinitions for {}:\n old: {old}\n new: {} ({})",
                        attr.name,
                        attr.value,
                        self.current_file()
                    );
                    let at = Origin {
                        frame: cx.frame,
                        ..attr.origin
                    };
                    self.warn(
                        ProblemKind::InconsistentNamespaceRedefinition,
                        at,
                        message,
                        reference,
                    );
                }
                _ => self.result.tree.set_attr(to, attr),
            }
        }
    }
}
