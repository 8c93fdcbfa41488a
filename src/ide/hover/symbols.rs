//! Names of xacro: properties, parameters, arguments, macros, blocks.

use std::sync::Arc;

use super::super::context::Cx;
use super::super::expressions::{ExprText, parsed, path_to};
use super::super::instances::is_call_of;
use super::super::locate::LocatedNode;
use super::super::values::{Instance, distinct, part_values};
use super::expression::{place_name, root_name, shown, value_lines};
use super::page::{Page, code, plain};
use crate::rename::definition_at;
use crate::text_names::{TextDefinition, TextNames};
use base::{Encoding, FastSet, TextRange, counted};
use expand::{Definition, DefinitionId, Expansion, FrameId, SymbolKind, Use, UseKind, XId};
use expr::Value;
use rules::RuleEnv;
use xml::{Node, NodeKind};

/// The name of xacro at a place.
pub(super) fn about(cx: &Cx<'_>, at: &LocatedNode<'_>) -> Option<(TextRange, Page)> {
    let (id, range) = cx.symbol_at(at.offset)?;
    let definition = cx.expansion.index.symbols.get(id)?;
    Some((
        range,
        definition_page(cx, id, definition, values_here(cx, at).unwrap_or_default()),
    ))
}

fn definition_page(
    cx: &Cx<'_>,
    id: DefinitionId,
    definition: &Definition,
    here: Vec<Instance>,
) -> Page {
    match definition.kind {
        SymbolKind::Macro => macro_page(cx, id, definition),
        SymbolKind::Parameter | SymbolKind::Argument | SymbolKind::Property => {
            value_page(cx, id, definition, here)
        }
        SymbolKind::BlockProperty | SymbolKind::BlockParameter => block_page(cx, id, definition),
        SymbolKind::Namespace => Page::titled(format!("**namespace** {}", code(&definition.name))),
    }
}

/// The name of xacro at a place that was not evaluated.
pub(super) fn by_text(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    names: &TextNames,
    at: &LocatedNode<'_>,
) -> Option<(TextRange, Page)> {
    let (span, meaning) = names.at(cx.source.id, at.offset)?;
    let page = match meaning.all() {
        [] => return None,
        [given] => match evaluated(cx, given) {
            Some(page) => page,
            None => {
                let mut page =
                    Page::titled(format!("**{}** {}", noun(given.kind), code(&given.name)));
                page.add("not evaluated with these arguments");
                page.add(format!("defined in {}", place_of(world, given)));
                page
            }
        },
        [first, ..] => {
            let mut page = Page::titled(format!("**{}** {}", noun(first.kind), code(&first.name)));
            page.add("not evaluated with these arguments; one of:");
            page.list(
                meaning
                    .all()
                    .iter()
                    .map(|given| format!("{} in {}", noun(given.kind), place_of(world, given))),
            );
            page
        }
    };
    Some((span.range, page))
}

/// What is known of a definition that was evaluated, though not where it is used.
fn evaluated(cx: &Cx<'_>, given: &TextDefinition) -> Option<Page> {
    let id = definition_at(cx, given.span)?;
    let definition = cx.expansion.index.symbols.get(id)?;
    Some(definition_page(cx, id, definition, Vec::new()))
}

fn place_of(world: RuleEnv<'_>, given: &TextDefinition) -> String {
    let path = world.vfs.path(given.span.file);
    let document = world.vfs.document(&path).ok();
    let line = document.map(|file| {
        file.document
            .line_col(given.span.range.start, Encoding::Utf8)
            .line
            + 1
    });
    let name = path
        .file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned();
    code(&format!("{name}:{}", line.unwrap_or(1)))
}

fn noun(kind: SymbolKind) -> &'static str {
    match kind {
        SymbolKind::Property => "property",
        SymbolKind::Parameter => "parameter",
        SymbolKind::BlockProperty | SymbolKind::BlockParameter => "block",
        SymbolKind::Argument => "argument",
        SymbolKind::Macro => "macro",
        SymbolKind::Namespace => "namespace",
    }
}

