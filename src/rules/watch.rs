//! What rules look at beyond the element that they are asked about.
use std::cell::{Cell, RefCell};

use expand::XId;

/// Notes what a rule looks at while it is asked.
#[derive(Default)]
pub(super) struct Watch {
    anything: Cell<bool>,
    names: Cell<bool>,
    elements: RefCell<Vec<XId>>,
}

/// What rules looked at beyond an element.
#[derive(Debug, Default)]
pub(super) struct Beyond {
    /// More than the next ones tell.
    pub anything: bool,
    /// The names of links and joints and the ends of joints.
    pub names: bool,
    /// Links and joints.
    pub elements: Vec<XId>,
}

impl Watch {
    /// Nothing was looked at from now on.
    pub(super) fn start(&self) {
        self.anything.set(false);
        self.names.set(false);
        self.elements.borrow_mut().clear();
    }

    /// Something is looked at that has no note of its own.
    pub(super) fn note_anything(&self) {
        self.anything.set(true);
    }

    /// It is looked which links and joints have a name.
    pub(super) fn note_names(&self) {
        self.names.set(true);
    }

    /// A link or joint is looked at.
    pub(super) fn note_element(&self, element: XId) {
        self.elements.borrow_mut().push(element);
    }

    /// Whether anything was looked at.
    pub(super) fn is_beyond(&self) -> bool {
        self.anything.get() || self.names.get()
    }

    /// Add what was looked at.
    pub(super) fn add_to(&self, beyond: &mut Beyond) {
        beyond.anything |= self.anything.get();
        beyond.names |= self.names.get();
        beyond.elements.extend_from_slice(&self.elements.borrow());
    }
}
