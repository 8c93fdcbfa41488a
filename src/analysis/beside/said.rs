//! What a file says that other files rest on: where it says something else, they are looked at again.
use std::path::Path;

use super::super::graph::gives_robot;
use super::super::launch_names::given_in;
use super::super::session::Session;
use super::super::walk::is_launch;
use super::robots::robot_name;
use super::sort::{Sort, beside_settings, is_about_robots, sort};
use facts::parts_where;
use xml::Document;

/// What a file says that the pairing of other files rests on, and the arguments that it gives to robots.
pub(in super::super) fn said_to_others(session: &Session, path: &Path) -> Vec<String> {
    let mut said = vec![format!(
        "{:?} {}",
        robot_name(session, path),
        is_about_robots(session, path)
    )];
    if is_launch(path) {
        said.extend(given_in(session, path));
    } else if sort(path) == Some(Sort::Yaml) {
        let settings = beside_settings(session, path);
        said.extend(
            settings.map(|settings| format!("{:?} {:?}", settings.listed, settings.assistant)),
        );
    } else if let Ok(file) = session.vfs.document(path) {
        let parts = parts_where(&file.document, |marks| marks.parameters);
        let named = parts.flat_map(|(_, item)| item.text().split("<parameters>").skip(1));
        said.extend(named.filter_map(|rest| Some(rest.split_once('<')?.0.to_owned())));
        said.push(gives_robot(&file.document).to_string());
        said.extend(included_names(&file.document));
    }
    said
}

/// The names of the files that a document includes, with the prefix of xacro or without it.
fn included_names(document: &Document) -> impl Iterator<Item = String> {
    let parts = parts_where(document, |marks| marks.include);
    let nodes = parts.flat_map(|(_, item)| item.all_nodes());
    let tags = nodes.filter(|node| matches!(node.name(), "xacro:include" | "include"));
    tags.filter_map(|tag| Some(tag.attr("filename")?.raw().to_owned()))
}
