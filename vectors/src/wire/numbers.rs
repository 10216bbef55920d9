//! Spellings of numbers, and what they are.

/// A spelling of a double.
pub(super) struct Double {
    /// Names it in a case's id.
    pub(super) name: &'static str,
    /// As the frame spells it.
    pub(super) literal: String,
    /// The nearest double, in its shortest spelling.
    pub(super) is: &'static str,
    /// The rule that the case shows.
    pub(super) rule: &'static str,
    /// The bug class.
    pub(super) flag: &'static str,
}

impl Double {
    /// Whether no fewer than sixteen digits name it.
    pub(super) fn is_long(&self) -> bool {
        let mantissa = self.is.split(['e', 'E']).next().unwrap_or_default();
        let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
        digits.trim_matches('0').len() > 15
    }
}

/// Spellings for every field of type number.
pub(super) fn few_doubles() -> Vec<Double> {
    vec![
        spelled("integer", "5", "5.0", "integer-spelled-doubles"),
        exact("negative-zero", "-0.0", "-0.0", "signed-zero"),
        // Just above the half between two doubles.
        spelled("integer-of-twenty-digits", "18446744073709553665", "1.8446744073709556e19", "integer-spelled-doubles"),
    ]
}

/// More of them, for one number field of each role.
pub(super) fn more_doubles() -> Vec<Double> {
    let mut all = vec![
        exact("smallest", "5e-324", "5e-324", "subnormals"),
        exact("largest", "1.7976931348623157e308", "1.7976931348623157e308", "largest-double"),
        spelled("zero-integer", "0", "0.0", "integer-spelled-doubles"),
        exact("negative-zero-integer", "-0", "-0.0", "signed-zero"),
        exact("negative-zero-exponent", "-0e5", "-0.0", "signed-zero"),
        spelled("exponent", "5e0", "5.0", "exponents"),
        spelled("exponent-upper-case-plus", "5E+0", "5.0", "exponents"),
        spelled("exponent-upper-case-plus-two", "1E+2", "100.0", "exponents"),
        spelled("exponent-plus-and-point", "-2.5e+1", "-25.0", "exponents"),
        spelled("exponent-negative", "50e-1", "5.0", "exponents"),
        spelled("exponent-upper-case-negative", "5.0E-1", "0.5", "exponents"),
        spelled("exponent-leading-zeros", "5e-0001", "0.5", "exponents"),
        spelled("exponent-huge-of-zero", "0e99999999999999999999", "0.0", "exponents"),
        spelled("exponent-beyond-machine-integers", "1e-99999999999999999999", "0.0", "exponents"),
        spelled("trailing-zeros", "0.5000", "0.5", "exponents"),
        spelled("underflow", "1e-400", "0.0", "underflow"),
        exact("underflow-negative", "-1e-400", "-0.0", "underflow"),
        spelled("below-half-of-smallest", "2.4703282292062327e-324", "0.0", "rounding"),
        spelled("above-half-of-smallest", "2.4703282292062328e-324", "5e-324", "rounding"),
        spelled("smallest-with-many-digits", "4.9406564584124654417656879e-324", "5e-324", "subnormals"),
        exact("smallest-negative", "-5e-324", "-5e-324", "subnormals"),
        exact("largest-subnormal", "2.225073858507201e-308", "2.225073858507201e-308", "subnormals"),
        spelled("largest-subnormal-hard", "2.2250738585072011e-308", "2.225073858507201e-308", "rounding"),
        spelled("smallest-normal-from-below", "2.2250738585072012e-308", "2.2250738585072014e-308", "rounding"),
        exact("smallest-normal", "2.2250738585072014e-308", "2.2250738585072014e-308", "subnormals"),
        spelled("largest-rounded-down", "1.7976931348623158e308", "1.7976931348623157e308", "largest-double"),
        exact("largest-negative", "-1.7976931348623157e308", "-1.7976931348623157e308", "largest-double"),
        spelled("two-to-53-plus-1", "9007199254740993", "9007199254740992.0", "rounding"),
        spelled(
            "two-to-53-plus-1-and-a-bit",
            "9007199254740993.00000000000000000001",
            "9007199254740994.0",
            "rounding",
        ),
        spelled("two-to-53-plus-3", "9007199254740995", "9007199254740996.0", "rounding"),
        spelled("two-to-63", "9223372036854775808", "9.223372036854775808e18", "integer-spelled-doubles"),
        spelled("two-to-64", "18446744073709551616", "1.8446744073709551616e19", "integer-spelled-doubles"),
        spelled("thirty-digits", "123456789012345678901234567890", "1.2345678901234568e29", "integer-spelled-doubles"),
        spelled("integer-of-22-digits", "-1180591620717411434497", "-1.1805916207174116e21", "integer-spelled-doubles"),
        spelled(
            "integer-of-31-digits",
            "1267650600228229542234191560705",
            "1.2676506002282297e30",
            "integer-spelled-doubles",
        ),
        spelled(
            "integer-of-61-digits",
            "1606938044258990453947923680586147734807949174969684883144705",
            "1.6069380442589906e60",
            "integer-spelled-doubles",
        ),
        exact("seventeen-digits", "0.30000000000000004", "0.30000000000000004", "seventeen-digits"),
        exact("seventeen-digits-below-one", "0.99999999999999989", "0.9999999999999999", "seventeen-digits"),
        exact("seventeen-digits-above-one", "1.0000000000000002", "1.0000000000000002", "seventeen-digits"),
        exact("a-third", "0.3333333333333333", "0.3333333333333333", "seventeen-digits"),
        spelled("ten-to-23", "1e23", "1e23", "rounding"),
        spelled("above-ten-to-23", "1.00000000000000008388608e23", "1.0000000000000001e23", "rounding"),
        spelled("halfway-above-one", "1.00000000000000011102230246251565404236316680908203125", "1.0", "rounding"),
        spelled(
            "halfway-above-one-and-a-bit",
            "1.00000000000000011102230246251565404236316680908203126",
            "1.0000000000000002",
            "rounding",
        ),
    ];
    all.push(spelled("eight-hundred-digits", format!("0.1{}1", "0".repeat(798)), "0.1", "many-digits"));
    all.push(spelled(
        "halfway-decided-by-digit-800",
        format!("9007199254740993.{}1", "0".repeat(783)),
        "9007199254740994.0",
        "many-digits",
    ));
    // Behind the half between two doubles, farther than any of them has digits.
    all.push(spelled(
        "halfway-decided-by-digit-1000",
        format!("1.00000000000000011102230246251565404236316680908203125{}1", "0".repeat(946)),
        "1.0000000000000002",
        "many-digits",
    ));
    all.push(spelled("largest-below-the-halfway", format!("{HALFWAY}1"), "1.7976931348623157e308", "largest-double"));
    all.push(spelled("many-digits-and-exponent", format!("1{}e-395", "0".repeat(400)), "100000.0", "many-digits"));
    // As many as overflow with one more.
    for (name, zeros) in
        [("299-zeros-and-9", 299), ("288-zeros-and-20", 288), ("209-zeros-and-99", 209), ("8-zeros-and-300", 8)]
    {
        all.push(spelled(name, format!("1{}e{}", "0".repeat(zeros), 308 - zeros), "1e308", "many-digits"));
    }
    // A sign is no digit.
    all.push(spelled("minus-and-309-digits", format!("-1{}", "0".repeat(308)), "-1e308", "many-digits"));
    all.push(spelled("many-zeros-and-exponent", format!("0.{}1e401", "0".repeat(399)), "10.0", "many-digits"));
    // What stands at the end decides, beyond any buffer of a kibibyte or a few.
    for (zeros, names) in [
        (1100, ["a-kibibyte-of-zeros", "a-kibibyte-and-a-power", "a-kibibyte-behind-a-digit"]),
        (4200, ["four-kibibytes-of-zeros", "four-kibibytes-and-a-power", "four-kibibytes-behind-a-digit"]),
    ] {
        let (few, many) = ("0".repeat(zeros - 1), "0".repeat(zeros));
        all.push(spelled(names[0], format!("0.{few}1e{zeros}"), "1.0", "many-digits"));
        all.push(spelled(names[1], format!("1{many}e-{zeros}"), "1.0", "many-digits"));
        all.push(spelled(names[2], format!("2.{many}e2"), "200.0", "many-digits"));
    }
    // Exponents beyond what readers take for far beyond every double, which so many digits bring back.
    for (zeros, names) in [
        (20_100, ["twenty-thousand-zeros-below", "twenty-thousand-zeros"]),
        (100_100, ["hundred-thousand-zeros-below", "hundred-thousand-zeros"]),
    ] {
        all.push(spelled(names[0], format!("0.{}25e{zeros}", "0".repeat(zeros)), "0.25", "many-digits"));
        all.push(spelled(names[1], format!("25{}e-{zeros}", "0".repeat(zeros)), "25.0", "many-digits"));
    }
    let zeros = "0".repeat(20);
    all.push(spelled("exponent-of-twenty-zeros", format!("1e{zeros}1"), "10.0", "exponents"));
    all.extend(by_powers());
    all.extend(rounded_once());
    all
}

