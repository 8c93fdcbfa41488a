//! Paths as texts: how they are written, shown and compared on each system.
//!
//! Everything that depends on the system is here, as functions of texts, so that each system is tested on every other.

use std::borrow::Cow;

/// A family of systems, by how it writes paths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum System {
    /// `/folder/file`; a backslash is a letter like any other.
    Posix,
    /// `C:\folder\file`, `C:/folder/file`, `\\server\share\file`; letters of any case mean the same file.
    Windows,
}

/// The system that this program runs on.
pub const HERE: System = if cfg!(windows) {
    System::Windows
} else {
    System::Posix
};

/// Names that are devices in every folder of Windows, with any ending.
const DEVICES: [&str; 4] = ["con", "prn", "aux", "nul"];

impl System {
    /// A path as it is written into robots and shown in messages. On Windows it has slashes, which every program
    /// there reads and which are no escapes in expressions and URIs, a drive in upper case, and no `\\?\` in front.
    pub fn slashed(self, path: &str) -> Cow<'_, str> {
        if self == System::Posix {
            return Cow::Borrowed(path);
        }
        let plain = match path
            .strip_prefix(r"\\?\UNC\")
            .or_else(|| path.strip_prefix("//?/UNC/"))
        {
            Some(share) => Cow::Owned(format!("//{share}")),
            None => Cow::Borrowed(
                path.strip_prefix(r"\\?\")
                    .or_else(|| path.strip_prefix("//?/"))
                    .unwrap_or(path),
            ),
        };
        let is_lower = has_drive(&plain) && plain.starts_with(|c: char| c.is_ascii_lowercase());
        if !is_lower && !plain.contains('\\') {
            return plain;
        }
        let mut slashed = plain.replace('\\', "/");
        if is_lower && let Some(drive) = slashed.get_mut(..1) {
            drive.make_ascii_uppercase();
        }
        Cow::Owned(slashed)
    }

    /// What an absolute path with slashes begins with: `/`, `C:/`, `//server/share/`. Empty for a relative one.
    pub fn root(self, path: &str) -> &str {
        let end = match self {
            System::Windows if has_drive(path) => usize::from(path.get(2..3) == Some("/")) * 3,
            System::Windows if path.starts_with("//") => {
                let mut slashes = path.match_indices('/').skip(2);
                let (_, share) = (slashes.next(), slashes.next());
                share.map_or(path.len(), |(at, _)| at + 1)
            }
            _ => usize::from(path.starts_with('/')),
        };
        path.get(..end).unwrap_or("")
    }

    /// Whether a path counts from the top: of the disk, a drive or a share.
    pub fn is_absolute(self, path: &str) -> bool {
        !self.root(&self.slashed(path)).is_empty()
    }

    /// An absolute path without `.`, `..` and doubled slashes, by its text alone, as `os.path.abspath` gives it.
    pub fn normalized(self, path: &str) -> String {
        let path = self.slashed(path);
        let root = self.root(&path);
        let mut parts: Vec<&str> = Vec::new();
        for part in path
            .get(root.len()..)
            .unwrap_or("")
            .split('/')
            .filter(|p| !p.is_empty() && *p != ".")
        {
            if part == ".." {
                parts.pop();
            } else {
                parts.push(part);
            }
        }
        let root = if root.is_empty() { "/" } else { root };
        let slash = if root.ends_with('/') { "" } else { "/" };
        format!("{root}{slash}{}", parts.join("/"))
    }

    /// The URI of an absolute path: `file:///folder/file`, `file:///C:/folder/file`, `file://server/share/file`.
    pub fn file_uri(self, path: &str) -> String {
        let path = self.slashed(path);
        let (mut uri, rest) = match path.strip_prefix("//").filter(|_| self == System::Windows) {
            Some(share) => (String::from("file://"), share),
            None if path.starts_with('/') => (String::from("file://"), &*path),
            None => (String::from("file:///"), &*path),
        };
        let drive = if self == System::Windows && has_drive(rest) {
            2
        } else {
            0
        };
        for (at, byte) in rest.bytes().enumerate() {
            match byte {
                b'/' | b'-' | b'_' | b'.' | b'~' => uri.push(char::from(byte)),
                byte if byte.is_ascii_alphanumeric() || at < drive => uri.push(char::from(byte)),
                other => uri.push_str(&format!("%{other:02X}")),
            }
        }
        uri
    }

    /// The path that a URI leads to, by what follows its `file:`; none when it is not absolute. Nothing is decoded but
    /// the colon of a drive.
    pub fn of_file_uri(self, rest: &str) -> Option<String> {
        let path = match rest.strip_prefix("//") {
            Some(authority) => authority.strip_prefix("localhost").unwrap_or(authority),
            None => rest,
        };
        if self == System::Posix {
            return path.starts_with('/').then(|| path.to_owned());
        }
        let below = path.strip_prefix('/').unwrap_or(path);
        let encoded = below
            .get(1..4)
            .is_some_and(|colon| colon.eq_ignore_ascii_case("%3a"));
        let drive = if encoded {
            below.replacen(below.get(1..4).unwrap_or(""), ":", 1)
        } else {
            below.to_owned()
        };
        if has_drive(&drive) {
            return Some(self.slashed(&drive).into_owned());
        }
        match rest.strip_prefix("//") {
            // `file:////server/share`
            _ if path.starts_with("//") => Some(path.to_owned()),
            Some(authority)
                if !authority.starts_with('/') && !authority.starts_with("localhost/") =>
            {
                authority.contains('/').then(|| format!("//{authority}"))
            }
            _ => path.starts_with('/').then(|| path.to_owned()),
        }
    }

    /// What has to stand between a text and a path behind it: in a URI, a path without a leading slash needs one.
    pub fn joint(self, before: &str, path: &str) -> &'static str {
        let is_drive = self == System::Windows && has_drive(path) && !self.root(path).is_empty();
        if is_drive && before.to_ascii_lowercase().ends_with("file://") {
            "/"
        } else {
            ""
        }
    }

