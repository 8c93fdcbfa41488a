//! YAML files as values of expressions.
use std::sync::Arc;

use base::TextRange;
use expr::{
    self, Budget, DateValue, ErrorKind, EvalError, Host, HostFn, Lookup, ScopeId, Str, Value,
    literal,
};
use yaml::{Unit, YamlKind, YamlNode};

/// The value of a loaded file, with xacro's unit tags computed. Only the outermost list or mapping has
/// dotted access; it hands it on to what is taken out of it.
///
/// # Errors
/// When the expression of a value with a unit cannot be evaluated.
pub fn file_value(node: &YamlNode, budget: &mut Budget) -> Result<Value, EvalError> {
    convert(node, true, budget)
}

fn convert(node: &YamlNode, top: bool, budget: &mut Budget) -> Result<Value, EvalError> {
    Ok(match &node.kind {
        YamlKind::Null => Value::None,
        YamlKind::Bool(value) => Value::Bool(*value),
        YamlKind::Int(value) => Value::int(value.clone()),
        YamlKind::Float(value) => Value::Float(*value),
        YamlKind::Str(text) => Value::Str(text.as_str().into()),
        YamlKind::Timestamp { text, .. } => date(text),
        YamlKind::Binary(bytes) => Value::Bytes(bytes.as_slice().into()),
        YamlKind::List(items) => Value::list_from(list(items, budget)?, top),
        YamlKind::Map(items) => Value::dict_from(pairs(items, budget)?, top),
        YamlKind::Set(items) => Value::set_from(list(items, budget)?),
        YamlKind::Pairs(items) => {
            let pairs = pairs(items, budget)?;
            Value::list_from(
                pairs
                    .into_iter()
                    .map(|(key, value)| Value::tuple_from([key, value])),
                top,
            )
        }
        YamlKind::Tagged { unit, text } => Value::Float(measure(text, budget)? * factor(*unit)),
    })
}

fn list(items: &[YamlNode], budget: &mut Budget) -> Result<Vec<Value>, EvalError> {
    items
        .iter()
        .map(|item| convert(item, false, budget))
        .collect()
}

fn pairs(
    items: &[(YamlNode, YamlNode)],
    budget: &mut Budget,
) -> Result<Vec<(Value, Value)>, EvalError> {
    let pair = |(key, value): &(YamlNode, YamlNode)| {
        Ok((convert(key, false, budget)?, convert(value, false, budget)?))
    };
    items.iter().map(pair).collect()
}

fn factor(unit: Unit) -> f64 {
    match unit {
        Unit::Radians | Unit::Meters => 1.0,
        Unit::Degrees => std::f64::consts::PI / 180.0,
        Unit::Millimeters => 0.001,
        Unit::Foot => 0.3048,
        Unit::Inches => 0.0254,
    }
}

/// The number of a scalar with a unit: an expression that sees the global symbols only.
fn measure(text: &str, budget: &mut Budget) -> Result<f64, EvalError> {
    let parsed = expr::parse(text);
    if let Some(error) = parsed.errors.first() {
        let message = match error.kind {
            expr::ExprErrorKind::ForbiddenName => error.reference.clone(),
            _ => format!("invalid expression: {text}"),
        };
        return Err(EvalError::new(ErrorKind::Xacro, message));
    }
    let mut host = GlobalsOnly { missing: None };
    let value = expr::evaluate(&parsed.expr, &mut host, budget)?;
    if let Some(name) = host.missing {
        return Err(EvalError::new(
            ErrorKind::Name,
            format!("name '{name}' is not defined"),
        ));
    }
    literal::float_of(&value)
}

/// A date from the text Python prints for it.
fn date(text: &str) -> Value {
    let mut numbers = text
        .split(|c: char| !c.is_ascii_digit())
        .map(|part| part.parse::<u32>().unwrap_or(0));
    let [year, month, day, hour, minute, second, behind] =
        std::array::from_fn(|_| numbers.next().unwrap_or(0));
    let date = (year as i32, month, day);
    let Some((_, clock)) = text.split_once(' ') else {
        return Value::Date(Arc::new(DateValue {
            date,
            time: None,
            utc_offset: None,
        }));
    };
    let micro = if clock.contains('.') { behind } else { 0 };
    let zone = clock.rfind(['+', '-']).and_then(|at| clock.get(at..));
    let utc_offset = zone.map(|zone| {
        let parts = zone
            .get(1..)
            .unwrap_or("")
            .split(':')
            .map(|part| part.parse::<i32>().unwrap_or(0));
        let seconds: i32 = parts
            .zip([3600, 60, 1])
            .map(|(part, unit)| part * unit)
            .sum();
        if zone.starts_with('-') {
            -seconds
        } else {
            seconds
        }
    });
    Value::Date(Arc::new(DateValue {
        date,
        time: Some((hour, minute, second, micro)),
        utc_offset,
    }))
}

/// No property is visible.
struct GlobalsOnly {
    missing: Option<String>,
}

impl Host for GlobalsOnly {
    fn lookup(&mut self, _: &str, _: TextRange) -> Lookup {
        Lookup::Missing
    }

    fn scope_attribute(&mut self, _: ScopeId, _: &str, _: TextRange) -> Lookup {
        Lookup::Missing
    }

    fn call(
        &mut self,
        _: HostFn,
        _: &[Value],
        _: &[(Str, Value)],
        _: TextRange,
    ) -> Result<Value, EvalError> {
        Err(EvalError::new(
            ErrorKind::Xacro,
            "xacro functions are not allowed in a YAML value with a unit",
        ))
    }

    fn deprecated(&mut self, _: &str, _: &str, _: TextRange) {}

    fn undefined(&mut self, name: &str, _: TextRange) {
        self.missing.get_or_insert_with(|| name.to_owned());
    }
}
