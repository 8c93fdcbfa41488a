//! The xacro language.

mod constant_condition;
mod duplicate_include;
mod mentions;
mod redefined_macro;
mod redefined_property;
mod shadowed_builtin;
mod shadowed_property;
mod source;
mod string_bool_comparison;
mod unprefixed_macro_call;
mod unprefixed_xacro_tag;
mod untaken;
mod unused;
mod unused_arg;
mod unused_include;
mod unused_macro;
mod unused_macro_param;
mod unused_property;

use super::registry::Category::Xacro;
use super::registry::Safety::{Safe, Unsafe};
use super::registry::Severity::{Error, Info, Warning};
use super::registry::{Rule, page};

pub(super) use mentions::Mentions;
pub(super) use shadowed_builtin::{is_harmless as shadowing_is_harmless, is_news as shadowing_is_news};
pub use source::include_tags;
pub(super) use unprefixed_xacro_tag::is_unprefixed;

/// The rules. Those without a file are found by the expander.
#[rustfmt::skip]
pub(super) static RULES: &[Rule] = &[
    Rule::found("XAC001", "undefined-property", Xacro, Error, page("undefined-property")).fixed(Unsafe),
    Rule::found("XAC002", "undefined-macro", Xacro, Error, page("undefined-macro")).fixed(Unsafe),
    Rule::found("XAC003", "undefined-arg", Xacro, Error, page("undefined-arg")).fixed(Unsafe),
    Rule::found("XAC004", "undefined-block", Xacro, Error, page("undefined-block")).fixed(Unsafe),
    Rule::found("XAC005", "missing-macro-param", Xacro, Error, page("missing-macro-param")).fixed(Unsafe),
    Rule::found("XAC006", "unknown-macro-param", Xacro, Error, page("unknown-macro-param")).fixed(Unsafe),
    Rule::found("XAC007", "macro-block-mismatch", Xacro, Error, page("macro-block-mismatch")),
    Rule::found("XAC008", "include-not-found", Xacro, Error, page("include-not-found")).fixed(Unsafe),
    Rule::found("XAC009", "include-cycle", Xacro, Error, page("include-cycle")),
    duplicate_include::RULE,
    unused_include::RULE,
    unused_property::RULE,
    unused_macro::RULE,
    unused_arg::RULE,
    unused_macro_param::RULE,
    redefined_property::RULE,
    redefined_macro::RULE,
    Rule::found("XAC018", "shadowed-builtin", Xacro, Warning, page("shadowed-builtin")),
    shadowed_property::RULE,
    unprefixed_xacro_tag::RULE,
    unprefixed_macro_call::RULE,
    Rule::found("XAC022", "invalid-property-name", Xacro, Error, page("invalid-property-name")).fixed(Unsafe),
    Rule::found("XAC023", "property-cycle", Xacro, Error, page("property-cycle")),
    Rule::found("XAC024", "invalid-expression", Xacro, Error, page("invalid-expression")).fixed(Safe),
    Rule::found("XAC025", "expression-error", Xacro, Error, page("expression-error")).fixed(Unsafe),
    Rule::found("XAC026", "unclosed-expression", Xacro, Error, page("unclosed-expression")),
    Rule::found("XAC027", "invalid-condition", Xacro, Error, page("invalid-condition")),
    string_bool_comparison::RULE,
    Rule::found("XAC029", "deprecated-builtin-call", Xacro, Info, page("deprecated-builtin-call")).fixed(Safe),
    Rule::found("XAC030", "macro-name-with-prefix", Xacro, Warning, page("macro-name-with-prefix")).fixed(Safe),
    Rule::found("XAC031", "unknown-xacro-attribute", Xacro, Info, page("unknown-xacro-attribute")).fixed(Safe),
    Rule::found("XAC032", "missing-xacro-attribute", Xacro, Error, page("missing-xacro-attribute")).fixed(Unsafe),
    Rule::found("XAC033", "include-children-ignored", Xacro, Warning, page("include-children-ignored")).fixed(Safe),
    Rule::found("XAC034", "infinite-macro-recursion", Xacro, Error, page("infinite-macro-recursion")),
    Rule::found("XAC035", "glob-include-no-match", Xacro, Warning, page("glob-include-no-match")),
    Rule::found("XAC036", "conflicting-property-attributes", Xacro, Error, page("conflicting-property-attributes")),
    Rule::found("XAC037", "use-before-definition", Xacro, Error, page("use-before-definition")),
    constant_condition::RULE,
    Rule::found("XAC039", "parent-scope-at-top", Xacro, Warning, page("parent-scope-at-top")),
    Rule::found("XAC040", "default-with-scope", Xacro, Warning, page("default-with-scope")),
    Rule::found("XAC041", "invalid-macro-name", Xacro, Error, page("invalid-macro-name")),
    Rule::found("XAC042", "inconsistent-namespace-redefinition", Xacro, Info, page("inconsistent-namespace-redefinition")),
];