/// Something of a name that no evaluation came by.
pub(super) fn by_name(cx: &Cx<'_>, name: &str) -> Option<Page> {
    let named = cx.expansion.index.symbols.iter();
    let mut named = named.filter(|(_, given)| {
        given.name == name && matches!(given.kind, SymbolKind::Property | SymbolKind::Parameter)
    });
    let (id, definition) = named.next()?;
    if named.next().is_some() {
        return None;
    }
    Some(value_page(cx, id, definition, Vec::new()))
}

/// The values of the name at a place of an expression, in each call.
fn values_here(cx: &Cx<'_>, at: &LocatedNode<'_>) -> Option<Vec<Instance>> {
    let text = ExprText::at(&cx.source.document, at)?;
    let token = text.token_at(at.offset)?;
    let whole = text.range(token.range());
    let Some((expr, start)) = parsed(token) else {
        return Some(super::super::values::instances(cx, whole));
    };
    let inside = text.offset(at.offset).saturating_sub(start);
    let path = path_to(expr, inside);
    Some(part_values(cx, whole, expr, path.last()?))
}

fn value_page(cx: &Cx<'_>, id: DefinitionId, definition: &Definition, here: Vec<Instance>) -> Page {
    let noun = match definition.kind {
        SymbolKind::Parameter => "parameter",
        SymbolKind::Argument => "argument",
        _ => "property",
    };
    let given = bound(cx, id);
    let values = if here.is_empty() { &given } else { &here };
    let title = format!("**{noun}** {}", code(&definition.name));
    let different = distinct(values.iter().map(|instance| &instance.value));
    let mut page = match different.as_slice() {
        [value] => Page::titled(format!("{title} = {}", shown(value))),
        _ => Page::titled(title),
    };
    // that all calls read the same from it is no news
    let is_constant = given.len() == 1
        && definition.kind == SymbolKind::Property
        && matches!(different.as_slice(), [value] if !value.is_unknown());
    if values.is_empty() {
        page.add(format!("? – {} does not define it", root_name(cx)));
    } else if is_idle(cx, definition, &different) {
        page.add("the macro is never called, so it has no value");
    } else if !is_constant {
        value_lines(cx, values)
            .into_iter()
            .for_each(|line| page.add(line));
    }
    if let Some(default) = default_of(cx, id, definition) {
        page.add(format!("default {}", code(&default)));
    }
    if definition.kind == SymbolKind::Parameter {
        let all: Vec<String> = distinct(given.iter().map(|instance| &instance.value))
            .into_iter()
            .take(4)
            .map(shown)
            .collect();
        if all.len() > 1 && !here.is_empty() {
            let more = if all.len() > 3 { ", …" } else { "" };
            let listed = all.iter().take(3).cloned().collect::<Vec<_>>().join(", ");
            page.add(format!(
                "over {}: {listed}{more}",
                counted(given.len(), "call")
            ));
        }
    }
    page.add(origin_line(cx, id, definition));
    page.add(comment_above(cx, id).unwrap_or_default());
    page
}

/// Whether a parameter has no value because nothing calls its macro.
fn is_idle(cx: &Cx<'_>, definition: &Definition, values: &[&Value]) -> bool {
    let called = |used: &Use| used.kind == UseKind::Call && Some(used.definition) == definition.of;
    definition.kind == SymbolKind::Parameter
        && matches!(values, [Value::Unknown])
        && !cx.expansion.index.symbols.uses.iter().any(called)
}

/// The values that a definition was given, with the calls that gave them.
fn bound(cx: &Cx<'_>, id: DefinitionId) -> Vec<Instance> {
    let bindings = cx
        .expansion
        .index
        .bindings
        .iter()
        .filter(|info| info.definition == Some(id));
    let values = bindings.filter_map(|info| {
        let frame = info
            .origin
            .map_or(expand::FrameId::ROOT, |origin| origin.frame);
        Some(Instance {
            frame,
            value: info.value.clone()?,
        })
    });
    values.collect()
}

