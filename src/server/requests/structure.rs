//! What the text of a file alone answers: symbols, folding, selection, linked editing.
use lsp_types::{
    DocumentSymbol, DocumentSymbolParams, DocumentSymbolResponse, FoldingRange, FoldingRangeKind,
    FoldingRangeParams, LinkedEditingRangeParams, LinkedEditingRanges, Location, SelectionRange,
    SelectionRangeParams, SymbolInformation, SymbolKind, Url,
};

use crate::convert;
use crate::failure::RequestFailure;
use crate::state::ServerState;
use base::CancelFlag;
use base::limits::SYMBOLS;
use ide::{self, FoldKind, Outline, OutlineKind};
use xml::Document;

/// What may be typed in both tags at once.
const NAME: &str = "[^\\s<>/=\"']+";

pub fn symbols(
    state: &mut ServerState,
    params: DocumentSymbolParams,
    _: &CancelFlag,
) -> Result<Option<DocumentSymbolResponse>, RequestFailure> {
    let (_, source) = state.source(&params.text_document.uri)?;
    let mut symbols = ide::outline(&source.document);
    symbols.truncate(SYMBOLS);
    let symbols = symbols
        .into_iter()
        .map(|symbol| document_symbol(state, &source.document, symbol));
    Ok(Some(if state.client.nested_symbols {
        DocumentSymbolResponse::Nested(symbols.collect())
    } else {
        let mut flat = Vec::new();
        flatten(
            symbols.collect(),
            None,
            &params.text_document.uri,
            &mut flat,
        );
        DocumentSymbolResponse::Flat(flat)
    }))
}

#[allow(deprecated)] // the protocol's struct has a deprecated field
fn document_symbol(state: &ServerState, document: &Document, symbol: Outline) -> DocumentSymbol {
    let children = symbol
        .children
        .into_iter()
        .map(|child| document_symbol(state, document, child));
    let children: Vec<_> = children.collect();
    DocumentSymbol {
        name: symbol.name,
        detail: Some(symbol.detail).filter(|detail| !detail.is_empty()),
        kind: kind(symbol.kind),
        tags: None,
        deprecated: None,
        range: convert::range(document, symbol.range, state.encoding),
        selection_range: convert::range(document, symbol.name_range, state.encoding),
        children: (!children.is_empty()).then_some(children),
    }
}

pub fn folding(
    state: &mut ServerState,
    params: FoldingRangeParams,
    _: &CancelFlag,
) -> Result<Option<Vec<FoldingRange>>, RequestFailure> {
    let (_, source) = state.source(&params.text_document.uri)?;
    let fold = |fold: ide::Fold| FoldingRange {
        start_line: fold.start,
        end_line: fold.end,
        kind: match fold.kind {
            FoldKind::Element => None,
            FoldKind::Comment => Some(FoldingRangeKind::Comment),
            FoldKind::Includes => Some(FoldingRangeKind::Imports),
            FoldKind::Region => Some(FoldingRangeKind::Region),
        },
        ..FoldingRange::default()
    };
    let most = state.client.most_folds.unwrap_or(SYMBOLS).min(SYMBOLS);
    let folds = ide::largest(ide::folds(&source.document), most);
    Ok(Some(folds.into_iter().map(fold).collect()))
}

pub fn selections(
    state: &mut ServerState,
    params: SelectionRangeParams,
    _: &CancelFlag,
) -> Result<Option<Vec<SelectionRange>>, RequestFailure> {
    let (_, source) = state.source(&params.text_document.uri)?;
    let document = &source.document;
    let selection = |position| {
        let offset = convert::offset(document, position, state.encoding);
        let ranges = ide::selection(document, offset).into_iter().rev();
        let grown = ranges.fold(None, |parent: Option<SelectionRange>, range| {
            let range = convert::range(document, range, state.encoding);
            Some(SelectionRange {
                range,
                parent: parent.map(Box::new),
            })
        });
        grown.unwrap_or(SelectionRange {
            range: lsp_types::Range::new(position, position),
            parent: None,
        })
    };
    Ok(Some(params.positions.into_iter().map(selection).collect()))
}

pub fn linked_editing(
    state: &mut ServerState,
    params: LinkedEditingRangeParams,
    _: &CancelFlag,
) -> Result<Option<LinkedEditingRanges>, RequestFailure> {
    let at = params.text_document_position_params;
    let (_, source) = state.source(&at.text_document.uri)?;
    let document = &source.document;
    let offset = convert::offset(document, at.position, state.encoding);
    let ranges = ide::same_tag_names(document, offset).map(|names| LinkedEditingRanges {
        ranges: names
            .iter()
            .map(|name| convert::range(document, *name, state.encoding))
            .collect(),
        word_pattern: Some(NAME.to_owned()),
    });
    Ok(ranges)
}

/// Symbols in a row, each with the name of the one that holds it.
#[allow(deprecated)] // the protocol's struct has a deprecated field
fn flatten(
    symbols: Vec<DocumentSymbol>,
    inside: Option<&str>,
    uri: &Url,
    flat: &mut Vec<SymbolInformation>,
) {
    for symbol in symbols {
        flat.push(SymbolInformation {
            name: symbol.name.clone(),
            kind: symbol.kind,
            tags: None,
            deprecated: None,
            location: Location::new(uri.clone(), symbol.range),
            container_name: inside.map(str::to_owned),
        });
        flatten(
            symbol.children.unwrap_or_default(),
            Some(&symbol.name),
            uri,
            flat,
        );
    }
}

fn kind(kind: OutlineKind) -> SymbolKind {
    match kind {
        OutlineKind::Link => SymbolKind::CLASS,
        OutlineKind::Joint => SymbolKind::EVENT,
        OutlineKind::Macro => SymbolKind::FUNCTION,
        OutlineKind::Property => SymbolKind::CONSTANT,
        OutlineKind::Argument => SymbolKind::VARIABLE,
        OutlineKind::Include => SymbolKind::MODULE,
        OutlineKind::Call => SymbolKind::OBJECT,
        OutlineKind::Material => SymbolKind::ENUM_MEMBER,
        OutlineKind::Condition => SymbolKind::NAMESPACE,
        OutlineKind::Block => SymbolKind::STRUCT,
    }
}
