//! The book: its table of contents names every page, and every rule in the order of the rules.

use std::collections::BTreeSet;

use xacro_lsp::rules::{self, Category};

use crate::pages::{self, Page};

const SUMMARY: &str = "docs/SUMMARY.md";

/// One line for each rule, below its category.
fn lines_of_rules() -> String {
    let mut text = String::from("\n");
    for category in Category::ALL {
        let mut rules = rules::all().filter(|rule| rule.category == category).peekable();
        if rules.peek().is_none() {
            continue;
        }
        text.push_str(&format!("  - [{}]()\n", category.title()));
        rules.for_each(|rule| text.push_str(&format!("    - [{0}](rules/{0}.md)\n", rule.name)));
    }
    text.push('\n');
    text
}

#[test]
fn the_book_has_every_rule() {
    const END: &str = "<!-- end of rules -->";
    let page = Page::read(SUMMARY);
    let begin = page.text.find("<!-- rules: ").expect("the comment in front of the rules");
    let begin = begin + page.text[begin..].find('\n').unwrap() + 1;
    let end = page.text.find(END).expect("the comment behind the rules");
    let new = format!("{}{}{}", &page.text[..begin], lines_of_rules(), &page.text[end..]);
    pages::up_to_date(SUMMARY, &new);
}

/// A page that the table of contents does not name is not in the book, and links to it would be broken there.
#[test]
fn the_book_has_every_page() {
    let summary = Page::read(SUMMARY);
    let named: Vec<&str> = summary.text.split("](").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    let named: Vec<&str> = named.into_iter().filter(|path| !path.is_empty()).collect();
    let once: BTreeSet<&str> = named.iter().copied().collect();
    assert_eq!(once.len(), named.len(), "a page is named twice");
    for page in pages::all() {
        let Some(path) = page.path.strip_prefix("docs/").filter(|path| *path != "SUMMARY.md") else { continue };
        assert!(once.contains(path), "docs/{path} is not in {SUMMARY}: add a line");
    }
}