    /// A name as it is compared with others.
    pub fn folded(self, name: &str) -> Cow<'_, str> {
        match self {
            System::Posix => Cow::Borrowed(name),
            System::Windows => Cow::Owned(name.to_lowercase()),
        }
    }

    /// Why a path is no name of a file, whatever the disk holds.
    pub fn refusal(self, path: &str) -> Option<&'static str> {
        if self == System::Posix {
            return None;
        }
        let path = self.slashed(path);
        if path.starts_with("//./") {
            return Some("it names a device");
        }
        if has_drive(&path) && self.root(&path).is_empty() {
            return Some("it has a drive without a slash after the colon");
        }
        let name = path
            .rsplit('/')
            .next()
            .unwrap_or("")
            .split(['.', ':'])
            .next()
            .unwrap_or("")
            .trim_end();
        let name = name.to_ascii_lowercase();
        let port = name
            .strip_prefix("com")
            .or_else(|| name.strip_prefix("lpt"));
        let is_port = port.is_some_and(|number| matches!(number.as_bytes(), [b'1'..=b'9']));
        (is_port || DEVICES.contains(&name.as_str())).then_some("it names a device")
    }
}

/// Whether a path begins with a drive, as `C:`.
fn has_drive(path: &str) -> bool {
    matches!(path.as_bytes(), [letter, b':', ..] if letter.is_ascii_alphabetic())
}

#[cfg(test)]
mod tests {
    use super::System::{Posix, Windows};

    #[test]
    fn slashes() {
        for (path, expected) in [
            (r"C:\ws\src\a.xacro", "C:/ws/src/a.xacro"),
            (r"c:\ws/src\a.xacro", "C:/ws/src/a.xacro"),
            (r"\\?\C:\ws", "C:/ws"),
            (r"\\?\UNC\server\share\a", "//server/share/a"),
            (
                r"\\wsl.localhost\Ubuntu\home\me",
                "//wsl.localhost/Ubuntu/home/me",
            ),
            (r"parts\arm.xacro", "parts/arm.xacro"),
            ("Z:/done", "Z:/done"),
            ("", ""),
            ("é:/x", "é:/x"),
        ] {
            assert_eq!(Windows.slashed(path), expected);
        }
        assert_eq!(Posix.slashed(r"/a\b"), r"/a\b");
    }

