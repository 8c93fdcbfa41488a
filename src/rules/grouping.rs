//! Which findings of a rule are one defect.

use ecow::EcoString;

use super::registry::{Rule, Severity};

/// What several findings of one rule and severity share when they are one defect.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Group {
    /// Nothing: each place needs a repair of its own.
    Place,
    /// The text that is reported, in one file: a misspelled name that is used again and again.
    Text,
    /// The file: a habit of its author, or of the program that wrote it.
    File,
    /// A name, in one file.
    Name(EcoString),
    /// A value, in any file: a tensor that was copied, a package that is not declared.
    Value(EcoString),
    /// Something outside of the descriptions that has the defect itself, such as a mesh.
    Thing(EcoString),
}

impl Group {
    /// How many places make a group. Of two, both are shown, unless what is wrong is neither of them.
    pub fn least(&self) -> usize {
        if matches!(self, Group::Thing(_)) {
            2
        } else {
            3
        }
    }
}

/// Rules about structure and syntax: two findings are two defects, even where the text is the same.
const EACH_PLACE: [&str; 27] = [
    "duplicate-geometry-name",
    "duplicate-joint-name",
    "duplicate-link-name",
    "duplicate-material",
    "empty-name",
    "include-cycle",
    "infinite-macro-recursion",
    "invalid-config",
    "invalid-expression",
    "joint-self-loop",
    "link-cycle",
    "macro-block-mismatch",
    "malformed-suppression",
    "mimic-cycle",
    "missing-macro-param",
    "missing-xacro-attribute",
    "multiple-parents",
    "multiple-roots",
    "names-differ-by-case",
    "no-links",
    "orphan-link",
    "property-cycle",
    "ros2-control-duplicate-name",
    "unclosed-expression",
    "undefined-link",
    "unused-suppression",
    "xml-syntax-error",
];

/// Rules below errors that are about names or texts: what is written alike is repaired alike.
const BY_TEXT: [&str; 16] = [
    "duplicate-element",
    "duplicate-include",
    "glob-include-no-match",
    "invalid-name",
    "macro-name-with-prefix",
    "redefined-macro",
    "redefined-property",
    "shadowed-builtin",
    "unexpected-text",
    "unknown-rule-in-suppression",
    "unknown-xacro-attribute",
    "unused-arg",
    "unused-include",
    "unused-macro",
    "unused-macro-param",
    "unused-property",
];

/// Rules whose errors are about values: the program that wrote one of them wrote all of them.
const BY_FILE: [&str; 3] = [
    "inertia-not-positive-definite",
    "joint-limit-negative",
    "non-positive-dimension",
];

impl Rule {
    /// What findings share that do not say it themselves. Errors are one defect only where the same text is
    /// wrong; conventions and doubtful values are one for each file.
    pub fn group(&self) -> Group {
        if EACH_PLACE.contains(&self.name) {
            Group::Place
        } else if BY_FILE.contains(&self.name) {
            Group::File
        } else if BY_TEXT.contains(&self.name) || self.severity == Severity::Error {
            Group::Text
        } else {
            Group::File
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::registry::all;
    use super::{BY_FILE, BY_TEXT, EACH_PLACE};

    #[test]
    fn the_lists_name_rules_and_each_once() {
        let mut names: Vec<&str> = [&EACH_PLACE[..], &BY_TEXT, &BY_FILE].concat();
        for name in &names {
            assert!(all().any(|rule| rule.name == *name), "{name} is no rule");
        }
        names.sort_unstable();
        assert!(names.windows(2).all(|pair| pair[0] != pair[1]), "{names:?}");
    }
}
