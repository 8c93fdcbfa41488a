//! Where the calls of launch files write the names of arguments.
use base::{Span, TextRange};
use vfs::Vfs;
use workspace::launch::{CallArgument, LaunchCall};

/// Where a call writes the name of an argument; else where the call stands.
pub(super) fn argument_place(vfs: &Vfs, call: &LaunchCall, argument: &CallArgument) -> Span {
    let whole = || Span {
        file: vfs.file_id(&call.caller),
        range: call.range,
    };
    spelled_argument(vfs, call, argument).unwrap_or_else(whole)
}

/// Where a call writes the name of an argument, as far as its text tells.
pub(super) fn spelled_argument(
    vfs: &Vfs,
    call: &LaunchCall,
    argument: &CallArgument,
) -> Option<Span> {
    let file = vfs.file_id(&call.caller);
    let text = vfs.text(&call.caller);
    let text = text.as_ref().map_or("", |file| &*file.text);
    let name = &argument.name;
    let forms = [
        format!("{name}:="),
        format!("'{name}'"),
        format!("\"{name}\""),
        format!("{name}="),
    ];
    let within = |range: TextRange| {
        let code = range.slice(text);
        let (at, form) = forms
            .iter()
            .find_map(|form| Some((whole(code, form)?, form)))?;
        let lead = u32::from(form.starts_with(['"', '\'']));
        let start = range.start + at as u32 + lead;
        Some(TextRange::new(start, start + name.len() as u32))
    };
    let range = argument
        .range
        .and_then(within)
        .or_else(|| within(call.range))?;
    Some(Span { file, range })
}

/// Where a text holds another that is not the end of a longer name.
fn whole(text: &str, form: &str) -> Option<usize> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let mut places = text.match_indices(form).map(|(at, _)| at);
    places.find(|at| {
        !text
            .get(..*at)
            .is_some_and(|before| before.ends_with(is_part))
    })
}
