//! `xacro-lint`: the command line.

fn main() {}