fn origin_line(cx: &Cx<'_>, id: DefinitionId, definition: &Definition) -> String {
    let uses = cx
        .expansion
        .index
        .symbols
        .all_uses()
        .filter(|used| used.definition == id);
    let uses = uses.filter(|used| used.kind != UseKind::Given).count();
    let at = expand::Origin {
        src: definition.place.src,
        range: definition.place.range,
        frame: expand::FrameId::ROOT,
    };
    let place = place_name(cx, at).unwrap_or_default();
    let of = definition
        .of
        .and_then(|of| cx.expansion.index.symbols.get(of));
    let of = of
        .map(|of| format!("of macro {}, ", code(&of.name)))
        .unwrap_or_default();
    format!("{of}defined in {place}, used {}", counted(uses, "time"))
}

/// The text of the default of a parameter or argument.
fn default_of(cx: &Cx<'_>, id: DefinitionId, definition: &Definition) -> Option<String> {
    match definition.kind {
        SymbolKind::Argument => Some(element(cx.expansion, id)?.attr("default")?.raw().to_owned()),
        SymbolKind::Parameter => {
            let spec = parameter_spec(cx, id, definition)?;
            Some(
                spec.split_once(":=")
                    .or_else(|| spec.split_once('='))?
                    .1
                    .to_owned(),
            )
        }
        _ => None,
    }
}

/// The default of an argument, and the comment above its declaration or behind it on the same line, where it is declared.
pub fn declared_argument(
    expansion: &Expansion,
    name: &str,
) -> Option<(Option<String>, Option<String>)> {
    let mut given = expansion.index.symbols.iter();
    let (id, _) =
        given.find(|(_, given)| given.kind == SymbolKind::Argument && given.name == name)?;
    let element = element(expansion, id)?;
    let default = element
        .attr("default")
        .map(|default| default.raw().to_owned());
    let above = crate::completion::comment_above(element);
    let above = Some(above).filter(|comment| !comment.is_empty());
    Some((default, above.or_else(|| comment_behind(expansion, id))))
}

/// The comment that stands behind what gives a definition, on the same line.
fn comment_behind(expansion: &Expansion, id: DefinitionId) -> Option<String> {
    const MOST: u32 = 1000;
    let place = expansion.index.symbols.get(id)?.place;
    let source = expansion.sources.get(place.src)?;
    let document = &expansion.files.get(source.file)?.source.document;
    let mut parts = document.parts();
    let (base, _) = parts.find(|(_, item)| Arc::ptr_eq(item, &source.item))?;
    let end = element(expansion, id)?.range().end + base;
    let behind = document.slice(TextRange::new(end, (end + MOST).min(document.len())));
    let line = behind.lines().next()?.trim_start();
    let (comment, _) = line.strip_prefix("<!--")?.split_once("-->")?;
    let comment = comment.trim();
    (!comment.is_empty() && !comment.starts_with("xacro-lint:")).then(|| comment.to_owned())
}

/// The text that declares a parameter, with its default.
fn parameter_spec(cx: &Cx<'_>, id: DefinitionId, definition: &Definition) -> Option<String> {
    let element = element(cx.expansion, id)?;
    let attr = element.attr("params")?;
    let start = definition
        .place
        .range
        .start
        .checked_sub(attr.value_range().start)?;
    let text = attr.raw();
    // up to the parameter behind it
    let next = cx
        .expansion
        .index
        .symbols
        .definitions
        .iter()
        .filter(|other| {
            other.of == definition.of
                && other.place.src == definition.place.src
                && other.place.range.start > definition.place.range.start
        });
    let end = next
        .map(|other| other.place.range.start - attr.value_range().start)
        .min();
    let spec = text.get(start as usize..end.unwrap_or(text.len() as u32) as usize)?;
    Some(
        spec.trim_end_matches(|c: char| c.is_whitespace() || c == '*')
            .to_owned(),
    )
}

/// The element that gives a definition.
fn element(expansion: &Expansion, id: DefinitionId) -> Option<Node<'_>> {
    let place = expansion.index.symbols.get(id)?.place;
    let item = &expansion.sources.get(place.src)?.item;
    let holds = |node: &Node<'_>| {
        node.kind() == NodeKind::Element && node.start_tag_range().contains_range(place.range)
    };
    item.all_nodes().filter(holds).last()
}

