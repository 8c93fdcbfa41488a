//! Colors.
use lsp_types::{
    Color, ColorInformation, ColorPresentation, ColorPresentationParams, DocumentColorParams,
    TextEdit,
};

use crate::convert;
use crate::failure::RequestFailure;
use crate::requests::navigation::asked;
use crate::requests::tokens::start_of;
use crate::state::ServerState;
use base::CancelFlag;

pub fn colors(
    state: &mut ServerState,
    params: DocumentColorParams,
    cancel: &CancelFlag,
) -> Result<Vec<ColorInformation>, RequestFailure> {
    let asked = asked(state, &start_of(params.text_document), cancel)?;
    let information = |color: ide::Color| {
        let [red, green, blue, alpha] = color.rgba.map(|part| part as f32);
        ColorInformation {
            range: convert::range(&asked.source.document, color.range, state.encoding),
            color: Color {
                red,
                green,
                blue,
                alpha,
            },
        }
    };
    Ok(ide::colors(&asked.cx())
        .into_iter()
        .map(information)
        .collect())
}

/// The text of a color that was selected; none for a color that an expression makes.
pub fn color_texts(
    state: &mut ServerState,
    params: ColorPresentationParams,
    _: &CancelFlag,
) -> Result<Vec<ColorPresentation>, RequestFailure> {
    let (_, source) = state.source(&params.text_document.uri)?;
    let range = convert::text_range(&source.document, params.range, state.encoding);
    if source.document.slice(range).contains('$') {
        return Ok(Vec::new());
    }
    let Color {
        red,
        green,
        blue,
        alpha,
    } = params.color;
    let label = ide::color_text([red, green, blue, alpha].map(f64::from));
    let text_edit = Some(TextEdit::new(params.range, label.clone()));
    Ok(vec![ColorPresentation {
        label,
        text_edit,
        additional_text_edits: None,
    }])
}
