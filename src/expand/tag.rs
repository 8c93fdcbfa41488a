//! An element of the source as the pass over the document sees it.
use super::names::EvalContext;
use super::node::XId;
use super::origin::SrcId;
use xml::{Attr, Node};

/// An element of the source as the pass sees it: `xacro:element` and `xacro:call` go on under another name.
#[derive(Clone, Copy)]
pub(super) struct Tag<'a> {
    pub node: Node<'a>,
    pub src: SrcId,
    pub name: &'a str,
    /// Attributes that were used up by renaming it.
    pub used: &'static [&'static str],
}

impl<'a> Tag<'a> {
    pub fn attrs(&self) -> impl Iterator<Item = Attr<'a>> + use<'a> {
        let used = self.used;
        self.node.attrs().filter(move |a| !used.contains(&a.name()))
    }

    pub fn attr(&self, name: &str) -> Option<Attr<'a>> {
        self.attrs().find(|a| a.name() == name)
    }
}

/// Children of one element while they are evaluated.
#[derive(Clone, Copy, Debug)]
pub(super) struct SiblingState {
    /// Where their text is.
    pub src: SrcId,
    /// The element that what they give is put into.
    pub out: XId,
    pub cx: EvalContext,
    /// After `xacro:eval-comments`.
    pub eval_comments: bool,
}

impl SiblingState {
    pub fn new(src: SrcId, out: XId, cx: EvalContext) -> Self {
        Self {
            src,
            out,
            cx,
            eval_comments: false,
        }
    }
}
