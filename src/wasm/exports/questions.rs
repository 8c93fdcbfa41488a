//! Single questions about files in memory.

use super::{ExportState, with};

/// What the functions are about.
pub(super) type HostState = crate::Bench;

/// Answer the question in the input; the length of the answer.
#[unsafe(no_mangle)]
extern "C" fn call() -> usize {
    answer(|bench, question| bench.call(question).map(String::into_bytes))
}

/// The bytes of the file of a model whose id is the input; the length of the answer.
#[unsafe(no_mangle)]
extern "C" fn mesh() -> usize {
    answer(|bench, id| bench.mesh(id))
}

fn answer(work: impl FnOnce(&mut HostState, &str) -> Result<Vec<u8>, String>) -> usize {
    with(|state: &mut ExportState| {
        let question = state.text();
        let answer = work(&mut state.held, &question);
        state.answer(answer)
    })
}
