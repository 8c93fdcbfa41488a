//! Which comment hides a finding, without a look at every comment for every finding.
use std::collections::BTreeMap;

use super::super::registry::all;
use super::super::rule::Rule;
use super::directive::{Directive, Selector, Suppression};
use base::{FastMap, TextRange};

/// The suppressions of a file, by the words they name rules with.
#[derive(Clone, Debug, Default)]
pub(super) struct SuppressionIndex {
    words: BTreeMap<String, OfWord>,
    /// For each word of an `enable`: the end of the first `disable` of a rule that both mean.
    begins: FastMap<String, Option<u32>>,
}

/// The suppressions that name a word, by their numbers.
#[derive(Clone, Debug, Default)]
struct OfWord {
    /// Those of single elements, by the text they hold for; texts of two elements share nothing.
    elements: Vec<(TextRange, usize)>,
    /// `disable` and `enable` with their ends, in order.
    switches: Vec<(u32, usize, Directive)>,
    /// The last one that holds for the whole file.
    file: Option<usize>,
}

impl SuppressionIndex {
    /// That of suppressions in the order of the text.
    pub fn of(list: &[Suppression]) -> Self {
        let mut found = Self::default();
        for (number, suppression) in list.iter().enumerate() {
            for selector in &suppression.rules {
                let words = &mut found.words;
                if !words.contains_key(&selector.text) {
                    words.insert(selector.text.clone(), OfWord::default());
                }
                if let Some(word) = words.get_mut(&selector.text) {
                    word.add(number, suppression);
                }
            }
        }
        for word in found.words.values_mut() {
            word.elements
                .sort_by_key(|(range, number)| (range.start, *number));
        }
        let enables = list
            .iter()
            .filter(|suppression| suppression.directive == Directive::Enable);
        for selector in enables.flat_map(|suppression| &suppression.rules) {
            if !found.begins.contains_key(&selector.text) {
                let begin = found.first_disable(selector);
                found.begins.insert(selector.text.clone(), begin);
            }
        }
        found
    }

    /// The end of the first `disable` that names a rule which `selector` names too, or the same word.
    fn first_disable(&self, selector: &Selector) -> Option<u32> {
        let rules = all().filter(|rule| selector.names(rule));
        let words = rules
            .flat_map(Rule::selectors)
            .filter_map(|word| self.words.get(word));
        words
            .chain(self.words.get(&selector.text))
            .filter_map(OfWord::first_disable)
            .min()
    }

    /// Where the first `disable` ends that an `enable` of this word could end.
    pub fn begins(&self, word: &str) -> Option<u32> {
        self.begins.get(word).copied().flatten()
    }

    /// The number of the suppression that hides a finding of `rule` at `offset`, the nearest one first.
    pub fn hiding(&self, rule: &Rule, offset: u32) -> Option<usize> {
        // what is disabled was disabled last
        let switch = self
            .words_of(rule)
            .filter_map(|word| word.last_switch(offset))
            .max_by_key(|(number, _)| *number);
        let disabled = switch
            .filter(|(_, directive)| *directive == Directive::Disable)
            .map(|(number, _)| number);
        let others = self
            .words_of(rule)
            .filter_map(|word| word.element(offset).max(word.file));
        others.chain(disabled).max()
    }

    /// Those that name a rule.
    fn words_of<'a>(&'a self, rule: &'a Rule) -> impl Iterator<Item = &'a OfWord> {
        rule.selectors().filter_map(|word| self.words.get(word))
    }
}

impl OfWord {
    fn add(&mut self, number: usize, suppression: &Suppression) {
        match suppression.directive {
            Directive::DisableNextLine => self.elements.push((suppression.scope, number)),
            Directive::DisableFile => self.file = Some(number),
            switch => self
                .switches
                .push((suppression.comment.end, number, switch)),
        }
    }

    fn first_disable(&self) -> Option<u32> {
        let mut disables = self
            .switches
            .iter()
            .filter(|(_, _, switch)| *switch == Directive::Disable);
        disables.next().map(|(end, ..)| *end)
    }

    /// The last one in front of `offset`.
    fn last_switch(&self, offset: u32) -> Option<(usize, Directive)> {
        let count = self.switches.partition_point(|(end, ..)| *end <= offset);
        let (_, number, switch) = self.switches.get(count.checked_sub(1)?)?;
        Some((*number, *switch))
    }

    /// The last one of the element around `offset`.
    fn element(&self, offset: u32) -> Option<usize> {
        let count = self
            .elements
            .partition_point(|(range, _)| range.start <= offset);
        let (range, number) = self.elements.get(count.checked_sub(1)?)?;
        (offset < range.end).then_some(*number)
    }
}
