//! Inputs made of seeds: bytes, numbers, words and brackets changed, parts moved, repeated, cut and taken from other
//! seeds.

/// A generator of pseudo-random numbers, SplitMix64: the same for the same seed on every machine.
///
/// Source: Steele, Lea, Flood, OOPSLA 2014, doi:10.1145/2660193.2660195.
#[derive(Debug, Clone)]
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below a bound; 0 where the bound is.
    pub fn below(&mut self, bound: usize) -> usize {
        if bound == 0 { 0 } else { (self.next() % bound as u64) as usize }
    }

    pub fn one_of<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[self.below(all.len())]
    }
}

/// Numbers at which readers go wrong.
const NUMBERS: [&str; 26] = [
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "0.5",
    "1e308",
    "-1e308",
    "1e309",
    "1e-308",
    "5e-324",
    "NaN",
    "inf",
    "-inf",
    "1e16",
    "255",
    "256",
    "65536",
    "2147483648",
    "4294967296",
    "9007199254740993",
    "18446744073709551615",
    "99999999999999999999",
    "0x10",
    "1_000",
    "1e8",
];
/// Texts at which they go wrong.
const TEXTS: [&str; 22] = [
    "",
    " ",
    "\n",
    "\r\n",
    "\t",
    "\"",
    "\\",
    "\u{feff}",
    "\u{1b}[2J",
    "\u{0}",
    "µ",
    "\u{1f600}",
    "//",
    "/*",
    "*/",
    ",",
    ":",
    "..",
    "None",
    "Some(1)",
    "true",
    "r#\"",
];
/// Lengths and counts of binary formats.
const WORDS: [u64; 14] =
    [0, 1, 2, 7, 8, 127, 128, 255, 65_535, 1 << 20, (1 << 26) + 1, u32::MAX as u64, i64::MAX as u64, u64::MAX];
/// Longest input, bytes: what is repeated must not outgrow the limits of files for long.
const LONGEST: usize = 1 << 21;

/// Which kinds of changes make sense.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    Text,
    Binary,
}

/// Changes an input one to eight times; `other` lends parts.
pub fn mutate(random: &mut Random, form: Form, input: &mut Vec<u8>, other: &[u8]) {
    for _ in 0..=random.below(8).min(random.below(8)) {
        match (form, random.below(8)) {
            (Form::Text, 0..4) => change_text(random, input, other),
            (Form::Binary, 0..2) => put_word(random, input),
            _ => change_bytes(random, input, other),
        }
        input.truncate(LONGEST);
    }
}

/// A range within so many bytes, most often short.
fn range(random: &mut Random, length: usize) -> std::ops::Range<usize> {
    let start = random.below(length);
    let most = [4, 16, 64, 1024, length][random.below(5)].min(length - start);
    start..start + random.below(most + 1)
}

fn change_bytes(random: &mut Random, input: &mut Vec<u8>, other: &[u8]) {
    let at = random.below(input.len());
    match random.below(8) {
        0 | 1 if !input.is_empty() => input[at] ^= 1 << random.below(8),
        2 if !input.is_empty() => input[at] = *random.one_of(&[0, 1, 0x7f, 0x80, 0xff, b'(', b')', b'"', b',', b'\n']),
        3 => {
            let random_bytes: Vec<u8> = (0..=random.below(8)).map(|_| random.next() as u8).collect();
            put(input, at..at, &random_bytes);
        }
        4 => {
            let range = range(random, input.len());
            input.drain(range);
        }
        5 => {
            let part = input[range(random, input.len())].to_vec();
            put(input, at..at, &part);
        }
        6 => {
            let part = &other[range(random, other.len())];
            let end = (at + [0, part.len()][random.below(2)]).min(input.len());
            put(input, at..end, part);
        }
        _ => input.truncate(at),
    }
}

/// Overwrites two, four or eight bytes with a number at which readers go wrong.
fn put_word(random: &mut Random, input: &mut [u8]) {
    let bytes = random.one_of(&WORDS).wrapping_add(random.below(3) as u64).wrapping_sub(1).to_le_bytes();
    let count = *random.one_of(&[2, 4, 8]);
    let at = random.below(input.len());
    let end = (at + count).min(input.len());
    input[at..end].copy_from_slice(&bytes[..end - at]);
}

