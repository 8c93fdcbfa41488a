//! Names to values: lazy evaluation, and what was read for it.
use ecow::EcoString;

use super::binding_info::{BindingId, LazyUse};
use super::expander::Expander;
use super::kind::ProblemKind;
use super::macro_table::Macros;
use super::meant;
use super::memo::ForcedProperty;
use super::origin::Origin;
use super::problem::{Outside, TraceStep};
use super::scope::{Block, PropertyState, Scopes};
use super::stack::with_stack;
use super::symbols::UseKind;
use super::undefined::{UndefinedKind, UndefinedName};
use base::limits::LAZY_DEPTH;
use expr::{ScopeId, Value, literal};
use xml::NodeKind;

impl Expander<'_> {
    /// The value of `name` seen from `scope`; `at` is the text that asks. `None`: no such property.
    pub fn resolve(&mut self, scope: ScopeId, name: &str, at: Origin) -> Option<Value> {
        let (holder, binding) = self.names.scopes.find(scope, name)?;
        let (info, state) = (binding.info, binding.state.clone());
        self.note_read(at, info, UseKind::Read);
        Some(self.read(holder, (name, info), state, at))
    }

    /// The same without noting that `at` refers to it.
    pub fn value_of(&mut self, scope: ScopeId, name: &str, at: Origin) -> Option<Value> {
        let (holder, binding) = self.names.scopes.find(scope, name)?;
        let (info, state) = (binding.info, binding.state.clone());
        Some(self.read(holder, (name, info), state, at))
    }

    /// The value of a binding that was found, read for the text at `at`.
    fn read(
        &mut self,
        holder: ScopeId,
        (name, info): (&str, BindingId),
        state: PropertyState,
        at: Origin,
    ) -> Value {
        let value = match state {
            PropertyState::Block(_) => return Value::Unknown,
            PropertyState::Ready(value) => value,
            PropertyState::Lazy(..) => self.force(holder, name, at),
        };
        self.names.reads.push(info);
        value
    }

    /// Evaluate a lazy property for good.
    fn force(&mut self, holder: ScopeId, name: &str, at: Origin) -> Value {
        let scope = self.names.scopes.get_mut(holder);
        let Some((name, PropertyState::Lazy(text, place), info)) = scope
            .vars
            .get(name)
            .map(|(n, b)| (n.clone(), b.state.clone(), b.info))
        else {
            return Value::Unknown;
        };
        if scope.resolving.contains(&name) {
            return self.circular(holder, &name, at);
        }
        if self.names.lazy_uses.len() >= LAZY_DEPTH {
            let message =
                format!("properties depend on each other more than {LAZY_DEPTH} levels deep");
            self.error(
                ProblemKind::ExpressionError,
                at,
                message,
                "maximum recursion depth exceeded",
            );
            return Value::Unknown;
        }
        scope.resolving.push(name.clone());
        self.note_source(place.origin.src);
        self.names.lazy_uses.push(LazyUse {
            name: name.clone(),
            at,
        });
        let mark = self.names.reads.len();
        let value = with_stack(|| self.eval_text(&text, place, holder));
        self.names.lazy_uses.pop();
        let value = match value {
            Value::Str(text) => literal::from_text(&text),
            value => value,
        };
        let reads = self.take_reads(mark);
        if holder == Scopes::TOP {
            self.note_evaluated(&name, (info, reads), &value);
            self.note_forced(|| ForcedProperty {
                name: name.clone(),
                info,
                value: value.clone(),
                reads,
            });
        }
        if let Some(info) = self.result.index.bindings.get_mut(info) {
            info.reads = reads;
            info.value = Some(value.clone());
        }
        let scope = self.names.scopes.get_mut(holder);
        scope.resolving.retain(|n| *n != name);
        if let Some(binding) = scope.vars.get_mut(&name) {
            binding.state = PropertyState::Ready(value.clone());
        }
        value
    }

    fn circular(&mut self, holder: ScopeId, name: &EcoString, at: Origin) -> Value {
        let resolving = self.names.scopes.get(holder).resolving.clone();
        let chain = resolving
            .iter()
            .chain([name])
            .map(EcoString::as_str)
            .collect::<Vec<_>>()
            .join(" -> ");
        let start = resolving.iter().position(|n| n == name).unwrap_or(0);
        let mut cycle: Vec<(&EcoString, Origin)> = resolving
            .iter()
            .skip(start)
            .map(|name| {
                let binding = self
                    .names
                    .scopes
                    .find(holder, name)
                    .map(|(_, binding)| binding.info);
                let info = binding.and_then(|info| self.result.index.bindings.get(info));
                (name, info.and_then(|info| info.origin).unwrap_or(at))
            })
            .collect();
        // the first property of the cycle is to blame, wherever the cycle was entered
        let first = (0..cycle.len()).min_by_key(|&i| {
            let place = cycle
                .get(i)
                .and_then(|(_, origin)| self.result.place(*origin));
            place.map(|place| (place.file, place.range.start))
        });
        cycle.rotate_left(first.unwrap_or(0));
        let names: Vec<&str> = cycle
            .iter()
            .chain(cycle.first())
            .map(|(name, _)| name.as_str())
            .collect();
        let reference = format!(
            "circular variable definition: {chain}\nConsider disabling lazy evaluation via lazy_eval=\"false\""
        );
        let message = format!("circular property definition: {}", names.join(" -> "));
        let origin = cycle.first().map_or(at, |&(_, origin)| origin);
        let mut problem = self
            .problem(ProblemKind::PropertyCycle, origin, message)
            .says(reference)
            .help("give one of them a constant value, or add lazy_eval=\"false\" to it");
        let others = cycle.iter().skip(1).filter_map(|&(name, origin)| {
            Some(TraceStep {
                place: self.result.place(origin)?,
                message: format!("`{name}` is part of the cycle"),
            })
        });
        problem.trace.splice(0..0, others.collect::<Vec<_>>());
        self.push(problem);
        Value::Unknown
    }

    /// Report a name that is no property, parameter or global symbol; `code` is the expression it stands in.
    pub fn undefined_property(&mut self, scope: ScopeId, name: &str, code: &str, at: Origin) {
        let message = format!("property `{name}` is not defined");
        // in a macro with many calls, looking for similar names each time would cost more than the calls
        if self.is_repeated(ProblemKind::UndefinedProperty, at, &message) {
            return;
        }
        let Some(missing) = self.missing_name(UndefinedKind::Property, name, |expander| {
            expander.names.scopes.visible_names(scope)
        }) else {
            return;
        };
        let is_block = self.holds_block(scope, name);
        let missing = UndefinedName {
            is_misspelled: missing.is_misspelled || is_block,
            ..missing
        };
        let mut problem = self
            .problem(ProblemKind::UndefinedProperty, at, message)
            .says(format!(
                "name '{name}' is not defined \nwhen evaluating expression '{code}'"
            ));
        if let Some(meant) = meant::by_name(name) {
            problem = meant.said_of(problem);
        } else if let Some(value) = self.text_of_block(scope, name) {
            problem = problem.help(format!(
                "write <xacro:property name=\"{name}\" value=\"{value}\"/>"
            ));
        } else if is_block {
            problem = problem.help(format!(
                "write <xacro:insert_block name=\"{name}\"/> where an element is allowed; `{name}` is a block"
            ));
        } else if let Some(call) = self.call_of(name) {
            problem = problem.help(format!(
                "write {call} where an element is allowed; `{name}` is a macro"
            ));
        } else if let Some(near) = &missing.near {
            problem = problem
                .help(format!("did you mean `{near}`?"))
                .replace_with(near);
        } else if let Some(text) = meant::by_comparison(name, code) {
            problem = problem
                .help(format!("quote the string: `${{{text}}}`"))
                .replace_with(format!("'{name}'"));
        } else if self.names.args.contains_key(name) {
            problem = problem.help(format!("write `$(arg {name})`; `{name}` is an argument"));
        } else {
            let define = format!("<xacro:property name=\"{name}\" value=\"...\"/>");
            problem = problem.help(format!("add {define} before this expression"));
        }
        self.push_undefined(missing, scope, problem);
    }

    /// Whether `name` is that of a block property.
    fn holds_block(&self, scope: ScopeId, name: &str) -> bool {
        self.names
            .scopes
            .find(scope, &format!("**{name}"))
            .or_else(|| self.names.scopes.find(scope, &format!("*{name}")))
            .is_some()
    }

    /// The text of a block property that holds nothing else: it was meant to be the value.
    fn text_of_block(&self, scope: ScopeId, name: &str) -> Option<String> {
        const LONGEST: usize = 60;
        let (_, binding) = self.names.scopes.find(scope, &format!("**{name}"))?;
        let PropertyState::Block(Block::Source(at)) = binding.state else {
            return None;
        };
        let node = self.result.sources.get(at.src)?.item.node(at.node);
        let text = node
            .first_child()
            .filter(|text| text.next_sibling().is_none() && text.kind() == NodeKind::Text)?;
        let text = text.raw().trim();
        (!text.is_empty() && text.len() <= LONGEST && !text.contains(['"', '<', '\n']))
            .then(|| text.to_owned())
    }

    /// How a macro of that name is called, if there is one.
    fn call_of(&self, name: &str) -> Option<String> {
        let def = self.names.macros.find(Macros::TOP, name)?;
        let own = def
            .params
            .iter()
            .filter(|param| !param.is_block() && param.default.is_none());
        let given: String = own
            .map(|param| format!(" {}=\"...\"", param.name))
            .collect();
        Some(format!("<xacro:{name}{given}/>"))
    }

    /// An argument that was read since `mark` for what is evaluated now and that is empty by default: whoever expands the
    /// file is to give it.
    pub fn empty_argument(&self, mark: usize) -> Option<EcoString> {
        self.result
            .empty_argument_of(self.names.reads.get(mark..).unwrap_or(&[]))
    }

    /// What may give another value to what is evaluated now, which read the names behind `mark`: nothing when it read
    /// none.
    pub fn outside_of_reads(&self, mark: usize) -> Option<Outside> {
        let argument = self.empty_argument(mark).map(Outside::Argument);
        (self.names.reads.len() > mark).then(|| argument.unwrap_or(Outside::Includer))
    }

    /// Report an argument that was neither declared nor given; `said` is how the reference shows its name.
    pub fn undefined_arg(&mut self, name: &str, at: Origin, said: String) {
        let Some(missing) = self.missing_name(UndefinedKind::Arg, name, |expander| {
            expander.names.args.keys().map(EcoString::as_str).collect()
        }) else {
            return;
        };
        let mut problem = self
            .problem(
                ProblemKind::UndefinedArg,
                at,
                format!("argument `{name}` is not defined"),
            )
            .says(said);
        problem = match &missing.near {
            Some(near) => problem.help(format!("did you mean `{near}`?")).replace_with(near),
            None => problem.help(format!(
                "add <xacro:arg name=\"{name}\" default=\"...\"/> before this use, or pass {name}:=..."
            )),
        };
        self.push_undefined(missing, Scopes::TOP, problem);
    }
}
