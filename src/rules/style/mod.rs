//! Style; off unless asked for.

mod missing_xml_declaration;
mod redundant_expression;
mod redundant_identity_origin;
mod todo_comment;

use super::rule::Rule;

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &redundant_identity_origin::RULE,
    &redundant_expression::RULE,
    &missing_xml_declaration::RULE,
    &todo_comment::RULE,
];
