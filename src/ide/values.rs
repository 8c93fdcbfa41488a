//! The values that expressions have in the expansion, and how they are shown.

use super::context::Cx;
use super::host::{self, NameResolver};
use super::instances::is_within;
use base::{FastSet, TextRange};
use expand::{BindingId, BindingKind, Evaluation, FrameId};
use expr::ast::{Expr, ExprKind};
use expr::{self, Lookup, Value, display, is_global_symbol};

/// A value, and the way that led to it.
#[derive(Clone, Debug)]
pub struct Instance {
    /// The way.
    pub frame: FrameId,
    /// The value.
    pub value: Value,
}

/// What stands for a value that is not known.
pub const UNKNOWN: &str = "?";

/// The values of the `${...}` or `$(...)` at `range` of the file, one for each way that led there; of those in the
/// macro whose call was selected, only what that call gave.
pub fn instances(cx: &Cx<'_>, range: TextRange) -> Vec<Instance> {
    of_selected(cx, all_instances(cx, range))
}

/// The same, whatever call was selected.
pub fn all_instances(cx: &Cx<'_>, range: TextRange) -> Vec<Instance> {
    part_instances(cx, range, |_, evaluation| evaluation.value.clone())
}

/// Of values that came through the call that was selected and others, only the former.
pub fn of_selected(cx: &Cx<'_>, mut found: Vec<Instance>) -> Vec<Instance> {
    if let Some(selected) = cx.selected_frame {
        let own = |instance: &Instance| is_within(cx.expansion, instance.frame, selected);
        if found.iter().any(own) {
            found.retain(own);
        }
    }
    found
}

/// The same for a part of it: `whole` is all of the expression.
pub fn part_values(cx: &Cx<'_>, range: TextRange, whole: &Expr, part: &Expr) -> Vec<Instance> {
    if std::ptr::eq(whole, part) {
        return instances(cx, range);
    }
    of_selected(
        cx,
        part_instances(cx, range, |cx, evaluation| {
            part_value(cx, evaluation, whole, part)
        }),
    )
}

fn part_instances(
    cx: &Cx<'_>,
    range: TextRange,
    value: impl Fn(&Cx<'_>, &Evaluation) -> Value,
) -> Vec<Instance> {
    let Some(place) = cx.source_range(range) else {
        return Vec::new();
    };
    let mut found: Vec<Instance> = Vec::new();
    for evaluation in cx.expansion.index.evaluations.at(place) {
        let instance = Instance {
            frame: evaluation.at.frame,
            value: value(cx, evaluation),
        };
        match found.iter_mut().find(|known| known.frame == instance.frame) {
            // a condition that holds is evaluated twice
            Some(known) if same(&known.value, &instance.value) => {}
            _ => found.push(instance),
        }
    }
    found
}

/// Whether two values read the same.
pub fn same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Float(a), Value::Float(b)) => a.to_bits() == b.to_bits(),
        (Value::Int(a), Value::Int(b)) => a == b,
        (Value::Str(a), Value::Str(b)) => a == b,
        _ => a.type_name() == b.type_name() && display::repr(a) == display::repr(b),
    }
}

/// The different ones among values, in order.
pub fn distinct<'v>(values: impl IntoIterator<Item = &'v Value>) -> Vec<&'v Value> {
    let mut found: Vec<&Value> = Vec::new();
    for value in values {
        if !found.iter().any(|known| same(known, value)) {
            found.push(value);
        }
    }
    found
}

/// The value of a part of an expression, from what was read when the whole was evaluated.
fn part_value(cx: &Cx<'_>, evaluation: &Evaluation, whole: &Expr, part: &Expr) -> Value {
    // a variable of a comprehension has no one value
    let free: FastSet<TextRange> = expr::names(whole)
        .into_iter()
        .map(|name| name.range)
        .collect();
    if !expr::names(part)
        .iter()
        .all(|name| free.contains(&name.range))
    {
        return Value::Unknown;
    }
    if changes_something(part) {
        return Value::Unknown;
    }
    let mut known = KnownValues {
        cx,
        reads: cx.expansion.index.read_in(evaluation.reads),
    };
    host::evaluate(part, &mut known, 200)
}

/// Whether a part calls a method that changes its object: the values of the expansion are not to be touched.
fn changes_something(part: &Expr) -> bool {
    const METHODS: &[&str] = &[
        "add",
        "append",
        "clear",
        "discard",
        "extend",
        "insert",
        "intersection_update",
        "pop",
        "popitem",
        "remove",
        "reverse",
        "setdefault",
        "sort",
        "update",
    ];
    let mut found =
        matches!(&part.kind, ExprKind::Attribute { name, .. } if METHODS.contains(&name.as_str()));
    expr::visit::children(part, &mut |child| found |= changes_something(child));
    found
}

/// Answers with what was read before, and with nothing else.
struct KnownValues<'a> {
    cx: &'a Cx<'a>,
    reads: &'a [BindingId],
}

impl KnownValues<'_> {
    fn value(&self, name: &str, of: impl Fn(BindingKind) -> bool) -> Option<Value> {
        let bindings = self
            .reads
            .iter()
            .filter_map(|&read| self.cx.expansion.index.bindings.get(read));
        let mut named = bindings.filter(|info| info.name == name && of(info.kind));
        let first = named.next()?.value.as_ref()?;
        // names of several namespaces may be spelled alike
        let alike = named.all(|info| info.value.as_ref().is_some_and(|value| same(value, first)));
        alike.then(|| first.clone())
    }

    fn named(&self, name: &str) -> Lookup {
        match self.value(name, |kind| kind != BindingKind::Argument) {
            // looking at it would use it up
            Some(Value::Iter(_)) => Lookup::Found(Value::Unknown),
            Some(value) => Lookup::Found(value),
            None if is_global_symbol(name) && !self.is_bound(name) => Lookup::Missing,
            None => Lookup::Found(Value::Unknown),
        }
    }

    /// Whether anything but an argument has the name.
    fn is_bound(&self, name: &str) -> bool {
        let mut bindings = self.cx.expansion.index.bindings.iter();
        bindings.any(|info| info.name == name && info.kind != BindingKind::Argument)
    }
}

impl NameResolver for KnownValues<'_> {
    fn name(&mut self, name: &str) -> Lookup {
        self.named(name)
    }

    fn member(&mut self, name: &str) -> Lookup {
        self.named(name)
    }

    fn argument_value(&mut self, name: &str) -> Value {
        self.value(name, |kind| kind == BindingKind::Argument)
            .unwrap_or_default()
    }

    fn yaml(&mut self, _: &[Value]) -> Value {
        Value::Unknown
    }
}

/// A value in at most `most` characters: numbers with ten digits that count, `?` for what is not known.
pub fn short(value: &Value, most: usize) -> String {
    let text = match value {
        Value::Float(number) => number_text(*number),
        Value::Str(text) => text.to_string(),
        other => display::repr(other).map_or_else(|| UNKNOWN.to_owned(), |text| text.to_string()),
    };
    cut(&text.replace(['\n', '\r', '\t'], " "), most)
}

/// A text in at most `most` characters.
pub fn cut(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or("").trim_end()),
        None => text.to_owned(),
    }
}

/// A number with ten digits that count: `0.05` for what a sum made 0.049999999999999996.
pub fn number_text(number: f64) -> String {
    let rounded = format!("{number:.9e}").parse().unwrap_or(number);
    display::to_str(&Value::Float(rounded))
        .map_or_else(|| number.to_string(), |text| text.to_string())
}
