//! In builds for tests: what was taken over from the last expansion is what an expansion from scratch gives.
use std::fmt::Debug;

use super::expansion::Expansion;

/// Compare everything that can be seen of two expansions.
pub(super) fn same(made: &Expansion, fresh: &Expansion) {
    list("node", &made.tree.all(), &fresh.tree.all());
    list("frame", made.frames.as_slice(), fresh.frames.as_slice());
    list(
        "binding",
        made.index.bindings.as_slice(),
        fresh.index.bindings.as_slice(),
    );
    list("read", &made.index.reads, &fresh.index.reads);
    list(
        "evaluation",
        made.index.evaluations.all(),
        fresh.index.evaluations.all(),
    );
    list(
        "definition",
        made.index.symbols.definitions.as_slice(),
        fresh.index.symbols.definitions.as_slice(),
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

fn list<T: Debug>(what: &str, made: &[T], fresh: &[T]) {
    for (number, (a, b)) in made.iter().zip(fresh).enumerate() {
        let (a, b) = (format!("{a:?}"), format!("{b:?}"));
        assert_eq!(a, b, "{what} {number} of an incremental expansion");
    }
    assert_eq!(made.len(), fresh.len(), "how many of {what}");
}
