//! Rules that look at one element at a time. Of each child of the root, all of them are asked before the next child, and
//! what is known of children from before an edit is not asked again: see [`Settled`].
use super::chosen::Chosen;
use super::context::DocumentCx;
use super::frames::{self, ElementPose};
use super::rule::{Check, Rule};
use super::settled::{Known, OpenRules, Settled, SettledStep, Steps};
use super::sink::Sink;
use super::watch::Beyond;
use super::xml::{self, CheckedElement, Numeric};
use base::FastMap;
use expand::{XId, XKind, XTree};
use model::{Joint, Link, SharedList};

/// A rule with its place among those that run, and what it does.
type Asked<F> = Vec<(u16, &'static Rule, F)>;

/// The rules about single elements, by what they look at.
#[derive(Default)]
pub(super) struct Visitors {
    elements: Asked<fn(&DocumentCx<'_>, &CheckedElement, &mut Sink<'_>)>,
    numbers: Asked<fn(&DocumentCx<'_>, &Numeric, &mut Sink<'_>)>,
    links: Asked<fn(&DocumentCx<'_>, &Link, &mut Sink<'_>)>,
    joints: Asked<fn(&DocumentCx<'_>, &Joint, &mut Sink<'_>)>,
    poses: Asked<fn(&DocumentCx<'_>, &ElementPose<'_>, &mut Sink<'_>)>,
}

impl Visitors {
    /// Those among the rules that run on a document, of which everything is there or not; all, or those at some places.
    fn of(rules: &[&'static Rule], complete: bool, places: Option<&[u16]>) -> Self {
        let mut visitors = Self::default();
        let rules = (0..).zip(rules.iter().copied());
        for (place, rule) in
            rules.filter(|(place, _)| places.is_none_or(|places| places.contains(place)))
        {
            match rule.check {
                Check::Element(check) => visitors.elements.push((place, rule, check)),
                Check::WholeElement(check) if complete => {
                    visitors.elements.push((place, rule, check));
                }
                Check::Number(check) => visitors.numbers.push((place, rule, check)),
                Check::Link(check) => visitors.links.push((place, rule, check)),
                Check::Joint(check) => visitors.joints.push((place, rule, check)),
                Check::Pose(check) => visitors.poses.push((place, rule, check)),
                _ => {}
            }
        }
        visitors
    }
}

/// Ask about all elements of a document, but not what is known from before; what is known now.
pub(super) fn visit(
    cx: &DocumentCx<'_>,
    chosen: Chosen<'_>,
    before: &Settled,
    sink: &mut Sink<'_>,
) -> Settled {
    let mut settled = Settled::on(cx, chosen.rules);
    let mut known = Known::of(before, &settled);
    let mut steps = Steps::of(cx);
    let all = Visitors::of(chosen.rules, cx.complete, None);
    let mut some: FastMap<&OpenRules, Visitors> = FastMap::default();
    let mut lists: FastMap<Vec<u16>, OpenRules> = FastMap::default();
    let root = xml::root_element(cx);
    let mut visit = Visit {
        cx,
        root: &root,
        sink,
        open: Vec::new(),
        beyond: Beyond::default(),
    };
    visit.element(&all, &root);
    let mut children = Children::of(cx);
    for (step, elements) in cx.steps() {
        children.run_until(Some(elements.start), |child| visit.child(&all, child));
        let known_step = known.step(step);
        let said = known_step.and_then(|known| known.said.as_ref());
        if let Some((known_step, said)) = known_step.zip(said)
            && known.holds(said, &steps)
        {
            for finding in &said.findings {
                visit.sink.report_again(finding);
            }
            children.skip_until(elements.end);
            settled.add(step, known_step.clone());
            continue;
        }
        let visitors = known_step.map(|known| {
            let of_these = || Visitors::of(chosen.rules, cx.complete, Some(&*known.open));
            &*some.entry(&known.open).or_insert_with(of_these)
        });
        visit.start();
        children.run_until(Some(elements.end), |child| {
            visit.child(visitors.unwrap_or(&all), child);
        });
        let said = steps.said(step, &visit.beyond, visit.sink.take_kept());
        let open = match lists.get(&visit.open) {
            Some(list) => list.clone(),
            None => {
                let list = OpenRules::from(visit.open.as_slice());
                lists.entry(visit.open.clone()).or_insert(list).clone()
            }
        };
        settled.add(step, SettledStep { open, said });
        if chosen.cancel.is_cancelled() {
            return settled;
        }
    }
    children.run_until(None, |child| visit.child(&all, child));
    settled
}

/// Who is asked about what, and what they say.
struct Visit<'v, 'a, 's> {
    cx: &'v DocumentCx<'a>,
    root: &'v CheckedElement,
    sink: &'v mut Sink<'s>,
    /// The rules that found something, or looked at something else to know.
    open: Vec<u16>,
    /// What they looked at.
    beyond: Beyond,
}

impl Visit<'_, '_, '_> {
    /// A step begins.
    fn start(&mut self) {
        self.open.clear();
        self.beyond = Beyond::default();
        self.sink.start_keeping();
    }

    /// Ask about a child of the root and all that is in it.
    fn child(&mut self, visitors: &Visitors, child: Child<'_>) {
        if !(visitors.elements.is_empty() && visitors.numbers.is_empty()) {
            let (cx, root) = (self.cx, self.root);
            xml::each_below(cx, root, child.id, |element| {
                self.element(visitors, element)
            });
        }
        if let Some(link) = child.link {
            self.each(&visitors.links, |check, cx, sink| check(cx, link, sink));
            for pose in frames::poses_of_link(link) {
                self.each(&visitors.poses, |check, cx, sink| check(cx, &pose, sink));
            }
        }
        if let Some(joint) = child.joint {
            self.each(&visitors.joints, |check, cx, sink| check(cx, joint, sink));
            if let Some(pose) = frames::pose_of_joint(joint) {
                self.each(&visitors.poses, |check, cx, sink| check(cx, &pose, sink));
            }
        }
    }

    fn element(&mut self, visitors: &Visitors, element: &CheckedElement) {
        self.each(&visitors.elements, |check, cx, sink| {
            check(cx, element, sink)
        });
        if !visitors.numbers.is_empty() {
            xml::each_number(self.cx, element, |number| {
                self.each(&visitors.numbers, |check, cx, sink| check(cx, number, sink));
            });
        }
    }

    fn each<F: Copy>(&mut self, asked: &Asked<F>, ask: impl Fn(F, &DocumentCx<'_>, &mut Sink<'_>)) {
        for &(place, rule, check) in asked {
            self.sink.set_rule(rule);
            let found = self.sink.reported();
            self.cx.watch.start();
            ask(check, self.cx, self.sink);
            let is_beyond = self.cx.watch.is_beyond();
            if is_beyond {
                self.cx.watch.add_to(&mut self.beyond);
            }
            let is_open = is_beyond || self.sink.reported() != found;
            if is_open && !self.open.contains(&place) {
                self.open.push(place);
            }
        }
    }
}

/// A child of the root, and what it is to the robot.
#[derive(Clone, Copy)]
struct Child<'a> {
    id: XId,
    link: Option<&'a Link>,
    joint: Option<&'a Joint>,
}