    #[test]
    fn roots() {
        for (path, expected) in [
            ("C:/a", "C:/"),
            ("C:a", ""),
            ("C:", ""),
            ("//server/share/a", "//server/share/"),
            ("//server/share", "//server/share"),
            ("//server", "//server"),
            ("/a", "/"),
            ("a/b", ""),
        ] {
            assert_eq!(Windows.root(path), expected, "{path}");
        }
        assert_eq!((Posix.root("//a"), Posix.root("C:/a")), ("/", ""));
        assert!(
            Windows.is_absolute(r"\\server\share")
                && Windows.is_absolute(r"c:\x")
                && !Windows.is_absolute("c:x")
        );
    }

    #[test]
    fn normal_forms() {
        for (system, path, expected) in [
            (Posix, "/a/./b//../c/", "/a/c"),
            (Posix, "/..", "/"),
            (Windows, r"Z:\work\.\a\..", "Z:/work"),
            (Windows, "z:/", "Z:/"),
            (Windows, r"\\server\share\a\..\..", "//server/share/"),
            (Windows, r"\\server\share", "//server/share/"),
        ] {
            assert_eq!(system.normalized(path), expected, "{path}");
        }
    }

    #[test]
    fn uris() {
        for (system, path, uri) in [
            (
                Posix,
                "/my robot/ä:1.xacro",
                "file:///my%20robot/%C3%A4%3A1.xacro",
            ),
            (
                Windows,
                r"c:\my robot\a.xacro",
                "file:///C:/my%20robot/a.xacro",
            ),
            (Windows, r"\\server\share\a b", "file://server/share/a%20b"),
        ] {
            assert_eq!(system.file_uri(path), uri);
        }
        for (rest, expected) in [
            ("///C:/a/b.stl", Some("C:/a/b.stl")),
            ("///c%3A/a/b.stl", Some("C:/a/b.stl")),
            ("//localhost/C:/a", Some("C:/a")),
            ("//C:/a", Some("C:/a")),
            ("/C:/a", Some("C:/a")),
            ("//server/share/a", Some("//server/share/a")),
            ("////server/share/a", Some("//server/share/a")),
            ("///a/b", Some("/a/b")),
            ("a/b", None),
            ("//a", None),
        ] {
            assert_eq!(Windows.of_file_uri(rest).as_deref(), expected, "{rest}");
        }
        for (rest, expected) in [
            ("///a/b", Some("/a/b")),
            ("//localhost/a", Some("/a")),
            ("/a", Some("/a")),
            ("//a/b", None),
        ] {
            assert_eq!(Posix.of_file_uri(rest).as_deref(), expected, "{rest}");
        }
    }

    #[test]
    fn a_drive_behind_the_scheme_gets_its_slash() {
        assert_eq!(Windows.joint("file://", "C:/ws/arm"), "/");
        assert_eq!(Windows.joint("file:///", "C:/ws/arm"), "");
        assert_eq!(Windows.joint("file://", "//server/share"), "");
        assert_eq!(Windows.joint("path=", "C:/ws/arm"), "");
        assert_eq!(Posix.joint("file://", "C:/ws/arm"), "");
    }

    #[test]
    fn what_is_no_file() {
        for path in [
            r"\\.\COM1",
            "C:arm.xacro",
            r"C:\ws\nul",
            "ws/Con.xacro",
            "aux",
            "LPT9.txt",
        ] {
            assert!(Windows.refusal(path).is_some(), "{path}");
        }
        for path in [
            r"C:\ws\conveyor.xacro",
            "com0",
            "com10",
            "nullable.xacro",
            r"\\server\share\a",
            "",
        ] {
            assert_eq!(Windows.refusal(path), None, "{path}");
        }
        assert_eq!(Posix.refusal("/ws/con"), None);
    }
}
