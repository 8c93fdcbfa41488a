//! Words that are no longer used, and what is wrong with a text.

/// Words and phrases that are no longer used, and what to write. A space at either end stands for the end of a word.
const RETIRED: &[(&str, &str)] = &[
    ("spelled otherwise", "differs in case"),
    (" mend", "fix"),
    (" anew", "again"),
    ("as it stands", "unchanged"),
    (" is no ", "is not a"),
    (" are no ", "are not"),
    ("knows no ", "unknown"),
    ("names no ", "has no"),
    (" lacks ", "is missing"),
    ("is meant, it seems", "did you mean `x`?"),
    ("with a similar name exists", "did you mean `x`?"),
    ("a similar rule is", "did you mean `x`?"),
    ("in silence", "silently"),
    ("without a word", "silently"),
    ("whoever", "the user"),
    ("somebody", "users"),
    ("in a circle", "in a cycle"),
    (" hang on each", "form a loop"),
    ("lie behind", "are after"),
    ("belongs into", "goes in"),
    ("belong into", "go in"),
    ("stand behind", "follow"),
    ("stands behind", "follows"),
    ("stands in", "is in"),
    (" may stand", "is allowed"),
    (" can stand", "is allowed"),
    ("cannot stand", "is not allowed"),
    (" behind ", "after"),
    (" a blank", "a space"),
    (" blanks ", "spaces"),
    ("small letters", "lower case"),
    ("drawing program", "CAD program"),
    ("thing of the past", "deprecated"),
    ("worked off", "processed"),
    ("looked for", "searched for"),
    ("never come back", "hang"),
    ("is not found", "not found"),
    (" refuses", "rejects"),
    (" is refused", "is rejected"),
    (" refused ", "rejected"),
    ("stand beside", "are next to"),
    ("stands beside", "is next to"),
    ("stand on the", "are on the"),
    (" lies in ", "is in"),
    (" lie in ", "are in"),
    (" lies outside", "is outside"),
    ("of which", "a relative clause of its own"),
    ("by hand of", "by"),
    ("looked at", "checked"),
    ("is said", "is reported"),
    ("are said", "are reported"),
    ("told once", "reported once"),
    ("unasked", "without a request"),
    ("nobody has", "is not"),
    ("that nobody", "that no one"),
    ("in the place of", "instead of"),
    ("takes the place of", "replaces"),
    ("beginnings of codes", "code prefixes"),
    ("with stars", "with wildcards"),
    (" kin ", "similar names"),
    ("slips of", "mistakes of"),
    ("is the whole truth", "is complete"),
    ("given up", "canceled"),
    (" the very ", "the same"),
    ("passed over", "ignored"),
    ("for people,", "for readers,"),
    ("comes with stars", "has wildcards"),
    (" wants ", "requires"),
    (" minds ", "cares"),
    ("that are there", "that exist"),
    ("that is there", "that exists"),
    ("that is not there", "that is missing"),
    ("are not there", "are missing"),
    ("is not there", "is missing"),
];

/// British spelling, and the American one.
const BRITISH: &[(&str, &str)] = &[
    ("colour", "color"),
    ("metre", "meter"),
    ("centre", "center"),
    ("behaviour", "behavior"),
    ("neighbour", "neighbor"),
    ("honour", "honor"),
    ("normalis", "normaliz"),
    ("localis", "localiz"),
    ("optimis", "optimiz"),
    ("organis", "organiz"),
    ("recognis", "recogniz"),
    ("initialis", "initializ"),
    ("licence", "license"),
    ("analyse", "analyze"),
    ("labelled", "labeled"),
    ("cancelled", "canceled"),
    ("cancelling", "canceling"),
    ("misspelt", "misspelled"),
    ("artefact", "artifact"),
    ("judgement", "judgment"),
    ("catalogue", "catalog"),
    ("customis", "customiz"),
    ("minimis", "minimiz"),
    ("maximis", "maximiz"),
    ("summaris", "summariz"),
    ("serialis", "serializ"),
    ("synchronis", "synchroniz"),
    ("visualis", "visualiz"),
    ("utilis", "utiliz"),
    ("travell", "travel"),
    ("modell", "model"),
    ("whilst", "while"),
    ("fulfil ", "fulfill"),
];

/// A text without what is in backticks, in double quotes after `=`, and in tags: names and code are not ours.
pub fn prose(text: &str) -> String {
    let mut kept = String::new();
    for (i, part) in text.split('`').enumerate() {
        kept.push_str(if i % 2 == 0 { part } else { "X" });
    }
    kept
}

/// What is wrong with the words of a text.
pub fn wrong_words(text: &str) -> Vec<String> {
    let text = format!(
        " {} ",
        prose(text)
            .to_lowercase()
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ")
    );
    let text = [
        "there is no ",
        "there are no ",
        "is no longer ",
        "are no longer ",
    ]
    .iter()
    .fold(text, |text, allowed| text.replace(allowed, ""));
    let retired = RETIRED.iter().filter(|(word, _)| text.contains(word));
    let british = BRITISH.iter().filter(|(word, _)| text.contains(word));
    retired
        .chain(british)
        .map(|(word, better)| format!("`{}`: write `{better}`", word.trim()))
        .collect()
}
