//! Speed of the parser: whole files against roxmltree, single edits in small and large files.

use divan::counter::BytesCount;
use divan::{Bencher, black_box};
use xacro_lsp::base::{Encoding, LineCol, TextRange};
use xacro_lsp::xml::Document;

fn main() {
    divan::main();
}

/// Xacro as people write it, about `size` bytes long.
fn xacro(size: usize) -> String {
    let mut text = String::from(
        "<?xml version=\"1.0\"?>\n<!-- A robot. -->\n<robot name=\"bench\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n\n  \
         <xacro:arg name=\"prefix\" default=\"\"/>\n  <xacro:property name=\"wheel_radius\" value=\"0.0825\"/>\n",
    );
    let mut n = 0;
    while text.len() < size {
        text.push_str(&format!(
            "\n  <!-- Part number {n}: carries the next one. -->\n  <xacro:property name=\"length_{n}\" value=\"${{0.25 + {n} * wheel_radius}}\"/>\n  \
             <link name=\"$(arg prefix)link_{n}\">\n    <inertial>\n      <origin xyz=\"0 0 ${{length_{n} / 2}}\" rpy=\"0 0 0\"/>\n      \
             <mass value=\"${{2.5 * length_{n}}}\"/>\n      <inertia ixx=\"0.01\" ixy=\"0.0\" ixz=\"0.0\" iyy=\"0.01\" iyz=\"0.0\" izz=\"0.01\"/>\n    \
             </inertial>\n    <visual>\n      <origin xyz=\"0 0 0\" rpy=\"0 ${{pi / 2}} 0\"/>\n      <geometry>\n        \
             <mesh filename=\"package://bench_description/meshes/visual/link_{n}.dae\" scale=\"0.001 0.001 0.001\"/>\n      </geometry>\n      \
             <material name=\"grey\"/>\n    </visual>\n    <collision>\n      <geometry>\n        <cylinder radius=\"${{wheel_radius}}\" \
             length=\"${{length_{n}}}\"/>\n      </geometry>\n    </collision>\n  </link>\n\n  <joint name=\"$(arg prefix)joint_{n}\" type=\"revolute\">\n    \
             <parent link=\"$(arg prefix)link_{n}\"/>\n    <child link=\"$(arg prefix)link_{next}\"/>\n    <axis xyz=\"0 0 1\"/>\n    \
             <limit lower=\"-3.14\" upper=\"3.14\" effort=\"150\" velocity=\"${{radians(180)}}\"/>\n  </joint>\n  \
             <xacro:sensor_block name=\"s_{n}\" parent=\"link_{n}\">\n    <origin xyz=\"0.1 0 0\" rpy=\"0 0 0\"/>\n  </xacro:sensor_block>\n",
            next = n + 1
        ));
        n += 1;
    }
    text.push_str("</robot>\n");
    text
}

const SIZES: [usize; 4] = [10_000, 100_000, 1_000_000, 5_000_000];

#[divan::bench(args = SIZES)]
fn parse(bencher: Bencher<'_, '_>, size: usize) {
    let text = xacro(size);
    bencher
        .counter(BytesCount::of_str(&text))
        .bench_local(|| Document::parse(black_box(&text)));
}

#[divan::bench(args = SIZES)]
fn parse_and_check(bencher: Bencher<'_, '_>, size: usize) {
    let text = xacro(size);
    bencher
        .counter(BytesCount::of_str(&text))
        .bench_local(|| Document::parse(black_box(&text)).errors());
}

#[divan::bench(args = SIZES)]
fn parse_roxmltree(bencher: Bencher<'_, '_>, size: usize) {
    let text = xacro(size);
    bencher
        .counter(BytesCount::of_str(&text))
        .bench_local(|| drop(black_box(roxmltree::Document::parse(black_box(&text)))));
}

/// One character typed in the middle, as a language server sees it: position to offset, edit, errors, offset
/// to position.
#[divan::bench(args = [10_000, 50_000, 500_000, 5_000_000])]
fn edit(bencher: Bencher<'_, '_>, size: usize) {
    let text = xacro(size);
    let middle = text[text.len() / 2..]
        .find("ixx=\"")
        .map_or(0, |at| text.len() / 2 + at + 5);
    let mut document = Document::parse(&text);
    let position = document.line_col(middle as u32, Encoding::Utf16);
    let mut typed = false;
    bencher.bench_local(move || {
        let start = document.offset(black_box(position), Encoding::Utf16);
        let (end, letter) = if typed { (start + 1, "") } else { (start, "7") };
        typed = !typed;
        document.edit(TextRange::new(start, end), letter);
        let errors = document.errors();
        let place = document.line_col(start + 1, Encoding::Utf16);
        (errors, place)
    });
}

/// The same while a snapshot of every revision is held, as the analysis of the last keystroke does.
#[divan::bench(args = [10_000, 50_000, 500_000, 5_000_000])]
fn edit_with_snapshot(bencher: Bencher<'_, '_>, size: usize) {
    let text = xacro(size);
    let middle = text[text.len() / 2..]
        .find("ixx=\"")
        .map_or(0, |at| text.len() / 2 + at + 5) as u32;
    let mut document = Document::parse(&text);
    let mut snapshot = document.clone();
    let mut typed = false;
    bencher.bench_local(|| {
        let (end, letter) = if typed {
            (middle + 1, "")
        } else {
            (middle, "7")
        };
        typed = !typed;
        document.edit(TextRange::new(middle, end), letter);
        snapshot = document.clone();
        snapshot.len()
    });
}

/// A position in the middle of the file to an offset and back.
#[divan::bench(args = [50_000, 5_000_000])]
fn positions(bencher: Bencher<'_, '_>, size: usize) {
    let document = Document::parse(&xacro(size));
    let line = document.line_count() / 2;
    bencher.bench_local(|| {
        let offset = document.offset(black_box(LineCol { line, col: 7 }), Encoding::Utf16);
        document.line_col(offset, Encoding::Utf16)
    });
}