/// The children of the root that are left, in document order, which is that of the links and joints of the robot.
struct Children<'a> {
    tree: &'a XTree,
    root: XId,
    next: Option<XId>,
    links: Cursor<'a, Link>,
    joints: Cursor<'a, Joint>,
}

impl<'a> Children<'a> {
    fn of(cx: &DocumentCx<'a>) -> Self {
        let tree = &cx.expansion.tree;
        Self {
            tree,
            root: cx.element,
            next: tree.first_child(cx.element),
            links: Cursor::of(cx.links(), |link| link.element),
            joints: Cursor::of(cx.joints(), |joint| joint.element),
        }
    }

    /// Take all, or those in front of a node.
    fn run_until(&mut self, end: Option<XId>, mut each: impl FnMut(Child<'a>)) {
        while let Some(id) = self.next.filter(|&id| end.is_none_or(|end| id < end)) {
            self.next = self.tree.next_sibling(id);
            if self.tree.get(id).kind == XKind::Element {
                each(Child {
                    id,
                    link: self.links.find(id),
                    joint: self.joints.find(id),
                });
            }
        }
    }

    /// Pass over those in front of a node, which is the next child of the root if it is one at all.
    fn skip_until(&mut self, end: XId) {
        match self.tree.child_at(end, self.root) {
            Some(next) => self.next = Some(next),
            None => self.run_until(Some(end), |_| {}),
        }
    }
}

/// A place in a list in document order.
struct Cursor<'a, T> {
    list: &'a SharedList<T>,
    element: fn(&T) -> XId,
    next: usize,
}

impl<'a, T> Cursor<'a, T> {
    fn of(list: &'a SharedList<T>, element: fn(&T) -> XId) -> Self {
        Self {
            list,
            element,
            next: 0,
        }
    }

    /// What is of an element that stands behind those that were asked about before.
    fn find(&mut self, id: XId) -> Option<&'a T> {
        let mut found = self.list.get(self.next)?;
        if (self.element)(found) < id {
            // elements in between were passed over
            self.next = self.list.position(&id, self.element);
            found = self.list.get(self.next)?;
        }
        let is_it = (self.element)(found) == id;
        self.next += usize::from(is_it);
        is_it.then_some(found)
    }
}
