//! Colors of the material libraries of OBJ.

use super::gltf::FileLoader;
use super::obj::logical_lines;
use base::FastMap;

/// Libraries that are read for one mesh.
const MOST_LIBRARIES: usize = 16;

/// The colors of materials by name.
#[derive(Debug, Default)]
pub(super) struct Colors {
    colors: FastMap<String, [f64; 4]>,
    libraries: usize,
}

impl Colors {
    /// Read the library that a mesh names; several may be named in one line.
    pub(super) fn read(&mut self, name: &str, beside: FileLoader<'_>) {
        let whole = beside(name).map(|bytes| vec![bytes]);
        let found = whole.unwrap_or_else(|| name.split_whitespace().filter_map(beside).collect());
        for bytes in found {
            self.libraries += 1;
            if self.libraries <= MOST_LIBRARIES {
                self.take(&String::from_utf8_lossy(&bytes));
            }
        }
    }

    /// The color of a material.
    pub(super) fn of(&self, name: &str) -> Option<[f64; 4]> {
        self.colors.get(name.trim()).copied()
    }

    fn take(&mut self, text: &str) {
        let mut name = None;
        for (_, line) in logical_lines(text) {
            let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((&line, ""));
            let mut numbers = rest
                .split_ascii_whitespace()
                .filter_map(|number| number.parse::<f64>().ok());
            if word == "newmtl" {
                name = Some(rest.trim().to_owned());
                continue;
            }
            let Some(name) = &name else { continue };
            match (word, numbers.next(), numbers.next(), numbers.next()) {
                ("Kd", Some(r), Some(g), Some(b)) => {
                    let known = self
                        .colors
                        .entry(name.clone())
                        .or_insert([0.0, 0.0, 0.0, 1.0]);
                    *known = [r, g, b, known[3]];
                }
                ("d", Some(opacity), ..) => {
                    let [.., known] = self
                        .colors
                        .entry(name.clone())
                        .or_insert([0.72, 0.74, 0.78, 1.0]);
                    *known = opacity;
                }
                _ => {}
            }
        }
    }
}
