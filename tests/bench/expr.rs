//! What an expression and a text cost to understand. Compare the lines with each other, not with
//! other machines.

use divan::Bencher;
use xacro_lsp::expr;

/// As they stand in robot descriptions.
const EXPRESSIONS: &[&str] = &[
    "x",
    "wheel_radius*2",
    "-wheel_separation/2",
    "2*pi/3 - 0.1",
    "(1/12) * mass * (y*y + z*z)",
    "prefix + 'base_link'",
    "'left' if reflect > 0 else 'right'",
    "xacro.load_yaml(config_file)['joints']['shoulder'].lower",
    "limits['shoulder_pan']['max_position'] * scale",
    "index in [1, 2, 3]",
    "not simulation and side is not None",
    "[i * 2 for i in range(4)]",
    "' '.join([str(v) for v in origin])",
    "values[i:i+3]",
];

/// All of [`EXPRESSIONS`]; divide by their number.
#[divan::bench]
fn typical_expressions(bencher: Bencher<'_, '_>) {
    bencher.counter(EXPRESSIONS.len()).bench(|| {
        for text in EXPRESSIONS {
            divan::black_box(expr::parse(divan::black_box(text)));
        }
    });
}

#[divan::bench(args = EXPRESSIONS)]
fn expression(text: &str) -> expr::Parsed {
    expr::parse(text)
}

/// Time must grow with the length, not faster.
#[divan::bench(args = [100, 1_000, 10_000])]
fn long_list(bencher: Bencher<'_, '_>, items: usize) {
    let text = format!("[{}]", "a.b * 2 + f(c, d='x'), ".repeat(items));
    bencher
        .counter(items)
        .bench(|| expr::parse(divan::black_box(&text)));
}

/// The same for text that is wrong everywhere.
#[divan::bench(args = [100, 1_000, 10_000])]
fn long_nonsense(bencher: Bencher<'_, '_>, items: usize) {
    let text = "(a b ] + 'x 0777 {: ".repeat(items);
    bencher
        .counter(items)
        .bench(|| expr::parse(divan::black_box(&text)));
}

#[divan::bench(args = ["1.5 0 -0.25", "${prefix}wheel_${side}_link", "$(find pkg)/urdf/${name}.xacro", "${a * 2} 0 ${b / 2}"])]
fn template(text: &str) -> expr::Template {
    expr::split(text)
}

fn main() {
    divan::main();
}
