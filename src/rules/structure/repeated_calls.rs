//! Two calls of one macro that give the same names: one mistake, however many names the macro gives.
use super::super::context::RobotCx;
use base::{FastMap, FastSet, TextRange};
use expand::{Expansion, FileIdx, FileRange, Frame, FrameKind, Origin};
use model::AttrValue;

/// The advice where no call is to blame.
pub(super) const HELP: &str =
    "rename one of them; in a macro, start the name with a parameter: name=\"${prefix}...\"";

type CallRange = (FileIdx, TextRange);

/// The pairs of calls that were seen.
#[derive(Default)]
pub(super) struct RepeatedCalls {
    seen: FastSet<(CallRange, CallRange)>,
}

/// The later one of two calls.
pub(super) struct Repeated {
    /// The macro.
    name: String,
    /// The parameter that makes names different.
    prefix: Option<String>,
    /// Whether nothing was said of these two calls before.
    pub(super) is_first: bool,
}

impl Repeated {
    pub(super) fn help(&self) -> String {
        let name = &self.name;
        match &self.prefix {
            Some(prefix) => {
                format!("write another {prefix}=\"...\" in each call of macro `{name}`")
            }
            None => format!(
                "start the names in macro `{name}` with a parameter: name=\"${{prefix}}...\""
            ),
        }
    }
}

impl RepeatedCalls {
    /// The pairs that give the same links.
    pub(super) fn of_links(cx: &RobotCx<'_>) -> Self {
        let mut calls = Self::default();
        let mut first: FastMap<&str, &AttrValue> = FastMap::default();
        for name in cx.robot.links.iter().filter_map(|link| link.name.as_ref()) {
            let Some(text) = name.name() else { continue };
            match first.get(text.as_str()) {
                Some(earlier) => {
                    calls.between(cx.expansion, earlier.origin, name.origin);
                }
                None => {
                    first.insert(text, name);
                }
            }
        }
        calls
    }

    /// The calls that made the same name of the same text.
    pub(super) fn between(
        &mut self,
        expansion: &Expansion,
        one: Origin,
        other: Origin,
    ) -> Option<Repeated> {
        if expansion.place(one)? != expansion.place(other)? {
            return None;
        }
        let (one, other) = (calls_around(expansion, one), calls_around(expansion, other));
        let mut pairs = one.iter().zip(&other);
        let ((first, one), (later, other)) = pairs.find(|((_, one), (_, other))| one != other)?;
        if first.kind != FrameKind::Macro
            || later.kind != FrameKind::Macro
            || first.name != later.name
        {
            return None;
        }
        let is_first = self
            .seen
            .insert(((one.file, one.range), (other.file, other.range)));
        Some(Repeated {
            name: later.name.to_string(),
            prefix: prefix_of(expansion, later.call),
            is_first,
        })
    }
}

/// Whether two names are equal only as long as arguments are empty that are there to be given: each is made from another one.
pub(super) fn differ_when_given(expansion: &Expansion, one: &AttrValue, other: &AttrValue) -> bool {
    expansion.empty_argument(&one.pieces) != expansion.empty_argument(&other.pieces)
}

/// The calls and blocks around a text, outermost first.
fn calls_around(expansion: &Expansion, origin: Origin) -> Vec<(&Frame, FileRange)> {
    let frames = expansion
        .frames_of(origin)
        .filter(|frame| frame.kind != FrameKind::Include);
    let mut frames: Vec<_> = frames
        .filter_map(|frame| Some((frame, expansion.place(frame.call)?)))
        .collect();
    frames.reverse();
    frames
}

/// The attribute of a call that is a prefix by its name.
fn prefix_of(expansion: &Expansion, call: Origin) -> Option<String> {
    let item = &expansion.sources.get(call.src)?.item;
    let node = item.element_at(call.range.start)?;
    let mut names = node.attrs().map(|attr| attr.name());
    names
        .find(|name| ["prefix", "tf_prefix", "ns", "namespace"].contains(name))
        .map(str::to_owned)
}
