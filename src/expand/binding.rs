//! What a call gives to the parameters of its macro: attributes, blocks, defaults, values of the caller.
use super::binding_info::{BindingInfo, BindingKind};
use super::expander::Expander;
use super::kind::ProblemKind;
use super::macro_table::{MacroDef, MacroParam, OpenParams};
use super::names::EvalContext;
use super::node::{XId, XKind};
use super::origin::Origin;
use super::problem::{Detail, Outside, TraceStep};
use super::property::literal_of;
use super::scope::{Block, PropertyState, TextOrigin};
use super::symbols::UseKind;
use super::tag::Tag;
use expr::Value;
use packages::nearest;

/// A block that a call gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum GivenBlock {
    /// An element.
    Known(XId),
    /// One that the macro around the call got from its caller, who is not known.
    Unknown,
    /// The same for any number of elements.
    Any,
}

/// A call of a macro while its parameters are bound.
#[derive(Clone, Copy)]
pub(super) struct MacroCall<'a> {
    pub tag: Tag<'a>,
    pub def: &'a MacroDef,
    /// The start tag.
    pub at: Origin,
    /// Around the call.
    pub cx: EvalContext,
    /// In the body of the macro.
    pub body: EvalContext,
}

impl Expander<'_> {
    /// Attributes of the call, evaluated where the call stands. Gives the parameters that are left.
    pub(super) fn bind_attributes<'d>(&mut self, call: MacroCall<'d>) -> Vec<&'d MacroParam> {
        let MacroCall { tag, cx, .. } = call;
        let mut open = OpenParams::new(&call.def.params);
        for attr in tag.attrs() {
            let at = Origin {
                src: tag.src,
                range: attr.name_range(),
                frame: cx.frame,
            };
            let given = open.take(attr.name());
            let Some(param) =
                given.or_else(|| self.misspelled_param(call, &mut open, attr.name(), at))
            else {
                continue;
            };
            if param.name == attr.name() {
                self.note_use(
                    at,
                    param.definition.map(|(_, definition)| definition),
                    UseKind::Given,
                );
            }
            let origin = Origin {
                range: attr.value_range(),
                ..at
            };
            let text = attr.value(self.entities(tag.src)).into_owned();
            let place = TextOrigin {
                origin,
                is_attr: true,
            };
            self.bind_param(call, param, &text, place);
        }
        open.left()
    }

    /// Evaluate a text in the caller's scope and bind it in the body's.
    fn bind_param(
        &mut self,
        call: MacroCall<'_>,
        param: &MacroParam,
        text: &str,
        place: TextOrigin,
    ) {
        let mark = self.names.reads.len();
        let value = literal_of(self.eval_text(text, place, call.cx.scope));
        let reads = self.take_reads(mark);
        let info = BindingInfo {
            reads,
            ..param_info(param, place.origin)
        };
        self.bind(
            call.body.scope,
            param.name.clone(),
            PropertyState::Ready(value),
            info,
            place.origin,
        );
    }

    /// The blocks that a call gives: its child elements, and blocks of the caller passed on.
    pub(super) fn given_blocks(&self, content: XId) -> Vec<GivenBlock> {
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
    pub(super) fn bind_blocks(
        &mut self,
        call: MacroCall<'_>,
        given: Vec<GivenBlock>,
        is_sure: bool,
        open: &mut Vec<&MacroParam>,
    ) {
        let MacroCall { def, at, body, .. } = call;
        let mut wanted: Vec<&MacroParam> = open.iter().copied().filter(|p| p.is_block()).collect();
        open.retain(|p| !p.is_block());
        if given.len() > wanted.len() {
            wanted.extend(self.blocks_without_star(def, open));
        }
        let mut blocks = given
            .into_iter()
            .take_while(|block| *block != GivenBlock::Any);
        let mut missing = Vec::new();
        for param in wanted {
            match blocks.next() {
                Some(GivenBlock::Known(block)) => {
                    let origin = self.result.tree.get(block).origin;
                    let info = param_info(param, origin);
                    let state = PropertyState::Block(Block::Built(block));
                    let key = if param.is_block() {
                        param.name.clone()
                    } else {
                        format!("*{}", param.name).into()
                    };
                    self.bind(body.scope, key, state, info, origin);
                }
                block => {
                    if block.is_none() && is_sure {
                        missing.push(param.name.trim_start_matches('*'));
                    }
                    self.bind_unknown(param, at, body);
                }
            }
        }
        if self.flow.unwinding || !is_sure {
            return;
        }
        if !missing.is_empty() {
            let message = format!(
                "call of macro `{}` is missing a block for `{}`",
                def.name,
                missing.join("`, `")
            );
            let problem = self
                .problem(ProblemKind::MacroBlockMismatch, at, message)
                .says("Not enough blocks")
                .help("write one element per block parameter between the start and end tag of the call");
            self.push_with_definition(problem, def);
        } else if let Some(GivenBlock::Known(extra)) = blocks.next() {
            let node = self.result.tree.get(extra);
            let (name, at) = (node.text.clone(), node.origin);
            let message = format!(
                "too many blocks in call of macro `{}`: unexpected `{name}`",
                def.name
            );
            let problem = self
                .problem(ProblemKind::MacroBlockMismatch, at, message)
                .says(format!("Unused block \"{name}\""));
            self.push_with_definition(problem, def);
        }
    }

    /// Take the parameters without a value that the body inserts as blocks: their `*` is missing, which is reported.
    fn blocks_without_star<'d>(
        &mut self,
        def: &MacroDef,
        open: &mut Vec<&'d MacroParam>,
    ) -> Vec<&'d MacroParam> {
        if !self.request.probe {
            return Vec::new();
        }
        let Some(item) = self.item(def.body.src) else {
            return Vec::new();
        };
        let body = item.node(def.body.node).range();
        let inserts = item.all_nodes().filter(|node| {
            node.name() == "xacro:insert_block" && body.contains_range(node.range())
        });
        let inserted: Vec<&str> = inserts
            .filter_map(|node| Some(node.attr("name")?.raw()))
            .collect();
        let (meant, others): (Vec<&MacroParam>, Vec<&MacroParam>) = std::mem::take(open)
            .into_iter()
            .partition(|param| param.default.is_none() && inserted.contains(&param.name.as_str()));
        *open = others;
        for param in &meant {
            let name = &param.name;
            let at = param.definition.map_or(def.origin, |(at, _)| at);
            let message = format!(
                "parameter `{name}` of macro `{}` is inserted as a block",
                def.name
            );
            let problem = self
                .problem(ProblemKind::UndefinedBlock, at, message)
                .says(format!("Undefined block \"{name}\""));
            self.push(
                problem
                    .help(format!("write `*{name}`"))
                    .replace_with(format!("*{name}")),
            );
        }
        meant
    }

    /// Defaults of the parameters that are left.
    pub(super) fn bind_defaults(&mut self, call: MacroCall<'_>, open: &mut Vec<&MacroParam>) {
        let MacroCall { def, at, body, .. } = call;
        let mut left = Vec::new();
        for param in std::mem::take(open) {
            let Some(spec) = def.params.fallback(&param.name) else {
                left.push(param);
                continue;
            };
            if spec.forward && self.forward(call, param) {
                continue;
            }
            match &spec.default {
                Some((text, _)) => {
                    let origin = Origin {
                        frame: body.frame,
                        ..spec.default_at.unwrap_or(def.origin)
                    };
                    let place = TextOrigin {
                        origin,
                        is_attr: true,
                    };
                    self.bind_param(call, param, text, place);
                }
                None => self.nothing_to_forward(def, param, at, body),
            }
        }
        *open = left;
    }

    /// `^`: the value the caller sees under the same name.
    fn forward(&mut self, call: MacroCall<'_>, param: &MacroParam) -> bool {
        let MacroCall { at, cx, body, .. } = call;
        let name = &param.name;
        let mark = self.names.reads.len();
        let outer = self
            .names
            .scopes
            .find(cx.scope, name)
            .map(|(_, binding)| binding.info);
        if let (Some((place, _)), Some(outer)) = (param.definition, outer) {
            self.note_read(place, outer, UseKind::Read);
        }
        let value = match self.value_of(cx.scope, name, at) {
            Some(value) => value,
            None => match expr::global_symbol(name) {
                Some(value) => value,
                None => return false,
            },
        };
        let reads = self.take_reads(mark);
        let info = BindingInfo {
            reads,
            ..param_info(param, at)
        };
        self.bind(
            body.scope,
            name.clone(),
            PropertyState::Ready(literal_of(value)),
            info,
            at,
        );
        true
    }

    fn nothing_to_forward(
        &mut self,
        def: &MacroDef,
        param: &MacroParam,
        at: Origin,
        body: EvalContext,
    ) {
        let name = &param.name;
        let message = format!(
            "parameter `{name}` of macro `{}` uses `{name}` of the caller, which is not defined",
            def.name
        );
        let problem = self
            .problem(ProblemKind::MissingMacroParam, at, message)
            .says(format!("Undefined property to forward: {name}"))
            .depends_on(Outside::Includer)
            .help(format!("pass {name}=\"...\" in the call"));
        self.push_with_definition(problem, def);
        self.bind_unknown(param, at, body);
    }

    pub(super) fn bind_unknown(&mut self, param: &MacroParam, at: Origin, body: EvalContext) {
        self.result.complete = false;
        self.bind(
            body.scope,
            param.name.clone(),
            PropertyState::Ready(Value::Unknown),
            param_info(param, at),
            at,
        );
    }

    pub(super) fn missing_params(&mut self, call: MacroCall<'_>, open: &[&MacroParam]) {
        let MacroCall { def, at, body, .. } = call;
        if self.flow.unwinding {
            return;
        }
        let mut open = open.to_vec();
        open.retain(|param| !self.is_listed_twice(def, param));
        if open.is_empty() {
            return;
        }
        let names: Vec<&str> = open.iter().map(|p| p.name.as_str()).collect();
        let plural = if names.len() == 1 {
            "parameter"
        } else {
            "parameters"
        };
        let message = format!(
            "call of macro `{}` is missing the {plural} `{}`",
            def.name,
            names.join("`, `")
        );
        let add: Vec<String> = names.iter().map(|n| format!("{n}=\"...\"")).collect();
        let problem = self
            .problem(ProblemKind::MissingMacroParam, at, message)
            .says(format!("Undefined parameters [{}]", names.join(",")))
            .help(format!("add {}", add.join(" ")))
            .detail(Detail::MissingParams(
                open.iter().map(|param| param.name.clone()).collect(),
            ));
        self.push_with_definition(problem, def);
        for param in &open {
            self.bind_unknown(param, at, body);
        }
    }

    /// Whether a parameter that a call lacks has the name of one before; reports it where it is listed again: a call gives
    /// only one of them.
    fn is_listed_twice(&mut self, def: &MacroDef, param: &MacroParam) -> bool {
        let mut same = def.params.iter().filter(|other| other.name == param.name);
        let first = same.next().and_then(|first| first.definition);
        let (Some((first, _)), Some((again, _))) = (first, param.definition) else {
            return false;
        };
        if first.range == again.range {
            return false;
        }
        let name = &param.name;
        let message = format!("duplicate parameter `{name}` in macro `{}`", def.name);
        let mut problem = self
            .problem(ProblemKind::MissingMacroParam, again, message)
            .says(format!("Undefined parameters [{name}]"))
            .help("remove one of them, or rename it");
        let place = self.result.place(first);
        problem.trace.extend(place.map(|place| TraceStep {
            place,
            message: "first listed here".to_owned(),
        }));
        self.push(problem);
        true
    }

    /// Report an attribute that is no parameter. If it looks like one that is not given otherwise, it is
    /// taken for that one: a typing error is one finding, not two.
    fn misspelled_param<'d>(
        &mut self,
        call: MacroCall<'_>,
        open: &mut OpenParams<'d>,
        name: &str,
        at: Origin,
    ) -> Option<&'d MacroParam> {
        let MacroCall { tag, def, body, .. } = call;
        let message = format!("unknown parameter `{name}` in call of macro `{}`", def.name);
        let mut problem = self
            .problem(ProblemKind::UnknownMacroParam, at, message)
            .says(format!("Invalid parameter \"{name}\""));
        if let Some(block) = self.block_of_name(def, open, name) {
            let message = format!(
                "block parameter `{name}` of macro `{}` is given as an attribute",
                def.name
            );
            let problem = self
                .problem(ProblemKind::MacroBlockMismatch, at, message)
                .says(format!("Invalid parameter \"{name}\""))
                .help("remove the attribute, and write an element between the start and the end tag of the call");
            self.push_with_definition(problem, def);
            self.bind_unknown(block, at, body);
            return None;
        }
        let names = def
            .params
            .iter()
            .map(|p| p.name.as_str())
            .filter(|_| self.compares());
        let near = nearest(name, names).map(str::to_owned);
        self.names.compared += def.params.iter().len();
        if let Some(near) = &near {
            problem = problem
                .help(format!("did you mean `{near}`?"))
                .replace_with(near.as_str());
        }
        self.push_with_definition(problem, def);
        let near = near.filter(|near| tag.attr(near).is_none() && !near.starts_with('*'));
        if near.is_none() && self.request.probe {
            // the body may read it: it is missing in `params`, and that is reported here
            let info = BindingInfo::new(name.into(), BindingKind::Parameter, at);
            self.bind(
                body.scope,
                name.into(),
                PropertyState::Ready(Value::Unknown),
                info,
                at,
            );
        }
        open.take(&near?)
    }

    /// The block parameter of a name that a call gives as an attribute.
    fn block_of_name<'d>(
        &self,
        def: &MacroDef,
        open: &mut OpenParams<'d>,
        name: &str,
    ) -> Option<&'d MacroParam> {
        let is_it =
            |param: &&MacroParam| param.is_block() && param.name.trim_start_matches('*') == name;
        let block = def
            .params
            .iter()
            .find(is_it)
            .filter(|_| self.request.probe)?;
        open.take(&block.name)
    }
}

/// A parameter of a call, with its value at `at`.
fn param_info(param: &MacroParam, at: Origin) -> BindingInfo {
    let info = BindingInfo::new(param.name.clone(), BindingKind::Parameter, at);
    BindingInfo {
        definition: param.definition.map(|(_, definition)| definition),
        ..info
    }
}
