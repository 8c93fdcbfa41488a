//! What must hold for every input, tried on a bounded number of changed seeds: the functions of
//! `tests/fuzz/harness`, which the targets of cargo-fuzz try for longer, and the inputs that once made them fail.
//!
//! `SEEDS=FOLDER cargo test --test properties seeds` writes the seeds for cargo-fuzz; `ROUNDS=N` tries more.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

#[path = "fuzz/harness/mod.rs"]
mod harness;
#[path = "properties/seeds.rs"]
mod seeds;

use std::fs;
use std::path::Path;

use harness::{TARGETS, Target, target};

/// Inputs tried by each test.
const ROUNDS: usize = 400;

/// Numbers that look random and are the same in every run.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, below: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        ((self.0 >> 33) % below.max(1) as u64) as usize
    }
}

/// A seed with some changes: bytes turned, pieces cut, doubled, moved, words of the languages thrown in.
fn changed(seeds: &[Vec<u8>], words: &[&str], dice: &mut Dice) -> Vec<u8> {
    let mut input = seeds[dice.roll(seeds.len())].clone();
    for _ in 0..dice.roll(6) {
        let start = dice.roll(input.len() + 1);
        let end = (start + 1 + dice.roll(30)).min(input.len());
        match dice.roll(7) {
            0 if start < input.len() => input[start] ^= 1 << dice.roll(8),
            1 => drop(input.drain(start.min(end)..end)),
            2 => {
                let piece = input[start.min(end)..end].to_vec();
                input.splice(start..start, piece);
            }
            3 => {
                let other = &seeds[dice.roll(seeds.len())];
                let from = dice.roll(other.len() + 1);
                let piece = other[from..(from + dice.roll(200)).min(other.len())].to_vec();
                input.splice(start..start, piece);
            }
            4 => input.truncate(start),
            _ => {
                input.splice(start..start, words[dice.roll(words.len())].bytes());
            }
        }
    }
    input
}

fn rounds() -> usize {
    std::env::var("ROUNDS")
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(ROUNDS)
}

fn try_out(name: &str) {
    let target: &Target = target(name);
    let seeds = seeds::of(target);
    assert!(!seeds.is_empty(), "{name} has no seeds");
    for seed in &seeds {
        (target.run)(seed);
    }
    let words = seeds::words();
    let mut dice = Dice(name.len() as u64);
    for _ in 0..rounds() {
        let input = changed(&seeds, &words, &mut dice);
        let outcome = std::panic::catch_unwind(|| (target.run)(&input));
        assert!(
            outcome.is_ok(),
            "{name}: {:?}",
            String::from_utf8_lossy(&input)
        );
    }
}

macro_rules! properties {
    ($($name:ident)*) => {
        $(#[test] fn $name() { try_out(stringify!($name)); })*

        #[test]
        fn every_target_is_tried() {
            let tried = [$(stringify!($name)),*];
            assert_eq!(TARGETS.iter().map(|target| target.name).collect::<Vec<_>>(), tried);
            for name in tried {
                let file = format!("tests/fuzz/fuzz_targets/{name}.rs");
                assert!(Path::new(env!("CARGO_MANIFEST_DIR")).join(&file).is_file(), "{file} is missing");
            }
        }
    };
}

properties! { xml edits formatter expression yaml expander fixes mesh configuration launch
launch_requests messages }

/// Inputs that made a function fail once; `tests/fuzz/regressions/TARGET-WHAT`.
#[test]
fn what_failed_once() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fuzz/regressions");
    let mut tried = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        let (name, _) = name
            .split_once('-')
            .unwrap_or_else(|| panic!("{name}: no target"));
        (target(name).run)(&fs::read(&path).unwrap());
        tried += 1;
    }
    assert!(tried > 0);
}

#[test]
fn seeds_for_the_fuzzer() {
    let Some(folder) = std::env::var_os("SEEDS") else {
        assert!(TARGETS.iter().all(|target| seeds::of(target).len() > 1));
        return;
    };
    for target in TARGETS {
        let folder = Path::new(&folder).join(target.name);
        fs::create_dir_all(&folder).unwrap();
        for (number, seed) in seeds::of(target).iter().enumerate() {
            fs::write(folder.join(format!("seed-{number}")), seed).unwrap();
        }
    }
    let words = seeds::words().into_iter().map(|word| {
        let bytes = word.bytes().map(|byte| format!("\\x{byte:02x}"));
        format!("\"{}\"\n", bytes.collect::<String>())
    });
    fs::write(
        Path::new(&folder).join("words.dict"),
        words.collect::<String>(),
    )
    .unwrap();
}

/// A table of `python_oracle.py`: what Python makes of random expressions is what we make of them.
///
/// `TABLE=FILE` names the table; without it the one that is stored is tried.
#[test]
fn python() {
    let stored = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fuzz/python.txt");
    let path = std::env::var_os("TABLE").map_or(stored, Into::into);
    let table = fs::read_to_string(path).unwrap();
    let mut differ = Vec::new();
    for line in table.lines() {
        let (text, expected) = line.split_once('\t').unwrap();
        let got = harness::outcome(text);
        // limits of ours are no difference, nor is what is not supported and says so
        let ours = got.as_ref().is_none_or(|got| got == expected);
        if !ours {
            differ.push(format!(
                "{text}\n  python: {expected}\n  ours:   {}",
                got.unwrap_or_default()
            ));
        }
    }
    let count = table.lines().count();
    assert!(
        count > 0 && differ.is_empty(),
        "{} of {count} differ:\n{}",
        differ.len(),
        differ.join("\n")
    );
}