fn change_text(random: &mut Random, input: &mut Vec<u8>, other: &[u8]) {
    let tokens = tokens(random, input);
    if tokens.is_empty() {
        input.extend_from_slice(random.one_of(&TEXTS).as_bytes());
        return;
    }
    let token = random.one_of(&tokens).clone();
    match random.below(7) {
        // A number for a number, a word for a word of the same or of another text.
        0 | 1 => {
            let numbers: Vec<_> = tokens.iter().filter(|t| input[t.start].is_ascii_digit()).collect();
            let at = if numbers.is_empty() { token } else { (*random.one_of(&numbers)).clone() };
            put(input, at, random.one_of(&NUMBERS).as_bytes());
        }
        2 => {
            let word = input[random.one_of(&tokens).clone()].to_vec();
            put(input, token, &word);
        }
        3 => {
            let words = self::tokens(random, other);
            if !words.is_empty() {
                put(input, token, &other[random.one_of(&words).clone()]);
            }
        }
        4 => {
            put(input, token.start..token.start, random.one_of(&TEXTS).as_bytes());
        }
        5 => {
            // Deep nesting, now and then very deep.
            let depth = *random.one_of(&[1, 2, 8, 64, 200, 20_000]);
            let (open, close) =
                *random.one_of(&[("(", ")"), ("[", "]"), ("{", "}"), ("Some(", ")"), ("(a:", ")"), ("/*", "*/")]);
            let nested =
                [open.repeat(depth).as_bytes(), &input[token.clone()], close.repeat(depth).as_bytes()].concat();
            put(input, token, &nested);
        }
        _ => {
            // A long word or a long list.
            let count = *random.one_of(&[2, 10, 100, 5_000]);
            // What is cut off afterwards need not be made.
            let end = token.end.min(token.start + LONGEST / count);
            let part =
                [&input[token.start..end], random.one_of(&["", ",", " ", "\n"]).as_bytes()].concat().repeat(count);
            put(input, token, &part);
        }
    }
}

/// Overwrites a range by something of another length, which shifts what follows.
fn put(input: &mut Vec<u8>, range: std::ops::Range<usize>, part: &[u8]) {
    let tail = input.split_off(range.end);
    input.truncate(range.start);
    input.extend_from_slice(part);
    input.extend_from_slice(&tail);
}

/// Length of the part of a text in which words are looked for: most change one, and long texts have thousands.
const LOOKED_AT: usize = 1024;

/// Words and numbers of a part of a text.
fn tokens(random: &mut Random, text: &[u8]) -> Vec<std::ops::Range<usize>> {
    let inside = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'.' | b'-' | b'+') || byte >= 0x80;
    let from = random.below((text.len() + 1).saturating_sub(LOOKED_AT));
    let to = (from + LOOKED_AT).min(text.len());
    let mut tokens = Vec::new();
    let mut start = None;
    for (at, &byte) in text[from..to].iter().enumerate() {
        match (start, inside(byte)) {
            (None, true) => start = Some(from + at),
            (Some(begin), false) => {
                tokens.push(begin..from + at);
                start = None;
            }
            _ => {}
        }
    }
    tokens.extend(start.map(|begin| begin..to));
    tokens
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_the_same_seed_makes_the_same_inputs() {
        let made = |seed| {
            let (mut random, mut input) = (Random::new(seed), b"(a: mm(3), b: [1, 2])".to_vec());
            (0..200)
                .map(|_| {
                    mutate(&mut random, Form::Text, &mut input, b"c: kN(4)");
                    input.clone()
                })
                .collect::<Vec<_>>()
        };
        assert_eq!(made(1), made(1));
        assert_ne!(made(1), made(2));
        assert!(made(1).iter().all(|input| input.len() <= LONGEST));
    }

    #[test]
    fn limit_nothing_and_one_byte_can_be_changed() {
        let mut random = Random::new(3);
        for form in [Form::Text, Form::Binary] {
            for start in [&b""[..], b"x"] {
                for _ in 0..2000 {
                    let mut input = start.to_vec();
                    mutate(&mut random, form, &mut input, start);
                }
            }
        }
    }

    /// First numbers of the reference program for seed 1234567 (Vigna, prng.di.unimi.it/splitmix64.c).
    #[test]
    fn code_splitmix64() {
        let mut random = Random::new(1_234_567);
        assert_eq!([random.next(), random.next()], [6_457_827_717_110_365_317, 3_203_168_211_198_807_973]);
    }
}
