//! Expressions against numbers worked out by hand, and expressions at random.

use super::Expression;
use num_dual::Dual64;
use proptest::prelude::{Just, Strategy, prop_oneof, proptest};

fn value(text: &str) -> f64 {
    Expression::parse(text, &["x", "alpha"])
        .unwrap_or_else(|error| panic!("{error}"))
        .value(&[0.5, 0.3])
}

#[test]
fn operators_bind_as_in_mathematics() {
    assert_eq!(value("1 + 2 * 3 - 4 / 2"), 5.0);
    assert_eq!(value("-2^2"), -4.0);
    assert_eq!(value("2^-1"), 0.5);
    assert_eq!(value("2^3^2"), 512.0);
    assert_eq!(value("-(1 - 3) * +x"), 1.0);
    assert_eq!(value("8 / 4 / 2"), 1.0);
    assert_eq!(value("max(x, 2e-1) - min(1., .25)"), 0.25);
    assert!((value("sin(pi / 2) + cos(0) + tanh(0) + sqrt(4) * ln(exp(1)) + abs(-1)") - 5.0).abs() < 1e-15);
    assert!((value("(1 - x)^1.5") - 0.5f64.powf(1.5)).abs() < 1e-16);
}

#[test]
fn a_fault_is_shown_with_its_column_and_a_cure() {
    for (text, column, cure) in [
        ("", 1, "at the end"),
        ("2 * ", 5, "at the end"),
        ("2 x", 3, "write 2 * x"),
        ("2 * (x + 1", 5, "put )"),
        ("x + 1)", 6, "open a bracket"),
        ("alpa * 2", 1, "did you mean alpha"),
        ("x ** 2", 3, "a^b"),
        ("sin x", 4, "sin(a)"),
        ("min(x)", 6, "min(a, b)"),
        ("sin(x, 1)", 6, "sin(a)"),
        ("x alpha", 3, "operator"),
        ("1.2.3", 1, "0.5 or 2e-3"),
        ("x; 2", 2, "operator"),
        ("$", 1, "a number"),
    ] {
        let error = Expression::parse(text, &["x", "alpha"]).expect_err(text);
        assert_eq!(error.column, column, "{error}");
        assert!(error.cure.contains(cure), "{error}");
    }
    let deep = format!("{}x{}", "(".repeat(500), ")".repeat(500));
    assert!(Expression::parse(&deep, &["x"]).is_err());
    assert!(Expression::parse(&"x+".repeat(5000), &["x"]).is_err());
}

#[test]
fn derivatives_come_with_dual_numbers() {
    let slope = |text: &str, x: f64| {
        let read = Expression::parse(text, &["x"]).unwrap();
        read.value(&[Dual64::new(x, 1.0)]).eps
    };
    assert!((slope("x^3", 0.5) - 0.75).abs() < 1e-15);
    assert_eq!(
        [slope("x", 0.0), slope("x^4", 0.0), slope("x^3 + x", 0.0)],
        [1.0, 0.0, 1.0]
    );
    // next to 0 the inverse of a divisor overflows, and exponents count as 0
    for text in ["0 / 1e-320 + x", "x / 1e-200 * 1e-200", "x + 1e-310 / 1e-310"] {
        assert!(
            (slope(text, 0.5) - 1.0).abs() < 1e-10,
            "{text}: {}",
            slope(text, 0.5)
        );
    }
    let root_of_negative = Expression::parse("(-x)^1e-320", &["x"]).unwrap();
    assert!(root_of_negative.value(&[Dual64::new(0.5, 1.0)]).re.is_nan());
    assert!((slope("x^x", 0.5) - 0.5f64.sqrt() * (1.0 + 0.5f64.ln())).abs() < 1e-15);
    assert!((slope("sin(2 * x) / x", 0.5) - (4.0 * 1f64.cos() - 4.0 * 1f64.sin())).abs() < 1e-14);
    assert_eq!(slope("abs(x) + max(x, 0) + x^2", -1.0), -3.0);
}

