//! How much is said: findings, drawn lines, letters.

use xacro_lsp::base::limits::*;

use super::{LINK, check, folder, robot, run, write};

#[test]
fn message_letters() {
    let name = "n".repeat(50_000);
    let said = check(
        &format!(
            "<joint name=\"{name}\" type=\"fixed\"><parent link=\"{name}p\"/><child link=\"{name}c\"/></joint>"
        ),
        &[],
    );
    let longest = said
        .lines()
        .filter(|line| line.starts_with("error["))
        .map(str::len)
        .max()
        .unwrap();
    assert!(
        (MESSAGE_LETTERS..MESSAGE_LETTERS + 100).contains(&longest),
        "{longest}"
    );
}

#[test]
fn drawn_line() {
    let said = check(&format!("{}<link/>", " ".repeat(DRAWN_LINE)), &[]);
    assert!(
        said.contains(&format!("r.urdf.xacro:2:{}", DRAWN_LINE + 1)),
        "{said}"
    );
    assert!(said.len() < DRAWN_LINE, "{}", said.len());
}

#[test]
fn findings_of_a_rule() {
    // one line, so that it is seen too that a long line is not taken apart for each of them
    let folder = folder();
    write(
        &folder,
        "r.urdf",
        format!(
            "<robot name=\"r\">{LINK}{}</robot>",
            "<a/>".repeat(FINDINGS_OF_A_RULE + 10)
        ),
    );
    let said = run(
        &folder,
        &["check", "--statistics", "r.urdf"],
        &mut std::io::empty(),
    );
    assert!(
        said.contains(&format!("{FINDINGS_OF_A_RULE}  hint")),
        "{said}"
    );
}

#[test]
fn drawn_of_a_rule() {
    let links: String = (0..150)
        .map(|n| format!("<link name=\"${{gone{n}}}\"/>\n"))
        .collect();
    let said = check(&links, &[]);
    assert_eq!(
        said.matches("[undefined-property]").count(),
        DRAWN_OF_A_RULE,
        "{said}"
    );
    assert!(said.contains("145 more not shown"), "{said}");
}

#[test]
fn drawn_in_all() {
    let folder = folder();
    for file in 0..4 {
        let link = |n: usize| format!("<link name=\"${{gone{file}_{n}}}\"/>\n");
        let links: String = (0..DRAWN_OF_A_RULE).map(link).collect();
        write(&folder, &format!("r{file}.urdf.xacro"), robot(&links));
    }
    let said = run(&folder, &["check", "."], &mut std::io::empty());
    assert_eq!(
        said.matches("[undefined-property]").count(),
        DRAWN_IN_ALL,
        "{said}"
    );
    let all = run(
        &folder,
        &["check", "--show", "all", "."],
        &mut std::io::empty(),
    );
    assert_eq!(
        all.matches("[undefined-property]").count(),
        4 * DRAWN_OF_A_RULE,
        "{all}"
    );
}

#[test]
fn drawn_problems() {
    let links: String = (0..150)
        .map(|n| format!("<link name=\"${{gone{n}}}\"/>\n"))
        .collect();
    let folder = folder();
    write(&folder, "r.urdf.xacro", robot(&links));
    let said = run(&folder, &["expand", "r.urdf.xacro"], &mut std::io::empty());
    assert_eq!(
        said.matches("error: name 'gone").count(),
        DRAWN_PROBLEMS,
        "{said}"
    );
}
