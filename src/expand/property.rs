//! `xacro:property`.
use std::borrow::Cow;

use ecow::EcoString;

use super::binding_info::{BindingInfo, BindingKind};
use super::expander::Expander;
use super::kind::ProblemKind;
use super::meant;
use super::names::EvalContext;
use super::node::XId;
use super::origin::Origin;
use super::scope::{Binding, Block, PropertyState, Scopes, SrcRef, TextOrigin};
use super::symbols::SymbolKind;
use super::tag::Tag;
use base::TextRange;
use expr::{ScopeId, Value, display, is_global_symbol, is_identifier, literal, normalized};

/// The attributes of `xacro:property`.
const PROPERTY_ATTRS: [&str; 6] = ["name", "value", "default", "remove", "scope", "lazy_eval"];

/// Words of a wrong name that may be meant by themselves.
const MOST_WORDS: usize = 8;

type AttrText<'a> = Option<(Cow<'a, str>, TextOrigin)>;

/// What a tag says of the property that it defines.
struct Given<'a> {
    name: EcoString,
    name_place: TextOrigin,
    /// None for a block.
    value: AttrText<'a>,
    scope: AttrText<'a>,
    lazy: bool,
}

impl Expander<'_> {
    /// Define, default or remove a property.
    pub fn property(&mut self, tag: Tag<'_>, has_next: bool, out: XId, cx: EvalContext) {
        self.drop_comments(out, has_next);
        let Some((name_text, name_place)) = self.required_attr(tag, "name", cx) else {
            return self.nameless_property(tag, cx);
        };
        self.check_attrs(tag, &PROPERTY_ATTRS, cx);
        let name = self.eval_text(&name_text, name_place, cx.scope);
        let Some(name) = self.property_name(&name, name_place, cx) else {
            return;
        };
        let mut value = self.attr(tag, "value", cx);
        let default = self.attr(tag, "default", cx);
        let Some(remove) = self.flag(tag, "remove", false, cx) else {
            return;
        };
        if usize::from(value.is_some()) + usize::from(default.is_some()) + usize::from(remove) > 1 {
            return self.conflicting(tag, &name, cx);
        }
        let known = self.names.scopes.holder(cx.scope, &name).is_some() || is_global_symbol(&name);
        if remove && known {
            return self.remove_property(cx.scope, &name, name_place);
        }
        let scope = self.attr(tag, "scope", cx);
        if let Some((_, place)) = &default {
            if scope.is_some() {
                let message =
                    format!("`scope` of property `{name}` is ignored because it has a `default`");
                let reference =
                    format!("{name}: default property value can only be defined on local scope");
                let at = scope.as_ref().map_or(place.origin, |(_, p)| p.origin);
                self.warn(ProblemKind::DefaultWithScope, at, message, reference);
            }
            if known {
                return;
            }
            value = default;
        }
        if value.is_none() && self.has_misspelled_value(tag) {
            return self.bind_lost(name, name_place.origin, cx);
        }
        let Some(lazy) = self.flag(tag, "lazy_eval", true, cx) else {
            return;
        };
        let given = Given {
            name,
            name_place,
            value,
            scope,
            lazy,
        };
        self.store(tag, &given, cx);
    }

    fn store(&mut self, tag: Tag<'_>, given: &Given<'_>, cx: EvalContext) {
        let name = &given.name;
        let mut at_once = !given.lazy;
        let mut target = Some(cx.scope);
        match given.scope.as_ref().map(|(text, _)| text.as_ref()) {
            Some("global") => (target, at_once) = (Some(Scopes::TOP), true),
            Some("parent") => (target, at_once) = (self.parent_scope(cx.scope), true),
            _ => {}
        }
        let kind = if given.value.is_some() {
            SymbolKind::Property
        } else {
            SymbolKind::BlockProperty
        };
        let definition = self.define(kind, name, given.name_place.origin);
        let (key, state, origin) = match &given.value {
            None => {
                let at = self.tag_origin(tag, cx);
                let block = Block::Source(SrcRef {
                    src: tag.src,
                    node: tag.node.id(),
                });
                (
                    EcoString::from(format!("**{name}")),
                    PropertyState::Block(block),
                    at,
                )
            }
            Some((text, place)) if at_once => {
                let mark = self.names.reads.len();
                let value = literal_of(self.eval_text(text, *place, cx.scope));
                let reads = self.take_reads(mark);
                let info = BindingInfo {
                    reads,
                    ..BindingInfo::new(name.clone(), BindingKind::Property, place.origin)
                        .of(definition)
                };
                return self.put(
                    target,
                    name.clone(),
                    PropertyState::Ready(value),
                    info,
                    given,
                );
            }
            Some((text, place)) => (name.clone(), lazy_state(text, *place), place.origin),
        };
        let info = BindingInfo::new(name.clone(), BindingKind::Property, origin).of(definition);
        self.put(target, key, state, info, given);
    }

    fn put(
        &mut self,
        target: Option<ScopeId>,
        key: EcoString,
        state: PropertyState,
        info: BindingInfo,
        given: &Given<'_>,
    ) {
        let at = given.name_place.origin;
        let Some(target) = target else {
            let at = given.scope.as_ref().map_or(at, |(_, place)| place.origin);
            let message = format!(
                "property `{}` has scope=\"parent\" outside a macro",
                info.name
            );
            let problem = self
                .problem(ProblemKind::ParentScopeAtTop, at, message)
                .says("'dict' object has no attribute '_setitem'")
                .help("remove scope=\"parent\"");
            return self.push(problem);
        };
        let is_value = !matches!(state, PropertyState::Block(_));
        let state = if is_value
            && self.flow.unknown_conditions > 0
            && self.names.scopes.holder(target, &key).is_some()
        {
            // the branch may not be taken: then the value before holds
            PropertyState::Ready(Value::Unknown)
        } else {
            state
        };
        self.bind(target, key, state, info, at);
    }

    /// Put a binding into a scope.
    pub fn bind(
        &mut self,
        scope: ScopeId,
        key: EcoString,
        state: PropertyState,
        mut info: BindingInfo,
        at: Origin,
    ) {
        if is_global_symbol(&key) {
            let message = format!("property `{key}` shadows the built-in symbol `{key}`");
            self.warn(
                ProblemKind::ShadowedBuiltin,
                at,
                message,
                format!("redefining global symbol: {key}"),
            );
        }
        self.defined(super::undefined::UndefinedKind::Property, &key, scope, at);
        if let PropertyState::Ready(value) = &state {
            info.value = Some(value.clone());
        }
        let info = self.add_binding(info);
        self.names.scopes.note_change(scope);
        let new = Binding { state, info };
        self.note_bound(scope, &key, &new);
        self.names.scopes.get_mut(scope).vars.insert(key, new);
    }

    /// The scope `scope="parent"` means; none at the top.
    fn parent_scope(&self, from: ScopeId) -> Option<ScopeId> {
        let scope = self.names.scopes.get(from);
        let mut target = scope.parent?;
        if !scope.is_namespace {
            // from a macro, the namespaces between it and its caller are skipped
            while self.names.scopes.get(target).is_namespace {
                target = self.names.scopes.get(target).parent?;
            }
        }
        Some(target)
    }

    fn property_name(
        &mut self,
        name: &Value,
        place: TextOrigin,
        cx: EvalContext,
    ) -> Option<EcoString> {
        let Value::Str(name) = name else {
            if let Some(shown) = display::to_str(name) {
                let message = format!("invalid property name `{shown}`");
                let reference = format!("Property names must be valid python identifiers: {shown}");
                self.error(
                    ProblemKind::InvalidPropertyName,
                    place.origin,
                    message,
                    reference,
                );
            }
            return None;
        };
        let reference = if !is_identifier(name) {
            format!("Property names must be valid python identifiers: {name}")
        } else if name.starts_with("__") {
            format!("Property names must not start with double underscore:{name}")
        } else {
            return Some(name.clone());
        };
        let lookup = normalized(name);
        let (message, help) = if name.starts_with("__") {
            (
                format!("property name `{name}` starts with two underscores"),
                None,
            )
        } else if is_identifier(&lookup) {
            let message =
                format!("property `{name}` is never found: expressions look for `{lookup}`");
            (
                message,
                Some(format!("write `{lookup}`, the NFKC form of the same name")),
            )
        } else {
            (format!("invalid property name `{name}`"), None)
        };
        let general =
            "use letters, digits and `_`; do not start with a digit or use a Python keyword";
        let help = help.unwrap_or_else(|| general.to_owned());
        let problem = self
            .problem(ProblemKind::InvalidPropertyName, place.origin, message)
            .says(reference)
            .help(help);
        self.push(problem);
        // what reads the name that was meant is a consequence
        let words = name
            .split(|c: char| !c.is_alphanumeric() && c != '_')
            .filter(|word| is_identifier(word));
        let words: Vec<EcoString> = words.take(MOST_WORDS).map(EcoString::from).collect();
        let joined = EcoString::from(words.join("_"));
        for meant in words
            .into_iter()
            .chain(Some(joined).filter(|joined| is_identifier(joined)))
        {
            if self.names.scopes.holder(cx.scope, &meant).is_none() && !is_global_symbol(&meant) {
                self.bind_lost(meant, place.origin, cx);
            }
        }
        None
    }

    /// A property without a name: `<xacro:property width="0.1"/>` was meant to define `width`.
    fn nameless_property(&mut self, tag: Tag<'_>, cx: EvalContext) {
        let names: Vec<_> = tag
            .attrs()
            .filter(|attr| is_identifier(attr.name()) && !PROPERTY_ATTRS.contains(&attr.name()))
            .take(MOST_WORDS)
            .collect();
        for attr in names {
            let at = Origin {
                src: tag.src,
                range: attr.name_range(),
                frame: cx.frame,
            };
            self.bind_lost(attr.name().into(), at, cx);
        }
    }

    /// Whether an attribute that was reported was meant to be `value`, and nothing else gives one.
    fn has_misspelled_value(&self, tag: Tag<'_>) -> bool {
        tag.node.child_elements().next().is_none()
            && tag.attrs().any(|attr| {
                !PROPERTY_ATTRS.contains(&attr.name())
                    && meant::by_attribute(attr.name(), &["value"]).is_some()
            })
    }

    /// Define a name whose definition was reported as wrong: that its value is unknown is no further finding.
    fn bind_lost(&mut self, name: EcoString, at: Origin, cx: EvalContext) {
        self.result.complete = false;
        let info = BindingInfo::new(name.clone(), BindingKind::Property, at);
        self.bind(
            cx.scope,
            name,
            PropertyState::Ready(Value::Unknown),
            info,
            at,
        );
    }

    /// A boolean attribute; `None` when its value is an error or unknown.
    fn flag(&mut self, tag: Tag<'_>, name: &str, default: bool, cx: EvalContext) -> Option<bool> {
        match self.attr(tag, name, cx) {
            Some((text, place)) if !text.is_empty() => {
                let mark = self.names.reads.len();
                let value = self.eval_text(&text, place, cx.scope);
                self.truth(&value, &text, place.origin, mark)
            }
            _ => Some(default),
        }
    }

    fn conflicting(&mut self, tag: Tag<'_>, name: &EcoString, cx: EvalContext) {
        let given: Vec<_> = tag
            .attrs()
            .filter(|a| matches!(a.name(), "value" | "default" | "remove"))
            .collect();
        let names: Vec<String> = given.iter().map(|a| format!("`{}`", a.name())).collect();
        let range = given.last().map_or(tag.node.name_range(), |a| a.range());
        let at = Origin {
            src: tag.src,
            range,
            frame: cx.frame,
        };
        let problem = self
            .problem(
                ProblemKind::ConflictingPropertyAttributes,
                at,
                format!(
                    "property `{name}` has more than one of {}",
                    names.join(" and ")
                ),
            )
            .says(format!(
                "Property attributes default, value, and remove are mutually exclusive: {name}"
            ));
        self.push(problem);
        self.bind_lost(name.clone(), at, cx);
    }

    fn remove_property(&mut self, scope: ScopeId, name: &EcoString, place: TextOrigin) {
        self.steps.journal.unclear += 1;
        self.names.scopes.remove_everywhere(scope, name);
        if is_global_symbol(name) {
            let message = format!("cannot remove the built-in symbol `{name}`");
            self.warn(
                ProblemKind::ShadowedBuiltin,
                place.origin,
                message,
                format!("Cannot remove global symbol: {name}"),
            );
        }
    }
}

/// The literal rule on the result of an expression.
pub(super) fn literal_of(value: Value) -> Value {
    match value {
        Value::Str(text) => literal::from_text(&text),
        value => value,
    }
}

/// What a property with this text is until its first use.
fn lazy_state(text: &str, place: TextOrigin) -> PropertyState {
    let Value::Str(literal) = literal::from_text(text) else {
        return PropertyState::Ready(literal::from_text(text));
    };
    if !literal.contains('$') {
        // nothing to evaluate: only the literal rule is applied once more
        return PropertyState::Ready(literal::from_text(&literal));
    }
    let mut place = place;
    if literal.len() + 2 == text.len() && text.starts_with('\'') {
        let range = place.origin.range;
        place.origin.range = TextRange::new(range.start + 1, range.end.saturating_sub(1));
    }
    PropertyState::Lazy(literal, place)
}
