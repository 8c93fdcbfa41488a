//! The pages that the programs show themselves: those of the rules.

include!(concat!(env!("OUT_DIR"), "/rules.rs"));

/// The page of a rule, in Markdown. A name without a page ends the build where it is called for a constant.
#[allow(clippy::panic, clippy::indexing_slicing, reason = "both end the build")]
pub const fn rule(name: &str) -> &'static str {
    let mut at = 0;
    while at < RULES.len() {
        if is_same(RULES[at].0.as_bytes(), name.as_bytes()) {
            return RULES[at].1;
        }
        at += 1;
    }
    panic!("docs/rules has no page of this name")
}

/// `==`, which constants do not have.
#[allow(clippy::indexing_slicing, reason = "at is below both lengths")]
const fn is_same(a: &[u8], b: &[u8]) -> bool {
    let mut at = 0;
    while at < a.len() && at < b.len() && a[at] == b[at] {
        at += 1;
    }
    at == a.len() && at == b.len()
}
