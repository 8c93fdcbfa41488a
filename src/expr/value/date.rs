//! Dates and times of YAML files.

use crate::display::push;

/// A date, or date and time.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DateValue {
    /// Year, month, day.
    pub date: (i32, u32, u32),
    /// Hour, minute, second, microsecond; none for a plain date.
    pub time: Option<(u32, u32, u32, u32)>,
    /// Offset from UTC in seconds, if given.
    pub utc_offset: Option<i32>,
}

impl DateValue {
    /// Microseconds since year zero in UTC (local time where there is no offset), for comparison.
    pub(crate) fn instant(&self) -> i64 {
        let (year, month, day) = self.date;
        let (hour, minute, second, micro) = self.time.unwrap_or_default();
        let days = days_before(year, month) + i64::from(day);
        let seconds =
            days * 86_400 + i64::from(hour) * 3600 + i64::from(minute) * 60 + i64::from(second);
        (seconds - i64::from(self.utc_offset.unwrap_or(0))) * 1_000_000 + i64::from(micro)
    }
}

/// Days of the Gregorian calendar before the first of a month.
fn days_before(year: i32, month: u32) -> i64 {
    // Counting years from March puts the leap day last.
    let (year, month) = if month <= 2 {
        (i64::from(year) - 1, month + 9)
    } else {
        (i64::from(year), month - 3)
    };
    year * 365 + year / 4 - year / 100 + year / 400 + (i64::from(month) * 153 + 2) / 5
}

/// `2001-12-14` or `2001-12-14 21:59:43.100000+01:00`
pub(crate) fn date_text(date: &DateValue, separator: &str) -> String {
    let (year, month, day) = date.date;
    let mut out = format!("{year:04}-{month:02}-{day:02}");
    let Some((hour, minute, second, micro)) = date.time else {
        return out;
    };
    push(
        &mut out,
        format_args!("{separator}{hour:02}:{minute:02}:{second:02}"),
    );
    if micro != 0 {
        push(&mut out, format_args!(".{micro:06}"));
    }
    if let Some(offset) = date.utc_offset {
        let sign = if offset < 0 { '-' } else { '+' };
        let (hours, minutes) = (
            offset.unsigned_abs() / 3600,
            offset.unsigned_abs() / 60 % 60,
        );
        push(&mut out, format_args!("{sign}{hours:02}:{minutes:02}"));
    }
    out
}

/// `datetime.date(2001, 12, 14)`
pub(crate) fn date_repr(date: &DateValue) -> String {
    let (year, month, day) = date.date;
    let Some((hour, minute, second, micro)) = date.time else {
        return format!("datetime.date({year}, {month}, {day})");
    };
    let mut out = format!("datetime.datetime({year}, {month}, {day}, {hour}, {minute}");
    if second != 0 || micro != 0 {
        push(&mut out, format_args!(", {second}"));
    }
    if micro != 0 {
        push(&mut out, format_args!(", {micro}"));
    }
    match date.utc_offset {
        None => {}
        Some(0) => out.push_str(", tzinfo=datetime.timezone.utc"),
        Some(offset) => {
            let days = if offset < 0 { "days=-1, " } else { "" };
            let seconds = offset.rem_euclid(86_400);
            push(
                &mut out,
                format_args!(
                    ", tzinfo=datetime.timezone(datetime.timedelta({days}seconds={seconds}))"
                ),
            );
        }
    }
    out.push(')');
    out
}
