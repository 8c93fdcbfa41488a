//! Whether two robots are the same but for names.

use std::collections::{BTreeMap, BTreeSet};

use roxmltree::Node;

use super::canonical::parsed;

/// The attributes that name a link, joint, material or planning group: element, attribute, what it names.
const SLOTS: [(&str, &str, &[RenamedKind]); 22] = [
    ("link", "name", &[RenamedKind::Link]),
    ("joint", "name", &[RenamedKind::Joint]),
    ("parent", "link", &[RenamedKind::Link]),
    ("child", "link", &[RenamedKind::Link]),
    ("mimic", "joint", &[RenamedKind::Joint]),
    ("material", "name", &[RenamedKind::Material]),
    (
        "gazebo",
        "reference",
        &[RenamedKind::Link, RenamedKind::Joint],
    ),
    // of SRDF
    ("chain", "base_link", &[RenamedKind::Link]),
    ("chain", "tip_link", &[RenamedKind::Link]),
    ("disable_collisions", "link1", &[RenamedKind::Link]),
    ("disable_collisions", "link2", &[RenamedKind::Link]),
    ("disable_default_collisions", "link", &[RenamedKind::Link]),
    ("enable_collisions", "link1", &[RenamedKind::Link]),
    ("enable_collisions", "link2", &[RenamedKind::Link]),
    ("end_effector", "group", &[RenamedKind::Group]),
    ("end_effector", "parent_group", &[RenamedKind::Group]),
    ("end_effector", "parent_link", &[RenamedKind::Link]),
    ("group", "name", &[RenamedKind::Group]),
    ("group_state", "group", &[RenamedKind::Group]),
    ("passive_joint", "name", &[RenamedKind::Joint]),
    ("virtual_joint", "child_link", &[RenamedKind::Link]),
    ("virtual_joint", "name", &[RenamedKind::Joint]),
];

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum RenamedKind {
    Link,
    Joint,
    Material,
    Group,
}

/// What is different in two expanded robots beside names in which `old` became `new`: names of links, joints and materials, and
/// those that follow them, as that of a transmission. None: nothing is. Every use of a name has to follow it, and no two names may
/// become one.
pub fn other_difference(before: &str, after: &str, old: &str, new: &str) -> Option<String> {
    let (Some(one), Some(other)) = (parsed(before), parsed(after)) else {
        return (before != after).then(|| "the robot cannot be compared".to_owned());
    };
    let mut names = NameMap::default();
    let mut others = other.descendants().filter(Node::is_element);
    for a in one.descendants().filter(Node::is_element) {
        let Some(b) = others.next().filter(|b| is_alike(&a, b)) else {
            return Some(format!("`<{}>` would differ", a.tag_name().name()));
        };
        if let Some(found) = names
            .attributes(&a, &b, old, new)
            .or_else(|| names.texts(&a, &b, old, new))
        {
            return Some(found);
        }
    }
    if others.next().is_some() {
        return Some("there would be more elements".to_owned());
    }
    names.conflict()
}

/// Whether two elements have the same tag, the same attributes and as many elements inside.
fn is_alike(a: &Node<'_, '_>, b: &Node<'_, '_>) -> bool {
    a.tag_name() == b.tag_name()
        && element_count(a) == element_count(b)
        && a.attributes().len() == b.attributes().len()
        && a.attributes()
            .zip(b.attributes())
            .all(|(a, b)| a.name() == b.name())
}

/// How many elements stand directly in a node.
fn element_count(node: &Node<'_, '_>) -> usize {
    node.children().filter(Node::is_element).count()
}

/// What names became.
#[derive(Default)]
struct NameMap<'a> {
    became: BTreeMap<(RenamedKind, &'a str), Vec<&'a str>>,
    /// References to a link or a joint, which may be either: what each was and is.
    either: Vec<(&'a str, &'a str)>,
    /// Contents of elements that are different: what each was and is.
    contents: Vec<(&'a str, &'a str)>,
    /// Contents of elements that stay, such as the links of a joint for Gazebo.
    kept: BTreeSet<&'a str>,
}

impl<'a> NameMap<'a> {
    /// The first attribute that is different and is no name.
    fn attributes(
        &mut self,
        a: &Node<'a, '_>,
        b: &Node<'a, '_>,
        old: &str,
        new: &str,
    ) -> Option<String> {
        let tag = a.tag_name().name();
        for (one, other) in a.attributes().zip(b.attributes()) {
            let (was, is) = (one.value(), other.value());
            let slot = SLOTS
                .iter()
                .find(|(element, name, _)| *element == tag && *name == one.name());
            match slot {
                Some((_, _, [kind])) => self.add(*kind, was, is),
                Some(_) => self.either.push((was, is)),
                None => {}
            }
            let is_name = slot.is_some() || one.name() == "name";
            if was != is && !(is_name && becomes(was, is, old, new)) {
                return Some(format!("`{}` of `<{tag}>` would be `{is}`", one.name()));
            }
        }
        None
    }

    /// The first text in an element that is different and cannot be a name. Which names there are is known in the end.
    fn texts(
        &mut self,
        a: &Node<'a, '_>,
        b: &Node<'a, '_>,
        old: &str,
        new: &str,
    ) -> Option<String> {
        let (was, is) = (
            a.text().unwrap_or_default().trim(),
            b.text().unwrap_or_default().trim(),
        );
        if was == is {
            self.kept.insert(was);
            return None;
        }
        self.contents.push((was, is));
        (!becomes(was, is, old, new))
            .then(|| format!("`<{}>` would hold `{is}`", a.tag_name().name()))
    }

