//! Slips that show elsewhere. `7,0` and `7.0 kg` were meant to be numbers, `yes` to be `true`: they are found where they are
//! used, and reported where they are written. Parameters that are attributes are found at the calls.
use std::path::Path;

use ecow::EcoString;

use super::binding_info::{BindingId, BindingInfo, BindingKind};
use super::expander::Expander;
use super::kind::ProblemKind;
use super::macro_table::MacroParam;
use super::meant::MeantText;
use super::names::EvalContext;
use super::origin::Origin;
use super::problem::{Outside, Problem};
use super::scope::Scopes;
use super::tag::Tag;
use base::{FastSet, TextRange};
use expr::{EvalError, Value, is_identifier};

/// Bindings that are looked at.
const MOST: usize = 64;

/// Names of a list that are shown.
const MOST_SHOWN: usize = 20;

/// A number as it was meant, and what is wrong with it.
pub fn meant_number(text: &str) -> Option<(String, &'static str)> {
    let text = text.trim();
    if is_number(text) {
        return None;
    }
    let signed = text.replace(['\u{2212}', '\u{2013}'], "-");
    if is_number(&signed) {
        return Some((signed, "write an ASCII minus sign `-`"));
    }
    let pointed = text.replace(',', ".");
    if is_number(&pointed) && !text.contains('.') {
        return Some((pointed, "use a decimal point"));
    }
    let number = text
        .trim_end_matches(|c: char| c.is_alphabetic() || matches!(c, '/' | '^' | '²' | '³' | '°'));
    let unit = text.get(number.len()..).unwrap_or_default();
    let number = number.trim_end();
    (is_number(number) && !unit.is_empty() && unit.chars().count() <= 6)
        .then(|| (number.to_owned(), "remove the unit"))
}

/// Whether a text is a finite number in decimal digits.
fn is_number(text: &str) -> bool {
    text.bytes().any(|byte| byte.is_ascii_digit())
        && text
            .bytes()
            .all(|byte| byte.is_ascii_digit() || b".+-eE".contains(&byte))
        && text.parse::<f64>().is_ok_and(f64::is_finite)
}

/// Whether an expression in a text has this word.
fn is_read(text: &str, name: &str) -> bool {
    let mut codes = text
        .split("${")
        .skip(1)
        .filter_map(|rest| rest.split('}').next());
    codes.any(|code| {
        code.split(|c: char| !c.is_alphanumeric() && c != '_')
            .any(|word| word == name)
    })
}

