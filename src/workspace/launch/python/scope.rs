//! The variables of a program while it is read.

use base::FastMap;
use ecow::EcoString;

use super::value::PythonValue;

/// Variables by name.
pub(super) type Variables = FastMap<EcoString, PythonValue>;

/// The variables of the file and of the functions that are being read, innermost last.
#[derive(Default)]
pub(super) struct VariableScopes {
    frames: Vec<FunctionScope>,
    /// Names that may mean the same list or dictionary.
    aliases: FastMap<EcoString, Vec<EcoString>>,
}

/// The variables of a function.
#[derive(Default)]
struct FunctionScope {
    variables: Variables,
    /// How many frames around this one are visible: those that the function is written in.
    outer: usize,
}

impl VariableScopes {
    /// Begin a function that is written inside of the frame `outer`; the file itself is frame 0.
    pub fn enter(&mut self, variables: Variables, outer: usize) {
        self.frames.push(FunctionScope { variables, outer });
    }

    /// Leave the innermost function.
    pub fn leave(&mut self) {
        self.frames.pop();
    }

    /// The number of the innermost frame.
    pub fn depth(&self) -> usize {
        self.frames.len().saturating_sub(1)
    }

    /// The value of a name; none where nothing defines it.
    pub fn get(&self, name: &str) -> Option<&PythonValue> {
        let mut at = self.depth();
        loop {
            let frame = self.frames.get(at)?;
            if let Some(value) = frame.variables.get(name) {
                return Some(value);
            }
            if at == 0 {
                return None;
            }
            at = frame.outer.min(at - 1);
        }
    }

    /// Set a variable of the innermost function.
    pub fn set(&mut self, name: &str, value: PythonValue) {
        if let Some(frame) = self.frames.last_mut() {
            frame.variables.insert(name.into(), value);
        }
    }

    /// What a function may have changed elsewhere is not known, in any frame.
    pub fn forget(&mut self, name: &str) {
        for frame in &mut self.frames {
            frame.variables.insert(name.into(), PythonValue::Unknown);
        }
    }

    /// Whether the innermost function has a variable of this name.
    pub fn has_own(&self, name: &str) -> bool {
        self.frames
            .last()
            .is_some_and(|frame| frame.variables.contains_key(name))
    }

    /// A list or dictionary that was changed under one name may have others: those are not known.
    pub fn forget_aliases(&mut self, name: &str) {
        let aliases = self.aliases.get(name).cloned().unwrap_or_default();
        aliases
            .iter()
            .filter(|other| other.as_str() != name)
            .for_each(|other| self.forget(other));
    }

    /// Keep in mind that two names mean one value.
    pub fn alias(&mut self, one: &str, other: &str) {
        for (name, alias) in [(one, other), (other, one)] {
            let known = self.aliases.entry(name.into()).or_default();
            if known.len() < 100 && !known.iter().any(|known| known == alias) {
                known.push(alias.into());
            }
        }
    }

    /// The variables of the innermost function.
    pub fn own(&self) -> Variables {
        self.frames
            .last()
            .map(|frame| frame.variables.clone())
            .unwrap_or_default()
    }

    /// The variables of the innermost function, for a change; what a frame holds is given back with it.
    pub fn replace(&mut self, variables: Variables) -> Variables {
        let own = self
            .frames
            .last_mut()
            .map(|frame| std::mem::replace(&mut frame.variables, variables));
        own.unwrap_or_default()
    }
}

/// The variables behind a branch: what both sides agree on.
pub(super) fn joined(mut one: Variables, other: Variables) -> Variables {
    let mut both = Variables::default();
    let mut names: Vec<EcoString> = other.keys().cloned().collect();
    names.extend(
        one.keys()
            .filter(|name| !other.contains_key(*name))
            .cloned(),
    );
    let mut other = other;
    for name in names {
        let value = match (one.remove(&name), other.remove(&name)) {
            (Some(a), Some(b)) => a.join(b),
            // set on one side only: where it can be read, it was set there
            (Some(only), None) | (None, Some(only)) => only,
            (None, None) => PythonValue::Unknown,
        };
        both.insert(name, value);
    }
    both
}
