//! In builds for tests: what was taken over from the last expansion is what an expansion from scratch gives.
use std::fmt::Debug;

use super::expansion::Expansion;

/// Compare everything that can be seen of two expansions.
pub(super) fn same(made: &Expansion, fresh: &Expansion) {
    list("node", &made.tree.all(), &fresh.tree.all());
    list("frame", &made.frames, &fresh.frames);
    list("binding", &made.index.bindings, &fresh.index.bindings);
    list("read", &made.index.reads, &fresh.index.reads);
    list(
        "evaluation",
        made.index.evaluations.all(),
        fresh.index.evaluations.all(),
    );
    list(
        "definition",
        &made.index.symbols.definitions,
        &fresh.index.symbols.definitions,
    );
    list("use", &made.index.symbols.uses, &fresh.index.symbols.uses);
    list(
        "quiet use",
        &made.index.symbols.quiet_uses,
        &fresh.index.symbols.quiet_uses,
    );
    list("problem", &made.problems, &fresh.problems);
    list("untrusted problem", &made.untrusted, &fresh.untrusted);
    list("message", &made.messages, &fresh.messages);
    let (a, b): (Vec<_>, Vec<_>) = (made.record.iter().collect(), fresh.record.iter().collect());
    list("record", &a, &b);
    list("include", &made.includes, &fresh.includes);
    list("probe", &made.index.probes, &fresh.index.probes);
    list("argument", &made.arguments, &fresh.arguments);
    assert_eq!(
        (made.complete, made.whole),
        (fresh.complete, fresh.whole),
        "complete and whole"
    );
}

fn list<'l, T: Debug + 'l, L: IntoIterator<Item = &'l T, IntoIter: ExactSizeIterator>>(
    what: &str,
    made: L,
    fresh: L,
) {
    let (made, fresh) = (made.into_iter(), fresh.into_iter());
    let lengths = (made.len(), fresh.len());
    for (number, (a, b)) in made.zip(fresh).enumerate() {
        let (a, b) = (format!("{a:?}"), format!("{b:?}"));
        assert_eq!(a, b, "{what} {number} of an incremental expansion");
    }
    assert_eq!(lengths.0, lengths.1, "how many of {what}");
}
