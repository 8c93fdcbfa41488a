//! What the table of keys has for a place in a configuration file.

use super::Config;
use super::keys::{Key, Type};
use super::place::{ConfigPlace, PlaceKind};
use super::settings::Table;

/// What may stand at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// One of these keys, each with what it says.
    Keys(Vec<(&'static str, &'static str)>),
    /// One of these strings.
    Words(&'static [&'static str]),
    /// True or false.
    Bool,
    /// A name, path or number.
    Free,
}

/// What may stand at a place; `None` where nothing may.
pub fn wanted(place: &ConfigPlace) -> Option<Wanted> {
    let of = type_at(&place.path)?;
    match place.kind {
        PlaceKind::Key | PlaceKind::Header { .. } => {
            let keys = match of {
                Type::Keys(keys) | Type::Tables(keys) => keys,
                Type::Map(_) => return Some(Wanted::Free),
                Type::List(Type::Map(_)) => return Some(Wanted::Free),
                _ => return None,
            };
            let is_header = |key: &&Key| match place.kind {
                PlaceKind::Header { is_list } => has_header(key.of, is_list),
                _ => true,
            };
            Some(Wanted::Keys(
                keys.iter()
                    .filter(is_header)
                    .map(|key| (key.name, key.doc))
                    .collect(),
            ))
        }
        PlaceKind::Value { in_list } => match (of, in_list) {
            (Type::Choice(words), false) | (Type::Choices(words), true) => {
                Some(Wanted::Words(words))
            }
            (Type::Bool, false) => Some(Wanted::Bool),
            (Type::Text | Type::Argument | Type::Arguments, false) => Some(Wanted::Free),
            (Type::Texts | Type::Arguments | Type::List(Type::Texts), true) => Some(Wanted::Free),
            _ => None,
        },
    }
}

/// What the table of keys says of the key at a place.
pub fn doc(path: &[String]) -> Option<&'static str> {
    let (name, above) = path.split_last()?;
    let keys = match type_at(above)? {
        Type::Keys(keys) | Type::Tables(keys) => keys,
        _ => return None,
    };
    Some(keys.iter().find(|key| key.name == name)?.doc)
}

/// Whether a key has a table with this kind of header.
fn has_header(of: Type, is_list: bool) -> bool {
    match of {
        // the header of a list of tables leads on to the tables in these
        Type::Tables(_) => true,
        Type::Keys(_) | Type::Map(_) => !is_list,
        Type::List(of) => is_list && matches!(of, Type::Map(_)),
        _ => false,
    }
}

/// The type of what keys lead to.
fn type_at(path: &[String]) -> Option<Type> {
    path.iter()
        .try_fold(Type::Keys(Config::KEYS), |of, name| match of {
            Type::Keys(keys) | Type::Tables(keys) => {
                Some(keys.iter().find(|key| key.name == name)?.of)
            }
            Type::Map(of) => Some(*of),
            Type::List(Type::Map(of)) => Some(**of),
            _ => None,
        })
}
