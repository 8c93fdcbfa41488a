//! Launch files and scripts.

use std::path::Path;

use xacro_lsp::workspace::launch::{calls, read};

use super::choice_and_text;

/// Any text is read, what is found lies in it, and a second reading finds the same.
pub fn launch(data: &[u8]) {
    let (choice, text) = choice_and_text(data);
    let name =
        ["a.launch.py", "a.launch", "a.launch.xml", "a.sh", "a.yaml"][usize::from(choice) % 5];
    // the word without which nothing is read
    let text = format!("{text}\n# xacro\n");
    let find = || {
        read(Path::new(name), &text)
            .map(|file| calls(&file))
            .unwrap_or_default()
    };
    let found = find();
    for call in &found {
        let ranges = call
            .args
            .iter()
            .filter_map(|arg| arg.range)
            .chain(call.file.place())
            .chain([call.range]);
        for range in ranges {
            assert!(
                text.get(range.start as usize..range.end as usize).is_some(),
                "{range:?} {call:?}"
            );
        }
        assert!(call.known() <= call.args.len());
    }
    let shown = |calls: &[xacro_lsp::workspace::launch::LaunchCall]| format!("{calls:?}");
    assert_eq!(shown(&found), shown(&find()));
}
