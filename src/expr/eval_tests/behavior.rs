//! Places of errors, unknown operands, and what is reported to the host.

use super::*;

/// The first error's message and the part of the text it is placed at, or the value.
pub(super) fn blame(text: &str, budget: &mut Budget) -> String {
    let parsed = parse(text);
    let mut host = TestHost {
        names: properties(),
        ..TestHost::default()
    };
    match evaluate(&parsed.expr, &mut host, budget) {
        Ok(value) if host.undefined.is_empty() => {
            display::repr(&value).unwrap_or_default().to_string()
        }
        Ok(_) => host.undefined.join(" "),
        Err(error) => format!("{} at `{}`", error.message, error.range.slice(text)),
    }
}

#[test]
fn errors_have_the_narrowest_place() {
    let table = [
        ("1 + 2 / 0", "division by zero at `0`"),
        (
            "1 + (n // (n - 3))",
            "integer division or modulo by zero at `n - 3`",
        ),
        (
            "2 * ('a' + 1)",
            "can only concatenate str (not \"int\") to str at `'a' + 1`",
        ),
        ("[l[7]]", "list index out of range at `7`"),
        (
            "cfg['b']['z']",
            "The yaml dictionary has no key 'z' at `'z'`",
        ),
        ("cfg.b.z + 1", "The yaml dictionary has no key 'z' at `z`"),
        (
            "1 + s.foo()",
            "'str' object has no attribute 'foo' at `foo`",
        ),
        (
            "1 < 2 < 'a'",
            "'<' not supported between instances of 'int' and 'str' at `2 < 'a'`",
        ),
        (
            "n + int('x')",
            "invalid literal for int() with base 10: 'x' at `int('x')`",
        ),
        ("[i for i in n]", "'int' object is not iterable at `n`"),
        (
            "[a for a, b in l]",
            "cannot unpack non-iterable int object at `a, b`",
        ),
        (
            "[1, *n]",
            "Value after * must be an iterable, not int at `n`",
        ),
        ("(lambda v: v / 0)(1)", "division by zero at `0`"),
        ("-s", "bad operand type for unary -: 'str' at `-s`"),
        (
            "math.foo + python.bar(1) + zzz",
            "foo@5..8 bar@18..21 zzz@27..30",
        ),
        ("1 if undefined_a else undefined_b", "undefined_a@5..16"),
        (
            "f(undefined_a, k=undefined_b)",
            "f@0..1 undefined_a@2..13 undefined_b@17..28",
        ),
    ];
    for (text, expected) in table {
        assert_eq!(blame(text, &mut Budget::default()), expected, "{text}");
    }
}

#[test]
fn unknown_operands_make_unknown_values_without_errors() {
    let unknown = [
        "u + 1",
        "1 + u",
        "-u",
        "not u",
        "u.foo",
        "u.foo.bar(1)",
        "u[0]",
        "l[u]",
        "u(1)",
        "sin(u)",
        "len(u)",
        "int(u)",
        "u and 1",
        "u or 1",
        "1 if u else 2",
        "u < 1 < 'a'",
        "1 in u",
        "u in l",
        "u is None",
        "u == u",
        "[i for i in u]",
        "[i for i in l if u]",
        "python.list(u)",
        "python.sum([1, u])",
        "python.sorted([2, u, 1])",
        "max([1, u])",
        "max(1, u)",
        "f'{u}'",
        "'%s' % u",
        "'%s' % (u,)",
        "'{}'.format(u)",
        "','.join(['a', u])",
        "str([u])",
        "[u] == [u]",
        "python.set([u])",
        "dict([(u, 1)])",
        "l[u:]",
        "python.range(u)",
        "(lambda v: v)(u) + 1",
        "l.index(u)",
        "python.any(v for v in [u])",
        "[*u]",
        "max(*u)",
        "dict(**u)",
        "cfg[u]",
        "cfg.get(u)",
        "xacro.arg(u)",
        "load_yaml(u)",
        "(1, u) < (1, 2)",
        "python.isinstance(u, int)",
        "fsum([1.0, u])",
        "[a for a, b in [u]]",
    ];
    for text in unknown {
        let parsed = parse(text);
        let mut host = TestHost {
            names: properties(),
            ..TestHost::default()
        };
        host.names.push(("u", Value::Unknown));
        let value = evaluate(&parsed.expr, &mut host, &mut Budget::default());
        let unknown = value.as_ref().is_ok_and(Value::is_unknown);
        assert!(
            unknown && host.undefined.is_empty(),
            "{text}: {value:?} {:?}",
            host.undefined
        );
    }
    let inside = [
        ("[1, u][0]", "1"),
        ("len([1, u])", "2"),
        ("1 in [1, u]", "True"),
        ("(l.append(u), len(l))[1]", "4"),
        ("0 and u", "0"),
        ("1 or u", "1"),
        ("2 if 1 else u", "2"),
        ("[v for v in [1, u]][0]", "1"),
        ("dict(a=u, b=1)['b']", "1"),
        ("(lambda v: 5)(u)", "5"),
        ("(lambda d: (d.setdefault('a', u), len(d)))(dict())[1]", "1"),
    ];
    for (text, expected) in inside {
        let parsed = parse(text);
        let mut host = TestHost {
            names: properties(),
            ..TestHost::default()
        };
        host.names.push(("u", Value::Unknown));
        let value = evaluate(&parsed.expr, &mut host, &mut Budget::default()).unwrap();
        assert_eq!(display::repr(&value).as_deref(), Some(expected), "{text}");
    }
    assert_eq!(
        display::to_str(&Value::list_from([Value::Unknown], false)),
        None
    );
}

#[test]
fn bare_names_are_reported_when_called() {
    let parsed = parse("[sorted, sorted(l), list(range(2)), dotify(dict()), load_yaml('f')]");
    let mut host = TestHost {
        names: properties(),
        ..TestHost::default()
    };
    evaluate(&parsed.expr, &mut host, &mut Budget::default()).unwrap();
    assert_eq!(
        host.deprecated,
        [
            "python.sorted",
            "python.range",
            "xacro.dotify",
            "xacro.load_yaml"
        ]
    );
}

#[test]
fn functions_outlive_their_expression() {
    let mut host = TestHost {
        names: properties(),
        ..TestHost::default()
    };
    let run =
        |host: &mut TestHost, text: &str| evaluate(&parse(text).expr, host, &mut Budget::default());
    let function = run(&mut host, "lambda v: v / n").unwrap();
    let generator = run(&mut host, "(v / 0 for v in l)").unwrap();
    host.names.push(("f", function));
    host.names.push(("g", generator));
    assert_eq!(
        display::repr(&run(&mut host, "f(6)").unwrap()).as_deref(),
        Some("2.0")
    );
    host.names.retain(|(name, _)| *name != "n");
    host.names.push(("n", Value::Int(0)));
    // The place is that of the call: the other text is gone.
    assert_eq!(
        run(&mut host, "1 + f(6)").unwrap_err().range,
        TextRange::new(4, 8)
    );
    assert_eq!(
        run(&mut host, "0 + python.sum(g)").unwrap_err().range,
        TextRange::new(4, 17)
    );
    host.names.retain(|(name, _)| *name != "n");
    run(&mut host, "1 + f(6)").unwrap();
    assert_eq!(host.undefined, ["n@4..8"]);
}
