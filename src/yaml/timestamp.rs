//! Dates and times.

/// The parts of a timestamp as they are written.
#[derive(Debug, PartialEq)]
pub(super) struct TimestampParts {
    pub(super) year: u32,
    pub(super) month: u32,
    pub(super) day: u32,
    pub(super) time: Option<Time>,
}

/// A time of day.
#[derive(Debug, PartialEq)]
pub(super) struct Time {
    hour: u32,
    minute: u32,
    second: u32,
    micros: u32,
    /// Offset from UTC in minutes.
    zone: Option<i32>,
}

/// Reads a timestamp piece by piece.
struct TimestampReader<'t>(&'t str);

impl TimestampReader<'_> {
    fn eat(&mut self, c: char) -> Option<()> {
        self.0 = self.0.strip_prefix(c)?;
        Some(())
    }

    /// A number of `least` to `most` digits.
    fn number(&mut self, least: usize, most: usize) -> Option<u32> {
        let length = self
            .0
            .bytes()
            .take(most)
            .take_while(u8::is_ascii_digit)
            .count();
        let (digits, rest) = self
            .0
            .split_at_checked(length)
            .filter(|_| length >= least)?;
        self.0 = rest;
        digits.parse().ok()
    }

    fn blanks(&mut self) -> bool {
        let rest = self.0.trim_start_matches([' ', '\t']);
        let any = rest.len() < self.0.len();
        self.0 = rest;
        any
    }
}

/// The parts of a text that has the form of a timestamp, valid or not.
pub(super) fn parse(text: &str) -> Option<TimestampParts> {
    let mut cursor = TimestampReader(text);
    let year = cursor.number(4, 4)?;
    cursor.eat('-')?;
    let month = cursor.number(1, 2)?;
    cursor.eat('-')?;
    let day = cursor.number(1, 2)?;
    let time = if cursor.0.is_empty() {
        None
    } else {
        Some(time(&mut cursor)?)
    };
    Some(TimestampParts {
        year,
        month,
        day,
        time,
    })
}

fn time(cursor: &mut TimestampReader<'_>) -> Option<Time> {
    if cursor.eat('T').or_else(|| cursor.eat('t')).is_none() && !cursor.blanks() {
        return None;
    }
    let hour = cursor.number(1, 2)?;
    cursor.eat(':')?;
    let minute = cursor.number(2, 2)?;
    cursor.eat(':')?;
    let second = cursor.number(2, 2)?;
    let mut micros = 0;
    if cursor.eat('.').is_some() {
        let digits = cursor.0.len()
            - cursor
                .0
                .trim_start_matches(|c: char| c.is_ascii_digit())
                .len();
        let (fraction, rest) = cursor.0.split_at_checked(digits)?;
        cursor.0 = rest;
        let six: String = fraction
            .chars()
            .chain(std::iter::repeat('0'))
            .take(6)
            .collect();
        micros = six.parse().ok()?;
    }
    cursor.blanks();
    let zone = zone(cursor)?;
    cursor.0.is_empty().then_some(Time {
        hour,
        minute,
        second,
        micros,
        zone,
    })
}

/// Nothing, `Z`, or an offset.
fn zone(cursor: &mut TimestampReader<'_>) -> Option<Option<i32>> {
    if cursor.0.is_empty() {
        return Some(None);
    }
    if cursor.eat('Z').is_some() {
        return Some(Some(0));
    }
    let sign = if cursor.eat('-').is_some() {
        -1
    } else {
        cursor.eat('+').map(|()| 1)?
    };
    let hours = cursor.number(1, 2)?;
    let minutes = if cursor.eat(':').is_some() {
        cursor.number(2, 2)?
    } else {
        0
    };
    Some(Some(sign * i32::try_from(hours * 60 + minutes).ok()?))
}

impl TimestampParts {
    /// What Python's `str` and `repr` give.
    ///
    /// # Errors
    /// The message of Python's `ValueError` for a date or time that does not exist.
    pub(super) fn show(&self) -> Result<(String, String), String> {
        let TimestampParts {
            year,
            month,
            day,
            time,
        } = self;
        let days = match month {
            2 if year % 4 == 0 && (year % 100 != 0 || year % 400 == 0) => 29,
            2 => 28,
            4 | 6 | 9 | 11 => 30,
            _ => 31,
        };
        if let Some(minutes) = time
            .as_ref()
            .and_then(|time| time.zone)
            .filter(|zone| zone.abs() >= 1440)
        {
            return Err(too_far(minutes));
        }
        let problem = match (year, month, day) {
            (0, ..) => Some("year 0 is out of range"),
            (_, 0 | 13.., _) => Some("month must be in 1..12"),
            (_, _, day) if *day == 0 || *day > days => Some("day is out of range for month"),
            _ => None,
        };
        if let Some(problem) = problem {
            return Err(problem.to_owned());
        }
        let date = format!("{year:04}-{month:02}-{day:02}");
        let Some(time) = time else {
            return Ok((date, format!("datetime.date({year}, {month}, {day})")));
        };
        time.check()?;
        Ok((
            format!("{date} {}", time.text()),
            format!("datetime.datetime({year}, {month}, {day}, {})", time.repr()),
        ))
    }
}

impl Time {
    fn check(&self) -> Result<(), String> {
        let bounds = [
            (self.hour, 23, "hour"),
            (self.minute, 59, "minute"),
            (self.second, 59, "second"),
        ];
        match bounds.iter().find(|(value, most, _)| value > most) {
            Some((_, most, name)) => Err(format!("{name} must be in 0..{most}")),
            None => Ok(()),
        }
    }

    fn text(&self) -> String {
        let mut text = format!("{:02}:{:02}:{:02}", self.hour, self.minute, self.second);
        if self.micros != 0 {
            text.push_str(&format!(".{:06}", self.micros));
        }
        if let Some(zone) = self.zone {
            let sign = if zone < 0 { '-' } else { '+' };
            text.push_str(&format!(
                "{sign}{:02}:{:02}",
                zone.abs() / 60,
                zone.abs() % 60
            ));
        }
        text
    }

    /// The arguments of `datetime.datetime` from the hour on.
    fn repr(&self) -> String {
        let mut text = format!("{}, {}", self.hour, self.minute);
        if self.second != 0 || self.micros != 0 {
            text.push_str(&format!(", {}", self.second));
        }
        if self.micros != 0 {
            text.push_str(&format!(", {}", self.micros));
        }
        match self.zone {
            None => {}
            Some(0) => text.push_str(", tzinfo=datetime.timezone.utc"),
            Some(zone) => {
                text.push_str(&format!(", tzinfo=datetime.timezone({})", timedelta(zone)));
            }
        }
        text
    }
}

/// Python's `repr` of a time difference: whole days, possibly below zero, and seconds.
fn timedelta(minutes: i32) -> String {
    let (days, seconds) = (minutes.div_euclid(1440), minutes.rem_euclid(1440) * 60);
    let parts: Vec<String> = [("days", days), ("seconds", seconds)]
        .iter()
        .filter(|(_, value)| *value != 0)
        .map(|(name, value)| format!("{name}={value}"))
        .collect();
    format!("datetime.timedelta({})", parts.join(", "))
}

fn too_far(minutes: i32) -> String {
    format!(
        "offset must be a timedelta strictly between -timedelta(hours=24) and timedelta(hours=24), not {}.",
        timedelta(minutes)
    )
}
