//! The global symbols: functions and constants that every expression can use.

mod catalog;
mod complex;
mod convert;
mod iterators;
pub(crate) mod math;
mod math_exact;
mod math_float;
mod math_gamma;
mod python;
mod rounding;
mod sorting;
pub(crate) mod types;
mod xacro;

pub use catalog::{BuiltinKind, GlobalSymbol, global_symbols};
pub(crate) use convert::add_entries;
pub(crate) use python::{argument_type, index_sized, integer};
pub(crate) use sorting::sort;

use std::sync::LazyLock;

use super::args::{Args, Arity};
use super::interp::Interp;
use super::stop::Eval;
use super::value::{Builtin, Module, Type, Value};

/// The code of a built-in function or method; methods get their object as second argument.
type BuiltinFn = fn(&mut Interp, &Value, &Args) -> Eval;

/// A built-in function or method.
#[derive(Debug)]
pub(crate) struct Function {
    /// Its name.
    pub(crate) name: &'static str,
    /// Its type or module; empty for Python's own functions.
    pub(crate) owner: &'static str,
    /// Its parameters as documentation shows them.
    pub(crate) params: &'static str,
    /// What it does, in a line.
    pub(crate) doc: &'static str,
    pub(crate) arity: Arity,
    pub(crate) run: BuiltinFn,
}

impl Function {
    /// A method of the type `owner`.
    pub(crate) const fn method(
        owner: &'static str,
        name: &'static str,
        arity: Arity,
        run: BuiltinFn,
    ) -> Self {
        Self {
            name,
            owner,
            params: "",
            doc: "",
            arity,
            run,
        }
    }

    /// `len()`, `math.sin()`, `str.upper()`
    pub(crate) fn qualified_name(&self, receiver: &Value) -> String {
        let owner = match receiver {
            Value::Dict(dict) if dict.is_yaml() => receiver.type_name(),
            _ => self.owner,
        };
        match owner {
            "" | "xacro" => format!("{}()", self.name),
            owner => format!("{owner}.{}()", self.name),
        }
    }

    /// Whether it is a Python function, which only matters for its type.
    pub(crate) fn is_python(&self) -> bool {
        self.owner == "xacro"
    }

    /// Whether it keeps its argument without looking at it, so that an unknown one may pass.
    pub(crate) fn stores_unknown(&self) -> bool {
        match self.owner {
            "list" => matches!(self.name, "append" | "insert"),
            "dict" => self.name == "setdefault",
            _ => false,
        }
    }
}

