//! The xacro language.

mod constant_condition;
pub(super) mod dropped_root_element;
pub(super) mod duplicate_include;
pub(super) mod found;
pub(super) mod include_children_ignored;
pub(super) mod include_not_found;
pub(super) mod invalid_property_name;
mod mentions;
pub(super) mod missing_dollar;
pub(super) mod missing_macro_param;
pub(super) mod redefined_macro;
pub(super) mod redefined_property;
pub(super) mod shadowed_builtin;
mod shadowed_property;
mod source;
mod string_bool_comparison;
pub(super) mod unknown_macro_param;
pub(super) mod unknown_xacro_attribute;
pub(super) mod unprefixed_macro_call;
pub(super) mod unprefixed_xacro_tag;
mod untaken;
mod unused;
pub(super) mod unused_arg;
pub(super) mod unused_include;
pub(super) mod unused_macro;
pub(super) mod unused_macro_param;
pub(super) mod unused_property;
mod words;

use super::rule::Rule;

pub use source::include_tags;
pub(super) use unprefixed_xacro_tag::is_unprefixed;
pub(super) use words::MentionedWords;

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &found::UNDEFINED_PROPERTY,
    &found::UNDEFINED_MACRO,
    &found::UNDEFINED_ARG,
    &found::UNDEFINED_BLOCK,
    &missing_macro_param::RULE,
    &unknown_macro_param::RULE,
    &found::MACRO_BLOCK_MISMATCH,
    &include_not_found::RULE,
    &found::INCLUDE_CYCLE,
    &duplicate_include::RULE,
    &unused_include::RULE,
    &unused_property::RULE,
    &unused_macro::RULE,
    &unused_arg::RULE,
    &unused_macro_param::RULE,
    &redefined_property::RULE,
    &redefined_macro::RULE,
    &shadowed_builtin::RULE,
    &shadowed_property::RULE,
    &unprefixed_xacro_tag::RULE,
    &unprefixed_macro_call::RULE,
    &invalid_property_name::RULE,
    &found::PROPERTY_CYCLE,
    &found::INVALID_EXPRESSION,
    &found::EXPRESSION_ERROR,
    &found::UNCLOSED_EXPRESSION,
    &found::INVALID_CONDITION,
    &string_bool_comparison::RULE,
    &found::DEPRECATED_BUILTIN_CALL,
    &found::MACRO_NAME_WITH_PREFIX,
    &unknown_xacro_attribute::RULE,
    &found::MISSING_XACRO_ATTRIBUTE,
    &include_children_ignored::RULE,
    &found::INFINITE_MACRO_RECURSION,
    &found::GLOB_INCLUDE_NO_MATCH,
    &found::CONFLICTING_PROPERTY_ATTRIBUTES,
    &found::USE_BEFORE_DEFINITION,
    &constant_condition::RULE,
    &found::PARENT_SCOPE_AT_TOP,
    &found::DEFAULT_WITH_SCOPE,
    &found::INVALID_MACRO_NAME,
    &found::INCONSISTENT_NAMESPACE_REDEFINITION,
    &missing_dollar::RULE,
    &dropped_root_element::RULE,
];
