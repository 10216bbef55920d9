//! Where everything that is drawn comes from: a generator of random numbers, and the classes of numbers, sizes and
//! strings at which implementations go wrong.
//!
//! What is drawn depends on the seed and the number of the input alone, never on time, threads or the peer.

use super::harvest::Harvest;

/// The largest integer of the wire.
pub(crate) const LARGEST: i64 = (1 << 53) - 1;

/// Doubles of which the text, or an implementation of it, may think.
const CONSTANTS: [f64; 42] = [
    0.0,
    0.05,
    0.1,
    0.25,
    0.3,
    0.5,
    0.95,
    0.99,
    1.0,
    1.5,
    2.0,
    3.0,
    4.0,
    5.0,
    10.0,
    20.0,
    50.0,
    60.0,
    100.0,
    200.0,
    250.0,
    256.0,
    500.0,
    512.0,
    1000.0,
    4095.0,
    4096.0,
    4097.0,
    30_000.0,
    59_999.0,
    60_000.0,
    60_001.0,
    65_536.0,
    120_000.0,
    16_777_216.0,
    2_147_483_648.0,
    4_294_967_296.0,
    9_007_199_254_740_992.0,
    9_223_372_036_854_775_808.0,
    18_446_744_073_709_551_616.0,
    3.402_823_466_385_288_6e38,
    1.340_780_792_994_259_7e154,
];

/// The classes from which doubles are drawn, by name.
pub(crate) const DOUBLES: [&str; 10] =
    ["plain", "constant", "neighbour", "tiny", "huge", "large-integer", "half", "any-bits", "measured", "dictionary"];

/// What has more bytes than letters, or fewer in a composed form, or more.
const WIDE: [&str; 9] =
    ["\u{e9}", "\u{3b1}", "\u{4e2d}", "\u{ff5e}", "\u{1f681}", "\u{1f681}", "e\u{301}", "\u{958}", "\u{df}"];

/// A source of random choices.
#[derive(Debug, Clone)]
pub(crate) struct Draw<'h> {
    state: u64,
    harvest: &'h Harvest,
    /// Doubles that stand in the input already.
    seen: Vec<f64>,
    /// How many values an input may still have, so that large is not large times large.
    left: usize,
    /// How many steps every trace has, if that is not drawn.
    length: Option<usize>,
}

impl<'h> Draw<'h> {
    /// The source for the input of this number.
    pub(crate) fn new(seed: u64, number: u64, harvest: &'h Harvest) -> Self {
        let mut draw = Self {
            state: seed ^ number.wrapping_mul(0x9e37_79b9_7f4a_7c15),
            harvest,
            seen: Vec::new(),
            left: 0,
            length: None,
        };
        // Neighbouring seeds are to have nothing in common.
        draw.next();
        draw.next();
        draw.left = if draw.chance(2) { 20_000 } else { 1500 };
        draw
    }

    /// The same, with so many steps in every trace.
    pub(crate) fn with_length(mut self, length: Option<usize>) -> Self {
        self.length = length;
        self
    }

    /// How many steps every trace has, if that is not drawn.
    pub(crate) fn length(&self) -> Option<usize> {
        self.length
    }

