//! Rules that look at one element at a time. Of each child of the root, all of them are asked before the next child, and
//! children that they were asked about before are passed over: see [`Settled`].
use super::context::DocumentCx;
use super::frames::{self, ElementPose};
use super::rule::{Check, Rule};
use super::run::Chosen;
use super::settled::{About, Basis, Settled};
use super::sink::Sink;
use super::xml::{self, CheckedElement, Numeric};
use expand::XId;
use model::{Joint, Link, SharedIter};

/// A rule with what it does.
type Asked<F> = Vec<(&'static Rule, F)>;

/// The rules about single elements, by what they look at.
#[derive(Default)]
pub(super) struct Visitors {
    elements: Asked<fn(&DocumentCx<'_>, &CheckedElement, &mut Sink<'_>)>,
    numbers: Asked<fn(&DocumentCx<'_>, &Numeric, &mut Sink<'_>)>,
    links: Asked<fn(&DocumentCx<'_>, &Link, &mut Sink<'_>)>,
    bodies: Asked<fn(&DocumentCx<'_>, &Link, &mut Sink<'_>)>,
    joints: Asked<fn(&DocumentCx<'_>, &Joint, &mut Sink<'_>)>,
    poses: Asked<fn(&DocumentCx<'_>, &ElementPose<'_>, &mut Sink<'_>)>,
}

impl Visitors {
    /// Those among the rules that run on a document, of which everything is there or not.
    pub(super) fn of(rules: &[&'static Rule], complete: bool) -> Self {
        let mut visitors = Self::default();
        for &rule in rules {
            match rule.check {
                Check::Element(check) => visitors.elements.push((rule, check)),
                Check::WholeElement(check) if complete => visitors.elements.push((rule, check)),
                Check::Number(check) => visitors.numbers.push((rule, check)),
                Check::Link(check) => visitors.links.push((rule, check)),
                Check::Body(check) => visitors.bodies.push((rule, check)),
                Check::Joint(check) => visitors.joints.push((rule, check)),
                Check::Pose(check) => visitors.poses.push((rule, check)),
                _ => {}
            }
        }
        visitors
    }

    /// Ask about all elements of a document but those that are settled; what is settled now.
    pub(super) fn run(
        &self,
        cx: &DocumentCx<'_>,
        chosen: Chosen<'_>,
        before: &Settled,
        sink: &mut Sink<'_>,
    ) -> Settled {
        let mut settled = Settled::on(Basis::of(cx, chosen.rules));
        let is_same = before.rests_on(&settled);
        let root = xml::root_element(cx);
        self.ask_element(cx, &root, sink);
        let mut children = Children::of(cx);
        let ask_all = |child: Child<'_>, sink: &mut Sink<'_>| {
            for about in About::ALL {
                self.ask(about, cx, &root, child, sink);
            }
        };
        for (step, elements) in cx.steps() {
            children.run_until(Some(elements.start), |child| ask_all(child, sink));
            let mut asked = About::ALL.map(|about| Asking {
                about,
                is_known: is_same && before.holds(about, &step),
                is_settled: true,
            });
            children.run_until(Some(elements.end), |child| {
                for asking in asked.iter_mut().filter(|asking| !asking.is_known) {
                    let found = sink.reported();
                    cx.start_watch();
                    self.ask(asking.about, cx, &root, child, sink);
                    asking.is_settled &= !cx.looked_beyond() && sink.reported() == found;
                }
            });
            for asking in asked.into_iter().filter(|asking| asking.is_settled) {
                settled.add(asking.about, step.clone());
            }
            if chosen.cancel.is_cancelled() {
                return settled;
            }
        }
        children.run_until(None, |child| ask_all(child, sink));
        settled
    }

    /// Ask about a child of the root and all that is in it.
    fn ask(
        &self,
        about: About,
        cx: &DocumentCx<'_>,
        root: &CheckedElement,
        child: Child<'_>,
        sink: &mut Sink<'_>,
    ) {
        if about == About::Shapes {
            if let Some(link) = child.link {
                each(&self.bodies, sink, |check, sink| check(cx, link, sink));
            }
            return;
        }
        xml::each_below(cx, root, child.id, |element| {
            self.ask_element(cx, element, sink);
        });
        if let Some(link) = child.link {
            self.ask_link(cx, link, sink);
        }
        if let Some(joint) = child.joint {
            self.ask_joint(cx, joint, sink);
        }
    }

    fn ask_element(&self, cx: &DocumentCx<'_>, element: &CheckedElement, sink: &mut Sink<'_>) {
        each(&self.elements, sink, |check, sink| check(cx, element, sink));
        if !self.numbers.is_empty() {
            xml::each_number(cx, element, |number| {
                each(&self.numbers, sink, |check, sink| check(cx, number, sink));
            });
        }
    }

    fn ask_link(&self, cx: &DocumentCx<'_>, link: &Link, sink: &mut Sink<'_>) {
        each(&self.links, sink, |check, sink| check(cx, link, sink));
        for pose in frames::poses_of_link(link) {
            each(&self.poses, sink, |check, sink| check(cx, &pose, sink));
        }
    }

    fn ask_joint(&self, cx: &DocumentCx<'_>, joint: &Joint, sink: &mut Sink<'_>) {
        each(&self.joints, sink, |check, sink| check(cx, joint, sink));
        if let Some(pose) = frames::pose_of_joint(joint) {
            each(&self.poses, sink, |check, sink| check(cx, &pose, sink));
        }
    }
}

fn each<F: Copy>(asked: &Asked<F>, sink: &mut Sink<'_>, mut ask: impl FnMut(F, &mut Sink<'_>)) {
    for &(rule, check) in asked {
        sink.set_rule(rule);
        ask(check, sink);
    }
}

/// What is asked about a step.
struct Asking {
    about: About,
    /// Whether it was settled before.
    is_known: bool,
    /// Whether it is now.
    is_settled: bool,
}

/// A child of the root, and what it is to the robot.
#[derive(Clone, Copy)]
struct Child<'a> {
    id: XId,
    link: Option<&'a Link>,
    joint: Option<&'a Joint>,
}

/// The children of the root that are left, in document order, which is that of the links and joints of the robot.
struct Children<'a, I: Iterator<Item = XId>> {
    ids: std::iter::Peekable<I>,
    links: std::iter::Peekable<SharedIter<'a, Link>>,
    joints: std::iter::Peekable<SharedIter<'a, Joint>>,
}

impl<'a> Children<'a, std::iter::Empty<XId>> {
    fn of(cx: &DocumentCx<'a>) -> Children<'a, impl Iterator<Item = XId>> {
        Children {
            ids: cx.expansion.tree.elements(cx.element).peekable(),
            links: cx.links().iter().peekable(),
            joints: cx.joints().iter().peekable(),
        }
    }
}

impl<'a, I: Iterator<Item = XId>> Children<'a, I> {
    /// Take all, or those in front of a node.
    fn run_until(&mut self, end: Option<XId>, mut each: impl FnMut(Child<'a>)) {
        while let Some(id) = self.ids.next_if(|&id| end.is_none_or(|end| id < end)) {
            each(Child {
                id,
                link: self.links.next_if(|link| link.element == id),
                joint: self.joints.next_if(|joint| joint.element == id),
            });
        }
    }
}