impl Expander<'_> {
    /// The value behind an expression that cannot be evaluated, when it is a number with a slip: what was read for the
    /// expression follows the first `mark` reads.
    pub(super) fn number_slip(&self, error: &EvalError, mark: usize) -> Option<Problem> {
        let is_about_types = [
            "operand",
            "must be str",
            "real number",
            "could not convert",
            "bad operand",
        ]
        .iter()
        .any(|words| error.message.contains(words));
        if !is_about_types || !self.request.probe {
            return None;
        }
        let (name, at, text) = self.written_text(mark, |text| {
            meant_number(text).is_some() || self.is_property(text)
        })?;
        let (number, help) = meant_number(&text).unwrap_or_else(|| {
            (
                format!("${{{text}}}"),
                "put the name of the property in `${...}`",
            )
        });
        let message = format!("`{text}`, the value of `{name}`, is not a number");
        Some(
            self.problem(ProblemKind::ExpressionError, at, message)
                .help(format!("{help}: write `{number}`"))
                .replace_with(number),
        )
    }

    /// Whether a text is the name of a property of the robot, which was meant to be its value.
    fn is_property(&self, text: &str) -> bool {
        is_identifier(text) && self.names.scopes.find(Scopes::TOP, text).is_some()
    }

    /// A file that is missing since an argument names a folder that is not there: what there is instead.
    pub(super) fn folder_slip(&self, error: &EvalError) -> Option<Problem> {
        let path = Path::new(
            error
                .message
                .split('\'')
                .nth(1)
                .filter(|_| self.request.probe)?,
        );
        let missing = path
            .ancestors()
            .skip(1)
            .take_while(|folder| !self.sources.vfs.is_dir(folder))
            .last()?;
        let (name, around) = (missing.file_name()?.to_str()?, missing.parent()?);
        let is_it = |binding: &&BindingInfo| {
            binding.kind == BindingKind::Argument
                && matches!(&binding.value, Some(Value::Str(value)) if value.as_str() == name)
        };
        let argument = self.result.index.bindings.iter().find(is_it)?;
        let at = argument.origin?;
        let folders = self.sources.vfs.list_dir(around);
        let mut names: Vec<&str> = folders
            .iter()
            .filter(|entry| entry.is_dir)
            .map(|entry| entry.name.as_str())
            .collect();
        names.sort_unstable();
        let more = if names.len() > MOST_SHOWN {
            ", ..."
        } else {
            ""
        };
        let given = &argument.name;
        let list: Vec<String> = names
            .iter()
            .take(MOST_SHOWN)
            .map(|name| format!("`{name}`"))
            .collect();
        let message = format!(
            "no folder `{name}` in `{}` for argument `{given}`",
            vfs::slashed(around)
        );
        let help = format!("pass {given}:=... with one of {}{more}", list.join(", "));
        let problem = self
            .problem(ProblemKind::ExpressionError, at, message)
            .depends_on(Outside::File);
        (!list.is_empty()).then(|| problem.help(help))
    }

    /// A value that is written in another file than the condition that it is wrong in.
    pub(super) fn condition_slip(&self, shown: &str, at: Origin, mark: usize) -> Option<Problem> {
        let here = self.result.place(at)?.file;
        let (name, at, text) = self.written_text(mark, |text| text == shown)?;
        if !self.request.probe || self.result.place(at)?.file == here {
            return None;
        }
        let message =
            format!("`{text}`, the value of `{name}`, is used as a condition and is not a boolean");
        let mut problem = self
            .problem(ProblemKind::InvalidCondition, at, message)
            .help("write `true` or `false`");
        problem.outside = self.empty_argument(mark).map(Outside::Argument);
        Some(problem)
    }

    /// What to write for an include that leads nowhere, where one file of that name is near: relative to the file with the
    /// include, when it lies there or below, else through its package.
    pub(super) fn namesake_of(&self, missing: &Path, at: Origin) -> Option<MeantText> {
        let text = self.text_of(at);
        let is_plain = |text: &str| !text.contains(['$', '*', '?', '[', '{']);
        let is_written = is_plain(text) || text.strip_prefix("$(find ").is_some_and(is_plain);
        if !self.request.probe || !is_written {
            return None;
        }
        let from = self
            .result
            .files
            .get(self.result.place(at)?.file)?
            .source
            .path
            .clone();
        let found = self.sources.packages.namesake(missing, None, &from)?;
        let folder = from.parent()?;
        let text = match found.strip_prefix(folder) {
            Ok(below) if !text.starts_with('$') => below.to_str()?.to_owned(),
            _ => {
                let package = self.sources.packages.containing(&found)?;
                let inside = found.strip_prefix(&package.folder).ok()?.to_str()?;
                format!("$(find {})/{inside}", package.name)
            }
        };
        Some(MeantText::new(format!("write `{text}`")).with(text))
    }

    /// The parameters of a macro that has no `params`, and attributes that its body reads instead.
    pub(super) fn params_in_attributes(
        &mut self,
        tag: Tag<'_>,
        cx: EvalContext,
    ) -> Vec<MacroParam> {
        if !self.request.probe || tag.attr("params").is_some() {
            return Vec::new();
        }
        let body = self.text_of(Origin {
            src: tag.src,
            range: tag.node.range(),
            frame: cx.frame,
        });
        let others: Vec<_> = tag
            .attrs()
            .filter(|attr| !["name", "params"].contains(&attr.name()))
            .collect();
        if others.is_empty()
            || !others
                .iter()
                .all(|attr| is_identifier(attr.name()) && is_read(body, attr.name()))
        {
            return Vec::new();
        }
        let (Some(first), Some(last)) = (others.first(), others.last()) else {
            return Vec::new();
        };
        let names: Vec<EcoString> = others.iter().map(|attr| attr.name().into()).collect();
        let list = format!("params=\"{}\"", names.join(" "));
        let range = TextRange::new(first.range().start, last.range().end);
        let in_a_row = tag
            .attrs()
            .filter(|attr| range.contains_range(attr.range()))
            .count()
            == others.len();
        let at = Origin {
            src: tag.src,
            range: if in_a_row { range } else { first.range() },
            frame: cx.frame,
        };
        let what = if names.len() == 1 {
            "parameter"
        } else {
            "parameters"
        };
        let message = format!(
            "{what} `{}` of `xacro:macro` given as attributes",
            names.join("`, `")
        );
        let unknown = format!("{}: unknown attribute(s): {}", tag.name, names.join(", "));
        let problem = self
            .problem(ProblemKind::MissingXacroAttribute, at, message)
            .says(unknown)
            .help(format!("write {list}"));
        self.push(if in_a_row {
            problem.replace_with(list)
        } else {
            problem
        });
        names.into_iter().map(MacroParam::named).collect()
    }

    /// The name, the place and the text of a value that is written in the source and is of a kind.
    fn written_text(
        &self,
        mark: usize,
        is_it: impl Fn(&str) -> bool,
    ) -> Option<(String, Origin, String)> {
        let mut open: Vec<BindingId> = self.names.reads.get(mark..)?.to_vec();
        let mut seen = FastSet::default();
        while let Some(read) = open.pop().filter(|_| seen.len() < MOST) {
            let Some(binding) = self
                .result
                .index
                .bindings
                .get(read)
                .filter(|_| seen.insert(read))
            else {
                continue;
            };
            open.extend(self.result.index.read_in(binding.reads));
            let (Some(Value::Str(text)), Some(at)) = (&binding.value, binding.origin) else {
                continue;
            };
            if self.text_of(at) == text.as_str() && is_it(text) {
                return Some((binding.name.to_string(), at, text.to_string()));
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::meant_number;

    #[test]
    fn numbers_with_a_slip() {
        let meant = |text| {
            meant_number(text)
                .map(|(number, _)| number)
                .unwrap_or_default()
        };
        let cases = [
            ("7,0", "7.0"),
            ("7.0kg", "7.0"),
            ("0.5 m", "0.5"),
            ("\u{2212}1", "-1"),
            ("90°", "90"),
            ("1e-3", ""),
        ];
        for (text, expected) in cases {
            assert_eq!(meant(text), expected, "{text}");
        }
        assert_eq!(["left", "1,2,3", "link_1", "3.4.5", ""].map(meant), [""; 5]);
    }
}
