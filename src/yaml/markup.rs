//! Tokens that hold names: anchors, tags, directives.

use super::error::RawError;
use super::reader::{Mark, is_blank_or_end, is_break_or_end};
use super::scanner::Scanner;
use super::text::{is_space_or_end, shown};
use super::token::{YamlDirective, YamlToken, YamlTokenKind};

fn is_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '-' | '_')
}

fn is_uri(c: char) -> bool {
    c.is_ascii_alphanumeric() || "-;/?:@&=+$,_.!~*'()[]".contains(c)
}

impl<'t> Scanner<'t> {
    /// `&name` or `*name`
    pub(super) fn scan_anchor(&mut self) -> Result<YamlToken, RawError> {
        let start = self.reader.mark();
        let is_alias = self.reader.advance() == '*';
        let context = if is_alias {
            "while scanning an alias"
        } else {
            "while scanning an anchor"
        };
        let name = self.reader.take_while(is_name);
        let next = self.reader.peek();
        if name.is_empty() || !is_blank_or_end(next) && !"?:,]}%@`".contains(next) {
            return Err(self.unexpected(context, start, "alphabetic or numeric character"));
        }
        let name = name.to_owned();
        Ok(self.token(
            if is_alias {
                YamlTokenKind::Alias(name)
            } else {
                YamlTokenKind::Anchor(name)
            },
            start,
        ))
    }

    /// `!`, `!suffix`, `!handle!suffix` or `!<uri>`
    pub(super) fn scan_tag(&mut self) -> Result<YamlToken, RawError> {
        let start = self.reader.mark();
        let (handle, suffix) = match self.reader.peek_at(1) {
            '<' => {
                self.reader.advance();
                self.reader.advance();
                let uri = self.scan_uri("tag", start)?;
                if self.reader.peek() != '>' {
                    return Err(self.unexpected("while parsing a tag", start, "'>'"));
                }
                self.reader.advance();
                (None, uri)
            }
            next if is_blank_or_end(next) => {
                self.reader.advance();
                (None, "!".to_owned())
            }
            _ => {
                let handle = if self.word_has_second_mark() {
                    self.scan_handle("tag", start)?
                } else {
                    self.reader.advance().to_string()
                };
                (Some(handle), self.scan_uri("tag", start)?)
            }
        };
        if !is_space_or_end(self.reader.peek()) {
            return Err(self.unexpected("while scanning a tag", start, "' '"));
        }
        Ok(self.token(YamlTokenKind::Tag(handle, suffix), start))
    }

    /// Whether the word at the cursor, a `!`, has another `!`.
    fn word_has_second_mark(&self) -> bool {
        self.reader.word().chars().skip(1).any(|c| c == '!')
    }

    /// `!`, `!!` or `!name!`
    fn scan_handle(&mut self, what: &str, start: Mark) -> Result<String, RawError> {
        let context = format!("while scanning a {what}");
        if self.reader.peek() != '!' {
            return Err(self.unexpected(&context, start, "'!'"));
        }
        self.reader.advance();
        if self.reader.peek() == ' ' {
            return Ok("!".to_owned());
        }
        let name = self.reader.take_while(is_name);
        if self.reader.peek() != '!' {
            return Err(self.unexpected(&context, start, "'!'"));
        }
        self.reader.advance();
        Ok(format!("!{name}!"))
    }

    fn scan_uri(&mut self, what: &str, start: Mark) -> Result<String, RawError> {
        let mut uri = String::new();
        loop {
            uri.push_str(self.reader.take_while(is_uri));
            if self.reader.peek() != '%' {
                break;
            }
            uri.push_str(&self.scan_uri_escapes(what, start)?);
        }
        if uri.is_empty() {
            return Err(self.unexpected(&format!("while parsing a {what}"), start, "URI"));
        }
        Ok(uri)
    }

    /// A run of `%41`.
    fn scan_uri_escapes(&mut self, what: &str, start: Mark) -> Result<String, RawError> {
        let context = format!("while scanning a {what}");
        let (mut bytes, at) = (Vec::new(), self.reader.mark());
        while self.reader.peek() == '%' {
            self.reader.advance();
            let digits = self.hex_digits(2).map_err(|found| {
                let problem = format!(
                    "expected URI escape sequence of 2 hexadecimal numbers, but found {}",
                    shown(found)
                );
                RawError::within(&context, start, problem, self.reader.mark())
            })?;
            bytes.push(digits as u8);
        }
        String::from_utf8(bytes).map_err(|error| {
            let (bad, bytes) = (error.utf8_error().valid_up_to(), error.as_bytes());
            let byte = bytes.get(bad).copied().unwrap_or_default();
            let reason = match (error.utf8_error().error_len(), byte) {
                (None, _) => "unexpected end of data",
                (Some(_), 0xC2..=0xF4) => "invalid continuation byte",
                _ => "invalid start byte",
            };
            let problem =
                format!("'utf-8' codec can't decode byte 0x{byte:02x} in position {bad}: {reason}");
            RawError::within(&context, start, problem, at)
        })
    }

    /// A line that begins with `%`.
    pub(super) fn scan_directive(&mut self) -> Result<YamlToken, RawError> {
        let context = "while scanning a directive";
        let start = self.reader.mark();
        self.reader.advance();
        let name = self.reader.take_while(is_name);
        if name.is_empty() || !is_space_or_end(self.reader.peek()) {
            return Err(self.unexpected(context, start, "alphabetic or numeric character"));
        }
        let directive = match name {
            "YAML" => self.scan_version(start)?,
            "TAG" => self.scan_tag_directive(start)?,
            _ => YamlDirective::Other,
        };
        let token = self.token(YamlTokenKind::Directive(directive.clone()), start);
        if directive == YamlDirective::Other {
            self.reader.take_while(|c| !is_break_or_end(c));
        }
        self.skip_blanks_and_comment();
        if !is_break_or_end(self.reader.peek()) {
            return Err(self.unexpected(context, start, "a comment or a line break"));
        }
        self.reader.take_break();
        Ok(token)
    }

    fn scan_version(&mut self, start: Mark) -> Result<YamlDirective, RawError> {
        let context = "while scanning a directive";
        self.reader.take_while(|c| c == ' ');
        let major = self.scan_digits(context, start)?.to_owned();
        if self.reader.peek() != '.' {
            return Err(self.unexpected(context, start, "a digit or '.'"));
        }
        self.reader.advance();
        self.scan_digits(context, start)?;
        if !is_space_or_end(self.reader.peek()) {
            return Err(self.unexpected(context, start, "a digit or ' '"));
        }
        Ok(YamlDirective::Yaml(major))
    }

    fn scan_digits(&mut self, context: &str, start: Mark) -> Result<&'t str, RawError> {
        match self.reader.take_while(|c| c.is_ascii_digit()) {
            "" => Err(self.unexpected(context, start, "a digit")),
            digits => Ok(digits),
        }
    }

    fn scan_tag_directive(&mut self, start: Mark) -> Result<YamlDirective, RawError> {
        let context = "while scanning a directive";
        self.reader.take_while(|c| c == ' ');
        let handle = self.scan_handle("directive", start)?;
        if self.reader.peek() != ' ' {
            return Err(self.unexpected(context, start, "' '"));
        }
        self.reader.take_while(|c| c == ' ');
        let prefix = self.scan_uri("directive", start)?;
        if !is_space_or_end(self.reader.peek()) {
            return Err(self.unexpected(context, start, "' '"));
        }
        Ok(YamlDirective::Tag(handle, prefix))
    }
}
