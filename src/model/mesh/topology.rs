//! How the triangles of a mesh hang together.

use super::bounds::Bounds;
use super::soup::{MeshPoint, Soup};
use base::FastMap;

/// Points nearer than this part of the greatest length are one.
const WELDING: f64 = 1e-6;

/// The edges of a mesh after points that lie together were made one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Edges {
    /// All different edges.
    pub total: usize,
    /// Edges of one triangle only.
    pub boundary: usize,
    /// Edges of two triangles that both run along them in the same direction: one of the two is turned.
    pub same_direction: usize,
    /// Edges of more than two triangles.
    pub non_manifold: usize,
    /// Whether every edge is run along as often in one direction as in the other: then the mesh encloses a volume.
    pub closed: bool,
}

impl Edges {
    /// The edges of triangles within `bounds`.
    pub(super) fn of(soup: &Soup, bounds: Bounds) -> Self {
        let welded = weld(&soup.points, bounds);
        let mut runs: Vec<u64> = Vec::with_capacity(soup.triangles.len() * 3);
        for triangle in &soup.triangles {
            let [a, b, c] =
                triangle.map(|index| welded.get(index as usize).copied().unwrap_or(index));
            // what has no area has no sides
            if a != b && b != c && a != c {
                runs.extend([(a, b), (b, c), (c, a)].map(run));
            }
        }
        runs.sort_unstable();
        let mut edges = Self {
            closed: !runs.is_empty(),
            ..Self::default()
        };
        for uses in runs.chunk_by(|a, b| a | 1 == b | 1) {
            let forward = uses.iter().filter(|&run| run & 1 == 1).count();
            let backward = uses.len() - forward;
            edges.total += 1;
            edges.closed &= forward == backward;
            edges.boundary += usize::from(uses.len() == 1);
            edges.non_manifold += usize::from(uses.len() > 2);
            edges.same_direction += usize::from(uses.len() == 2 && forward != backward);
        }
        edges
    }
}

/// A run along an edge as one number, which sorts several times faster than its three parts: the smaller point, the greater one,
/// and whether it runs from the smaller to the greater. A mesh has far fewer than 2^31 points: a file with so many is not read.
fn run((from, to): (u32, u32)) -> u64 {
    u64::from(from.min(to)) << 32 | u64::from(from.max(to)) << 1 | u64::from(from < to)
}

/// For each point the first point that lies together with it.
fn weld(points: &[MeshPoint], bounds: Bounds) -> Vec<u32> {
    let distance = bounds.extent() * WELDING;
    // in a grid of twice the distance, what is near lies in the cell or in those on the nearer sides
    let cell = (distance * 2.0).max(f64::MIN_POSITIVE);
    let mut grid: FastMap<[i64; 3], u32> = FastMap::default();
    let mut next: Vec<Option<u32>> = Vec::with_capacity(points.len());
    let mut welded = Vec::with_capacity(points.len());
    for (index, point) in (0u32..).zip(points) {
        let (home, sides) = place(*point, bounds.min, cell);
        let found = cells(home, sides).find_map(|cell| {
            let chain =
                std::iter::successors(grid.get(&cell).copied(), |&at| *next.get(at as usize)?);
            chain.into_iter().find(|&at| {
                points
                    .get(at as usize)
                    .is_some_and(|other| near(*other, *point, distance))
            })
        });
        welded.push(found.unwrap_or(index));
        next.push(None);
        if found.is_none() {
            let before = grid.insert(home, index);
            next.last_mut().into_iter().for_each(|slot| *slot = before);
        }
    }
    welded
}

/// The cell of a point, and along each axis the side on which the next cell is nearer.
fn place([x, y, z]: MeshPoint, [ox, oy, oz]: MeshPoint, cell: f64) -> ([i64; 3], [i64; 3]) {
    let (x, i) = place_along(x - ox, cell);
    let (y, j) = place_along(y - oy, cell);
    let (z, k) = place_along(z - oz, cell);
    ([x, y, z], [i, j, k])
}

/// The same along one axis.
fn place_along(distance: f64, cell: f64) -> (i64, i64) {
    let steps = distance / cell;
    let side = if steps - steps.floor() < 0.5 { -1 } else { 1 };
    (steps.floor() as i64, side)
}

fn cells([x, y, z]: [i64; 3], [i, j, k]: [i64; 3]) -> impl Iterator<Item = [i64; 3]> {
    (0..8i64).map(move |bits| {
        [
            x.saturating_add(i * (bits & 1)),
            y.saturating_add(j * (bits >> 1 & 1)),
            z.saturating_add(k * (bits >> 2 & 1)),
        ]
    })
}

fn near(a: MeshPoint, b: MeshPoint, distance: f64) -> bool {
    a.iter().zip(&b).all(|(a, b)| (a - b).abs() <= distance)
}