/// Few digits with the first powers of ten that are no doubles: who multiplies or divides by one rounds twice.
fn by_powers() -> Vec<Double> {
    [
        ("three-times-ten-to-23", "3e23", "3e+23"),
        ("seven-times-ten-to-23", "7e23", "7e+23"),
        ("one-by-ten-to-23", "1e-23", "1e-23"),
        ("seven-by-ten-to-23", "7e-23", "7e-23"),
    ]
    .map(|(name, literal, is)| spelled(name, literal, is, "rounding"))
    .into()
}

/// Digits of more than 53 bits with a power of ten: who rounds the digits first, and what the power makes of them
/// again, mostly ends beside the nearest double.
fn rounded_once() -> [Double; 14] {
    [
        spelled("two-to-53-plus-1-times-ten", "9007199254740993e1", "9.007199254740994e16", "rounding"),
        spelled("two-to-53-plus-1-times-ten-negative", "-9007199254740993e1", "-9.007199254740994e16", "rounding"),
        spelled("two-to-53-plus-1-times-hundred", "9007199254740993e2", "9.007199254740993e17", "rounding"),
        spelled("two-to-53-plus-1-times-ten-to-22", "9007199254740993e22", "9.007199254740994e37", "rounding"),
        spelled("two-to-53-plus-1-by-ten-to-22", "9007199254740993e-22", "9.007199254740993e-07", "rounding"),
        spelled("two-to-53-plus-3-times-thousand", "9007199254740995e3", "9.007199254740995e18", "rounding"),
        spelled("two-to-53-plus-5-times-ten", "9007199254740997e1", "9.007199254740997e16", "rounding"),
        spelled("two-to-53-plus-5-by-ten", "9007199254740997e-1", "900719925474099.8", "rounding"),
        spelled("two-to-53-plus-3-by-ten-to-5", "9007199254740995e-5", "90071992547.40994", "rounding"),
        spelled("two-to-53-plus-3-and-decimals", "90071992547.40995", "90071992547.40994", "rounding"),
        spelled("two-to-60-plus-129-by-ten-to-18", "1152921504606847105e-18", "1.152921504606847", "rounding"),
        spelled("two-to-53-times-ten", "9007199254740992e1", "9.007199254740992e16", "rounding"),
        spelled("two-to-53-minus-1-times-ten", "9007199254740991e1", "9.00719925474099e16", "rounding"),
        spelled("nineteen-nines-times-ten-to-22", "9999999999999999999e22", "1e41", "rounding"),
    ]
}

