//! Which definition a name refers to, and what macros hold that nothing calls.
//!
//! A fixture is a set of files; `//- name` starts each. The answer lists, per definition, the places of its uses.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing
)] // a test may fail loudly

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use xacro_lsp::base::Encoding;
use xacro_lsp::expand::{Expansion, Request, SourceRange, Sources, expand};
use xacro_lsp::packages::{PackageOptions, Packages};
use xacro_lsp::vfs::{Environment, Vfs};

const HEAD: &str = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">";

/// Expand the first file of a fixture.
fn expanded(fixture: &str) -> Expansion {
    let cwd = Path::new("/fixture");
    let vfs = Arc::new(Vfs::with_cwd(u64::MAX, cwd.to_path_buf()));
    let mut first = None;
    for part in fixture.split("//- ").filter(|part| !part.trim().is_empty()) {
        let (name, text) = part.split_once('\n').unwrap();
        vfs.set_buffer(&cwd.join(name), Some(format!("{HEAD}\n{text}</robot>")));
        first.get_or_insert(name);
    }
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: cwd.to_path_buf(),
        ..Environment::default()
    };
    let packages = Packages::new(vfs.clone(), &env, PackageOptions::default());
    let request = Request {
        file: first.unwrap().to_owned(),
        probe: true,
        ..Request::default()
    };
    expand(
        Sources {
            vfs: &vfs,
            packages: &packages,
            env: &env,
        },
        &request,
    )
}

/// `file:line:column text`
fn shown(expansion: &Expansion, place: SourceRange) -> String {
    let source = expansion.sources.get(place.src).unwrap();
    let file = expansion.files.get(source.file).unwrap();
    let range = place.range.shift(source.base);
    let at = file.source.document.line_col(range.start, Encoding::Utf32);
    format!(
        "{}:{}:{} {}",
        file.name,
        at.line + 1,
        at.col + 1,
        file.source.document.slice(range)
    )
}

#[track_caller]
fn check_symbols(fixture: &str, expected: &str) {
    let expansion = expanded(fixture);
    let mut lines = String::new();
    for (id, definition) in expansion.index.symbols.iter() {
        lines.push_str(&format!(
            "{:?} {}\n",
            definition.kind,
            shown(&expansion, definition.place)
        ));
        for used in expansion.index.symbols.uses_of(id) {
            lines.push_str(&format!(
                "  {:?} {}\n",
                used.kind,
                shown(&expansion, used.place)
            ));
        }
    }
    assert_eq!(lines, expected, "{lines}");
}

#[test]
fn names_refer_to_what_is_in_scope() {
    check_symbols(
        r#"//- a.xacro
<xacro:property name="width" value="2"/>
<xacro:arg name="side" default="left"/>
<xacro:macro name="wheel" params="r width:=^ *mount">
  <joint name="$(arg side)_${r}"><xacro:insert_block name="mount"/>${width + r}</joint>
</xacro:macro>
<xacro:wheel r="${2 * width}"><origin/></xacro:wheel>
<xacro:wheel r="1"><origin/></xacro:wheel>
"#,
        "Property a.xacro:2:23 width
  Read a.xacro:7:23 width
  Read a.xacro:4:37 width
Argument a.xacro:3:18 side
  Read a.xacro:5:22 side
Macro a.xacro:4:20 wheel
  Call a.xacro:7:8 wheel
  Call a.xacro:8:8 wheel
Parameter a.xacro:4:35 r
  Given a.xacro:7:14 r
  Read a.xacro:5:30 r
  Read a.xacro:5:78 r
  Given a.xacro:8:14 r
Parameter a.xacro:4:37 width
  Read a.xacro:5:70 width
BlockParameter a.xacro:4:47 mount
  Insert a.xacro:5:60 mount
",
    );
}

#[test]
fn names_of_another_file_are_found_through_its_namespace() {
    check_symbols(
        r#"//- a.xacro
<xacro:include filename="b.xacro" ns="arm"/>
<xacro:arm.link n="${arm.size}"/>
//- b.xacro
<xacro:property name="size" value="${1}"/>
<xacro:macro name="link" params="n"><link name="l${n}"/></xacro:macro>
"#,
        "Namespace a.xacro:2:39 arm
  Read a.xacro:3:8 arm
  Read a.xacro:3:22 arm
Property b.xacro:2:23 size
  Read a.xacro:3:26 size
Macro b.xacro:3:20 link
  Call a.xacro:3:12 link
Parameter b.xacro:3:34 n
  Given a.xacro:3:17 n
  Read b.xacro:3:52 n
",
    );
}

#[test]
fn what_nothing_calls_is_looked_into_and_changes_nothing() {
    let expansion = expanded(
        r#"//- a.xacro
<xacro:macro name="inner" params="x"><link name="${x}"/></xacro:macro>
<xacro:macro name="outer" params="x *block"><xacro:inner x="a_${x}"/>${missing}<xacro:insert_block name="block"/></xacro:macro>
"#,
    );
    assert!(
        expansion
            .tree
            .elements(expansion.tree.root().unwrap())
            .next()
            .is_none()
    );
    // `inner` is called by `outer`
    assert_eq!(expansion.index.probes.len(), 1);
    let probed: Vec<_> = expansion
        .problems
        .iter()
        .map(|p| (p.kind, p.probed, p.message.as_str()))
        .collect();
    assert_eq!(
        probed,
        [(
            expand::ProblemKind::UndefinedProperty,
            true,
            "property `missing` is not defined"
        )]
    );
}
