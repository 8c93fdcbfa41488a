//! Reading a launch file, script or page for the descriptions it names and the arguments it gives.

use std::borrow::Cow;
use std::cell::LazyCell;
use std::path::Path;

use super::{Caller, GivenArg, config};
use base::{FastMap, FastSet};

/// Whether a file of that name may call a robot.
pub(super) fn may_call(name: &str) -> bool {
    const ENDINGS: [&str; 16] = [
        "launch", "xml", "py", "sh", "bash", "md", "rst", "txt", "yaml", "yml", "cmake", "test", "in", "cpp",
        "toml", "ipynb",
    ];
    // these say what is installed, what depends on what, and what was; not what is used
    let tells_nothing =
        ["package.xml", "setup.py"].contains(&name) || name.to_lowercase().starts_with("changelog");
    let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
    ENDINGS.contains(&ending) && !tells_nothing && !is_description(name)
}

fn is_description(name: &str) -> bool {
    let name = name.to_lowercase();
    let name = name.strip_suffix(".xml").unwrap_or(&name);
    name.ends_with(".xacro") || name.ends_with(".urdf")
}

/// What a file calls; none when it names no description.
pub(super) fn caller(path: &Path, text: &str) -> Option<Caller> {
    let name = path.file_name()?.to_str()?;
    let text = &*without_comments(name, text);
    let descriptions = descriptions(name, text);
    let endings = computed(text);
    let is_yaml = name.ends_with(".yaml") || name.ends_with(".yml");
    let based_on = is_yaml.then(|| config::based_on(text)).flatten();
    if descriptions.is_empty() && endings.is_empty() && based_on.is_none() {
        return None;
    }
    let declared = LazyCell::new(|| declared(text));
    let mut args = Vec::new();
    for (at, _) in text.match_indices(":=") {
        let (before, after) = text.split_at(at);
        let own = last_word(before);
        if !own.is_empty() && !own.starts_with(|c: char| c == '_' || c.is_ascii_digit()) {
            let value = given(after.get(2..).unwrap_or("")).and_then(|given| given.resolved(text, &declared));
            args.push(GivenArg { name: own.to_owned(), value });
        }
    }
    args.extend(mappings(text));
    if is_yaml {
        args.extend(config::urdf_params(text));
    }
    let is_open = takes_any(text);
    Some(Caller { path: path.to_owned(), descriptions, endings, is_open, args, based_on })
}

/// A text without its comments: what they name is not called.
fn without_comments<'t>(name: &str, text: &'t str) -> Cow<'t, str> {
    match name.rsplit_once('.').map_or("", |(_, ending)| ending) {
        "launch" | "xml" | "test" if text.contains("<!--") => {
            let mut parts = text.split("<!--");
            let first = parts.next().unwrap_or("").to_owned();
            let behind = parts.filter_map(|part| Some(part.split_once("-->")?.1));
            Cow::Owned(behind.fold(first, |kept, part| kept + part))
        }
        "py" | "sh" | "bash" | "yaml" | "yml" if text.contains('#') => {
            Cow::Owned(text.split_inclusive('\n').map(without_line_comment).collect())
        }
        _ => Cow::Borrowed(text),
    }
}

/// A line up to a `#` that begins a comment: outside of quotes, and behind a blank or nothing.
fn without_line_comment(line: &str) -> &str {
    let (mut quote, mut before) = (None, ' ');
    for (at, c) in line.char_indices() {
        match c {
            '"' | '\'' if quote.is_none() => quote = Some(c),
            c if quote == Some(c) && before != '\\' => quote = None,
            '#' if quote.is_none()
                && (before.is_whitespace() || matches!(before, ',' | '(' | '[' | ')' | ']')) =>
            {
                return line.get(..at).unwrap_or(line);
            }
            _ => {}
        }
        before = c;
    }
    line
}

/// The names of descriptions in a text, without folders. What is only installed or included is not called.
fn descriptions(name: &str, text: &str) -> FastSet<String> {
    let mut found = FastSet::default();
    for ending in [".xacro", ".urdf", ".URDF"] {
        for (at, _) in text.match_indices(ending) {
            let (before, after) = text.split_at(at + ending.len());
            let goes_on = |c: char| c.is_alphanumeric() || c == '_' || c == '.' && after.len() > 1;
            let sentence_ends = after.starts_with('.')
                && !after.get(1..).is_some_and(|rest| rest.starts_with(char::is_alphanumeric));
            if after.starts_with(goes_on) && !sentence_ends {
                continue;
            }
            let word =
                before.rfind(|c: char| !is_name(c)).map_or(before, |at| before.get(at..).unwrap_or(""));
            let word = word.trim_start_matches(|c: char| !is_name(c));
            let lead = before.strip_suffix(word).unwrap_or("");
            if word.len() > ending.len()
                && !is_installed(name, lead)
                && !is_included(lead)
                && !is_listed(lead)
            {
                found.insert(word.to_owned());
            }
        }
    }
    found
}

