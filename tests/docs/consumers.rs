//! The page of the consumers shows the table.

use xacro_lsp::rules::consumers::{CONSTRUCTS, CONSUMERS, Outcome};

use crate::pages::{self, Page};
use crate::summary::with_part;

const PAGE: &str = "docs/consumers.md";

/// The consumers, and what they were measured with.
fn programs() -> String {
    let mut text = String::from("\n| name | other names | measured with |\n|---|---|---|\n");
    for consumer in CONSUMERS {
        let aliases: Vec<String> = consumer
            .aliases
            .iter()
            .map(|alias| format!("`{alias}`"))
            .collect();
        text.push_str(&format!(
            "| `{}` | {} | {} |\n",
            consumer.name,
            aliases.join(", "),
            consumer.measured
        ));
    }
    text + "\n"
}

/// What each construct is to whom; constructs that all accept are left out.
fn table() -> String {
    let mut text =
        String::from("\n| construct | rejected by | changed or ignored by |\n|---|---|---|\n");
    for construct in CONSTRUCTS.iter() {
        let who = |outcome: Outcome| {
            let who = CONSUMERS
                .iter()
                .filter(|consumer| construct.outcome(consumer) == outcome);
            who.map(|consumer| consumer.title)
                .collect::<Vec<_>>()
                .join(", ")
        };
        let (rejects, changes) = (who(Outcome::Rejects), who(Outcome::Changes));
        if !rejects.is_empty() || !changes.is_empty() {
            text.push_str(&format!(
                "| {} | {rejects} | {changes} |\n",
                construct.title
            ));
        }
    }
    text + "\n"
}

#[test]
fn the_page_shows_the_table() {
    let page = Page::read(PAGE);
    let text = with_part(&page, "programs", &programs());
    let text = with_part(
        &Page {
            path: page.path,
            text,
        },
        "constructs",
        &table(),
    );
    pages::up_to_date(PAGE, &text);
}
