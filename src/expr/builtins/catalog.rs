//! What an editor shows of the global symbols.

use super::{DEPRECATED, math, python, types, xacro};
use crate::value::Module;

/// What a global symbol is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum BuiltinKind {
    Constant,
    Function,
    Type,
    Namespace,
}

/// A global symbol.
#[derive(Clone, Copy, Debug)]
pub struct GlobalSymbol {
    /// Its name without namespace.
    pub name: &'static str,
    /// Where it lives; none for a bare name.
    pub namespace: Option<Module>,
    /// What it is.
    pub kind: BuiltinKind,
    /// Its parameters, without parentheses; empty for constants.
    pub params: &'static str,
    /// What it is good for, in a line.
    pub doc: &'static str,
    /// The namespace a bare name should be taken from.
    pub deprecated: Option<&'static str>,
}

/// All global symbols: bare names first, then those of `math.`, `python.` and `xacro.`.
pub fn global_symbols() -> impl Iterator<Item = GlobalSymbol> {
    let namespaces = [
        ("math", "Python's math module."),
        ("python", "Python's built-in functions and types."),
        ("xacro", "Functions of xacro."),
    ];
    let namespaces = namespaces
        .into_iter()
        .map(|(name, doc)| symbol(name, None, BuiltinKind::Namespace, "", doc));
    let python = all_of(Module::Python)
        .filter(|symbol| super::global(symbol.name).is_some())
        .map(bare);
    let xacro = all_of(Module::Xacro)
        .filter(|symbol| super::global(symbol.name).is_some())
        .map(bare);
    namespaces
        .chain(python)
        .chain(xacro)
        .chain(all_of(Module::Math).map(bare))
        .chain(
            [Module::Math, Module::Python, Module::Xacro]
                .into_iter()
                .flat_map(all_of),
        )
}

fn bare(found: GlobalSymbol) -> GlobalSymbol {
    let deprecated = DEPRECATED
        .iter()
        .find(|(name, _)| *name == found.name)
        .map(|(_, namespace)| *namespace);
    GlobalSymbol {
        namespace: None,
        deprecated,
        ..found
    }
}

fn symbol(
    name: &'static str,
    namespace: Option<Module>,
    kind: BuiltinKind,
    params: &'static str,
    doc: &'static str,
) -> GlobalSymbol {
    GlobalSymbol {
        name,
        namespace,
        kind,
        params,
        doc,
        deprecated: None,
    }
}

fn all_of(module: Module) -> impl Iterator<Item = GlobalSymbol> {
    let functions = match module {
        Module::Math => math::FUNCTIONS,
        Module::Python => python::FUNCTIONS,
        Module::Xacro => xacro::FUNCTIONS,
    };
    let constants = if module == Module::Math {
        math::CONSTANTS
    } else {
        &[]
    };
    let named_types = types::NAMED
        .iter()
        .filter(move |named| (named.0 == "dotify") == (module == Module::Xacro));
    let named_types = named_types.filter(move |_| module != Module::Math);
    functions
        .iter()
        .map(move |f| symbol(f.name, Some(module), BuiltinKind::Function, f.params, f.doc))
        .chain(
            constants.iter().map(move |&(name, _, doc)| {
                symbol(name, Some(module), BuiltinKind::Constant, "", doc)
            }),
        )
        .chain(named_types.map(move |&(name, _, params, doc)| {
            symbol(name, Some(module), BuiltinKind::Type, params, doc)
        }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::builtins::{attribute, global};

    #[test]
    fn every_symbol_resolves_and_is_documented() {
        let mut count = 0;
        for symbol in global_symbols() {
            let found = match symbol.namespace {
                None => global(symbol.name),
                Some(module) => attribute(module, symbol.name),
            };
            assert!(found.is_some(), "{symbol:?}");
            assert!(
                symbol.doc.ends_with('.') && symbol.doc.len() < 100,
                "{symbol:?}"
            );
            count += 1;
        }
        assert!(count > 150, "{count}");
    }

    #[test]
    fn deprecated_bare_names_say_where_they_live() {
        let of = |name| {
            global_symbols()
                .find(|s| s.name == name && s.namespace.is_none())
                .map(|s| s.deprecated)
        };
        assert_eq!(of("range"), Some(Some("python")));
        assert_eq!(of("load_yaml"), Some(Some("xacro")));
        assert_eq!(of("len"), Some(None));
        assert_eq!(of("abs"), None);
    }
}