    /// 64 random bits, by SplitMix64.
    pub(crate) fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `end`, or 0.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        let end = end.max(1) as u64;
        usize::try_from(self.next() % end).unwrap_or(0)
    }

    /// A number from `low` to `high`.
    pub(crate) fn range(&mut self, low: i64, high: i64) -> i64 {
        let span = high.abs_diff(low).saturating_add(1);
        low.wrapping_add_unsigned(self.next() % span.max(1))
    }

    /// Whether it happens, so many times of a hundred.
    pub(crate) fn chance(&mut self, percent: u64) -> bool {
        self.next() % 100 < percent
    }

    /// One of these.
    pub(crate) fn pick<'p, T: ?Sized>(&mut self, from: &'p [&'p T]) -> &'p T {
        from[self.below(from.len())]
    }

    /// One of these.
    pub(crate) fn one<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len())]
    }

    /// A share from 0 to 1, 1 excluded.
    pub(crate) fn share(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A size from `low` to `high`: log-uniform, at the powers of two and their neighbours, at the ends, or at a number
    /// of the dictionary and its neighbours.
    pub(crate) fn size(&mut self, low: usize, high: usize) -> usize {
        if high <= low {
            return low;
        }
        if !self.harvest.numbers.is_empty() && self.chance(15) {
            let found = self.harvest.numbers[self.below(self.harvest.numbers.len())];
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is below `high`")]
            if found >= 1.0 && found < high as f64 {
                return (found as usize + self.below(3)).saturating_sub(1).clamp(low, high);
            }
        }
        let top = (high as f64).ln_1p();
        let size = match self.below(10) {
            0 => high,
            1 => high - 1,
            2..=4 => {
                let power = 1_usize << self.below((usize::BITS - high.leading_zeros()) as usize + 1).min(62);
                power.saturating_add(self.below(3)).saturating_sub(1)
            }
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is below `high`")]
            _ => (self.share() * top).exp_m1() as usize,
        };
        size.clamp(low, high)
    }

    /// Rarely, more than an implementation that keeps the last so many of something would keep.
    pub(crate) fn giant(&mut self) -> Option<usize> {
        self.chance(3).then(|| self.one(&[1 << 10, 1 << 10, 1 << 12, 1 << 12, 1 << 14, 1 << 16]) + 1 + self.below(40))
    }

    /// So many, or as many as the input may still have.
    pub(crate) fn afford(&mut self, count: usize) -> usize {
        let count = count.min(self.left);
        self.left -= count;
        count
    }

    /// Takes note of a double that stands in the input, so that others are drawn next to it.
    pub(crate) fn note(&mut self, value: f64) -> f64 {
        if self.seen.len() < 64 && value.is_finite() {
            self.seen.push(value);
        }
        value
    }

    /// A double that is easy to reckon with: a multiple of 1/16 of up to 64.
    pub(crate) fn plain(&mut self) -> f64 {
        self.range(-1024, 1024) as f64 / 16.0
    }

    /// A finite double of any class.
    pub(crate) fn finite(&mut self) -> f64 {
        let class = self.below(DOUBLES.len());
        self.of_class(class)
    }

    /// A finite double of the class at this place in [`DOUBLES`].
    pub(crate) fn of_class(&mut self, class: usize) -> f64 {
        let value = match DOUBLES.get(class).copied() {
            Some("plain") => self.plain(),
            Some("constant") => self.signed(),
            Some("neighbour") => {
                let near = if self.chance(15) {
                    // A short decimal, or just beside.
                    self.range(-9_999_999, 9_999_999) as f64 / 1000.0
                } else if self.chance(12) {
                    // Below a power of two doubles lie twice as close as above it.
                    let power = 2_f64.powi(i32::try_from(self.range(-1074, 1023)).unwrap_or(0));
                    if self.chance(50) {
                        return power;
                    }
                    power
                } else if self.seen.is_empty() || self.chance(30) {
                    self.one(&CONSTANTS)
                } else {
                    let place = self.below(self.seen.len());
                    self.seen[place]
                };
                self.neighbour(near)
            }
            Some("tiny") => {
                let value = match self.below(5) {
                    0 => 5e-324,
                    1 => f64::MIN_POSITIVE,
                    2 => f64::MIN_POSITIVE.next_down(),
                    3 => 10_f64.powi(-i32::try_from(self.below(320)).unwrap_or(0)),
                    _ => 0.0,
                };
                if self.chance(50) { -value } else { value }
            }
            Some("huge") => {
                let value = match self.below(4) {
                    0 => f64::MAX,
                    1 => f64::MAX / 2.0,
                    2 => 1.340_780_792_994_259_7e154,
                    _ => 10_f64.powi(i32::try_from(self.below(308)).unwrap_or(0)),
                };
                if self.chance(50) { -value } else { value }
            }
            Some("large-integer") => self.integer() as f64,
            Some("half") => self.range(-64, 64) as f64 + 0.5,
            Some("any-bits") => f64::from_bits(self.next()),
            // Of full precision, and of a size at which quantities are measured.
            Some("measured") => {
                let exponent = self.range(-20, 44);
                let value = (1.0 + self.share()) * 2_f64.powi(i32::try_from(exponent).unwrap_or(0));
                if self.chance(30) { -value } else { value }
            }
            _ => match self.harvest.numbers.as_slice() {
                [] => self.plain(),
                numbers => {
                    let found = numbers[self.below(numbers.len())];
                    if self.chance(50) { found } else { self.neighbour(found) }
                }
            },
        };
        if value.is_finite() { value } else { 1.0 }
    }

    /// A finite double that is not negative.
    pub(crate) fn positive(&mut self) -> f64 {
        self.finite().abs()
    }

    /// A double, rarely one that is not finite.
    pub(crate) fn double(&mut self) -> f64 {
        if self.chance(4) { self.strange() } else { self.finite() }
    }

    /// A double that is not finite.
    pub(crate) fn strange(&mut self) -> f64 {
        self.one(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY])
    }

    /// A constant with either sign.
    fn signed(&mut self) -> f64 {
        let value = self.one(&CONSTANTS);
        if self.chance(30) { -value } else { value }
    }

    /// A double that is a few ulps from another, or half or twice of it.
    pub(crate) fn neighbour(&mut self, of: f64) -> f64 {
        match self.below(10) {
            // Near misses at every scale, which tolerances pass.
            8 => of * (1.0 + self.little()),
            9 => of + self.little(),
            0 => of,
            1 => of.next_up(),
            2 => of.next_down(),
            3 => of.next_up().next_up(),
            4 => -of,
            5 => of / 2.0,
            6 => of * 2.0,
            _ => of + 1.0,
        }
    }

    /// A power of ten from 0.1 down to 10^-16, of either sign.
    pub(crate) fn little(&mut self) -> f64 {
        let value = 10_f64.powi(-i32::try_from(self.below(16)).unwrap_or(0) - 1);
        if self.chance(50) { -value } else { value }
    }

    /// An integer of the wire.
    pub(crate) fn integer(&mut self) -> i64 {
        let value = match self.below(7) {
            0..=2 => self.range(-4, 64),
            3 => {
                let power = 1_i64 << self.below(54);
                power + self.range(-1, 1)
            }
            4 => self.one(&[LARGEST, LARGEST - 1, 0, 1, -1, 16_777_216, 16_777_217, 2_147_483_647, 4_294_967_295]),
            5 => self.range(-LARGEST, LARGEST),
            _ => match self.harvest.numbers.as_slice() {
                [] => self.range(0, 4096),
                numbers => {
                    let found = numbers[self.below(numbers.len())];
                    #[expect(clippy::cast_possible_truncation, reason = "it is within the wire's integers")]
                    if found.abs() < LARGEST as f64 { found as i64 } else { LARGEST }
                }
            },
        };
        let value = value.clamp(-LARGEST, LARGEST);
        if self.chance(8) { -value } else { value }
    }

    /// Quotes and backslashes in front of what has a meaning outside strings.
    pub(crate) fn quoted(&mut self) -> String {
        if self.chance(30) {
            // A string that ends with what has to be escaped.
            return format!("{}{}", self.one(&["", "a", "[", "]]"]), self.one(&["\\", "\\\\", "\"", "\\\""]));
        }
        (0..1 + self.below(4))
            .flat_map(|_| [self.one(&["\"", "\\", "\\\"", ""]), self.one(&["[", "]", "{", "}", ",", ":", "//", "\"e"])])
            .collect()
    }

    /// A string: of the dictionary, of one script or another, of special characters, or long.
    pub(crate) fn string(&mut self) -> String {
        match self.below(14) {
            0 => String::new(),
            12 => self.nearly_known(),
            13 if self.chance(4) => {
                let length = self.size(300, 70_000);
                let tail = self.spiced();
                self.letters(length) + &tail
            }
            1 | 2 if !self.harvest.words.is_empty() => {
                let word = self.below(self.harvest.words.len());
                self.harvest.words[word].clone()
            }
            3 => {
                let length = self.size(1, 300);
                self.letters(length)
            }
            4 => self.spiced(),
            5 if self.chance(30) => self.quoted(),
            6 if self.chance(40) => self.formatted(),
            5 => self.pick(&["NaN", "null", "true", "-0", "0", "1e3", "__proto__", "constructor", "kind"]).to_owned(),
            6 => ["é", "e\u{301}", "ﬁ", "ǆ", "İ", "ß", "\u{1f681}", "\u{ff5e}", "\u{feff}", "中", "ا"][self.below(11)]
                .to_owned(),
            _ => self.name(),
        }
    }

    /// What some readers take for more than letters: an identifier, a number, an address, a date, a path.
    fn formatted(&mut self) -> String {
        const FORMATS: [&str; 16] = [
            "6ba7b810-9dad-11d1-80b4-00c04fd430c8",
            "6BA7B810-9DAD-11D1-80B4-00C04FD430C8",
            "{6ba7b810-9dad-11d1-80b4-00c04fd430c8}",
            "6ba7b8109dad11d180b400c04fd430c8",
            "192.168.001.010",
            "::1",
            "a%2Fb",
            "%61",
            "&amp;",
            "2026-01-02T03:04:05Z",
            "QUJD",
            "QUJD==",
            "a@b.c",
            "a=b",
            "xn--a",
            "file:a",
        ];
        if self.chance(40) { self.digits() } else { self.pick(&FORMATS).to_owned() }
    }

    /// A whole number as text, of any width: as a narrow counter or a word of some bits ends, or longer than any.
    pub(crate) fn digits(&mut self) -> String {
        match self.below(6) {
            0 => self.below(10).to_string(),
            1 => self.size(1, 1 << 20).to_string(),
            2 => {
                let power = self.one(&[8_u32, 10, 15, 16, 20, 24, 31, 32, 48, 53, 63, 64]);
                let least = if power == 64 { u128::from(u64::MAX) + 1 } else { 1 << power };
                (least * (1 + u128::from(self.next() % 3)) + u128::from(self.next() % 8)).to_string()
            }
            // 2^128, and a few more.
            3 => format!("34028236692093846346337460743176821145{}", 6 + self.below(4)),
            4 => {
                let (count, last) = (self.size(15, 45), self.below(10));
                let digit = char::from(self.one(b"019"));
                format!("{}{}{last}", 1 + self.below(9), digit.to_string().repeat(count))
            }
            _ => self.next().to_string(),
        }
    }

    /// A word that the text knows, but for its case, for what stands about it, or for its end.
    pub(crate) fn nearly_known(&mut self) -> String {
        const KNOWN: [&str; 20] = [
            "world",
            "m/s",
            "m",
            "mV",
            "Hz",
            "rad",
            "V_m",
            "spikes",
            "rate",
            "active",
            "hold",
            "estop",
            "init",
            "stream",
            "batch",
            "builtin",
            "velocity_setpoint",
            "pose_position",
            "vec3",
            "scalar",
        ];
        let word = self.pick(&KNOWN).to_owned();
        self.nearly(&word)
    }

    /// A word, but for its case, for what stands about it or within, for its end, or for how its letters are written:
    /// what some readers take for the same.
    pub(crate) fn nearly(&mut self, word: &str) -> String {
        const AROUND: [&str; 12] =
            [" ", "\t", "\n", "\r\n", "\0", "\u{a0}", "\u{3000}", "\u{2028}", "\u{feff}", "\u{200b}", "0", "+"];
        let at = |draw: &mut Self| draw.below(word.chars().count().max(1));
        match self.below(18) {
            0 => word.to_uppercase(),
            1 | 2 => format!("{word}{}", self.pick(&AROUND)),
            3 | 4 => format!("{}{word}", self.pick(&AROUND)),
            // Where some texts end.
            5 => format!("{word}\0{}", self.pick(&["x", "2", "/a"])),
            6 => word.chars().map(|c| if c.is_ascii_graphic() { wide(c) } else { c }).collect(),
            7 => {
                let (place, script) = (at(self), self.one(&[0xff10, 0x660, 0x966, 0x1d7ce]));
                let other = |c: char| match c.to_digit(10) {
                    Some(digit) => char::from_u32(script + digit).unwrap_or(c),
                    None => wide(c),
                };
                word.chars().enumerate().map(|(nth, c)| if nth == place { other(c) } else { c }).collect()
            }
            8 => word.chars().take(word.chars().count().saturating_sub(1)).collect(),
            9 => format!("{word}{}", self.one(&['2', '_', '.', '\u{301}', '\u{fe0f}'])),
            10 => {
                let place = at(self);
                let turned =
                    |c: char| if c.is_ascii_lowercase() { c.to_ascii_uppercase() } else { c.to_ascii_lowercase() };
                word.chars().enumerate().map(|(nth, c)| if nth == place { turned(c) } else { c }).collect()
            }
            11 => {
                let (place, within) = (at(self), self.one(&['_', '\u{200d}', '\u{ad}', ' ', '\\']));
                let each = |(nth, c)| std::iter::once(within).filter(move |_| nth == place).chain([c]);
                word.chars().enumerate().flat_map(each).collect()
            }
            12 => word.chars().rev().collect(),
            13 => word.to_owned(),
            // By another mark, or another spelling of the number behind.
            14 => word.replace(MARKS, self.pick(&["-", "_", ".", " ", ":", ""])),
            15 => {
                let digits = word.trim_end_matches(|c: char| c.is_ascii_digit()).len();
                let (head, number) = word.split_at(digits);
                format!("{head}{}{number}{}", self.pick(&["0", "00", "+", ""]), self.pick(&["", "", ".0", "e0"]))
            }
            16 => word.chars().map(alike).collect(),
            _ => {
                let place = at(self);
                word.chars().enumerate().map(|(nth, c)| if nth == place { alike(c) } else { c }).collect()
            }
        }
    }

    /// A short name.
    pub(crate) fn name(&mut self) -> String {
        if !self.harvest.words.is_empty() && self.chance(15) {
            let word = self.below(self.harvest.words.len());
            return self.harvest.words[word].clone();
        }
        let names = ["7", "0", "a", "b", "uav3", "s1", "pop", "v", "in", "grip", "tow", "x", "imu", "A", "a0", "front"];
        self.pick(&names).to_owned()
    }

    /// So many letters; some of the time others of more bytes each, as many as fit into so many bytes.
    pub(crate) fn letters(&mut self, length: usize) -> String {
        if length > 4 && self.chance(20) {
            let wide = self.pick(&WIDE);
            let end = if self.chance(50) { "" } else { "p" };
            return wide.repeat((length - end.len()) / wide.len()) + end;
        }
        let first = self.one(b"abxyz019");
        let mut text = char::from(first).to_string().repeat(length);
        // Equal but for the end: a cache by prefix, or a length that is cut, takes them for one.
        if length > 1 && self.chance(60) {
            text.pop();
            text.push(char::from(self.one(b"pqrs")));
        }
        text
    }

    /// A string with characters that encoders have to escape, or that sort in different orders.
    pub(crate) fn spiced(&mut self) -> String {
        const SPICE: [&str; 20] = [
            "\"",
            "\\",
            "/",
            "\u{8}",
            "\u{c}",
            "\n",
            "\r",
            "\t",
            "\u{0}",
            "\u{1f}",
            "\u{7f}",
            "\u{80}",
            "\u{2028}",
            "\u{feff}",
            "\u{ffff}",
            "\u{1f681}",
            // What is escaped directly behind an escape.
            "\\\u{1f681}",
            "\\ud83d",
            "]",
            "}",
        ];
        if self.chance(15) {
            // Any control character, and any plane.
            let code = if self.chance(60) { self.below(0x21) } else { self.below(17) * 0x1_0000 + self.below(0xd7ff) };
            return u32::try_from(code).ok().and_then(char::from_u32).map_or_else(String::new, String::from);
        }
        (0..=self.below(5)).map(|_| self.pick(&SPICE).to_owned() + if self.chance(50) { "a" } else { "" }).collect()
    }
}

