//! F26: colours.

use super::navigation::asked;
use lsp_types::{
    Color, ColorInformation, ColorPresentation, ColorPresentationParams, DocumentColorParams, TextEdit,
};

use super::tokens::start_of;
use crate::convert;
use crate::failure::Failure;
use crate::state::State;
use base::CancelFlag;

pub fn colours(
    state: &mut State,
    params: DocumentColorParams,
    cancel: &CancelFlag,
) -> Result<Vec<ColorInformation>, Failure> {
    let asked = asked(state, &start_of(params.text_document), cancel)?;
    let information = |colour: ide::Colour| {
        let [red, green, blue, alpha] = colour.rgba.map(|part| part as f32);
        ColorInformation {
            range: convert::range(&asked.source.document, colour.range, state.encoding),
            color: Color { red, green, blue, alpha },
        }
    };
    Ok(ide::colours(&asked.cx()).into_iter().map(information).collect())
}

/// The text of a colour that was picked; none for a colour that an expression makes.
pub fn colour_texts(
    state: &mut State,
    params: ColorPresentationParams,
    _: &CancelFlag,
) -> Result<Vec<ColorPresentation>, Failure> {
    let (_, source) = state.source(&params.text_document.uri)?;
    let range = convert::text_range(&source.document, params.range, state.encoding);
    if source.document.slice(range).contains('$') {
        return Ok(Vec::new());
    }
    let Color { red, green, blue, alpha } = params.color;
    let label = ide::colour_text([red, green, blue, alpha].map(f64::from));
    let text_edit = Some(TextEdit::new(params.range, label.clone()));
    Ok(vec![ColorPresentation { label, text_edit, additional_text_edits: None }])
}