/// Value and slope by hand, where parts of the way to them overflow or vanish.
#[test]
fn value_and_slope_are_finite_wherever_mathematics_has_them_so() {
    for (text, x, value, slope) in [
        ("tanh(x)", 1e3, 1.0, 0.0),
        ("tanh(x)", -400.0, -1.0, 0.0),
        ("tanh(1e6 * x)", 3e-4, 1.0, 0.0),
        ("tanh(exp(x))", 705.0, 1.0, 0.0),
        ("atan(exp(x))", 800.0, std::f64::consts::FRAC_PI_2, 0.0),
        ("atan(-exp(x))", 705.0, -std::f64::consts::FRAC_PI_2, 0.0),
        ("1 / (1 + exp(x))", 400.0, (-400f64).exp(), -(-400f64).exp()),
        ("1 / (1 + exp(2000 * x))", 0.354, 0.0, 0.0),
        ("1 / (1 + exp(x))", 800.0, 0.0, 0.0),
        ("(1 + exp(x))^-1", 800.0, 0.0, 0.0),
        ("(1 + exp(x))^-1.5", 800.0, 0.0, 0.0),
        ("(exp(x) - exp(-x)) / (exp(x) + exp(-x))", 600.0, 1.0, 0.0),
        ("exp(-exp(x))", 800.0, 0.0, 0.0),
        ("x^2.5", 0.0, 0.0, 0.0),
        ("x^1.5", 1e-250, 0.0, 1.5e-125),
        ("x^0.5", 1e-200, 1e-100, 5e99),
        ("x^-3", 1e80, 1e-240, 0.0),
        ("x^-1", 1e-100, 1e100, -1e200),
        ("x^x * 0 + x^(x + 2)", 1.0, 1.0, 3.0),
        ("x^(x + 2)", 0.0, 0.0, 0.0),
        ("abs(x)", 0.0, 0.0, 1.0),
        ("max(x, 0)", 0.0, 0.0, 1.0),
        ("sqrt(max(abs(x), 1e-6))", 0.0, 1e-3, 0.0),
        ("abs(x)^3", 0.0, 0.0, 0.0),
        ("x^0", 0.0, 1.0, 0.0),
    ] {
        let read = Expression::parse(text, &["x"]).unwrap();
        let dual = read.value(&[Dual64::new(x, 1.0)]);
        let near = |found: f64, by_hand: f64| (found - by_hand).abs() <= 1e-12 * by_hand.abs().max(1e-90);
        assert!(near(dual.re, value), "{text} at {x}: {} is not {value}", dual.re);
        assert!(
            near(dual.eps, slope),
            "{text} at {x}: slope {} is not {slope}",
            dual.eps
        );
        let plain: f64 = read.value(&[x]);
        assert!(near(plain, value), "{text} at {x}: {plain} is not {value}");
    }
}

/// Their value is 0, and they rise upright from there.
#[test]
fn a_root_at_zero_has_its_value_and_no_finite_slope() {
    for text in ["sqrt(x)", "x^0.5", "abs(x)^0.3", "sqrt(abs(x))", "x^(x + 0.5)"] {
        let read = Expression::parse(text, &["x"]).unwrap();
        let found = read.value(&[Dual64::new(0.0, 1.0)]);
        assert_eq!(found.re, 0.0, "{text}");
        assert!(!found.eps.is_finite(), "{text}: {}", found.eps);
        assert_eq!(read.value(&[0.0]), 0.0, "{text}");
    }
}

#[test]
fn no_function_loses_what_is_not_a_number() {
    for text in [
        "min(sqrt(x), 1)",
        "min(1, sqrt(x))",
        "max(sqrt(x), 1)",
        "max(1, sqrt(x))",
        "abs(sqrt(x))",
        "tanh(ln(x))",
        "1 / sqrt(x)",
        "sqrt(x)^3",
        "sqrt(x)^-3",
        "2^sqrt(x)",
        "0 * sqrt(x)",
    ] {
        let read = Expression::parse(text, &["x"]).unwrap();
        assert!(read.value(&[-1f64]).is_nan(), "{text}");
        assert!(read.value(&[Dual64::new(-1.0, 1.0)]).re.is_nan(), "{text}");
    }
}

/// A formula as text, with its value computed beside.
fn formula() -> impl Strategy<Value = (String, f64)> {
    let leaf = prop_oneof![
        (1..1000i32).prop_map(|n| (format!("{}", f64::from(n) / 64.0), f64::from(n) / 64.0)),
        Just(("x".to_string(), 0.5)),
        Just(("alpha".to_string(), 0.3)),
    ];
    leaf.prop_recursive(5, 40, 2, |inner| {
        (inner.clone(), inner, 0..6usize).prop_map(|((a, va), (b, vb), which)| match which {
            0 => (format!("({a} + {b})"), va + vb),
            1 => (format!("({a}-{b})"), va - vb),
            2 => (format!("({a}) * ({b})"), va * vb),
            3 => (format!("max({a},{b})"), if vb > va { vb } else { va }),
            4 => (format!("-({a})^2"), -(va * va)),
            _ => (format!("sin( {a} )"), va.sin()),
        })
    })
}

proptest! {
    #[test]
    fn a_formula_has_the_value_of_its_parts((text, expected) in formula()) {
        let found = value(&format!("({text})"));
        assert!((found - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{text}: {found} {expected}");
    }

    #[test]
    fn no_text_makes_the_reader_panic(text in ".{0,60}") {
        let _ = Expression::parse(&text, &["x"]);
    }

    #[test]
    fn no_text_of_its_own_letters_makes_the_reader_panic(text in "[x0-9.+*/^(),e a-]{0,80}") {
        if let Ok(read) = Expression::parse(&text, &["x"]) {
            let _ = read.value(&[0.5]);
        }
    }
}
