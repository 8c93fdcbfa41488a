//! Robot configurations of MoveIt Pro: YAML files that name a description and its arguments, and may specialize the
//! configuration of another package.

use super::{Caller, GivenArg};
use base::{FastMap, FastSet};

/// Configurations that are followed from one to the next.
const MOST_BASES: usize = 8;

/// The arguments below `urdf_params:`, as a list or a mapping.
pub(super) fn urdf_params(text: &str) -> Vec<GivenArg> {
    let mut given = Vec::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if line.trim() != "urdf_params:" {
            continue;
        }
        let indent = indentation(line);
        let below = lines.clone().filter(|line| !is_blank(line));
        given.extend(
            below
                .take_while(|line| indentation(line) > indent || is_item(line, indent))
                .filter_map(param),
        );
    }
    given
}

/// The package whose configuration a file specializes.
pub(super) fn based_on(text: &str) -> Option<String> {
    let value = text
        .lines()
        .find_map(|line| line.strip_prefix("based_on_package:"))?;
    scalar(value).filter(|name| !name.is_empty())
}

/// Complete configurations with what the ones that they specialize name and give.
pub(super) fn inherit(callers: &mut [Caller]) {
    let mut by_package: FastMap<String, usize> = FastMap::default();
    for (number, caller) in callers.iter().enumerate() {
        let package = caller
            .path
            .parent()
            .and_then(|folder| folder.parent()?.file_name()?.to_str());
        if let Some(package) = package.filter(|_| caller.path.ends_with("config/config.yaml")) {
            by_package.insert(package.to_owned(), number);
        }
    }
    for number in 0..callers.len() {
        let mut seen = FastSet::from_iter([number]);
        let mut base = callers
            .get(number)
            .and_then(|caller| caller.based_on.clone());
        while let Some(at) = base.and_then(|package| by_package.get(&package).copied()) {
            let Some(from) = callers
                .get(at)
                .filter(|_| seen.insert(at) && seen.len() <= MOST_BASES)
            else {
                break;
            };
            let (descriptions, args) = (from.descriptions.clone(), from.args.clone());
            base = from.based_on.clone();
            if let Some(own) = callers.get_mut(number) {
                own.descriptions.extend(descriptions);
                own.args.extend(args);
            }
        }
    }
}

fn indentation(line: &str) -> usize {
    line.len() - line.trim_start_matches(' ').len()
}

fn is_blank(line: &str) -> bool {
    line.trim().is_empty() || line.trim_start().starts_with('#')
}

/// Whether a line is an item of a list that starts in the column of its key.
fn is_item(line: &str, indent: usize) -> bool {
    indentation(line) == indent && line.trim_start().starts_with("- ")
}

fn param(line: &str) -> Option<GivenArg> {
    let item = line.trim_start();
    let (name, value) = item.strip_prefix("- ").unwrap_or(item).split_once(':')?;
    let value = scalar(value).filter(|value| !value.contains(['$', '%', '{', '>']));
    Some(GivenArg {
        name: scalar(name)?,
        value,
    })
}

/// A scalar without its quotes and the comment behind it.
fn scalar(text: &str) -> Option<String> {
    let text = text.trim();
    if let Some(quote) = text.chars().next().filter(|c| matches!(c, '"' | '\'')) {
        return Some(text.get(1..)?.split_once(quote)?.0.to_owned());
    }
    let plain = text.split(" #").next()?.trim();
    Some(plain.to_owned())
}

#[cfg(test)]
mod tests {
    use super::{based_on, urdf_params};

    #[test]
    fn parameters() {
        let text = "hardware:\n  urdf_params:\n    # mode\n    - side: left # or right\n\n    - \"mode\": 'a b'\n    \
                    - model: \"%>> share\"\n  other:\n    - more: 1\n";
        let found: Vec<(String, Option<String>)> = urdf_params(text)
            .into_iter()
            .map(|arg| (arg.name, arg.value))
            .collect();
        let expected = [
            ("side", Some("left")),
            ("mode", Some("a b")),
            ("model", None),
        ];
        assert_eq!(
            found,
            expected.map(|(name, value)| (name.to_owned(), value.map(str::to_owned)))
        );
        let unindented = "urdf_params:\n- side: left\nother: 1\n";
        assert_eq!(urdf_params(unindented).len(), 1);
        assert!(urdf_params("urdf_params: []\nside: left").is_empty());
    }

    #[test]
    fn bases() {
        assert_eq!(
            based_on("a: 1\nbased_on_package: \"arm_base\" # x").as_deref(),
            Some("arm_base")
        );
        assert_eq!(based_on("# based_on_package: arm\n"), None);
    }
}