/// What stands between the parts of a name.
const MARKS: [char; 5] = ['-', '_', '.', ' ', ':'];

/// A letter that looks or folds alike.
fn alike(c: char) -> char {
    match c {
        'a' => '\u{430}',
        'e' => '\u{435}',
        'i' => '\u{131}',
        'k' | 'K' => '\u{212a}',
        'o' => '\u{3bf}',
        's' => '\u{17f}',
        '1' => '\u{b9}',
        '-' => '\u{2010}',
        c => c,
    }
}

/// A letter as wide as an ideograph, which compatible normalisation makes the plain one.
fn wide(c: char) -> char {
    if c.is_ascii_graphic() { char::from_u32(u32::from(c) + 0xfee0).unwrap_or(c) } else { c }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_seed_draws_the_same_and_the_next_number_something_else() {
        let harvest = Harvest::default();
        let drawn = |seed, number| {
            let mut draw = Draw::new(seed, number, &harvest);
            (0..50).map(|_| (draw.finite().to_bits(), draw.string(), draw.size(0, 4096))).collect::<Vec<_>>()
        };
        assert_eq!(drawn(7, 3), drawn(7, 3));
        assert_ne!(drawn(7, 3), drawn(7, 4));
        assert_ne!(drawn(7, 3), drawn(8, 3));
    }

    #[test]
    fn what_is_nearly_a_word_differs_in_its_case_its_letters_or_what_stands_about_it() {
        let harvest = Harvest::default();
        let drawn: std::collections::HashSet<String> =
            (0..3000).map(|number| Draw::new(5, number, &harvest).nearly("m0")).collect();
        for word in ["M0", "m0", "m0\0x", "\u{ff4d}\u{ff10}", "m\u{660}", "\u{3000}m0", "m", "m_0", "0m"] {
            assert!(drawn.contains(word), "{word:?}");
        }
        let marked: std::collections::HashSet<String> =
            (0..3000).map(|number| Draw::new(5, number, &harvest).nearly("uav-1")).collect();
        for word in ["uav_1", "uav.1", "uav1", "uav-01", "uav-1.0", "u\u{430}v-1", "uav\u{2010}1"] {
            assert!(marked.contains(word), "{word:?}");
        }
        assert!(drawn.len() > 40, "{}", drawn.len());
        assert_eq!([wide('z'), wide('0'), wide('/'), wide('\u{e9}')], ['\u{ff5a}', '\u{ff10}', '\u{ff0f}', '\u{e9}']);
    }

    #[test]
    fn sizes_reach_the_ends_the_powers_of_two_and_what_lies_between() {
        let harvest = Harvest::default();
        let mut draw = Draw::new(1, 1, &harvest);
        let sizes: std::collections::HashSet<usize> = (0..5000).map(|_| draw.size(1, 4096)).collect();
        for size in [1, 4096, 4095, 1024, 1025, 63, 64, 65] {
            assert!(sizes.contains(&size), "{size}");
        }
        assert!(sizes.iter().all(|size| (1..=4096).contains(size)) && sizes.len() > 300);
    }

    #[test]
    fn every_class_of_doubles_is_finite_and_of_its_kind() {
        let harvest = Harvest::default();
        let mut draw = Draw::new(1, 1, &harvest);
        for _ in 0..2000 {
            for class in 0..DOUBLES.len() {
                assert!(draw.of_class(class).is_finite());
            }
            assert!(draw.of_class(6).fract().abs() == 0.5);
            assert!(draw.of_class(3).abs() <= 1.0);
            assert!((2_f64.powi(-20)..2_f64.powi(45)).contains(&draw.of_class(8).abs()));
            assert!(draw.integer().abs() <= LARGEST);
        }
    }

    #[test]
    fn digits_are_those_of_words_that_overflow_and_some_texts_look_like_more_than_letters() {
        let harvest = Harvest::default();
        let digits: std::collections::HashSet<String> =
            (0..20_000).map(|number| Draw::new(3, number, &harvest).digits()).collect();
        let known = ["256", "1024", "65536", "18446744073709551616", "340282366920938463463374607431768211456"];
        assert!(known.iter().all(|word| digits.contains(*word)));
        assert!(digits.iter().all(|word| word.bytes().all(|byte| byte.is_ascii_digit())));
        let drawn: std::collections::HashSet<String> =
            (0..20_000).map(|number| Draw::new(3, number, &harvest).string()).collect();
        assert!(drawn.contains("6BA7B810-9DAD-11D1-80B4-00C04FD430C8") && drawn.contains("a%2Fb"));
    }
}
