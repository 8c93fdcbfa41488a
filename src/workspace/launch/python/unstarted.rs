//! Nodes that a launch file makes and never starts: nothing hands on the variables that hold them.

use base::{FastMap, FastSet, TextRange};

use crate::launch::{LaunchCommand, LaunchFile};

/// A variable that is set, and the value that it gets.
pub(super) struct Assignment {
    pub name: String,
    /// Where the variable stands.
    pub start: u32,
    pub value: TextRange,
}

/// Leave out publishers, spawners and nodes of hardware that stand only in values of variables which nothing reads, other than such values.
pub(super) fn leave_out(file: &mut LaunchFile, text: &str, assignments: &[Assignment]) {
    /// Each variable is compared with all others, and each of its places.
    const MOST: usize = 300;
    const MOST_PLACES: usize = 5_000;
    let nodes = [
        &file.files,
        &file.transforms,
        &file.spawners,
        &file.control_nodes,
    ];
    if nodes.into_iter().all(Vec::is_empty) || assignments.len() > MOST {
        return;
    }
    let places = places(text, assignments);
    if places.values().map(Vec::len).sum::<usize>() > MOST_PLACES {
        return;
    }
    let mut unread: FastSet<&str> = FastSet::default();
    loop {
        let inside = |at: u32| {
            let mut values = assignments.iter().filter(|one| unread.contains(&*one.name));
            values.any(|one| one.value.start <= at && at < one.value.end)
        };
        let is_read = |name: &str| {
            let mut all = places.get(name).into_iter().flatten();
            all.any(|&at| {
                let mut own = assignments.iter().filter(|one| one.name == name);
                !own.any(|one| one.start == at) && !inside(at)
            })
        };
        let names = assignments.iter().map(|one| one.name.as_str());
        let more: Vec<&str> = names
            .filter(|name| !unread.contains(name) && !is_read(name))
            .collect();
        if more.is_empty() {
            break;
        }
        unread.extend(more);
    }
    let is_started = |command: &LaunchCommand| {
        let mut values = assignments.iter().filter(|one| unread.contains(&*one.name));
        !values
            .any(|one| one.value.start <= command.range.start && command.range.end <= one.value.end)
    };
    file.files.retain(is_started);
    file.transforms.retain(is_started);
    file.spawners.retain(is_started);
    file.control_nodes.retain(is_started);
}

/// Where the names of variables stand in a text, outside of comments.
fn places<'a>(text: &str, assignments: &'a [Assignment]) -> FastMap<&'a str, Vec<u32>> {
    let mut found: FastMap<&str, Vec<u32>> = FastMap::default();
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    for name in assignments.iter().map(|one| one.name.as_str()) {
        found.entry(name).or_insert_with(|| {
            let all = memchr::memmem::find_iter(text.as_bytes(), name.as_bytes());
            let is_read = |at: &usize| {
                let (before, rest) = text.split_at_checked(*at).unwrap_or_default();
                let behind = rest.get(name.len()..).unwrap_or_default();
                let line = before.rsplit('\n').next().unwrap_or_default();
                !before.ends_with(is_name) && !behind.starts_with(is_name) && !line.contains('#')
            };
            all.filter(is_read).map(|at| at as u32).collect()
        });
    }
    found
}
