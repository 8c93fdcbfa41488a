//! Acceptance against a second parser: where the two disagree, a reason must be known.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

use std::collections::BTreeMap;

use xacro_lsp::xml::{Document, SyntaxError, SyntaxErrorKind};

const SEEDS: &[&str] = &[
    "<?xml version=\"1.0\"?>\n<!-- c --><robot name=\"r\" xmlns:xacro=\"u\">\n  <xacro:property name='p' value=\"${1}\"/>\
     &amp;<![CDATA[ r ]]><?pi d?>\n  <b></b>\n</robot>\n",
    "<a xmlns:x=\"u\" xmlns:y=\"u\"><b x:p=\"1\" y:q=\"2\"/><x:c y:d=\"\" xmlns:z=\"v\"><z:e z:f=\"1\" x:f=\"2\"/></x:c></a>",
    "<é ü:ö=\"1\" xmlns:ü=\"u\">ü\r\n\t\u{FFFD} 😀]] &gt; <![CDATA[ <x> & ]]]]><![CDATA[>]]>t</é>",
    "<!DOCTYPE a [<!ENTITY e \"v&#65;\"><!-- c --><!ELEMENT a ANY>]><a b=\"&e;\">&e;</a><!-- t -->",
];

const PIECES: &[&str] = &[
    "<",
    ">",
    "/",
    "\"",
    "'",
    "=",
    "&",
    ";",
    "-->",
    "<!--",
    "--",
    "<![CDATA[",
    "]]>",
    "</",
    "/>",
    "<?",
    "?>",
    " ",
    "\n",
    "\r",
    "x",
    "a:",
    ":",
    "1",
    "é",
    "·",
    "😀",
    "\u{0}",
    "\u{FFFF}",
    "&amp;",
    "&#x41;",
    "&#0;",
    "&e;",
    "&zz;",
    "<b>",
    "</b>",
    "<a/>",
    "</a>",
    "<robot>",
    " name=\"x\"",
    " xmlns:q=\"u\"",
    " xmlns:q=\"\"",
    "<q:r/>",
    "<?xml version=\"1.0\"?>",
    "<!DOCTYPE a>",
    "text",
];

/// A small generator of numbers, the same on every run.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % n
    }
}

fn mutate(numbers: &mut Numbers) -> String {
    let mut text = SEEDS[numbers.below(SEEDS.len())].to_owned();
    for _ in 0..=numbers.below(3) {
        let floor = |text: &str, mut at: usize| {
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        let start = numbers.below(text.len() + 1);
        let start = floor(&text, start);
        let end = floor(&text, (start + numbers.below(4)).min(text.len())).max(start);
        let piece = if numbers.below(4) == 0 {
            ""
        } else {
            PIECES[numbers.below(PIECES.len())]
        };
        text.replace_range(start..end, piece);
    }
    text
}

/// Why roxmltree accepts a text that expat, and so our parser, rejects.
fn reason(text: &str, ours: &SyntaxError) -> Option<&'static str> {
    Some(match ours.kind {
        SyntaxErrorKind::BadDeclaration => "roxmltree does not check the XML declaration",
        SyntaxErrorKind::BadDoctype => "roxmltree reads no declarations but those of entities",
        SyntaxErrorKind::BadNamespace => "roxmltree lets a prefix mean no namespace",
        SyntaxErrorKind::BadName => "roxmltree allows colons in front of names and in instructions",
        SyntaxErrorKind::BadEntity => {
            "roxmltree lets an entity with elements stand in an attribute"
        }
        _ if text.contains(['😀', '×']) => "roxmltree follows the fifth edition in names",
        _ if text.contains("<!ELEMENT") => "roxmltree reads no declarations but those of entities",
        _ => return None,
    })
}

#[test]
fn acceptance_equals_roxmltree_but_for_known_reasons() {
    let mut numbers = Numbers(7);
    let mut reasons: BTreeMap<&str, usize> = BTreeMap::new();
    let mut unknown = Vec::new();
    let mut accepted = 0;
    for _ in 0..20_000 {
        let text = mutate(&mut numbers);
        let errors = Document::parse(&text).errors();
        let options = roxmltree::ParsingOptions {
            allow_dtd: true,
            ..Default::default()
        };
        let theirs = roxmltree::Document::parse_with_options(&text, options).err();
        let difference = match (errors.first(), theirs) {
            (None, None) | (Some(_), Some(_)) => None,
            (None, Some(theirs)) => Some(Err(format!(
                "{text:?}: only roxmltree rejects it: {theirs}"
            ))),
            (Some(ours), None) => Some(
                reason(&text, ours)
                    .ok_or_else(|| format!("{text:?}: only we reject it: {}", ours.message)),
            ),
        };
        accepted += usize::from(errors.is_empty());
        match difference {
            Some(Ok(reason)) => *reasons.entry(reason).or_default() += 1,
            Some(Err(text)) => unknown.push(text),
            None => {}
        }
    }
    for (reason, count) in &reasons {
        println!("{count:6} {reason}");
    }
    assert!(
        accepted > 1000,
        "only {accepted} documents were well-formed"
    );
    assert!(
        unknown.is_empty(),
        "{} without a reason\n{}",
        unknown.len(),
        unknown[..unknown.len().min(20)].join("\n")
    );
}