/// Whether a text holds a name by itself, not as a part of another.
pub(super) fn has_name(text: &str, name: &str) -> bool {
    text.match_indices(name).any(|(at, _)| {
        let (before, after) = text.split_at(at);
        !before.ends_with(is_name) && !after.get(name.len()..).is_some_and(|rest| rest.starts_with(is_name))
    })
}

/// What the names of descriptions end with whose beginnings are computed: `_base.xacro` of `$(arg kind)_base.xacro`. The
/// empty text when the whole name is an argument of the call: `xacro $(arg model)`.
fn computed(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (at, _) in text.match_indices([')', '}']) {
        let after = text.get(at + 1..).unwrap_or("");
        let ending = after.split(|c: char| !is_name(c)).next().unwrap_or("");
        if is_description(ending) && !is_included(text.get(..at).unwrap_or("")) {
            found.push(ending.to_owned());
        }
    }
    if takes_any(text) || ["xacro.process", "xacro.parse("].iter().any(|call| text.contains(call)) {
        found.push(String::new());
    }
    found
}

/// Whether the name of the description is an argument of the call.
fn takes_any(text: &str) -> bool {
    const ARGUMENTS: [&str; 3] = ["$(arg ", "$(var ", "LaunchConfiguration("];
    let calls = text.match_indices("xacro").filter_map(|(at, word)| text.get(at + word.len()..));
    let mut names = calls.map(|after| after.trim_start_matches([' ', '\'', '"', ',', '.', 'p', 'y']));
    names.any(|name| ARGUMENTS.iter().any(|argument| name.starts_with(argument)))
}

fn is_name(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '-' | '.')
}

/// Whether a name behind this text stands in an `install(...)` of CMake.
fn is_installed(name: &str, lead: &str) -> bool {
    let command = lead.rfind('(').map_or("", |at| last_word(lead.get(..at).unwrap_or("")));
    let is_cmake = name == "CMakeLists.txt" || name.ends_with(".cmake");
    is_cmake && (command.eq_ignore_ascii_case("install") || command.eq_ignore_ascii_case("configure_file"))
}

/// Whether a name behind this text is part of a drawn tree of folders.
fn is_listed(lead: &str) -> bool {
    lead.rsplit('\n').next().unwrap_or("").contains(['├', '└', '│'])
}

/// Whether a name behind this text is that of an include.
fn is_included(lead: &str) -> bool {
    let tag = lead.rfind('<').and_then(|at| lead.get(at..)).unwrap_or("");
    tag.starts_with("<xacro:include") || tag.starts_with("<include") && tag.contains("filename")
}

/// The identifier at the end of a text.
fn last_word(text: &str) -> &str {
    let text = text.trim_end_matches(' ');
    let start = text.rfind(|c: char| !(c.is_alphanumeric() || c == '_'));
    let start = start
        .map_or(0, |at| at + text.get(at..).and_then(|rest| rest.chars().next()).map_or(1, char::len_utf8));
    text.get(start..).unwrap_or("")
}

