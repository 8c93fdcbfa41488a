//! Small meshes for tests, from a few words.

type Point = [f64; 3];

/// A binary STL: `box SIDE`, `block X Y Z` or `sphere RADIUS RINGS`, perhaps `at X Y Z` and `times FACTOR`, then any of `open` (a side is missing), `inverted` (inside
/// out), `flipped` (one triangle is turned), `solid` (the header says so) and `cut` (the end is missing).
pub fn binary_stl(recipe: &str) -> Vec<u8> {
    let words: Vec<&str> = recipe.split(' ').collect();
    let number = |place: usize| -> f64 { words[place].parse().unwrap() };
    let three = |place: usize| [number(place), number(place + 1), number(place + 2)];
    let mut triangles = match words[0] {
        "box" => block([number(1); 3]),
        "block" => block(three(1)),
        "sphere" => sphere(number(1), number(2) as usize),
        other => panic!("no shape `{other}`"),
    };
    let wants = |word| words.contains(&word);
    let behind = |word| {
        words
            .iter()
            .position(|other| *other == word)
            .map(|place| place + 1)
    };
    let at = behind("at").map_or([0.0; 3], three);
    let times = behind("times").map_or(1.0, number);
    for point in triangles.iter_mut().flatten() {
        *point = [0, 1, 2].map(|axis| (point[axis] + at[axis]) * times);
    }
    if wants("open") {
        triangles.truncate(triangles.len() - 2);
    }
    let turned = if wants("inverted") {
        triangles.len()
    } else {
        usize::from(wants("flipped"))
    };
    triangles[..turned]
        .iter_mut()
        .for_each(|triangle| triangle.swap(1, 2));
    let mut bytes = if wants("solid") {
        b"solid part".to_vec()
    } else {
        b"part".to_vec()
    };
    bytes.resize(80, 0);
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        bytes.extend([0; 12]);
        bytes.extend(
            triangle
                .iter()
                .flatten()
                .flat_map(|number| (*number as f32).to_le_bytes()),
        );
        bytes.extend([0; 2]);
    }
    bytes.truncate(bytes.len() - if wants("cut") { 20 } else { 0 });
    bytes
}

fn block(size: [f64; 3]) -> Vec<[Point; 3]> {
    let half = size.map(|side| side / 2.0);
    let corner = |i: usize| {
        [0, 1, 2].map(|axis| {
            if i >> axis & 1 == 1 {
                half[axis]
            } else {
                -half[axis]
            }
        })
    };
    let sides = [
        [0, 2, 3, 1],
        [0, 1, 5, 4],
        [1, 3, 7, 5],
        [3, 2, 6, 7],
        [2, 0, 4, 6],
        [4, 5, 7, 6],
    ];
    sides
        .iter()
        .flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]])
        .map(|side| side.map(corner))
        .collect()
}

/// Twice `rings` times one less than `rings` triangles.
fn sphere(radius: f64, rings: usize) -> Vec<[Point; 3]> {
    let point = |ring: usize, step: usize| {
        let polar = std::f64::consts::PI * ring as f64 / rings as f64;
        let around = std::f64::consts::TAU * (step % rings) as f64 / rings as f64;
        let at_pole = ring == 0 || ring == rings;
        let width = if at_pole { 0.0 } else { polar.sin() };
        [width * around.cos(), width * around.sin(), polar.cos()].map(|part| part * radius)
    };
    let mut triangles = Vec::new();
    for (ring, step) in (0..rings).flat_map(|ring| (0..rings).map(move |step| (ring, step))) {
        let (a, b) = (point(ring, step), point(ring, step + 1));
        let (c, d) = (point(ring + 1, step), point(ring + 1, step + 1));
        if ring > 0 {
            triangles.push([a, d, b]);
        }
        if ring + 1 < rings {
            triangles.push([a, c, d]);
        }
    }
    triangles
}
