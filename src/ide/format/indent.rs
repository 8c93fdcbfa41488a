//! How far lines are indented.

use std::collections::BTreeMap;

use super::pieces::{PieceKind, pieces};
use base::TextRange;
use xml::Document;

/// One step of indentation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Indent {
    /// The characters of a step.
    pub unit: String,
    /// Columns of a tabulator.
    pub tab: usize,
}

impl Indent {
    /// Steps of blanks.
    pub fn blanks(count: usize) -> Self {
        let count = count.clamp(1, 16);
        Self {
            unit: " ".repeat(count),
            tab: count,
        }
    }

    /// Steps of one tabulator, shown as this many columns.
    pub fn tabs(columns: usize) -> Self {
        Self {
            unit: "\t".to_owned(),
            tab: columns.clamp(1, 16),
        }
    }

    /// White space this wide: as many tabulators as fit when steps are made of them.
    pub(super) fn blank(&self, columns: usize) -> String {
        match self.unit.as_str() {
            "\t" => "\t".repeat(columns / self.tab) + &" ".repeat(columns % self.tab),
            _ => " ".repeat(columns),
        }
    }
}

/// The columns that a text takes when it begins at `from`.
pub(super) fn width(text: &str, from: usize, tab: usize) -> usize {
    let end = text.chars().fold(from, |column, c| match c {
        '\t' => (column / tab + 1) * tab,
        _ => column + 1,
    });
    end - from
}

/// The step of indentation that a document uses, two blanks when nothing tells.
pub fn indentation(document: &Document) -> Indent {
    own_indentation(document).unwrap_or_else(|| Indent::blanks(2))
}

/// The step of indentation that a document uses: what most elements stand further right than the element around
/// them.
pub fn own_indentation(document: &Document) -> Option<Indent> {
    let text = document.text();
    let mut open: Vec<Option<&str>> = Vec::new();
    let mut steps: BTreeMap<&str, usize> = BTreeMap::new();
    for piece in pieces(document) {
        match piece.kind {
            PieceKind::Start(element) => {
                let own = margin(&text, piece.range);
                if let (Some(own), Some(Some(outer))) = (own, open.last())
                    && let Some(step) = own.strip_prefix(outer)
                    && is_step(step)
                {
                    *steps.entry(step).or_default() += 1;
                }
                if !element.is_self_closing() {
                    open.push(own);
                }
            }
            PieceKind::End { .. } => drop(open.pop()),
            _ => {}
        }
    }
    let most = steps
        .iter()
        .max_by_key(|(step, count)| (**count, **step == "  ", std::cmp::Reverse(step.len())));
    let (step, _) = most?;
    Some(if *step == "\t" {
        Indent::tabs(4)
    } else {
        Indent::blanks(step.len())
    })
}

fn is_step(step: &str) -> bool {
    step == "\t" || !step.is_empty() && step.len() <= 8 && step.bytes().all(|byte| byte == b' ')
}

/// The white space in front of what begins its line.
fn margin(text: &str, range: TextRange) -> Option<&str> {
    let before = text.get(..range.start as usize)?;
    // from the end: a line may be as long as the file
    let rest = before.trim_end_matches([' ', '\t']);
    let begins = rest.is_empty() || rest.ends_with('\n');
    begins.then(|| before.get(rest.len()..))?
}
