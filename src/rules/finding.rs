//! What a rule has to say.
use ecow::{EcoString, EcoVec};

use super::grouping::Group;
use super::rule::{Rule, Safety, Severity};
use base::Span;
use expand::{Outside, ProblemKind};

/// A defect at its place.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The rule that found it.
    pub rule: &'static Rule,
    /// How bad it is.
    pub severity: Severity,
    /// One line that names the thing, without a full stop.
    pub message: String,
    /// The text that is wrong.
    pub span: Span,
    /// Further places: the first of two duplicates, definitions; then the calls that led here, innermost first.
    pub related: Vec<Related>,
    /// What to do, where there is something to say.
    pub help: Option<String>,
    /// The known name that is probably meant, where the help suggests one.
    pub similar: Option<String>,
    /// Edits that fix it.
    pub fix: Option<Fix>,
    /// The macro calls in which it holds, when the text that is wrong stands in the body of a macro. There may be
    /// thousands, and findings are copied for each report.
    pub call_sites: EcoVec<CallSite>,
    /// Whether it holds in some calls of that macro only, because the text reads differently in others.
    pub partial: bool,
    /// What expansion reported, where the finding comes from it.
    pub problem: Option<ProblemKind>,
    /// What outside of the expansion may make it go away.
    pub outside: Option<Outside>,
    /// Whether it is in a macro that nothing calls.
    pub probed: bool,
    /// What it shares with other findings that are the same defect; none: what the rule says.
    pub group: Option<Group>,
    /// The further places, once findings are grouped.
    pub places: Vec<Related>,
}

/// A macro call in which a finding holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CallSite {
    /// The tag of the call.
    pub call: Span,
    /// The macro.
    pub name: EcoString,
    /// What the call passes, when the text that is wrong is a parameter and nothing else.
    pub argument: Option<Span>,
    /// What there is to say about this call.
    pub message: EcoString,
    /// What to do here.
    pub help: Option<EcoString>,
}

impl Finding {
    /// A finding without further places, help or fix, as bad as its rule says.
    pub fn new(rule: &'static Rule, span: Span, message: impl Into<String>) -> Self {
        Self {
            rule,
            severity: rule.severity,
            message: without_placeholders(message.into()),
            span,
            related: Vec::new(),
            help: None,
            similar: None,
            fix: None,
            call_sites: EcoVec::new(),
            partial: false,
            problem: None,
            outside: None,
            probed: false,
            group: None,
            places: Vec::new(),
        }
    }

    /// With advice.
    #[must_use]
    pub fn advised(mut self, help: impl Into<Help>) -> Self {
        let Help { text, similar } = help.into();
        (self.help, self.similar) = (Some(text), similar);
        self
    }
}

/// What to do about a finding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Help {
    /// One line in the imperative.
    pub text: String,
    /// The known name that it suggests.
    pub similar: Option<String>,
}

impl Help {
    /// The suggestion of a known name.
    pub fn did_you_mean(near: impl Into<String>) -> Self {
        let near = near.into();
        Self {
            text: format!("did you mean `{near}`?"),
            similar: Some(near),
        }
    }

    /// With another sentence.
    #[must_use]
    pub fn and(mut self, sentence: &str) -> Self {
        self.text.push(' ');
        self.text.push_str(sentence);
        self
    }
}

impl From<String> for Help {
    fn from(text: String) -> Self {
        Self {
            text,
            similar: None,
        }
    }
}

impl From<&str> for Help {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

/// A message in which a thing whose name is empty, or not known as a whole, is "this link" instead of "link `?`".
fn without_placeholders(message: String) -> String {
    const KINDS: [&str; 7] = [
        "link",
        "joint",
        "material",
        "plugin",
        "robot",
        "ros2_control",
        "transmission",
    ];
    // most messages name things, and there may be one for each link of a robot
    let bytes = message.as_bytes();
    let mut signs = memchr::memchr2_iter(b'?', b'`', bytes);
    let is_placeholder_there =
        |at: usize| bytes.get(at) == Some(&b'?') || bytes.get(at + 1) == Some(&b'`');
    if !signs.any(is_placeholder_there) {
        return message;
    }
    let mut text = String::with_capacity(message.len());
    for (number, part) in message.split('`').enumerate() {
        let kind = KINDS.iter().find(|kind| {
            text.strip_suffix(' ')
                .is_some_and(|before| before.rsplit(' ').next() == Some(**kind))
        });
        match kind.filter(|_| number % 2 == 1 && is_placeholder(part)) {
            Some(kind) => {
                text.truncate(text.len() - kind.len() - 1);
                text.push_str("this ");
                text.push_str(kind);
            }
            None if number % 2 == 1 => {
                text.push('`');
                text.push_str(part);
                text.push('`');
            }
            None => text.push_str(part),
        }
    }
    // an odd number of backticks is not ours
    if message.matches('`').count().is_multiple_of(2) {
        text
    } else {
        message
    }
}

fn is_placeholder(name: &str) -> bool {
    name.is_empty() || name.contains('?') && !name.contains([' ', '$', '{', '('])
}

/// A further place of a finding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Related {
    /// The place.
    pub span: Span,
    /// What is there.
    pub message: String,
    /// Whether expansion came through here: a call, an include, a use. Else something to compare with.
    pub is_call: bool,
}

/// A way to fix a finding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// Whether the meaning can change.
    pub safety: Safety,
    /// What the edits do.
    pub message: String,
    /// Replacements that do not overlap.
    pub edits: Vec<Edit>,
}

/// New text in place of old.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The old text.
    pub span: Span,
    /// The new text.
    pub content: String,
}

#[cfg(test)]
mod tests {
    use super::without_placeholders;

    #[test]
    fn things_without_a_name_are_this_thing() {
        for (message, expected) in [
            ("link `?` has no inertial", "this link has no inertial"),
            (
                "mesh `a.stl` of link `?tool` is open",
                "mesh `a.stl` of this link is open",
            ),
            ("material `` has no color", "this material has no color"),
            (
                "unknown link `a`; did you mean `b`?",
                "unknown link `a`; did you mean `b`?",
            ),
            (
                "cannot evaluate `a if b else ?`: x",
                "cannot evaluate `a if b else ?`: x",
            ),
        ] {
            assert_eq!(without_placeholders(message.to_owned()), expected);
        }
    }
}
