//! What the table of keys has for a place in a configuration file.

use super::Config;
use super::cursor::{ConfigCursor, ConfigCursorKind};
use super::keys::{ConfigKey, KeyType};
use super::settings::ConfigTable;

/// What may stand at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ExpectedValue {
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
pub fn wanted(place: &ConfigCursor) -> Option<ExpectedValue> {
    let of = type_at(&place.path)?;
    match place.kind {
        ConfigCursorKind::Key | ConfigCursorKind::Header { .. } => {
            let keys = match of {
                KeyType::Keys(keys) | KeyType::Tables(keys) => keys,
                KeyType::Map(_) => return Some(ExpectedValue::Free),
                KeyType::List(KeyType::Map(_)) => return Some(ExpectedValue::Free),
                _ => return None,
            };
            let is_header = |key: &&ConfigKey| match place.kind {
                ConfigCursorKind::Header { is_list } => has_header(key.of, is_list),
                _ => true,
            };
            Some(ExpectedValue::Keys(
                keys.iter()
                    .filter(is_header)
                    .map(|key| (key.name, key.doc))
                    .collect(),
            ))
        }
        ConfigCursorKind::Value { in_list } => match (of, in_list) {
            (KeyType::Choice(words), false) | (KeyType::Choices(words), true) => {
                Some(ExpectedValue::Words(words))
            }
            (KeyType::Bool, false) => Some(ExpectedValue::Bool),
            (KeyType::Text | KeyType::Argument | KeyType::Arguments, false) => {
                Some(ExpectedValue::Free)
            }
            (KeyType::Texts | KeyType::Arguments | KeyType::List(KeyType::Texts), true) => {
                Some(ExpectedValue::Free)
            }
            _ => None,
        },
    }
}

/// What the table of keys says of the key at a place.
pub fn doc(path: &[String]) -> Option<&'static str> {
    let (name, above) = path.split_last()?;
    let keys = match type_at(above)? {
        KeyType::Keys(keys) | KeyType::Tables(keys) => keys,
        _ => return None,
    };
    Some(keys.iter().find(|key| key.name == name)?.doc)
}

/// Whether a key has a table with this kind of header.
fn has_header(of: KeyType, is_list: bool) -> bool {
    match of {
        // the header of a list of tables leads on to the tables in these
        KeyType::Tables(_) => true,
        KeyType::Keys(_) | KeyType::Map(_) => !is_list,
        KeyType::List(of) => is_list && matches!(of, KeyType::Map(_)),
        _ => false,
    }
}

/// The type of what keys lead to.
fn type_at(path: &[String]) -> Option<KeyType> {
    path.iter()
        .try_fold(KeyType::Keys(Config::KEYS), |of, name| match of {
            KeyType::Keys(keys) | KeyType::Tables(keys) => {
                Some(keys.iter().find(|key| key.name == name)?.of)
            }
            KeyType::Map(of) => Some(*of),
            KeyType::List(KeyType::Map(of)) => Some(**of),
            _ => None,
        })
}
