//! `xacro:macro` and macro calls.

use std::sync::Arc;

use ecow::EcoString;

use super::element::Tag;
use super::late::NameKind;
use super::machine::{Cx, Expander};
use super::origin::{FrameKind, Origin};
use super::params;
use super::problem::Outside;
use super::property::literal_of;
use super::resolve::{BindingInfo, BindingKind};
use super::scope::{Block, MacroDef, MacrosId, Open, Param, Params, Place, SrcRef, State};
use super::symbols::{DefinitionId, SymbolKind, UseKind};
use super::text::TextSite;
use super::tree::{XId, XKind};
use crate::base::TextRange;
use crate::expr::{ScopeId, Value, display};
use crate::workspace::nearest;

/// A macro and the scopes its body sees.
struct Resolved {
    def: Arc<MacroDef>,
    macros: MacrosId,
    scope: ScopeId,
}

/// A block that a call gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum GivenBlock {
    /// An element.
    Known(XId),
    /// One that the macro around the call got from its caller, who is not known.
    Unknown,
    /// The same for any number of elements.
    Any,
}

impl Expander<'_> {
    /// `xacro:macro`
    pub fn define_macro(&mut self, tag: Tag<'_>, has_next: bool, out: XId, cx: Cx) {
        self.drop_comments(out, has_next);
        let Some((name, place)) = self.required_attr(tag, "name", cx) else { return };
        self.check_attrs(tag, &["name", "params"], cx);
        let mut name = name.as_ref();
        if name == "call" {
            let message = "a macro cannot be called `call`: `xacro:call` is xacro's own";
            return self.error("XAC041", place.origin, message, "Invalid use of macro name 'call'");
        }
        if name.contains('.') {
            let message = format!("macro name `{name}` holds a `.`, which separates namespaces");
            let reference = format!("macro names must not contain '.' (reserved for namespaces): {name}");
            self.error("XAC041", place.origin, message, reference);
        } else if let Some(bare) = name.strip_prefix("xacro:") {
            let message = format!("macro name `{name}` should not have the prefix `xacro:`");
            let reference = format!("macro names must not contain prefix 'xacro:': {name}");
            let problem = self.problem("XAC030", place.origin, message).says(reference).warning();
            self.push(problem.help(format!("rename it to `{bare}`")).replace_with(bare));
            name = bare;
        }
        let name = EcoString::from(name);
        let params = self.attr(tag, "params", cx).map(|(text, place)| (params::parse(&text), place));
        if let Some((None, place)) = &params {
            let message = format!("the parameter list of macro `{name}` holds only blanks");
            self.error("XAC025", place.origin, message, "list index out of range");
        }
        self.defined(NameKind::Macro, &name, cx.scope, place.origin);
        let definition = self.define(SymbolKind::Macro, &name, place.origin);
        let params = params.and_then(|(list, place)| Some((list?, place)));
        let params = params.map_or(Params::default(), |(list, place)| {
            Params::new(self.define_params(tag, list, place, definition, cx))
        });
        let body = SrcRef { src: tag.src, node: tag.node.id() };
        let def = MacroDef { name, body, origin: place.origin, definition, params };
        let def = self.macros.define(cx.macros, def);
        if self.request.probe && self.calls.is_empty() && self.may_probe(tag.src) {
            self.idle_macros.push((def, cx));
        }
    }

    /// Note where the parameters of a macro stand.
    fn define_params(
        &mut self,
        tag: Tag<'_>,
        mut params: Vec<Param>,
        place: Place,
        of: DefinitionId,
        cx: Cx,
    ) -> Vec<Param> {
        let Some((text, _)) = self.attr(tag, "params", cx) else { return params };
        // all places at once: to find one takes as long as the list is
        let mut origin_of = self.origins_in(TextSite { text: &text, place });
        let mut places = Vec::with_capacity(params.len());
        for param in &mut params {
            let name = param.name.trim_start_matches('*');
            places.push(origin_of(TextRange::new(param.range.end - name.len() as u32, param.range.end)));
            param.default_at = param.default.as_ref().map(|(_, range)| origin_of(*range));
        }
        drop(origin_of);
        for (param, at) in params.iter_mut().zip(places) {
            let name = param.name.trim_start_matches('*');
            let kind = if param.is_block() { SymbolKind::BlockParameter } else { SymbolKind::Parameter };
            param.definition = Some((at, self.define_part(kind, &name.into(), at, Some(of))));
        }
        params
    }

    /// `xacro:call`: the macro's name is computed.
    pub fn dynamic_call(&mut self, tag: Tag<'_>, has_next: bool, out: XId, cx: Cx) {
        let Some((text, place)) = self.required_attr(tag, "macro", cx) else { return };
        if text.is_empty() {
            let message = "`xacro:call` does not say which macro to call";
            return self.error(
                "XAC032",
                place.origin,
                message,
                "xacro:call is missing the 'macro' attribute",
            );
        }
        let value = self.eval_text(&text, place, cx.scope);
        let Some(name) = display::to_str(&value) else { return self.skip_unknown(tag, cx) };
        let tag_name = format!("xacro:{name}");
        // `xacro:element` may have made it a call
        let used: &[&str] = if tag.used.is_empty() { &["macro"] } else { &["xacro:name", "macro"] };
        let tag = Tag { name: &tag_name, used, ..tag };
        // a computed name can end a recursion just as a condition can
        self.conditions += 1;
        self.call(tag, &name, has_next, out, cx);
        self.conditions -= 1;
    }

    /// A macro call.
    pub fn call(&mut self, tag: Tag<'_>, name: &str, has_next: bool, out: XId, cx: Cx) {
        let at = self.tag_origin(tag, cx);
        let Some(Resolved { def, macros, scope }) = self.find_macro(name, cx, at) else {
            return self.unknown_macro(tag, name, cx);
        };
        self.note_use(self.called_name(tag, &def, cx), Some(def.definition), UseKind::Call);
        if self.is_endless(&def, at) {
            return;
        }
        let frame = self.push_frame(FrameKind::Macro, def.name.clone(), at, Some(def.origin));
        let body_cx =
            Cx { scope: self.scopes.push(scope, false), macros: self.macros.push(Some(macros)), frame };
        let mut open = self.bind_attributes(tag, &def, cx, body_cx);
        let (content, losses) = (self.container(at), self.losses);
        self.eval_children(tag.node, tag.src, content, cx);
        let given = if self.losses > losses { Vec::new() } else { self.given_blocks(content) };
        let is_sure = self.losses == losses && !given.contains(&GivenBlock::Any);
        self.bind_blocks(tag, (given, is_sure), &def, &mut open, cx, body_cx);
        self.bind_defaults(&def, &mut open, at, cx, body_cx);
        if !open.is_empty() {
            self.missing_params(&def, &open, at, body_cx);
        }
        let body = self.container(at);
        self.calls.push((Arc::as_ptr(&def) as usize, self.conditions));
        self.eval_body(&def, body, body_cx);
        self.calls.pop();
        self.drop_comments(out, has_next);
        self.lift_namespaces(body, out, cx);
        self.splice(body, out);
    }

    /// The text that names the macro of a call.
    fn called_name(&self, tag: Tag<'_>, def: &MacroDef, cx: Cx) -> Origin {
        // `xacro:call`, and a macro called through `xacro:element`
        let range = tag.used.last().and_then(|name| tag.node.attr(name)).map(|attr| attr.value_range());
        let name = tag.node.name_range();
        let own = TextRange::new(name.end.saturating_sub(def.name.len() as u32).max(name.start), name.end);
        Origin { src: tag.src, range: range.unwrap_or(own), frame: cx.frame }
    }

    pub(super) fn eval_body(&mut self, def: &MacroDef, body: XId, cx: Cx) {
        let Some(item) = self.item(def.body.src) else { return };
        let node = item.node(def.body.node);
        // the reference evaluates the attributes of the macro tag as well
        self.eval_attributes(Tag { node, src: def.body.src, name: node.name(), used: &[] }, body, cx);
        self.eval_children(node, def.body.src, body, cx);
    }

    /// A node whose content will be spliced elsewhere.
    pub fn container(&mut self, origin: Origin) -> XId {
        self.result.tree.add(XKind::Container, EcoString::new(), origin)
    }

    /// Attributes of the call, evaluated where the call stands. Gives the parameters that are left.
    fn bind_attributes<'d>(&mut self, tag: Tag<'_>, def: &'d MacroDef, cx: Cx, body: Cx) -> Vec<&'d Param> {
        let mut open = Open::new(&def.params);
        for attr in tag.attrs() {
            let at = Origin { src: tag.src, range: attr.name_range(), frame: cx.frame };
            let given = open.take(attr.name());
            let Some(param) = given.or_else(|| self.misspelt_param(tag, def, &mut open, attr.name(), at))
            else {
                continue;
            };
            if param.name == attr.name() {
                self.note_use(at, param.definition.map(|(_, definition)| definition), UseKind::Given);
            }
            let origin = Origin { range: attr.value_range(), ..at };
            let text = attr.value(self.entities(tag.src)).into_owned();
            self.bind_param(param, &text, Place { origin, is_attr: true }, cx, body);
        }
        open.left()
    }

    /// Evaluate a text in the caller's scope and bind it in the body's.
    fn bind_param(&mut self, param: &Param, text: &str, place: Place, cx: Cx, body: Cx) {
        let mark = self.reads.len();
        let value = literal_of(self.eval_text(text, place, cx.scope));
        let reads = self.take_reads(mark);
        let info = BindingInfo { reads, ..param_info(param, place.origin) };
        self.bind(body.scope, param.name.clone(), State::Ready(value), info, place.origin);
    }

    /// The blocks that a call gives: its child elements, and blocks of the caller passed on.
    fn given_blocks(&self, content: XId) -> Vec<GivenBlock> {
        let tree = &self.result.tree;
        let block = |id: XId| match (tree.get(id).kind, tree.get(id).text.as_str()) {
            (XKind::Element, _) => Some(GivenBlock::Known(id)),
            (XKind::Container, "*") => Some(GivenBlock::Unknown),
            (XKind::Container, "**") => Some(GivenBlock::Any),
            _ => None,
        };
        tree.children(content).filter_map(block).collect()
    }

    /// Bind block parameters to what the call gives. When that is not all known (`is_sure`), none is missing and none is
    /// too many.
    fn bind_blocks(
        &mut self,
        tag: Tag<'_>,
        (given, is_sure): (Vec<GivenBlock>, bool),
        def: &MacroDef,
        open: &mut Vec<&Param>,
        cx: Cx,
        body: Cx,
    ) {
        let mut blocks = given.into_iter().take_while(|block| *block != GivenBlock::Any);
        let wanted: Vec<&Param> = open.iter().copied().filter(|p| p.is_block()).collect();
        open.retain(|p| !p.is_block());
        let mut missing = Vec::new();
        for param in wanted {
            match blocks.next() {
                Some(GivenBlock::Known(block)) => {
                    let origin = self.result.tree.get(block).origin;
                    let info = param_info(param, origin);
                    let state = State::Block(Block::Built(block));
                    self.bind(body.scope, param.name.clone(), state, info, origin);
                }
                block => {
                    if block.is_none() && is_sure {
                        missing.push(param.name.trim_start_matches('*'));
                    }
                    self.bind_unknown(param, self.tag_origin(tag, cx), body);
                }
            }
        }
        if self.unwinding || !is_sure {
            return;
        }
        if !missing.is_empty() {
            let message = format!("macro `{}` needs a block for `{}`", def.name, missing.join("`, `"));
            let problem = self
                .problem("XAC007", self.tag_origin(tag, cx), message)
                .says("Not enough blocks")
                .help("put one element for each block parameter between the start and end tag of the call");
            self.push_with_definition(problem, def);
        } else if let Some(GivenBlock::Known(extra)) = blocks.next() {
            let node = self.result.tree.get(extra);
            let (name, at) = (node.text.clone(), node.origin);
            let message = format!("`{name}` is one block more than macro `{}` takes", def.name);
            let problem = self.problem("XAC007", at, message).says(format!("Unused block \"{name}\""));
            self.push_with_definition(problem, def);
        }
    }

    fn bind_defaults(&mut self, def: &MacroDef, open: &mut Vec<&Param>, at: Origin, cx: Cx, body: Cx) {
        let mut left = Vec::new();
        for param in std::mem::take(open) {
            let Some(spec) = def.params.fallback(&param.name) else {
                left.push(param);
                continue;
            };
            if spec.forward && self.forward(param, at, cx, body) {
                continue;
            }
            match &spec.default {
                Some((text, _)) => {
                    let origin = Origin { frame: body.frame, ..spec.default_at.unwrap_or(def.origin) };
                    self.bind_param(param, text, Place { origin, is_attr: true }, cx, body);
                }
                None => self.nothing_to_forward(def, param, at, body),
            }
        }
        *open = left;
    }

    /// `^`: the value the caller sees under the same name.
    fn forward(&mut self, param: &Param, at: Origin, cx: Cx, body: Cx) -> bool {
        let name = &param.name;
        let mark = self.reads.len();
        let outer = self.scopes.find(cx.scope, name).map(|(_, binding)| binding.info);
        if let (Some((place, _)), Some(outer)) = (param.definition, outer) {
            self.note_read(place, outer, UseKind::Read);
        }
        let value = match self.value_of(cx.scope, name, at) {
            Some(value) => value,
            None => match crate::expr::global_symbol(name) {
                Some(value) => value,
                None => return false,
            },
        };
        let reads = self.take_reads(mark);
        let info = BindingInfo { reads, ..param_info(param, at) };
        self.bind(body.scope, name.clone(), State::Ready(literal_of(value)), info, at);
        true
    }

    fn nothing_to_forward(&mut self, def: &MacroDef, param: &Param, at: Origin, body: Cx) {
        let name = &param.name;
        let message = format!(
            "parameter `{name}` of macro `{}` takes the caller's `{name}`, which is not defined",
            def.name
        );
        let problem = self
            .problem("XAC005", at, message)
            .says(format!("Undefined property to forward: {name}"))
            .depends_on(Outside::Includer)
            .help(format!("pass it: {name}=\"...\""));
        self.push_with_definition(problem, def);
        self.bind_unknown(param, at, body);
    }

    pub(super) fn bind_unknown(&mut self, param: &Param, at: Origin, body: Cx) {
        self.result.complete = false;
        self.bind(body.scope, param.name.clone(), State::Ready(Value::Unknown), param_info(param, at), at);
    }

    fn missing_params(&mut self, def: &MacroDef, open: &[&Param], at: Origin, body: Cx) {
        if self.unwinding {
            return;
        }
        let names: Vec<&str> = open.iter().map(|p| p.name.as_str()).collect();
        let plural = if names.len() == 1 { "parameter" } else { "parameters" };
        let message = format!("call of macro `{}` lacks the {plural} `{}`", def.name, names.join("`, `"));
        let add: Vec<String> = names.iter().map(|n| format!("{n}=\"...\"")).collect();
        let problem = self
            .problem("XAC005", at, message)
            .says(format!("Undefined parameters [{}]", names.join(",")))
            .help(format!("add {}", add.join(" ")));
        self.push_with_definition(problem, def);
        for param in open {
            self.bind_unknown(param, at, body);
        }
    }

    /// Report an attribute that is no parameter. If it looks like one that is not given otherwise, it is
    /// taken for that one: a typing error is one finding, not two.
    fn misspelt_param<'d>(
        &mut self,
        tag: Tag<'_>,
        def: &MacroDef,
        open: &mut Open<'d>,
        name: &str,
        at: Origin,
    ) -> Option<&'d Param> {
        let message = format!("macro `{}` has no parameter `{name}`", def.name);
        let mut problem = self.problem("XAC006", at, message).says(format!("Invalid parameter \"{name}\""));
        let names = def.params.iter().map(|p| p.name.as_str()).filter(|_| self.compares());
        let near = nearest(name, names).map(str::to_owned);
        self.compared += def.params.iter().len();
        if let Some(near) = &near {
            problem = problem.help(format!("rename it to `{near}`")).replace_with(near.as_str());
        }
        self.push_with_definition(problem, def);
        let near = near.filter(|near| tag.attr(near).is_none() && !near.starts_with('*'))?;
        open.take(&near)
    }

    fn push_with_definition(&mut self, mut problem: super::Problem, def: &MacroDef) {
        let message = format!("macro `{}` is defined here", def.name);
        let place = self.result.place(def.origin);
        problem.trace.extend(place.map(|place| super::Step { place, message }));
        self.push(problem);
    }

    /// The macro called `name`: as a whole, else through its namespaces.
    fn find_macro(&mut self, name: &str, cx: Cx, at: Origin) -> Option<Resolved> {
        if let Some(def) = self.macros.find(cx.macros, name) {
            return Some(Resolved { def, macros: cx.macros, scope: cx.scope });
        }
        let (path, name) = name.rsplit_once('.')?;
        let (mut macros, mut scope) = (cx.macros, cx.scope);
        let mut start = at.range.start + self.text_of(at).find(path).unwrap_or(0) as u32;
        for step in path.split('.') {
            macros = self.macros.namespace(macros, step)?;
            let range = TextRange::new(start, start + step.len() as u32);
            start = range.end + 1;
            scope = match self.resolve(scope, step, Origin { range, ..at }) {
                Some(Value::Scope(id)) => id,
                _ => return None,
            };
        }
        let def = self.macros.find(macros, name)?;
        Some(Resolved { def, macros, scope })
    }

    /// The text at an origin.
    fn text_of(&self, at: Origin) -> &str {
        self.result.sources.get(at.src.0 as usize).map_or("", |source| at.range.slice(source.item.text()))
    }

    fn unknown_macro(&mut self, tag: Tag<'_>, name: &str, cx: Cx) {
        let at = self.tag_origin(tag, cx);
        if let Some(missing) =
            self.missing_name(NameKind::Macro, name, |machine| machine.macros.visible_names(cx.macros))
        {
            let message = format!("macro `{name}` is not defined");
            let mut problem =
                self.problem("XAC002", at, message).says(format!("unknown macro name: {}", tag.name));
            if let Some(near) = &missing.near {
                problem = problem
                    .help(format!("a macro with a similar name exists: `{near}`"))
                    .replace_with(format!("<xacro:{near}"));
            } else {
                problem = problem.help("include the file that defines it above this place");
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
        let same = self.calls.iter().rev().find(|(other, _)| *other == key);
        let Some(&(_, conditions)) = same else {
            return self.too_deep(def, at);
        };
        if self.unknown_conditions > 0 {
            // whether to go on cannot be known, so the recursion ends here
            self.result.complete = false;
            self.content_lost = true;
            return true;
        }
        if conditions == self.conditions {
            let message = format!("macro `{}` calls itself without a condition that could end it", def.name);
            let problem = self
                .problem("XAC034", at, message)
                .says("maximum recursion depth exceeded")
                .help("put the inner call into <xacro:if value=\"...\">");
            self.push_with_definition(problem, def);
            self.result.complete = false;
            return true;
        }
        self.too_deep(def, at)
    }

    fn too_deep(&mut self, def: &MacroDef, at: Origin) -> bool {
        let most = self.request.limits.macro_depth;
        let deep = self.calls.len() as u32 >= most;
        if deep {
            let message =
                format!("macro calls are nested more than {most} deep, here into macro `{}`", def.name);
            self.stop(at, message, Some("macro-depth"));
        }
        deep
    }

    /// Copy the `xmlns:*` attributes of a spliced tag to the element around it.
    pub fn lift_namespaces(&mut self, from: XId, to: XId, cx: Cx) {
        let attrs = std::mem::take(&mut self.result.tree.get_mut(from).attrs);
        for attr in attrs.iter().filter(|a| a.name.starts_with("xmlns:")).cloned() {
            let old = self.result.tree.attr(to, &attr.name).map(|a| a.value.clone());
            match old {
                Some(old) if old != attr.value => {
                    let message =
                        format!("`{}` is bound to `{}` here and to `{old}` around it", attr.name, attr.value);
                    let reference = format!(
                        "inconsistent namespace redefinitions for {}:\n old: {old}\n new: {} ({})",
                        attr.name,
                        attr.value,
                        self.current_file()
                    );
                    let at = Origin { frame: cx.frame, ..attr.origin };
                    self.warn("XAC042", at, message, reference);
                }
                _ => self.result.tree.set_attr(to, attr),
            }
        }
    }
}

/// A parameter of a call, with its value at `at`.
fn param_info(param: &Param, at: Origin) -> BindingInfo {
    let info = BindingInfo::new(param.name.clone(), BindingKind::Parameter, at);
    BindingInfo { definition: param.definition.map(|(_, definition)| definition), ..info }
}
