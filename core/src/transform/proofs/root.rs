//! Roots: three divisions, so few numbers are all that a prover finishes; more are in tests.

use crate::{
    proof::{cover, prove, which},
    transform::root::root_above,
};

/// A root is none too small, and none too large.
#[inline(always)]
fn is_a_root(root: f64, number: f64) -> bool {
    let square = root * root;
    number <= square && square <= number * (1.0 + 2.0 / (1u64 << 38) as f64)
}

prove! {
    /// The root is a little more than that of the number: for small whole numbers.
    [root_above]
    fn roots_of_whole_numbers_are_a_little_more(number: u32 = 1..=16) {
        let found = which(16, |known| is_a_root(root_above(f64::from(known + 1)), f64::from(known + 1)));
        assert!(found >> (number - 1) & 1 == 1);
        cover!(number == 7);
    }

    /// The same for powers of two, from 2^-896 on.
    [root_above]
    fn roots_of_powers_of_two_are_a_little_more(exponent: u64 = 0..=14) {
        let number = f64::from_bits((127 + (exponent << 7)) << 52);
        assert!(is_a_root(root_above(number), number));
        cover!(exponent == 7);
    }
}

#[cfg(test)]
mod tested {
    use crate::transform::root::root_above;

    /// Numbers of every exponent, with few and with many digits.
    fn numbers() -> impl Iterator<Item = f64> {
        let digits = [
            0,
            1,
            0x000F_FFFF_FFFF_FFFF,
            0x0005_5555_5555_5555,
            0x0008_0000_0000_0001,
            0x0003_243F_6A88_85A3,
        ];
        (0..0x7FF_u64).flat_map(move |exponent| digits.map(|digits| f64::from_bits(exponent << 52 | digits)))
    }

    #[test]
    fn roots_are_a_little_more() {
        for number in numbers() {
            let root = root_above(number);
            // Squares overflow next to the largest number, and have few digits next to 0.
            let scale =
                if number < 1.0 { f64::from_bits(0x58F0_0000_0000_0000) } else { 1.0 / (1u64 << 32) as f64 };
            let (square, number) = ((root * scale) * (root * scale), number * scale * scale);
            assert!(square >= number, "{root} is below the root");
            if number >= f64::MIN_POSITIVE * scale * scale {
                assert!(square <= number * (1.0 + 2.0 / (1u64 << 38) as f64), "{root} is too large");
            }
        }
    }

    #[test]
    fn what_is_no_number_has_no_root() {
        assert!(root_above(f64::NAN).is_nan());
        assert!(root_above(f64::INFINITY).is_nan());
        assert!(root_above(0.0) < 1e-150);
    }
}