/// What stands behind `:=`.
enum Given<'t> {
    /// The value itself.
    Literal(&'t str),
    /// The argument of the launch file that has the value.
    LaunchArgument(&'t str),
    /// The variable of a script that has it.
    Variable(&'t str),
}

/// What is given behind `:=`: bare text, a substitution of a launch file, or the next element of a list of Python.
fn given(after: &str) -> Option<Given<'_>> {
    if let Some(rest) = after.strip_prefix("$(") {
        let (kind, name) = rest.split(')').next()?.split_once(' ')?;
        return ["arg", "var"].contains(&kind).then(|| Given::LaunchArgument(name.trim()));
    }
    let ends = |c: char| c.is_whitespace() || matches!(c, '"' | '\'' | ',' | '<' | '`' | ']' | ';');
    let bare = after.split(ends).next()?;
    if !bare.is_empty() {
        let bare = bare.trim_end_matches(')');
        return (!bare.contains(['$', '{', '%', '\\', '('])).then_some(Given::Literal(bare));
    }
    let next = after.get(1..).filter(|_| after.starts_with(['"', '\'']))?;
    let next = next.trim_start().strip_prefix([',', '+'])?.trim_start();
    if let Some(name) = next.strip_prefix("LaunchConfiguration(") {
        return Some(Given::LaunchArgument(quoted(name)?));
    }
    match quoted(next) {
        Some(literal) => (!literal.is_empty() && !literal.contains(['{', '$', ' ', '\n']))
            .then_some(Given::Literal(literal)),
        None => {
            let name = next.split(|c: char| !(c.is_alphanumeric() || c == '_')).next()?;
            (!name.is_empty() && !next.starts_with(|c: char| c.is_ascii_digit()))
                .then_some(Given::Variable(name))
        }
    }
}

/// The text in quotes at the start of another.
fn quoted(text: &str) -> Option<&str> {
    let text = text.trim_start();
    let quote = text.chars().next().filter(|c| matches!(c, '"' | '\''))?;
    text.get(1..)?.split_once(quote).map(|(inner, _)| inner)
}

impl Given<'_> {
    /// The value, where the text of the file says it.
    fn resolved(&self, text: &str, declared: &FastMap<String, String>) -> Option<String> {
        match self {
            Given::Literal(value) => Some((*value).to_owned()),
            Given::LaunchArgument(name) => declared.get(*name).cloned().map(unquoted),
            Given::Variable(name) => {
                let assigned = format!("{name} = LaunchConfiguration(");
                let (_, after) = text.split_once(&assigned)?;
                declared.get(quoted(after)?).cloned().map(unquoted)
            }
        }
    }
}

/// A value as a shell hands it on: quotes around it are not part of it.
fn unquoted(value: String) -> String {
    let inner = ['"', '\''].into_iter().find_map(|quote| value.strip_prefix(quote)?.strip_suffix(quote));
    inner.map(str::to_owned).unwrap_or(value)
}

/// The arguments that a launch file declares with a plain default, in XML or Python.
fn declared(text: &str) -> FastMap<String, String> {
    let behind = |tag: &str, name: &str| quoted(tag.split_once(&format!("{name}="))?.1).map(str::to_owned);
    let tags = text.split("<arg").skip(1).filter_map(|rest| rest.split_once('>'));
    let of_xml = tags.filter_map(|(tag, _)| {
        let default = behind(tag, "default").or_else(|| behind(tag, "value"))?;
        Some((behind(tag, "name")?, default))
    });
    let of_python = text.split("DeclareLaunchArgument(").skip(1).filter_map(|rest| {
        let name = quoted(rest).map(str::to_owned).or_else(|| behind(rest, "name"))?;
        // what lies behind the next call belongs to something else
        let own = rest.split(" Node(").next()?;
        Some((name, behind(own, "default_value")?))
    });
    of_xml.chain(of_python).filter(|(_, default)| !default.contains("$(")).collect()
}

