//! The book: its table of contents names every page, and every rule in the order of the rules.

use std::collections::BTreeSet;

use xacro_lsp::rules::{self, Category};

use crate::links;
use crate::pages::{self, Page};

const SUMMARY: &str = "docs/SUMMARY.md";
const QUESTIONS: &str = "docs/faq/README.md";

/// A page with what stands between the comments of `name` made again.
pub fn with_part(page: &Page, name: &str, part: &str) -> String {
    let begin = page
        .text
        .find(&format!("<!-- {name}: "))
        .expect("the comment in front");
    let begin = begin + page.text[begin..].find('\n').unwrap() + 1;
    let end = page
        .text
        .find(&format!("<!-- end of {name} -->"))
        .expect("the comment behind");
    format!("{}{part}{}", &page.text[..begin], &page.text[end..])
}

/// One line for each rule, below its category.
fn lines_of_rules() -> String {
    let mut text = String::from("\n- [All rules](rules/README.md)\n");
    for category in Category::ALL {
        let mut rules = rules::all()
            .filter(|rule| rule.category == category)
            .peekable();
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
    let page = Page::read(SUMMARY);
    pages::up_to_date(SUMMARY, &with_part(&page, "rules", &lines_of_rules()));
}

/// The questions of the pages, in the order of the book.
fn questions(summary: &Page) -> String {
    let mut text = String::from("\n");
    let names = summary
        .text
        .split("](faq/")
        .skip(2)
        .filter_map(|rest| rest.split(')').next());
    for name in names {
        let page = Page::read(&format!("docs/faq/{name}"));
        let title = page.text.lines().next().unwrap().trim_start_matches("# ");
        text.push_str(&format!("## {title}\n\n"));
        for question in page
            .text
            .lines()
            .filter_map(|line| line.strip_prefix("## "))
        {
            text.push_str(&format!(
                "* [{question}]({name}#{})\n",
                links::anchor(question)
            ));
        }
        text.push('\n');
    }
    text
}

#[test]
fn the_list_of_questions_is_whole() {
    let new = with_part(
        &Page::read(QUESTIONS),
        "questions",
        &questions(&Page::read(SUMMARY)),
    );
    pages::up_to_date(QUESTIONS, &new);
}

/// A page that the table of contents does not name is not in the book, and links to it would be broken there.
#[test]
fn the_book_has_every_page() {
    // with the rules that are not written into it yet
    let summary = with_part(&Page::read(SUMMARY), "rules", &lines_of_rules());
    let named: Vec<&str> = summary
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next())
        .collect();
    let named: Vec<&str> = named.into_iter().filter(|path| !path.is_empty()).collect();
    let once: BTreeSet<&str> = named.iter().copied().collect();
    assert_eq!(once.len(), named.len(), "a page is named twice");
    for page in pages::all() {
        let Some(path) = page
            .path
            .strip_prefix("docs/")
            .filter(|path| *path != "SUMMARY.md")
        else {
            continue;
        };
        assert!(
            once.contains(path),
            "docs/{path} is not in {SUMMARY}: add a line"
        );
    }
}

#[test]
fn the_readme_counts_the_rules() {
    let text = Page::read("README.md").text;
    let end = text.find(" rules](").expect("the number of rules");
    let start = text[..end].rfind('[').expect("a link") + 1;
    let counted = format!("{}{}{}", &text[..start], rules::all().count(), &text[end..]);
    pages::up_to_date("README.md", &counted);
}