/// Powers of two of which fewer digits than hold them lie within half a step to the next double above, and beyond half
/// the smaller step to the one below.
const LOPSIDED: [i32; 21] =
    [-98, -97, -93, -92, -91, -90, -89, -88, -44, -25, -24, 64, 65, 66, 67, 68, 85, 89, 108, 122, 132];

/// Doubles of full precision over the sizes at which quantities are measured, and such that come back as a neighbour
/// from so many decimals as nearly hold them: what a writer makes shorter, or reckons with, changes one of so many.
pub(super) fn of_every_size() -> Vec<f64> {
    let mut state: u64 = 0x9e37_79b9_7f4a_7c15;
    let mut between_1_and_2 = || {
        // Knuth's multiplier; the high bits are the good ones.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from_bits((1023 << 52) | (state >> 12))
    };
    // From 2^-20, a millionth, to 2^44.
    let mut doubles: Vec<f64> = (0..130).map(|nth| 2_f64.powi(nth % 65 - 20) * between_1_and_2()).collect();
    for places in 0_u8..=12 {
        let nearly = 2_f64.powi(52) / 10_f64.powi(places.into());
        let is_changed = |double: &f64| {
            let written = format!("{double:.*}", usize::from(places));
            written.parse() != Ok(*double)
        };
        // Half of the doubles below 2^52 have a half behind the point, which no decimals hold.
        let candidates = std::iter::repeat_with(|| nearly * between_1_and_2() * if places == 0 { 0.5 } else { 1.0 });
        doubles.extend(candidates.take(10_000).filter(is_changed).take(8));
    }
    doubles.extend(LOPSIDED.map(|power| 2_f64.powi(power)));
    let signed = |(nth, double): (usize, f64)| if nth % 3 == 0 { -double } else { double };
    doubles.into_iter().enumerate().map(signed).collect()
}

