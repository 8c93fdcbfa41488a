//! The table of features in `docs/lsp.md`: whole, and its tests are there.

#[test]
fn every_feature_names_tests_that_exist() {
    let page = include_str!("../../docs/lsp.md");
    let (modules, acceptance) = (include_str!("main.rs"), include_str!("acceptance.rs"));
    let rows: Vec<&str> = page
        .lines()
        .filter(|line| line.starts_with("| ") && line.contains("(F"))
        .collect();
    let features = (1..=16).chain(20..=38);
    for number in features {
        let own = |row: &&&str| {
            let (_, listed) = row.split_once('(').unwrap();
            let listed = listed.split_once(')').unwrap().0;
            listed
                .split(", ")
                .any(|feature| feature == format!("F{number}"))
        };
        assert_eq!(rows.iter().filter(own).count(), 1, "F{number}");
    }
    for row in rows {
        let tests = row.trim_end_matches(" |").rsplit(" | ").next().unwrap();
        let names: Vec<&str> = tests
            .split(", ")
            .map(|name| name.trim_matches('`'))
            .collect();
        assert!(!names.is_empty(), "{row}");
        for name in names {
            let exists = match name.trim_start_matches("acceptance::").strip_suffix('*') {
                Some(prefix) => acceptance.contains(&format!("fn {prefix}")),
                None => modules.contains(&format!("mod {name};")),
            };
            assert!(exists, "`{name}` in {row}");
        }
    }
}
