//! Elements and attributes of a document, as the schema sees them.
use super::super::schema::ElementSpec;
use expand::XId;
use model::AttrValue;

/// An element outside of the free zones.
pub struct CheckedElement {
    pub id: XId,
    /// What the schema says about it; none: it may not stand there.
    pub spec: Option<&'static ElementSpec>,
    /// What the schema says about the element around it.
    pub parent: Option<&'static ElementSpec>,
    /// What the schema says about it, unless it is for other tools.
    pub known: Option<&'static ElementSpec>,
}

/// An attribute that holds numbers.
#[derive(Debug)]
pub struct Numeric {
    /// Its element.
    pub id: XId,
    /// Its name.
    pub name: &'static str,
    /// How many numbers it holds.
    pub count: usize,
    /// Its value.
    pub text: AttrValue,
}