/// Spellings of so many digits with so great an exponent, and the nearest double of each: such that a reader which
/// rounds the digits first, or multiplies or divides by the power in two parts, mostly ends beside it.
pub(super) fn of_every_length() -> Vec<(String, f64)> {
    let mut state: u64 = 0x2545_f491_4f6c_dd1d;
    let mut digits = |length: u32| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let from = 10_u64.pow(length - 1);
        from + (state >> 3) % (from * 9)
    };
    let exponents = (-38..=-23).chain(23..=38).chain([-22, -16, -9, -3, 3, 9, 16, 22]);
    let candidates = exponents.flat_map(|exponent: i32| (1..=18).map(move |length| (length, exponent)));
    let hardest = candidates.filter_map(|(length, exponent)| {
        let tries = (0..60).map(|_| digits(length)).map(|whole| (astray(whole, exponent), whole));
        let (ways, whole) = tries.max()?;
        (ways > 0).then(|| format!("{whole}e{exponent}"))
    });
    hardest.filter_map(|literal| Some((literal.parse().ok()?, literal))).map(|(is, literal)| (literal, is)).collect()
}

/// In how many ways to part the power of ten the product, or the quotient, is not the nearest double.
fn astray(whole: u64, exponent: i32) -> usize {
    let nearest: Option<f64> = format!("{whole}e{exponent}").parse().ok();
    let power = |exponent: u32| format!("1e{exponent}").parse().unwrap_or(f64::NAN);
    let by = |value: f64, power: f64| if exponent < 0 { value / power } else { value * power };
    let size = exponent.unsigned_abs();
    #[expect(clippy::cast_precision_loss, reason = "what such a reader does")]
    let rounded = whole as f64;
    (0..=size.min(22)).filter(|first| Some(by(by(rounded, power(*first)), power(size - first))) != nearest).count()
}

/// A number that is no finite double, for every field of type number.
pub(super) fn few_infinite() -> Vec<(&'static str, String)> {
    vec![("overflow", "1e309".to_owned())]
}