    fn add(&mut self, kind: RenamedKind, was: &'a str, is: &'a str) {
        let known = self.became.entry((kind, was)).or_default();
        if !known.contains(&is) {
            known.push(is);
        }
    }

    /// A name that would be another one in some places only, or that of two things.
    fn conflict(&self) -> Option<String> {
        let mut taken: BTreeMap<(RenamedKind, &str), &str> = BTreeMap::new();
        for ((kind, was), became) in &self.became {
            let [is] = became.as_slice() else {
                return Some(format!("`{was}` would keep its name in places"));
            };
            if taken.insert((*kind, is), was).is_some() {
                return Some(format!("`{is}` would be the name of two"));
            }
        }
        if let Some((was, _)) = self.either.iter().find(|(was, is)| !self.fits(was, is)) {
            return Some(format!("`{was}` would keep its name in places"));
        }
        // whoever reads such an element looks for what has another name now
        let is_left = |was: &&&str| {
            self.link_and_joint(was)
                .into_iter()
                .flatten()
                .any(|is| is != **was)
        };
        if let Some(was) = self.kept.iter().find(is_left) {
            return Some(format!("`{was}` would keep its name in places"));
        }
        let (_, is) = self
            .contents
            .iter()
            .find(|(was, is)| !self.link_and_joint(was).contains(&Some(is)))?;
        Some(format!("an element would hold `{is}`"))
    }

    /// Whether a reference to a link or a joint that was `was` may be `is`.
    fn fits(&self, was: &str, is: &str) -> bool {
        let became = self.link_and_joint(was);
        became.contains(&Some(is)) || was == is && became == [None; 2]
    }

    /// What the link and the joint of a name are called now.
    fn link_and_joint(&self, was: &str) -> [Option<&'a str>; 2] {
        [RenamedKind::Link, RenamedKind::Joint]
            .map(|kind| self.became.get(&(kind, was))?.first().copied())
    }
}

/// Whether a text becomes another one when `old` is replaced by `new`, in some places or in all.
fn becomes(was: &str, is: &str, old: &str, new: &str) -> bool {
    let mut open = vec![(was, is)];
    let mut seen = BTreeSet::new();
    while let Some((was, is)) = open.pop() {
        if was == is {
            return true;
        }
        if !seen.insert((was.len(), is.len())) {
            continue;
        }
        let replaced = was
            .strip_prefix(old)
            .filter(|_| !old.is_empty())
            .zip(is.strip_prefix(new));
        open.extend(replaced);
        let (mut one, mut other) = (was.chars(), is.chars());
        if let (Some(a), Some(b)) = (one.next(), other.next())
            && a == b
        {
            open.push((one.as_str(), other.as_str()));
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::{becomes, other_difference};

    fn robot(link: &str, parent: &str, more: &str) -> String {
        format!(
            "<robot><link name=\"{link}\"/><link name=\"🤖\"/><joint name=\"j\"><parent link=\"{parent}\"/>\
             <child link=\"🤖\"/></joint>{more}</robot>"
        )
    }

    #[track_caller]
    fn check(before: (&str, &str, &str), after: (&str, &str, &str), expected: Option<&str>) {
        let text = |(link, parent, more)| robot(link, parent, more);
        let found = other_difference(&text(before), &text(after), "base", "root");
        assert_eq!(found.as_deref(), expected);
    }

    #[test]
    fn all_uses_of_a_name_follow_it() {
        check(("base_l", "base_l", ""), ("root_l", "root_l", ""), None);
        check(
            ("base_l", "base_l", ""),
            ("root_l", "base_l", ""),
            Some("`base_l` would keep its name in places"),
        );
        check(
            ("base", "base", ""),
            ("🤖", "🤖", ""),
            Some("`name` of `<link>` would be `🤖`"),
        );
        let (one, other) = (
            "<gazebo reference=\"base\"/>",
            "<gazebo reference=\"root\"/>",
        );
        check(("base", "base", one), ("root", "root", other), None);
        check(
            ("base", "base", one),
            ("root", "root", one),
            Some("`base` would keep its name in places"),
        );
    }

    #[test]
    fn nothing_else_follows_a_name() {
        let mesh = |name: &str| format!("<mesh filename=\"{name}.stl\"/>");
        let found = Some("`filename` of `<mesh>` would be `root.stl`");
        check(
            ("base", "base", &mesh("base")),
            ("root", "root", &mesh("root")),
            found,
        );
        let frame = |name: &str| {
            format!(
                "<gazebo><plugin name=\"{name}_p\"><frameName>{name}</frameName></plugin></gazebo>"
            )
        };
        check(
            ("base", "base", &frame("base")),
            ("root", "root", &frame("root")),
            None,
        );
        let left = Some("`base` would keep its name in places");
        let joined = "<gazebo><joint><child>base</child></joint></gazebo>";
        check(("base", "base", joined), ("root", "root", joined), left);
        check(
            ("base", "base", &frame("base_t")),
            ("root", "root", &frame("root_t")),
            Some("an element would hold `root_t`"),
        );
        check(
            ("base", "base", ""),
            ("root", "root", "<link name=\"x\"/>"),
            Some("`<robot>` would differ"),
        );
    }

    #[test]
    fn texts_with_parts_replaced() {
        assert!(becomes("a_b_a", "c_b_a", "a", "c") && becomes("aa", "aaaa", "a", "aa"));
        assert!(!becomes("a_b", "c_d", "a", "c") && !becomes("ab", "a", "", "x"));
    }
}
