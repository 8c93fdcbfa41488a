//! Named things of the whole workspace.
use lsp_types::{Location, SymbolInformation, SymbolKind, WorkspaceSymbolParams};

use crate::convert;
use crate::failure::RequestFailure;
use crate::scanning::scan_all;
use crate::state::ServerState;
use base::CancelFlag;
use base::limits::WORKSPACE_SYMBOLS;
use facts::FactKind;

#[allow(deprecated)] // the protocol's struct has a deprecated field
pub fn workspace_symbols(
    state: &mut ServerState,
    params: WorkspaceSymbolParams,
    cancel: &CancelFlag,
) -> Result<Option<Vec<SymbolInformation>>, RequestFailure> {
    // what was not looked at yet belongs to the answer too
    scan_all(state, cancel)?;
    let mut found: Vec<(u32, SymbolInformation)> = Vec::new();
    for path in state.host.known_files() {
        if cancel.is_cancelled() {
            return Err(RequestFailure::Cancelled);
        }
        let (Some(source), Some(uri)) = (state.host.document(&path), state.uri(&path)) else {
            continue;
        };
        let container = path
            .file_name()
            .map(|name| name.to_string_lossy().into_owned());
        for hit in ide::search(&source.document, &params.query) {
            let range = convert::range(&source.document, hit.range, state.encoding);
            let symbol = SymbolInformation {
                name: hit.name,
                kind: kind(hit.kind),
                tags: None,
                deprecated: None,
                location: Location::new(uri.clone(), range),
                container_name: container.clone(),
            };
            found.push((hit.cost, symbol));
        }
    }
    found.extend(packages(state, &params.query));
    found.sort_by(|(a, one), (b, other)| a.cmp(b).then_with(|| one.name.cmp(&other.name)));
    found.truncate(WORKSPACE_SYMBOLS);
    Ok(Some(found.into_iter().map(|(_, symbol)| symbol).collect()))
}

/// The packages in the folders of the workspace.
#[allow(deprecated)]
fn packages(state: &ServerState, query: &str) -> Vec<(u32, SymbolInformation)> {
    let folders = state.host.folders();
    let Some(first) = folders.first() else {
        return Vec::new();
    };
    let entries = state
        .host
        .session()
        .packages
        .all(&first.join("package.xml"))
        .into_iter();
    let own = entries.filter(|entry| folders.iter().any(|folder| entry.path.starts_with(folder)));
    let symbol = |entry: packages::PackageEntry| {
        let cost = ide::fit(query, &entry.name)?;
        let uri = state.uri(&entry.path.join("package.xml"))?;
        let symbol = SymbolInformation {
            name: entry.name,
            kind: SymbolKind::PACKAGE,
            tags: None,
            deprecated: None,
            location: Location::new(uri, lsp_types::Range::default()),
            container_name: Some("package.xml".to_owned()),
        };
        Some((cost, symbol))
    };
    own.filter_map(symbol).collect()
}

fn kind(kind: FactKind) -> SymbolKind {
    match kind {
        FactKind::Macro => SymbolKind::FUNCTION,
        FactKind::Link => SymbolKind::CLASS,
        FactKind::Joint => SymbolKind::EVENT,
        FactKind::Property => SymbolKind::CONSTANT,
        _ => SymbolKind::VARIABLE,
    }
}
