//! XML: well-formedness and the URDF schema.

mod inconsistent_xacro_prefix;
mod missing_robot_name;
mod nonstandard_xacro_namespace;
mod unknown_root_element;
mod xacro_tags_in_urdf;

use super::registry::{Category::Xml, Rule, Safety, Severity::Error, page};

/// The rules.
pub(super) static RULES: &[Rule] = &[
    Rule::found("XML001", "xml-syntax-error", Xml, Error, page!("xml-syntax-error")),
    Rule::found("XML002", "missing-xacro-namespace", Xml, Error, page!("missing-xacro-namespace"))
        .fixed(Safety::Safe),
    nonstandard_xacro_namespace::RULE,
    inconsistent_xacro_prefix::RULE,
    unknown_root_element::RULE,
    missing_robot_name::RULE,
    Rule::found("XML016", "xml-encoding-mismatch", Xml, Error, page!("xml-encoding-mismatch")),
    xacro_tags_in_urdf::RULE,
];

/// The namespace that xacro's documentation names.
const XACRO_URI: &str = "http://www.ros.org/wiki/xacro";

/// Whether a namespace is meant to be xacro's: files in the wild spell it in many ways.
fn is_xacro_uri(uri: &str) -> bool {
    let rest = uri.trim_start_matches("http://").trim_start_matches("https://");
    let host = rest.split('/').next().unwrap_or("").trim_start_matches("www.");
    matches!(host, "ros.org" | "wiki.ros.org") && rest.trim_end_matches('/').ends_with("xacro")
}
