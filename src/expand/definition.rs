//! `xacro:macro`: definitions of macros and their parameters.
use ecow::EcoString;

use super::expander::Expander;
use super::kind::ProblemKind;
use super::macro_table::{MacroDef, MacroParam, MacroParams};
use super::names::EvalContext;
use super::node::XId;
use super::origin::Origin;
use super::problem::{Detail, Problem};
use super::scope::{SrcRef, TextOrigin};
use super::symbols::{DefinitionId, SymbolKind};
use super::tag::Tag;
use super::undefined::UndefinedKind;
use super::{meant, params};
use base::TextRange;
use packages::nearest;

impl Expander<'_> {
    /// `xacro:macro`
    pub fn define_macro(&mut self, tag: Tag<'_>, has_next: bool, out: XId, cx: EvalContext) {
        self.drop_comments(out, has_next);
        let Some((name, place)) = self.required_attr(tag, "name", cx) else {
            return;
        };
        let mut name = name.as_ref();
        if self.is_call_meant(tag, name, cx) {
            let own = format!("xacro:{name}");
            return self.call(
                Tag {
                    name: &own,
                    used: &["name"],
                    ..tag
                },
                name,
                has_next,
                out,
                cx,
            );
        }
        let listed = self.parameter_attribute(tag, cx);
        let attributes = self.params_in_attributes(tag, cx);
        if attributes.is_empty() {
            self.check_attrs(tag, &["name", listed], cx);
        }
        if name == "call" {
            let message = "invalid macro name `call`: `xacro:call` is reserved";
            return self.error(
                ProblemKind::InvalidMacroName,
                place.origin,
                message,
                "Invalid use of macro name 'call'",
            );
        }
        if name.contains('.') {
            let message =
                format!("macro name `{name}` contains `.`, which is reserved for namespaces");
            let reference =
                format!("macro names must not contain '.' (reserved for namespaces): {name}");
            self.error(
                ProblemKind::InvalidMacroName,
                place.origin,
                message,
                reference,
            );
        } else if let Some(bare) = name.strip_prefix("xacro:") {
            let message = format!("macro name `{name}` has the prefix `xacro:`");
            let reference = format!("macro names must not contain prefix 'xacro:': {name}");
            let problem = self
                .problem(ProblemKind::MacroNameWithPrefix, place.origin, message)
                .says(reference)
                .warning();
            self.push(
                problem
                    .help(format!("rename it to `{bare}`"))
                    .replace_with(bare),
            );
            name = bare;
        }
        let name = EcoString::from(name);
        let text = self
            .attr(tag, listed, cx)
            .map(|(text, _)| text)
            .unwrap_or_default();
        let params = self
            .attr(tag, listed, cx)
            .map(|(text, place)| (params::parse(&text), place));
        let params = params.map(|(list, place)| {
            (
                list.map(|list| self.repaired_params(&name, (&text, list), place)),
                place,
            )
        });
        if let Some((None, place)) = &params {
            let message = format!("`params` of macro `{name}` contains only whitespace");
            self.error(
                ProblemKind::ExpressionError,
                place.origin,
                message,
                "list index out of range",
            );
        }
        self.defined(UndefinedKind::Macro, &name, cx.scope, place.origin);
        let definition = self.define(SymbolKind::Macro, &name, place.origin);
        let params = params.and_then(|(list, place)| Some((list?, place)));
        let params = params.map_or_else(
            || MacroParams::new(attributes),
            |(list, place)| MacroParams::new(self.define_params((&text, list), place, definition)),
        );
        let body = SrcRef {
            src: tag.src,
            node: tag.node.id(),
        };
        let def = MacroDef {
            name,
            body,
            origin: place.origin,
            definition,
            params,
        };
        let old = self.names.macros.own(cx.macros, &def.name).cloned();
        let def = self.names.macros.define(cx.macros, def);
        self.note_defined(cx.macros, old, &def);
        if self.request.probe && self.guards.calls.is_empty() {
            self.probing.macros.push((def, cx));
        }
    }

    /// Whether the definition of a macro was meant to call it: it is empty, and gives parameters of the one that is there.
    /// The reference takes it as it is.
    fn is_call_meant(&mut self, tag: Tag<'_>, name: &str, cx: EvalContext) -> bool {
        let others: Vec<&str> = tag
            .attrs()
            .map(|attr| attr.name())
            .filter(|attr| *attr != "name")
            .collect();
        if !self.request.probe || others.contains(&"params") {
            return false;
        }
        let Some(def) = self.names.macros.find(cx.macros, name) else {
            return false;
        };
        // the same file may be included again, and a call of an empty macro gives nothing either
        let is_empty = |def: &MacroDef| {
            let item = self.item(def.body.src);
            item.is_some_and(|item| item.node(def.body.node).child_elements().next().is_none())
        };
        if is_empty(&def) {
            return false;
        }
        let blocks = def.params.iter().filter(|param| param.is_block()).count();
        let children = tag.node.child_elements().count();
        // the body of another definition would read parameters
        let is_empty = children == 0;
        if !is_empty && (children != blocks || others.is_empty()) {
            return false;
        }
        if !others
            .iter()
            .all(|attr| def.params.iter().any(|param| param.name == *attr))
        {
            return false;
        }
        let what = if is_empty { " with an empty body" } else { "" };
        let message = format!("macro `{name}` is redefined{what} instead of called");
        let at = self.tag_origin(tag, cx);
        let first = tag
            .node
            .attrs()
            .next()
            .filter(|attr| attr.name() == "name" && tag.node.end_tag().is_none());
        let whole = first.map(|attr| TextRange::new(at.range.start, attr.range().end));
        let problem = self
            .problem(
                ProblemKind::RedefinedMacro,
                Origin {
                    range: whole.unwrap_or(at.range),
                    ..at
                },
                message,
            )
            .warning()
            .help(format!(
                "write <xacro:{name} ...> with the parameters as attributes to call the macro"
            ));
        let problem = if whole.is_some() {
            problem.replace_with(format!("<xacro:{name}"))
        } else {
            problem
        };
        let problem = Problem {
            detail: (!is_empty).then(|| Detail::Called(name.into())),
            ..problem
        };
        self.push_with_definition(problem, &def);
        true
    }

    /// The attribute that lists the parameters: `params`, unless a misspelled one is there instead, which is reported.
    fn parameter_attribute<'a>(&mut self, tag: Tag<'a>, cx: EvalContext) -> &'a str {
        if !self.request.probe || tag.attr("params").is_some() {
            return "params";
        }
        let Some(attr) = tag
            .attrs()
            .find(|attr| nearest(attr.name(), ["params"]).is_some())
        else {
            return "params";
        };
        let at = Origin {
            src: tag.src,
            range: attr.name_range(),
            frame: cx.frame,
        };
        let message = format!("unknown attribute `{}` in `xacro:macro`", attr.name());
        let problem = self
            .problem(ProblemKind::MissingXacroAttribute, at, message)
            .says(format!(
                "{}: unknown attribute(s): {}",
                tag.name,
                attr.name()
            ));
        self.push(
            problem
                .help("did you mean `params`?")
                .replace_with("params"),
        );
        attr.name()
    }

    /// The parameters that are meant where a name is none that a call can give: `a, b` has commas. The reference takes
    /// them as they are, and refuses each call.
    fn repaired_params(
        &mut self,
        of: &str,
        (text, params): (&str, Vec<MacroParam>),
        place: TextOrigin,
    ) -> Vec<MacroParam> {
        let is_bad = |param: &MacroParam| meant::by_parameter(&param.name).is_some();
        if !self.request.probe || !params.iter().any(is_bad) {
            return params;
        }
        let mut repaired = Vec::with_capacity(params.len());
        for param in params {
            let Some(names) = meant::by_parameter(&param.name) else {
                repaired.push(param);
                continue;
            };
            let at = self.origin_in(self.site(text, place), param.range);
            self.push(self.bad_parameter(of, &param, &names, at));
            repaired.extend(
                names
                    .iter()
                    .enumerate()
                    .map(|(i, name)| param.part(name, i + 1 == names.len())),
            );
        }
        repaired
    }

    fn bad_parameter(&self, of: &str, param: &MacroParam, names: &[&str], at: Origin) -> Problem {
        let name = &param.name;
        let (why, help) = if name.contains('$') {
            ("contains an expression", "use plain parameter names")
        } else {
            ("contains a comma", "separate parameters with spaces")
        };
        let message = format!("parameter `{name}` of macro `{of}` {why}");
        let help = match names {
            [] => format!("{help}: remove the comma"),
            names => format!("{help}: write `{}`", names.join(" ")),
        };
        self.problem(ProblemKind::InvalidPropertyName, at, message)
            .help(help)
            .replace_with(names.join(" "))
    }

    /// Note where the parameters of a macro stand.
    fn define_params(
        &mut self,
        (text, mut params): (&str, Vec<MacroParam>),
        place: TextOrigin,
        of: DefinitionId,
    ) -> Vec<MacroParam> {
        // all places at once: to find one takes as long as the list is
        let mut origin_of = self.origins_in(self.site(text, place));
        let mut places = Vec::with_capacity(params.len());
        for param in &mut params {
            let name = param.name.trim_start_matches('*');
            places.push(origin_of(TextRange::new(
                param.range.end - name.len() as u32,
                param.range.end,
            )));
            param.default_at = param.default.as_ref().map(|(_, range)| origin_of(*range));
        }
        drop(origin_of);
        for (param, at) in params.iter_mut().zip(places) {
            let name = param.name.trim_start_matches('*');
            let kind = if param.is_block() {
                SymbolKind::BlockParameter
            } else {
                SymbolKind::Parameter
            };
            param.definition = Some((at, self.define_part(kind, &name.into(), at, Some(of))));
        }
        params
    }
}
