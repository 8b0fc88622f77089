//! What the programs in `bin/` share: run-time values that the compiler cannot know, the memory
//! functions that a libc would bring, and a panic handler that does not exist.
//!
//! `.ci/bare-metal` builds and inspects the programs. Each one uses a part of halfplane with values
//! read at run time; a panic that the compiler cannot rule out makes the link fail.

#![no_std]

use core::{panic::PanicInfo, ptr};

unsafe extern "C" {
    /// Defined nowhere: a reachable panic is a link error that names it.
    fn halfplane_can_panic() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    // SAFETY: a program that would call this does not link.
    unsafe { halfplane_can_panic() }
}

static mut INPUT: [u32; 64] = [0; 64];
static mut OUTPUT: u64 = 0;

/// A value that only the running program knows.
#[inline(never)]
pub fn input(at: usize) -> u32 {
    // SAFETY: inside the array; there is one thread.
    unsafe { ptr::read_volatile((&raw const INPUT).cast::<u32>().add(at & 63)) }
}

/// Three vertices' worth of window coordinates and depths: x, y, z each.
#[inline(never)]
pub fn inputs() -> [[u32; 3]; 3] {
    [[input(0), input(1), input(2)], [input(3), input(4), input(5)], [input(6), input(7), input(8)]]
}

/// Keeps a result from being optimised away.
#[inline(never)]
pub fn output(value: u64) {
    // SAFETY: there is one thread.
    unsafe { ptr::write_volatile(&raw mut OUTPUT, value) }
}

/// Defines the program's entry point: `$body`, over and over.
#[macro_export]
macro_rules! program {
    ($body:expr) => {
        #[unsafe(no_mangle)]
        extern "C" fn _start() -> ! {
            loop {
                $body();
            }
        }
    };
}

/// # Safety
/// As in C.
#[unsafe(no_mangle)]
unsafe extern "C" fn memcpy(to: *mut u8, from: *const u8, count: usize) -> *mut u8 {
    for i in 0..count {
        // SAFETY: both ranges are valid. Volatile, so that this is not compiled to a call of itself.
        unsafe { ptr::write_volatile(to.add(i), ptr::read_volatile(from.add(i))) };
    }
    to
}

/// # Safety
/// As in C.
#[unsafe(no_mangle)]
unsafe extern "C" fn memmove(to: *mut u8, from: *const u8, count: usize) -> *mut u8 {
    if (to as usize) <= from as usize {
        // SAFETY: copied upwards, no byte is overwritten before it is read.
        return unsafe { memcpy(to, from, count) };
    }
    for i in (0..count).rev() {
        // SAFETY: both ranges are valid, and copied downwards.
        unsafe { ptr::write_volatile(to.add(i), ptr::read_volatile(from.add(i))) };
    }
    to
}

/// # Safety
/// As in C.
#[unsafe(no_mangle)]
unsafe extern "C" fn memset(to: *mut u8, value: i32, count: usize) -> *mut u8 {
    for i in 0..count {
        // SAFETY: the range is valid.
        unsafe { ptr::write_volatile(to.add(i), value as u8) };
    }
    to
}