/// The function called `name` in a table sorted by name.
pub(crate) fn find(table: &'static [Function], name: &str) -> Option<&'static Function> {
    let place = table
        .binary_search_by(|function| function.name.cmp(name))
        .ok()?;
    table.get(place)
}

fn value_of(table: &'static [Function], name: &str) -> Option<Value> {
    Some(Value::Builtin(Builtin {
        function: find(table, name)?,
        deprecated: None,
    }))
}

/// Bare names that should be written with their namespace.
const DEPRECATED: [(&str, &str); 5] = [
    ("abs_filename", "xacro"),
    ("dotify", "xacro"),
    ("load_yaml", "xacro"),
    ("range", "python"),
    ("sorted", "python"),
];

/// The first and the last letters of names, by how long the names are: nearly all others are told from these at a glance.
struct Shapes([(u128, u128); 16]);

impl Shapes {
    fn of(names: impl Iterator<Item = &'static str>) -> Self {
        let mut shapes = Self([(0, 0); 16]);
        for name in names {
            if let (Some((first, last)), Some(shape)) = (ends(name), shapes.0.get_mut(name.len())) {
                shape.0 |= first;
                shape.1 |= last;
            }
        }
        shapes
    }

    /// Whether one of the names may be this one.
    fn admit(&self, name: &str) -> bool {
        let shape = self.0.get(name.len()).zip(ends(name));
        shape.is_some_and(|(known, own)| known.0 & own.0 != 0 && known.1 & own.1 != 0)
    }
}

/// The first and the last byte as members of sets; none where they are no ASCII.
fn ends(name: &str) -> Option<(u128, u128)> {
    let member = |byte: Option<&u8>| 1_u128.checked_shl((*byte?).into());
    let bytes = name.as_bytes();
    Some((member(bytes.first())?, member(bytes.last())?))
}

/// The value of a global symbol.
pub(crate) fn global(name: &str) -> Option<Value> {
    // asked for each property that is defined
    static SHAPES: LazyLock<Shapes> = LazyLock::new(|| {
        let own = ["True", "False", "math", "python", "xacro"];
        let inside = [Module::Math, Module::Python, Module::Xacro].map(names);
        Shapes::of(own.into_iter().chain(inside.into_iter().flatten().copied()))
    });
    if !SHAPES.admit(name) {
        return None;
    }
    match name {
        "list" | "dict" | "map" | "str" | "float" | "int" | "bool" => {
            types::named(name).map(Value::Type)
        }
        "len" | "min" | "max" | "round" => value_of(python::FUNCTIONS, name),
        "True" => Some(Value::Bool(true)),
        "False" => Some(Value::Bool(false)),
        "math" => Some(Value::Module(Module::Math)),
        "python" => Some(Value::Module(Module::Python)),
        "xacro" => Some(Value::Module(Module::Xacro)),
        _ => attribute(Module::Math, name).or_else(|| deprecated(name)),
    }
}

fn deprecated(name: &str) -> Option<Value> {
    let &(_, namespace) = DEPRECATED.iter().find(|(bare, _)| *bare == name)?;
    let table = match name {
        "range" | "dotify" => types::CONSTRUCTORS,
        "sorted" => python::FUNCTIONS,
        _ => xacro::FUNCTIONS,
    };
    Some(Value::Builtin(Builtin {
        function: find(table, name)?,
        deprecated: Some(namespace),
    }))
}

/// The value of `module.name`.
pub(crate) fn attribute(module: Module, name: &str) -> Option<Value> {
    match module {
        Module::Math => math::constant(name)
            .map(Value::Float)
            .or_else(|| value_of(math::FUNCTIONS, name)),
        Module::Python => match name {
            "True" => Some(Value::Bool(true)),
            "False" => Some(Value::Bool(false)),
            _ => types::named(name)
                .map(Value::Type)
                .or_else(|| value_of(python::FUNCTIONS, name)),
        },
        Module::Xacro if name == "dotify" => Some(Value::Type(Type::YamlDict)),
        Module::Xacro => value_of(xacro::FUNCTIONS, name),
    }
}

pub(crate) use convert::float;

/// The value of a global symbol, as an expression without properties sees it.
pub fn global_symbol(name: &str) -> Option<Value> {
    global(name)
}

/// The value of `module.name`.
pub fn module_symbol(module: Module, name: &str) -> Option<Value> {
    attribute(module, name)
}

/// The function called `name` that only `$(eval)` has.
pub fn eval_symbol(name: &str) -> Option<Value> {
    value_of(xacro::OF_EVAL, name)
}

/// The names of a module in the order in which the reference's namespace has them.
pub(crate) fn names(module: Module) -> &'static [&'static str] {
    match module {
        Module::Math => math::NAMES,
        Module::Python => python::NAMES,
        Module::Xacro => xacro::NAMES,
    }
}

/// Whether `name` is a global symbol, which a property would redefine.
pub fn is_global_symbol(name: &str) -> bool {
    global(name).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_sorted() {
        for table in [
            python::FUNCTIONS,
            math::FUNCTIONS,
            xacro::FUNCTIONS,
            xacro::OF_EVAL,
            types::CONSTRUCTORS,
        ] {
            assert!(table.is_sorted_by_key(|function| function.name));
        }
    }

    #[test]
    fn modules_hold_what_their_lists_say() {
        for module in [Module::Math, Module::Python, Module::Xacro] {
            assert!(
                names(module)
                    .iter()
                    .all(|name| attribute(module, name).is_some()),
                "{module:?}"
            );
            let known = global_symbols()
                .filter(|symbol| symbol.namespace == Some(module))
                .count();
            let constants = if module == Module::Python {
                ["True", "False"].len()
            } else {
                0
            };
            assert_eq!(names(module).len(), known + constants, "{module:?}");
        }
    }

    #[test]
    fn global_names() {
        for name in [
            "pi", "sin", "list", "sorted", "dotify", "math", "python", "xacro", "True", "e", "len",
            "cbrt",
        ] {
            assert!(is_global_symbol(name), "{name}");
        }
        let bare = global_symbols().filter(|symbol| symbol.namespace.is_none());
        for symbol in bare {
            assert!(is_global_symbol(symbol.name), "{}", symbol.name);
        }
        for name in [
            "list", "dict", "map", "str", "float", "int", "bool", "len", "min", "max",
        ] {
            assert!(is_global_symbol(name), "{name}");
        }
        for name in [
            "abs", "sum", "zip", "print", "tokenize", "", "None", "message",
        ] {
            assert!(!is_global_symbol(name), "{name}");
        }
    }
}
