//! An expression that is a plain literal.
use super::super::context::FileCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use expr::{TemplateToken, split};
use model::decimal;

pub(super) static RULE: Rule = Rule {
    code: "STY002",
    name: "redundant-expression",
    category: Category::Style,
    severity: Severity::Hint,
    default: Activation::Profiles(&["pedantic"]),
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("redundant-expression"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    for (base, node) in cx.elements() {
        for attr in node.attrs().filter(|attr| attr.has_dollar()) {
            let text = attr.raw();
            let start = attr.value_range().start + base;
            for token in split(text).tokens {
                let TemplateToken::Expr { range, inner, .. } = token else {
                    continue;
                };
                let literal = inner.slice(text).trim();
                if is_printed_as_written(literal) {
                    out.report_in(
                        cx.file,
                        range.shift(start),
                        format!("unnecessary expression for `{literal}`"),
                    )
                    .help(format!("write `{literal}`"))
                    .replace_with(Safety::Safe, format!("replace with `{literal}`"), literal)
                    .done();
                }
            }
        }
    }
}

/// Whether Python prints a number just as it stands here: `1.50` and `1e-3` it does not.
fn is_printed_as_written(literal: &str) -> bool {
    let digits = literal.strip_prefix('-').unwrap_or(literal);
    let whole = digits.split('.').next().unwrap_or_default();
    let plain = digits.len() < 12 && digits.chars().all(|c| c.is_ascii_digit() || c == '.');
    let whole_is_plain = whole == "0" || !whole.is_empty() && !whole.starts_with('0');
    let fraction = digits.split_once('.').map(|(_, fraction)| fraction);
    let fraction_is_plain =
        fraction.is_none_or(|text| text == "0" || !text.is_empty() && !text.ends_with('0'));
    let tiny = fraction.is_some_and(|text| whole == "0" && text.starts_with("0000"));
    plain
        && whole_is_plain
        && fraction_is_plain
        && !tiny
        && literal != "-0"
        && decimal(literal).is_some()
}

#[cfg(test)]
mod tests {
    use super::is_printed_as_written;

    #[test]
    fn numbers_that_python_prints_as_they_stand() {
        for text in ["0", "12", "-3", "0.5", "10.0", "-0.25"] {
            assert!(is_printed_as_written(text), "{text}");
        }
        for text in [
            "", "00", "1.50", "1e3", ".5", "5.", "x", "0.00001", "-0", "1_0", "1.2.3",
        ] {
            assert!(!is_printed_as_written(text), "{text}");
        }
    }
}