/// The comment in front of what gives a definition.
pub fn comment_above(cx: &Cx<'_>, id: DefinitionId) -> Option<String> {
    const MOST_LINES: usize = 6;
    let element = element(cx.expansion, id)?;
    let siblings: Vec<Node<'_>> = match element.parent() {
        Some(parent) => parent.children().collect(),
        None => element.item().nodes().collect(),
    };
    let before = siblings.iter().take_while(|node| **node != element);
    let mut comments = Vec::new();
    for node in before {
        match node.kind() {
            NodeKind::Comment => comments.push(*node),
            // an empty line, or something on the line of the comment, parts it from what follows
            NodeKind::Text
                if node.raw().matches('\n').count() < 2 && node.raw().trim().is_empty() => {}
            _ => comments.clear(),
        }
    }
    let text: Vec<&str> = comments
        .iter()
        .map(|comment| comment.raw().trim())
        .collect();
    let text = text.join("\n");
    let lines = text
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty())
        .take(MOST_LINES);
    let lines: Vec<String> = lines.map(plain).collect();
    (!lines.is_empty()).then(|| lines.join("  \n"))
}

fn macro_page(cx: &Cx<'_>, id: DefinitionId, definition: &Definition) -> Page {
    let parameters = cx
        .expansion
        .index
        .symbols
        .iter()
        .filter(|(_, given)| given.of == Some(id));
    let mut signature = Vec::new();
    for (parameter, given) in parameters {
        let star = if given.kind == SymbolKind::BlockParameter {
            "*"
        } else {
            ""
        };
        let spec = parameter_spec(cx, parameter, given).unwrap_or_else(|| given.name.to_string());
        signature.push(format!("{star}{spec}"));
    }
    let mut page = Page::titled(format!(
        "**macro** {}",
        code(&format!("{}({})", definition.name, signature.join(", ")))
    ));
    page.add(comment_above(cx, id).unwrap_or_default());
    page.add(made_line(cx, definition));
    page.add(origin_line(cx, id, definition));
    page
}

/// What one call of a macro makes: `1 link, 1 joint`.
fn made_line(cx: &Cx<'_>, definition: &Definition) -> String {
    let Some(robot) = cx.robot else {
        return String::new();
    };
    let calls: FastSet<FrameId> = cx
        .expansion
        .frames
        .iter_ids()
        .filter(|(_, frame)| is_call_of(frame, definition))
        .map(|(id, _)| id)
        .collect();
    if calls.is_empty() {
        return "never called".to_owned();
    }
    let links = robot.links.iter().map(|link| link.element);
    let links = links.filter(|id| is_made_by(cx, *id, definition)).count();
    let joints = robot.joints.iter().map(|joint| joint.element);
    let joints = joints.filter(|id| is_made_by(cx, *id, definition)).count();
    match (links % calls.len(), joints % calls.len()) {
        (0, 0) => {
            let (links, joints) = (links / calls.len(), joints / calls.len());
            let made = format!(
                "creates {}, {}",
                counted(links, "link"),
                counted(joints, "joint")
            );
            match calls.len() {
                1 => format!("{made} in its only call"),
                calls => format!("{made} in each of {}", counted(calls, "call")),
            }
        }
        _ => {
            format!(
                "{} create {}, {}",
                counted(calls.len(), "call"),
                counted(links, "link"),
                counted(joints, "joint")
            )
        }
    }
}

/// Whether a call of the macro made an element.
fn is_made_by(cx: &Cx<'_>, element: XId, definition: &Definition) -> bool {
    cx.expansion
        .frames_of(cx.expansion.tree.get(element).origin)
        .any(|frame| is_call_of(frame, definition))
}

fn block_page(cx: &Cx<'_>, id: DefinitionId, definition: &Definition) -> Page {
    let mut page = Page::titled(format!("**block** {}", code(&definition.name)));
    if definition.kind == SymbolKind::BlockParameter {
        page.add("an element passed by each call, inserted by `xacro:insert_block`");
    }
    page.add(origin_line(cx, id, definition));
    page.add(comment_above(cx, id).unwrap_or_default());
    page
}
