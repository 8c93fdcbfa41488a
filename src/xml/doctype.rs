//! A document type declaration, as minidom prints it.

use super::chars::is_space;

/// A document type declaration in the reference's own layout; `raw` is well-formed. The internal subset is kept as
/// it is written, or left out.
pub fn printed_doctype(raw: &str, with_subset: bool) -> String {
    let mut rest = raw.strip_prefix("<!DOCTYPE").unwrap_or(raw);
    let name = word(&mut rest);
    let local_name = name.split_once(':').map_or(name, |(_, local)| local);
    let mut out = format!("<!DOCTYPE {local_name}");
    let public = if word(&mut rest) == "PUBLIC" {
        literal(&mut rest)
    } else {
        ""
    };
    let public: Vec<&str> = public
        .split([' ', '\n', '\r'])
        .filter(|word| !word.is_empty())
        .collect();
    let system = literal(&mut rest);
    if !public.is_empty() {
        out += &format!("\n  PUBLIC '{}'\n  '{system}'", public.join(" "));
    } else if !system.is_empty() {
        out += &format!("\n  SYSTEM '{system}'");
    }
    if let Some((subset, _)) = skip_space(rest)
        .strip_prefix('[')
        .and_then(|inner| inner.rsplit_once(']'))
        && with_subset
    {
        out += &format!(" [{subset}]");
    }
    out.push('>');
    out
}

fn skip_space(text: &str) -> &str {
    text.trim_start_matches(|c: char| c.is_ascii() && is_space(c as u8))
}

/// Take the word that comes next; empty in front of a quote, a bracket or the end.
fn word<'t>(rest: &mut &'t str) -> &'t str {
    *rest = skip_space(rest);
    let ends = |c: char| (c.is_ascii() && is_space(c as u8)) || "\"'[>".contains(c);
    let (found, behind) = rest.split_at(rest.find(ends).unwrap_or(rest.len()));
    *rest = behind;
    found
}

/// Take the text in quotes that comes next; empty when there is none.
fn literal<'t>(rest: &mut &'t str) -> &'t str {
    *rest = skip_space(rest);
    let Some(quote) = rest.chars().next().filter(|c| matches!(c, '"' | '\'')) else {
        return "";
    };
    let Some((found, behind)) = rest.get(1..).and_then(|inner| inner.split_once(quote)) else {
        return "";
    };
    *rest = behind;
    found
}

#[cfg(test)]
mod tests {
    use super::printed_doctype;

    #[test]
    fn layout_is_that_of_minidom() {
        for (raw, printed) in [
            ("<!DOCTYPE   robot  >", "<!DOCTYPE robot>"),
            ("<!DOCTYPE q:robot>", "<!DOCTYPE robot>"),
            (
                "<!DOCTYPE robot SYSTEM \"a.dtd\">",
                "<!DOCTYPE robot\n  SYSTEM 'a.dtd'>",
            ),
            ("<!DOCTYPE robot SYSTEM \"\">", "<!DOCTYPE robot>"),
            (
                "<!DOCTYPE robot PUBLIC ' p  \nq ' 's'>",
                "<!DOCTYPE robot\n  PUBLIC 'p q'\n  's'>",
            ),
            (
                "<!DOCTYPE robot PUBLIC '' 's' []>",
                "<!DOCTYPE robot\n  SYSTEM 's' []>",
            ),
            (
                "<!DOCTYPE robot[ <!ENTITY a \"]\"> ] >",
                "<!DOCTYPE robot [ <!ENTITY a \"]\"> ]>",
            ),
        ] {
            assert_eq!(printed_doctype(raw, true), printed, "{raw}");
        }
        assert_eq!(
            printed_doctype("<!DOCTYPE robot SYSTEM 'a' [x]>", false),
            "<!DOCTYPE robot\n  SYSTEM 'a'>"
        );
    }
}
