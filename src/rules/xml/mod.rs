//! XML: well-formedness and the URDF schema.

pub(super) mod duplicate_element;
pub(super) mod inconsistent_xacro_prefix;
pub(super) mod invalid_number;
mod meant;
pub(super) mod missing_attribute;
pub(super) mod missing_element;
pub(super) mod missing_robot_name;
pub(super) mod missing_xacro_namespace;
mod newer_than_version;
pub(super) mod nonstandard_xacro_namespace;
mod seen;
pub(super) mod unexpected_text;
pub(super) mod unknown_attribute;
pub(super) mod unknown_element;
pub(super) mod unknown_root_element;
mod unsupported_urdf_version;
mod walk;
pub(super) mod wrong_vector_length;
pub(super) mod xacro_tags_in_urdf;
pub(super) mod xml_syntax_error;

use super::rule::{Category::Xml, Rule, Severity::Error, page};

pub(super) use invalid_number::each_number;
pub(super) use meant::{attributes as meant_attributes, with_dollars};
pub use missing_robot_name::missing_robot_name;
pub use seen::{CheckedElement, Numeric};
pub(super) use walk::{described, each_below, known, meant, root_element, tag_names};

// what expansion finds, without fixes of their own
pub(super) static XML_ENCODING_MISMATCH: Rule = Rule::found(
    "XML016",
    "xml-encoding-mismatch",
    Xml,
    Error,
    page("xml-encoding-mismatch"),
);

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &xml_syntax_error::RULE,
    &missing_xacro_namespace::RULE,
    &nonstandard_xacro_namespace::RULE,
    &inconsistent_xacro_prefix::RULE,
    &unknown_root_element::RULE,
    &unknown_element::RULE,
    &unknown_attribute::RULE,
    &missing_attribute::RULE,
    &missing_element::RULE,
    &invalid_number::RULE,
    &wrong_vector_length::RULE,
    &duplicate_element::RULE,
    &unexpected_text::RULE,
    &missing_robot_name::RULE,
    &unsupported_urdf_version::RULE,
    &XML_ENCODING_MISMATCH,
    &xacro_tags_in_urdf::RULE,
    &newer_than_version::RULE,
];
