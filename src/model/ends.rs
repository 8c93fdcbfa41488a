//! Which joints end at the links of a name. Names that are not known for sure count as they stand, unlike in
//! [`Kinematics`](super::kinematics::Kinematics).
use ecow::EcoString;

use super::robot::Robot;
use base::FastMap;

/// Links by name, and joints by the links that they name.
#[derive(Debug, Default)]
pub(super) struct Ends {
    /// Links by their name.
    pub(super) links: Chains,
    /// Joints by their name.
    pub(super) joints: Chains,
    /// Joints by the name of their child.
    pub(super) above: Chains,
    /// Joints by the name of their parent.
    pub(super) below: Chains,
}

impl Ends {
    pub(super) fn of(robot: &Robot) -> Self {
        let links = robot.links.iter().map(|link| {
            let name = link.name.as_ref().map(|name| name.value.clone());
            Some(name.unwrap_or_default())
        });
        let name = |joint: &super::Joint| Some(joint.name.as_ref()?.value.clone());
        let child = |joint: &super::Joint| Some(joint.child.as_ref()?.value.clone());
        let parent = |joint: &super::Joint| Some(joint.parent.as_ref()?.value.clone());
        Self {
            links: Chains::of(links),
            joints: Chains::of(robot.joints.iter().map(name)),
            above: Chains::of(robot.joints.iter().map(child)),
            below: Chains::of(robot.joints.iter().map(parent)),
        }
    }
}

/// Indices by name. The first of a name leads to the others, so that no name needs a list of its own.
#[derive(Debug, Default)]
pub(super) struct Chains {
    first: FastMap<EcoString, u32>,
    next: Vec<Option<u32>>,
}

impl Chains {
    fn of(names: impl DoubleEndedIterator<Item = Option<EcoString>> + ExactSizeIterator) -> Self {
        let mut first = FastMap::default();
        first.reserve(names.len());
        let mut next = vec![None; names.len()];
        // from the back: what is inserted last is the first of its name
        for ((index, name), slot) in names.enumerate().rev().zip(next.iter_mut().rev()) {
            let index = u32::try_from(index).ok();
            *slot = name
                .zip(index)
                .and_then(|(name, index)| first.insert(name, index));
        }
        Self { first, next }
    }

    /// The indices of a name, in order.
    pub(super) fn named(&self, name: &str) -> impl Iterator<Item = usize> + Clone {
        let first = self.first.get(name).copied();
        let next = |&index: &u32| self.next.get(index as usize).copied().flatten();
        std::iter::successors(first, next).map(|index| index as usize)
    }
}