/// The arguments in `mappings={'name': 'value'}` of Python.
fn mappings(text: &str) -> Vec<GivenArg> {
    let mut given = Vec::new();
    for (at, word) in text.match_indices("mappings") {
        let after = text.get(at + word.len()..).unwrap_or("").trim_start().trim_start_matches(['"', '\'']);
        let Some(dict) =
            after.trim_start().strip_prefix(['=', ':']).and_then(|rest| rest.trim_start().strip_prefix('{'))
        else {
            continue;
        };
        let dict = dict.split('}').next().unwrap_or("");
        for pair in dict.split(',') {
            let Some((name, value)) = pair.split_once(':') else { continue };
            let literal = |text: &str| quoted(text).map(str::to_owned);
            given.extend(literal(name).map(|name| GivenArg { name, value: literal(value) }));
        }
    }
    given
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{caller, may_call};

    /// The descriptions that a file calls, and the arguments with their values.
    type Called<'a> = (&'a [&'a str], &'a [(&'a str, Option<&'a str>)]);

    fn check_caller(name: &str, text: &str, expected: Option<Called<'_>>) {
        let found = caller(Path::new(name), text).map(|caller| {
            let mut names: Vec<String> = caller.descriptions.into_iter().collect();
            names.sort_unstable();
            (names, caller.args.into_iter().map(|arg| (arg.name, arg.value)).collect::<Vec<_>>())
        });
        let expected = expected.map(|(names, args)| {
            let args = args.iter().map(|(name, value)| ((*name).to_owned(), value.map(str::to_owned)));
            (names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>(), args.collect::<Vec<_>>())
        });
        assert_eq!(found, expected, "{text}");
    }

    #[test]
    fn launch_files_in_xml() {
        let text = r#"<launch><arg name="side" default="left"/><arg name="who"/>
            <param name="d" command="$(find xacro)/xacro '$(find arm)/urdf/arm.urdf.xacro' side:=$(arg side) who:=$(arg who) n:=2"/>
            </launch>"#;
        let args = [("side", Some("left")), ("who", None), ("n", Some("2"))];
        check_caller("a.launch", text, Some((&["arm.urdf.xacro"], &args)));
    }

    #[test]
    fn launch_files_in_python() {
        let text = r#"Command([FindExecutable(name="xacro"), " ", PathJoinSubstitution([pkg, "urdf", "arm.urdf.xacro"]),
            " ", "name:=", "arm", " ", "kind:=", kind, " sim:=true"])"#;
        let args = [("name", Some("arm")), ("kind", None), ("sim", Some("true"))];
        check_caller("a.launch.py", text, Some((&["arm.urdf.xacro"], &args)));
        let text = r#"DeclareLaunchArgument('prefix', default_value='""'), Command('arm.xacro prefix:=', LaunchConfiguration('prefix'))"#;
        check_caller("p.launch.py", text, Some((&["arm.xacro"], &[("prefix", Some(""))])));
        let text = r#"DeclareLaunchArgument('kind', default_value='big'), which = LaunchConfiguration("kind")
            Command(['xacro ', 'arm.xacro', ' a:=', LaunchConfiguration('kind'), ' b:=', which, ' c:=', other])"#;
        let args = [("a", Some("big")), ("b", Some("big")), ("c", None)];
        check_caller("b.launch.py", text, Some((&["arm.xacro"], &args)));
        let text = "<arg name='model' default='$(find a)/urdf/$(arg kind)_base.xacro'/> command='$(find xacro)/xacro $(arg model) x:=1'";
        let found = caller(Path::new("a.launch"), text).unwrap();
        assert_eq!(found.endings, ["_base.xacro", ""]);
        let text = "doc = xacro.parse(open(path))\nxacro.process_doc(doc, mappings={'side': side})";
        check_caller("b.launch.py", text, Some((&[], &[("side", None)])));
        let text = r#"xacro.process_file(os.path.join(share, 'arm.xacro'), mappings={'side': 'left', "kind": kind})"#;
        let args = [("side", Some("left")), ("kind", None)];
        check_caller("test_arm.py", text, Some((&["arm.xacro"], &args)));
    }

    #[test]
    fn pages_and_scripts() {
        let text = "Run `xacro urdf/arm.xacro side:=left`. See arm.urdf.";
        check_caller("README.md", text, Some((&["arm.urdf", "arm.xacro"], &[("side", Some("left"))])));
        check_caller("README.md", "<xacro:include filename=\"$(find arm)/urdf/arm.xacro\"/>", None);
        check_caller("README.md", "├── urdf\n│   └── arm.xacro  # the arm\n", None);
        check_caller("CMakeLists.txt", "install(FILES urdf/arm.xacro DESTINATION share)", None);
        check_caller("CMakeLists.txt", "xacro_add_files(urdf/arm.xacro)", Some((&["arm.xacro"], &[])));
        check_caller("a.py", "'.xacro' x:=1", None);
        check_caller("a.py", "arm.urdf_old", None);
        check_caller("ä.md", "ä:=ö ä.urdf", Some((&["ä.urdf"], &[("ä", Some("ö"))])));
    }

    #[test]
    fn comments_call_nothing() {
        let text =
            "<launch><!-- xacro old.urdf.xacro --><param command='xacro arm.xacro'/><!-- a:=1 --></launch>";
        check_caller("a.launch", text, Some((&["arm.xacro"], &[])));
        let text = "# xacro old.urdf.xacro a:=1\nrun('arm.xacro', 'b#:=2')  # or hand.xacro\n";
        check_caller("a.launch.py", text, Some((&["arm.xacro"], &[])));
        check_caller("a.sh", "xacro 'it#s.xacro' # x.xacro", Some((&["s.xacro"], &[])));
        check_caller("a.launch.py", "# only arm.xacro", None);
    }

    #[test]
    fn which_files_are_read() {
        for (name, expected) in [
            ("a.launch.py", true),
            ("a.launch", true),
            ("CMakeLists.txt", true),
            ("a.urdf.xacro", false),
            ("a.urdf.xml", false),
            ("package.xml", false),
            ("CHANGELOG.rst", false),
            ("a.stl", false),
        ] {
            assert_eq!(may_call(name), expected, "{name}");
        }
    }
}
