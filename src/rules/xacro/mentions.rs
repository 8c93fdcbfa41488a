//! What the texts of a description mention, whether expansion came by or not.
use super::super::context::DocumentCx;
use super::super::xacro::words::MentionedWords;
use super::untaken;
use base::FastSet;
use expand::FileIdx;

/// The mentions of the files of an expansion, in their order, and of those that other arguments would bring in;
/// none when it cannot be told which.
pub(super) fn everywhere<'a>(cx: &'a DocumentCx<'_>) -> Option<&'a [MentionedWords]> {
    let mentions = cx.mentions.get_or_init(|| {
        let untaken = untaken::files(cx)?;
        let read = cx.expansion.files.iter().map(|file| &file.source);
        Some(
            read.chain(&untaken)
                .map(|file| MentionedWords::of_file(file))
                .collect(),
        )
    });
    mentions.as_deref()
}

/// The same without some files.
pub(super) fn outside<'a>(
    cx: &'a DocumentCx<'_>,
    without: &'a FastSet<FileIdx>,
) -> Option<impl Iterator<Item = &'a MentionedWords> + Clone> {
    let files = (0..)
        .map(FileIdx)
        .zip(everywhere(cx)?)
        .filter(|(file, _)| !without.contains(file));
    Some(files.map(|(_, mentions)| mentions))
}

#[cfg(test)]
mod tests {
    use super::MentionedWords;
    use xml::Document;

    #[test]
    fn what_is_mentioned() {
        let text = "<r><xacro:macro name='m' params='a b:=^ c:=^|2 d:=3'><x y='${a * f(e)}' z='g'/>h ${i}\
                    <!-- ${j} --><xacro:arm.part/><xacro:insert_block name='k'/></xacro:macro></r>";
        let document = Document::parse(text);
        let item = document.items().next().unwrap().1.clone();
        let mut mentions = MentionedWords::default();
        mentions.add_item(&item);
        let found: String = "abcdefghijk"
            .chars()
            .filter(|c| mentions.word(&c.to_string()))
            .collect();
        assert_eq!(found, "abcefhi");
        assert!(
            mentions.tags.contains("arm.part")
                && mentions.blocks.contains("k")
                && !mentions.computed
        );
        let inside = MentionedWords::inside(item.element().unwrap());
        assert!(!inside.word("b") && inside.word("a"));
    }
}