/// More of them.
pub(super) fn more_infinite() -> Vec<(&'static str, String)> {
    // Too few digits to overflow by themselves, with an exponent that does not by itself.
    let together =
        |(name, zeros, exponent): (&'static str, usize, usize)| (name, format!("1{}e{exponent}", "0".repeat(zeros)));
    let split = [
        ("overflow-by-308-zeros-and-1", 308, 1),
        ("overflow-by-299-zeros-and-10", 299, 10),
        ("overflow-by-289-zeros-and-20", 289, 20),
        ("overflow-by-210-zeros-and-99", 210, 99),
        ("overflow-by-109-zeros-and-200", 109, 200),
        ("overflow-by-9-zeros-and-300", 9, 300),
    ];
    let split = split.map(together);
    let alone = [
        ("overflow-negative", "-1e309".to_owned()),
        ("overflow-by-rounding", "1.7976931348623159e308".to_owned()),
        ("overflow-at-the-halfway", format!("{HALFWAY}2")),
        ("overflow-by-digits", format!("1{}", "0".repeat(400))),
        ("overflow-by-one-digit", format!("1{}", "0".repeat(309))),
        ("overflow-by-digits-and-a-fraction", format!("1{}.5", "0".repeat(349))),
        ("overflow-exponent-leading-zeros", "1e00309".to_owned()),
        ("overflow-exponent-leading-zero", "1e0400".to_owned()),
        ("overflow-exponent-plus-and-zero", "-1E+0309".to_owned()),
        ("overflow-exponent-twenty-zeros", format!("1e{}309", "0".repeat(20))),
        ("overflow-huge-exponent", "1e99999999999999999999".to_owned()),
    ];
    alone.into_iter().chain(split).collect()
}

/// 2^1024 − 2^970, halfway from the largest double to the next power of two, but for its last
/// digit, a 2. From there on the nearest double is infinite.
const HALFWAY: &str = concat!(
    "1797693134862315807937289714053034150799341327100378269361737789804449682927647509466490",
    "1797758720709633028641669288791094655554785194040263065748867150582068190890200070838367",
    "6273854845817711531764475730270069855571366959622842914819860834936475292719074168444365",
    "51070434271155969950809304288017790417449779",
);

/// A spelling in an integer field: its name, and the digits.
pub(super) type Integer = (&'static str, &'static str);

/// Integers that every receiver reads.
pub(super) const INTEGERS: [Integer; 1] = [("largest", "9007199254740991")];

/// More of them.
pub(super) const MORE_INTEGERS: [Integer; 7] = [
    ("smallest", "-9007199254740991"),
    ("zero", "0"),
    ("one", "1"),
    ("minus-one", "-1"),
    ("two-to-31", "2147483648"),
    ("two-to-32-plus-1", "4294967297"),
    ("minus-two-to-31-minus-1", "-2147483649"),
];

/// Spellings that no integer field allows.
pub(super) const MISSPELLED: [Integer; 2] = [("fraction", "1.0"), ("negative-zero", "-0")];

/// More of them.
pub(super) const MORE_MISSPELLED: [Integer; 6] = [
    ("exponent", "1e0"),
    ("half", "1.5"),
    ("exponent-upper-case", "1E2"),
    ("exponent-negative", "10e-1"),
    ("zero-fraction", "0.0"),
    ("zero-exponent", "0e0"),
];

/// Integers beyond ±(2^53 − 1).
pub(super) const BEYOND: [Integer; 1] = [("two-to-53", "9007199254740992")];

/// More of them.
pub(super) const MORE_BEYOND: [Integer; 10] = [
    ("minus-two-to-53", "-9007199254740992"),
    ("int64-largest", "9223372036854775807"),
    ("int64-smallest", "-9223372036854775808"),
    ("two-to-63", "9223372036854775808"),
    ("two-to-64", "18446744073709551616"),
    ("two-to-64-plus-1", "18446744073709551617"),
    ("thirty-digits", "100000000000000000000000000000"),
    ("two-to-128-plus-7", "340282366920938463463374607431768211463"),
    ("minus-two-to-128-minus-7", "-340282366920938463463374607431768211463"),
    ("two-to-256-plus-7", "115792089237316195423570985008687907853269984665640564039457584007913129639943"),
];

/// What tells a spelling: the double is the one that the digits name.
fn spelled(name: &'static str, literal: impl Into<String>, is: &'static str, flag: &'static str) -> Double {
    Double { name, literal: literal.into(), is, rule: "NCP-WIRE-012", flag }
}

/// What tells a double: that it comes back bit for bit.
fn exact(name: &'static str, literal: impl Into<String>, is: &'static str, flag: &'static str) -> Double {
    Double { name, literal: literal.into(), is, rule: "NCP-WIRE-015", flag }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The table's second column is typed by hand; the standard library is its second source.
    #[test]
    fn every_spelling_is_nearest_to_the_double_that_the_table_gives() {
        for double in few_doubles().into_iter().chain(more_doubles()) {
            let read: f64 = double.literal.parse().unwrap();
            let is: f64 = double.is.parse().unwrap();
            assert_eq!(read.to_bits(), is.to_bits(), "{}", double.name);
        }
    }

    #[test]
    fn of_every_number_of_decimals_some_doubles_are_changed() {
        let doubles = of_every_size();
        assert_eq!(doubles.len(), 130 + 13 * 8 + LOPSIDED.len());
        for places in 0..=12 {
            let is_changed = |double: &&f64| format!("{double:.places$}").parse() != Ok(**double);
            assert!(doubles.iter().filter(|double| double.abs() > 1e3).filter(is_changed).count() >= 8, "{places}");
        }
    }

    #[test]
    fn of_a_lopsided_power_of_two_some_digits_above_the_double_below_are_read_as_that() {
        for power in LOPSIDED {
            let double = 2_f64.powi(power);
            let below = format!("{:.60e}", double.next_down());
            let is_between = |digits: &String| *digits > below && digits.parse() == Ok(double.next_down());
            assert!((1..17).map(|places| format!("{double:.places$e}")).any(|digits| is_between(&digits)), "{power}");
        }
    }

    #[test]
    fn a_reader_that_rounds_twice_reads_some_of_every_length_astray() {
        let all = of_every_length();
        assert!(all.iter().all(|(literal, is)| literal.parse() == Ok(*is) && is.is_finite()));
        // Digits that are a double, with a power that is one, are rounded once.
        for length in 1..=18 {
            let of_length = all.iter().filter(|(literal, _)| literal.find('e') == Some(length));
            assert!(of_length.count() >= 16, "{length}");
        }
    }

    #[test]
    fn every_overflow_is_one() {
        for (name, digits) in few_infinite().into_iter().chain(more_infinite()) {
            assert!(digits.parse::<f64>().unwrap().is_infinite(), "{name}");
        }
    }
}
