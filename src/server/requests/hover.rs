//! What is shown under the pointer.
use lsp_types::{HoverContents, HoverParams, TextDocumentPositionParams};

use crate::convert;
use crate::failure::RequestFailure;
use crate::requests::asked::Asked;
use crate::requests::configuration;
use crate::requests::configuration::is_about_config;
use crate::requests::launch::{is_about_launch, launched};
use crate::requests::navigation::asked_for_name;
use crate::state::ServerState;
use base::CancelFlag;
use expand::SymbolKind;
use ide::{self, Cx, Hover};
use vfs::SourceFile;

pub fn hover(
    state: &mut ServerState,
    params: HoverParams,
    cancel: &CancelFlag,
) -> Result<Option<lsp_types::Hover>, RequestFailure> {
    let at = &params.text_document_position_params;
    if is_about_launch(state, at) {
        let found = launched(state, at, cancel)?;
        return Ok(found.and_then(|found| {
            let hover = hover_at(state, &found.asked, found.asked.offset)?;
            Some(hover_answer(
                state,
                &found.source,
                Hover {
                    range: found.range,
                    ..hover
                },
            ))
        }));
    }
    if is_about_config(state, at) {
        return configuration::hover(state, at);
    }
    if let Some(found) = hover_while_typing(state, &params.text_document_position_params)? {
        return Ok(Some(found));
    }
    let Some(asked) = asked_for_name(state, at, cancel)? else {
        return Ok(None);
    };
    let asked = asked.on_name();
    Ok(
        hover_at(state, &asked, asked.offset)
            .map(|hover| hover_answer(state, &asked.source, hover)),
    )
}

/// What can be said of a name in a large robot that was edited, without expanding it again.
fn hover_while_typing(
    state: &mut ServerState,
    at: &TextDocumentPositionParams,
) -> Result<Option<lsp_types::Hover>, RequestFailure> {
    let (path, source) = state.source(&at.text_document.uri)?;
    let root = analysis::context(&mut state.host, &path).root;
    let before = root.and_then(|root| state.host.before_typing(&root, &path));
    let Some(before) = before else {
        return Ok(None);
    };
    let cx = Cx {
        source: &source,
        expansion: &before.expansion,
        robot: before.robot.as_ref(),
        kinematics: before.kinematics(),
        beside: &[],
        selected_frame: None,
    };
    let offset = convert::offset(&source.document, at.position, state.encoding);
    let found = ide::hover_while_typing(&cx, offset, |path| state.host.document(path));
    Ok(found.map(|hover| hover_answer(state, &source, hover)))
}

fn hover_answer(state: &ServerState, source: &SourceFile, hover: Hover) -> lsp_types::Hover {
    lsp_types::Hover {
        range: Some(convert::range(
            &source.document,
            hover.range,
            state.encoding,
        )),
        contents: HoverContents::Markup(state.client.hover.contents(hover.markdown)),
    }
}

/// What there is to say about an offset of a file.
pub fn hover_at(state: &ServerState, asked: &Asked, offset: u32) -> Option<Hover> {
    let session = state.host.session();
    let settings = session.settings(&asked.source.path);
    let around = session.rule_env(&settings.config);
    let hover = ide::hover(&asked.cx(), around, || asked.names(state), offset)?;
    Some(with_launch_values(state, asked, offset, hover))
}

/// Lines about launch files in one hover.
const MOST_VALUES: usize = 5;
/// Lines of one hover.
const MOST_LINES: usize = 25;

/// A hover on an argument, with the values that launch files give to it.
fn with_launch_values(state: &ServerState, asked: &Asked, offset: u32, mut hover: Hover) -> Hover {
    let cx = asked.cx();
    let argument = cx
        .symbol_at(offset)
        .and_then(|(id, _)| cx.expansion.index.symbols.get(id))
        .filter(|definition| definition.kind == SymbolKind::Argument);
    let (Some(argument), Some(root)) = (argument, cx.expansion.files.first()) else {
        return hover;
    };
    let values = analysis::launch_values(state.host.session(), &root.source.path, &argument.name);
    let left = MOST_LINES
        .saturating_sub(hover.markdown.lines().count() + 2)
        .min(MOST_VALUES);
    if values.is_empty() || left == 0 {
        return hover;
    }
    hover.markdown.push_str("\n\nin launch files:");
    let more = values.len().saturating_sub(left.saturating_sub(1));
    let shown = if values.len() > left {
        values.len() - more
    } else {
        values.len()
    };
    for (value, files) in values.iter().take(shown) {
        hover
            .markdown
            .push_str(&format!("\n* `{}`: {files}", value.replace('`', "'")));
    }
    if values.len() > shown {
        hover
            .markdown
            .push_str(&format!("\n* {} more values", values.len() - shown));
    }
    hover
}
