//! Expressions that ask for too much.

use super::behavior::blame;
use crate::Budget;

/// Everything here must end soon, with an error or a value, without using up the stack or the memory.
#[test]
fn hostile_expressions_end() {
    let table = [
        ("10**10**8", "the limit"),
        ("(10**10)**(10**10)", "the limit"),
        ("2**(2**70)", "the limit"),
        (
            "'a' * 10**12",
            "value has 1000000000000 characters; the limit is 64 MB",
        ),
        (
            "[0] * 10**9",
            "value has 1000000000 items; the limit is 64 MB",
        ),
        (
            "list(range(10**9))",
            "value has 1000000000 items; the limit is 64 MB",
        ),
        ("python.sum(range(10**9))", "the limit"),
        ("python.tuple(range(10**18))", "the limit"),
        ("python.sorted(range(10**9))", "the limit"),
        ("python.set(range(10**9))", "the limit"),
        ("'%1000000000d' % 1", "the limit"),
        ("'%.1000000000f' % 1", "the limit"),
        ("'{:1000000000}'.format(1)", "the limit"),
        ("'{:.1000000000f}'.format(1.5)", "the limit"),
        ("'{:01000000000,}'.format(1)", "the limit"),
        ("f'{1:1000000000}'", "the limit"),
        ("'a'.center(10**11)", "the limit"),
        ("'1'.zfill(10**11)", "the limit"),
        ("'\\t'.expandtabs(10**11)", "the limit"),
        ("('a' * 10**5).replace('a', 'b' * 10**5)", "the limit"),
        ("('a' * 10**5).join('b' * 10**5)", "the limit"),
        (
            "('a' * 10**5).translate(dict([(97, 'b' * 10**6)]))",
            "the limit",
        ),
        ("1 << 10**9", "the limit"),
        ("factorial(10**6)", "the limit"),
        ("factorial(10**12)", "the limit"),
        ("comb(10**9, 10**8)", "the limit"),
        ("comb(10**30, 10**8)", "the limit"),
        ("perm(10**30, 10**18)", "the limit"),
        ("prod(range(1, 10**7))", "the limit"),
        ("(5).to_bytes(10**12, 'big')", "the limit"),
        ("round(5, -10**18)", "0"),
        ("round(10**300000, -299999) > 0", "True"),
        ("10**20 in range(0, 10**30)", "True"),
        ("len(str(2**14000)) if 0 else 1", "1"),
        (
            "(lambda f: f(f))(lambda f: f(f))",
            "maximum recursion depth exceeded",
        ),
        (
            "(lambda f, d: f(f, [d]))(lambda f, d: f(f, [d]), [])",
            "maximum recursion depth exceeded",
        ),
        ("(lambda f: map(f, [1]))(1) == 1", "False"),
        (
            "[(t := [])] and [t := [t] for _ in range(10**5)] and 1",
            "1",
        ),
        (
            "[(t := ())] and [t := (t,) for _ in range(10**5)] and 1",
            "1",
        ),
        (
            "[(t := dict())] and [t := dict(a=t) for _ in range(10**5)] and 1",
            "1",
        ),
        (
            "[(t := 0)] and [t := (lambda t: lambda: t)(t) for _ in range(10**5)] and 1",
            "1",
        ),
        (
            "[(t := [1])] and [t := map(str, t) for _ in range(10**5)] and 1",
            "1",
        ),
        (
            "[(t := [])] and [t := [t] for _ in range(10**4)] and str(t)",
            "maximum recursion depth exceeded",
        ),
        (
            "[(t := ())] and [t := (t,) for _ in range(10**4)] and python.set([t])",
            "maximum recursion depth exceeded",
        ),
        (
            "[(t := []), (w := [])] and [(t := [t], w := [w]) for _ in range(10**4)] and t == w",
            "maximum recursion depth",
        ),
        (
            "[(t := []), (w := [])] and [(t := [t], w := [w]) for _ in range(10**4)] and t < w",
            "maximum recursion depth",
        ),
        (
            "[(t := [1])] and [t := map(str, t) for _ in range(10**4)] and list(t)",
            "maximum recursion depth",
        ),
        (
            "[(t := [1])] and [t := (v for v in t) for _ in range(10**4)] and list(t)",
            "maximum recursion depth",
        ),
        (
            "[(t := ())] and [t := (t, t) for _ in range(60)] and python.hash(t)",
            "maximum recursion depth",
        ),
        (
            "[(t := [0]), (w := [0])] and [(t := [t, t], w := [w, w]) for _ in range(60)] and t == w",
            "more than",
        ),
        ("(lambda l: [l.append(v) for v in l])([1])", "the limit"),
        ("(lambda l: l.extend(l))([1])", "None"),
        (
            "[(t := 'ab')] and [t := t + t for _ in range(60)]",
            "the limit",
        ),
        (
            "[(t := 3)] and [t := t * t for _ in range(60)]",
            "the limit",
        ),
        ("[i for i in range(10**9) if 0]", "the limit"),
        ("gcd(3**10000, 5**7000)", "1"),
        ("isqrt(10**60000) > 1", "True"),
        ("int('9' * 10**6)", "Exceeds the limit"),
        ("float('9' * 10**6)", "inf"),
        ("float('0.' + '9' * 10**6)", "1.0"),
        (
            "'{:{:{:{}}}}'.format(1, 2, 3, 4)",
            "Max string recursion exceeded",
        ),
        ("min([l] * 100000) == l", "True"),
        (
            "('a' * 10**6).count('a') + ('ab' * 10**6).find('b' * 10**6)",
            "999999",
        ),
        ("python.list(python.zip(*[range(10**9)] * 30))", "the limit"),
        ("'%s' % ([[]] * 10**4) == 1", "False"),
        ("pow(2, 10**8)", "math range error"),
        ("python.divmod(10**50000, 3**50000)[1] > 0", "True"),
        ("python.range(10**40)", "not supported"),
    ];
    let run = move || {
        for (text, expected) in table {
            let started = std::time::Instant::now();
            let mut budget = Budget::new(2_000_000, 48 << 20, 600);
            let got = blame(text, &mut budget);
            let head: String = got.chars().take(200).collect();
            assert!(got.contains(expected), "{text}: {head}");
            assert!(
                started.elapsed().as_secs() < 20,
                "{text} took {:?}",
                started.elapsed()
            );
            println!("{:?} {text}", started.elapsed());
        }
    };
    std::thread::Builder::new()
        .stack_size(2 << 20)
        .spawn(run)
        .unwrap()
        .join()
        .unwrap();
}

#[test]
fn shared_parts_do_not_make_texts_endless() {
    let text = "[(t := [])] and [t := [t, t] for _ in range(60)] and str(t)";
    let got = blame(text, &mut Budget::new(1_000_000, 1 << 20, 600));
    assert!(
        got.starts_with("text of a value is longer than the limit of"),
        "{got}"
    );
}
