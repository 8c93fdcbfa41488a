//! What the names of a file stand for.

use std::cell::OnceCell;

use super::super::context::Cx;
use super::{Modifiers, TokenKind, overlap};
use base::{FastMap, FastSet, TextRange};
use expand::{SymbolKind, Symbols};
use expr::{BuiltinKind as GlobalKind, global_symbols};
use xml::Node;

/// The names of a file that expansion came by, and those that all expressions know.
pub(super) struct KnownNames<'a> {
    /// By their place in the file.
    known: Vec<KnownName>,
    globals: FastMap<&'static str, (TokenKind, Modifiers)>,
    /// What stands for a name that expansion did not come by.
    properties: OnceCell<FastSet<&'a str>>,
    symbols: &'a Symbols,
}

/// What the name at a place is.
pub(super) type KnownName = (TextRange, SymbolKind);

impl<'a> KnownNames<'a> {
    /// Those of a part of the file.
    pub fn of(cx: &Cx<'a>, within: TextRange) -> Self {
        let symbols = &cx.expansion.index.symbols;
        let mut known = Vec::new();
        let base_of = cx.base_of();
        let given = symbols.definitions.iter();
        let given = given.map(|given| (given.place, given.kind));
        let used = symbols
            .all_uses()
            .filter_map(|used| Some((used.place, symbols.get(used.definition)?.kind)));
        for (place, kind) in given.chain(used) {
            let place = base_of(place.src).map(|base| place.range.shift(base));
            if let Some(place) = place.filter(|place| overlap(*place, within)) {
                known.push((place, kind));
            }
        }
        // of several, the last one counts
        known.reverse();
        known.sort_by_key(|(place, _)| (place.start, place.end));
        known.dedup_by_key(|(place, _)| *place);
        Self {
            known,
            globals: globals(),
            properties: OnceCell::new(),
            symbols,
        }
    }

    /// All of them, by their places in the file.
    pub fn all(&self) -> &[KnownName] {
        &self.known
    }

    /// What the name at a place is.
    pub fn at(&self, range: TextRange) -> Option<TokenKind> {
        let key = |range: &TextRange| (range.start, range.end);
        let found = self
            .known
            .binary_search_by_key(&key(&range), |(place, _)| key(place));
        let (_, kind) = self.known.get(found.ok()?)?;
        Some(match kind {
            SymbolKind::Property | SymbolKind::BlockProperty => TokenKind::Variable,
            SymbolKind::Parameter | SymbolKind::BlockParameter | SymbolKind::Argument => {
                TokenKind::Parameter
            }
            SymbolKind::Macro => TokenKind::Macro,
            SymbolKind::Namespace => TokenKind::Namespace,
        })
    }

    /// What a name in an expression of `node` is.
    pub fn named(
        &self,
        name: &str,
        range: TextRange,
        node: Option<Node<'_>>,
    ) -> (TokenKind, Modifiers) {
        if let Some(kind) = self.at(range) {
            return (kind, Modifiers::default());
        }
        if node.is_some_and(|node| is_parameter(node, name)) {
            return (TokenKind::Parameter, Modifiers::default());
        }
        if self.properties().contains(name) {
            return (TokenKind::Variable, Modifiers::default());
        }
        self.globals
            .get(name)
            .copied()
            .unwrap_or((TokenKind::Variable, Modifiers::default()))
    }

    /// The names of all properties.
    pub fn properties(&self) -> &FastSet<&'a str> {
        self.properties.get_or_init(|| {
            let given = self.symbols.definitions.iter();
            let properties = given.filter(|given| given.kind == SymbolKind::Property);
            properties.map(|given| given.name.as_str()).collect()
        })
    }

    /// What `module.name` is.
    pub fn member(&self, module: &str, name: &str) -> Option<TokenKind> {
        let of = |symbol: &expr::GlobalSymbol| {
            symbol.name == name && symbol.namespace.is_some_and(|found| found.name() == module)
        };
        global_symbols().find(of).map(|symbol| kind(symbol.kind))
    }
}

/// Whether a macro around an element has a parameter of this name.
fn is_parameter(node: Node<'_>, name: &str) -> bool {
    let around = std::iter::successors(Some(node), |node| node.parent());
    let lists = around
        .filter(|node| node.name() == "xacro:macro")
        .filter_map(|node| node.attr("params"));
    lists.into_iter().any(|params| {
        let words = params.raw().split_whitespace();
        words
            .map(|word| word.split([':', '=']).next().unwrap_or(""))
            .any(|word| word.trim_start_matches('*') == name)
    })
}

fn kind(kind: GlobalKind) -> TokenKind {
    match kind {
        GlobalKind::Constant => TokenKind::Variable,
        GlobalKind::Function | GlobalKind::Type => TokenKind::Function,
        GlobalKind::Namespace => TokenKind::Namespace,
    }
}

fn globals() -> FastMap<&'static str, (TokenKind, Modifiers)> {
    let mut found = FastMap::default();
    for symbol in global_symbols().filter(|symbol| symbol.namespace.is_none()) {
        let old = if symbol.deprecated.is_some() {
            Modifiers::DEPRECATED
        } else {
            Modifiers::default()
        };
        found.insert(
            symbol.name,
            (kind(symbol.kind), Modifiers::DEFAULT_LIBRARY.and(old)),
        );
    }
    found
}
