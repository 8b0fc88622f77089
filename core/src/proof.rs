//! Properties of the core, each stated once and driven by two engines: Kani, for all inputs, and
//! proptest, for some.
//!
//! A `proofs` module beside the code states them with [`prove!`]. The body is a plain function that
//! asserts; [`assume!`] narrows its inputs, and [`cover!`] says what must be possible.

/// States properties.
///
/// ```text
/// prove! {
///     /// What holds, and from where the bounds come.
///     #[kani::unwind(17)]              // what a prover needs to know; may be absent
///     [Type::method, function]         // the functions whose arithmetic the proof executes
///     fn name(x: i32 = -8..=8, bits: u32) { assert!(..) }
/// }
/// ```
///
/// Every input has a type, and a range or all values of the type.
macro_rules! prove {
    ($(
        $(#[doc = $doc:literal])*
        $(#[kani::$attribute:ident($($argument:tt)*)])*
        [$($proved:tt)*]
        fn $name:ident($($input:ident: $type:ty $(= $range:expr)?),* $(,)?) $body:block
    )+) => {
        $(
            $(#[doc = $doc])*
            #[inline(always)]
            fn $name($($input: $type),*) $body
        )+

        #[cfg(kani)]
        mod harnesses {
            #[allow(unused_imports)]
            use super::*;
            $(
                #[kani::proof]
                $(#[kani::$attribute($($argument)*)])*
                fn $name() {
                    super::$name($($crate::proof::any_input!($type $(, $range)?)),*);
                }
            )+
        }

        #[cfg(test)]
        mod tests {
            #[allow(unused_imports)]
            use super::*;
            $(
                #[test]
                fn $name() {
                    $crate::proof::run(
                        ($($crate::proof::some_inputs!($type $(, $range)?),)*),
                        |($($input,)*)| super::$name($($input),*),
                    );
                }
            )+
        }
    };
}

/// Any value of a type, or of a range.
#[cfg(kani)]
macro_rules! any_input {
    ($type:ty) => {
        kani::any::<$type>()
    };
    ($type:ty, $range:expr) => {
        kani::any_where(|value: &$type| $crate::proof::Within::within(value, &$range))
    };
}

/// The strategy for values of a type, or of a range.
#[cfg(test)]
macro_rules! some_inputs {
    ($type:ty) => {
        <$type as $crate::proof::Input>::all()
    };
    ($type:ty, $range:expr) => {
        <$type as $crate::proof::Input>::within($range)
    };
}

/// Leaves out the inputs for which the condition does not hold.
#[allow(unused_macros)]
macro_rules! assume {
    ($condition:expr) => {
        #[cfg(kani)]
        kani::assume($condition);
        #[cfg(not(kani))]
        {
            let holds: bool = $condition;
            if !holds {
                return;
            }
        }
    };
}

/// Some input that is not left out makes the condition true: a prover says where none does.
macro_rules! cover {
    ($condition:expr) => {
        #[cfg(kani)]
        kani::cover!($condition);
        #[cfg(not(kani))]
        let _: bool = $condition;
    };
}

/// What can lie within a range of its own type; of an array, each element.
#[cfg(kani)]
pub(crate) trait Within: Sized {
    /// Whether it does.
    fn within(&self, range: &core::ops::RangeInclusive<Self>) -> bool;
}

#[cfg(kani)]
macro_rules! integers_within {
    ($($type:ident)+) => {$(
        impl Within for $type {
            #[inline(always)]
            fn within(&self, range: &core::ops::RangeInclusive<Self>) -> bool {
                *range.start() <= *self && *self <= *range.end()
            }
        }
    )+};
}

#[cfg(kani)]
integers_within!(u8 u16 u32 u64 usize i32 i64);

#[cfg(kani)]
impl<T: Within + Copy, const N: usize> Within for [T; N] {
    #[inline(always)]
    fn within(&self, range: &core::ops::RangeInclusive<Self>) -> bool {
        let mut within = true;
        for i in 0..N {
            within &= self[i].within(&(range.start()[i]..=range.end()[i]));
        }
        within
    }
}

#[cfg(kani)]
pub(crate) use any_input;
#[cfg(test)]
pub(crate) use some_inputs;
#[allow(unused_imports)]
pub(crate) use {assume, cover, prove};

/// Of which of the first numbers something holds, in bits: each is tried by itself, so that a prover has constants to
/// calculate with.
#[cfg(feature = "transform")]
#[inline(always)]
pub(crate) fn which(count: i32, holds: impl Fn(i32) -> bool) -> u32 {
    let mut found = 0;
    for number in 0..count {
        found |= u32::from(holds(number)) << number;
    }
    found
}

#[cfg(test)]
pub(crate) use engine::{Input, run};

/// The engine of tests.
#[cfg(test)]
mod engine {
    extern crate std;

    use core::{fmt::Debug, ops::RangeInclusive};
    use proptest::{
        prelude::*,
        strategy::Union,
        test_runner::{Config, RngAlgorithm, TestRng, TestRunner},
    };
    use std::{vec, vec::Vec};

    /// Cases of each property.
    const CASES: u32 = 2000;

    /// A type of inputs, whose strategies like the ends of ranges.
    pub(crate) trait Input: Debug + Sized + 'static {
        /// All values.
        fn all() -> BoxedStrategy<Self>;
        /// The values of a range.
        fn within(range: RangeInclusive<Self>) -> BoxedStrategy<Self>;
    }

    /// Runs a property on the same cases in every run.
    ///
    /// # Panics
    ///
    /// With the smallest failing inputs that were found.
    pub(crate) fn run<S: Strategy>(inputs: S, property: impl Fn(S::Value)) {
        let config = Config { cases: CASES, failure_persistence: None, ..Config::default() };
        let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
        let outcome = TestRunner::new_with_rng(config, rng).run(&inputs, |inputs| {
            property(inputs);
            Ok(())
        });
        if let Err(error) = outcome {
            panic!("{error}");
        }
    }

    /// Evenly from a range, near its ends, near 0, and powers of two with their neighbours.
    macro_rules! integers {
        ($($type:ident)+) => {$(
            impl Input for $type {
                fn all() -> BoxedStrategy<Self> {
                    Self::within(Self::MIN..=Self::MAX)
                }

                fn within(range: RangeInclusive<Self>) -> BoxedStrategy<Self> {
                    let (low, high) = (*range.start(), *range.end());
                    let power = (0..Self::BITS, 0..3 as Self, any::<bool>()).prop_map(|(shift, near, minus)| {
                        let value = ((1 as Self) << shift).wrapping_add(near).wrapping_sub(1);
                        if minus { (0 as Self).wrapping_sub(value) } else { value }
                    });
                    let mut choices: Vec<(u32, BoxedStrategy<Self>)> = vec![
                        (4, (low..=high).boxed()),
                        (1, (low..=low.saturating_add(3).min(high)).boxed()),
                        (1, (high.saturating_sub(3).max(low)..=high).boxed()),
                    ];
                    let fitting = power.prop_map(move |value| value.clamp(low, high));
                    choices.push((2, fitting.boxed()));
                    Union::new_weighted(choices).boxed()
                }
            }
        )+};
    }

    integers!(u8 u16 u32 u64 usize i32 i64);

    impl Input for bool {
        fn all() -> BoxedStrategy<Self> {
            any::<bool>().boxed()
        }

        fn within(_: RangeInclusive<Self>) -> BoxedStrategy<Self> {
            Self::all()
        }
    }

    impl<T: Input + Clone, const N: usize> Input for [T; N] {
        fn all() -> BoxedStrategy<Self> {
            proptest::array::uniform(T::all()).boxed()
        }

        fn within(range: RangeInclusive<Self>) -> BoxedStrategy<Self> {
            let (low, high) = range.into_inner();
            let each: Vec<_> = low.into_iter().zip(high).map(|(low, high)| T::within(low..=high)).collect();
            each.prop_map(|values| values.try_into().unwrap_or_else(|_| unreachable!("as many as ranges")))
                .boxed()
        }
    }
}
