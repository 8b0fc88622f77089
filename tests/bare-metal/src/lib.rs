//! What the programs in `bin/` share: run-time values that the compiler cannot know, the memory
//! functions that a libc would bring, and a panic handler that does not exist.
//!
//! `.ci/bare-metal` builds and inspects the programs. Each one uses a part of halfplane with values
//! read at run time; a panic that the compiler cannot rule out makes the link fail.
//!
//! The values stand in the linked file, as [`INPUT`] and [`INDICES`]: whoever wants to run a program writes others over
//! them. A program's exit status is what its main function returns.

#![no_std]

use core::{hint::black_box, panic::PanicInfo, ptr, slice};

unsafe extern "C" {
    /// Defined nowhere: a reachable panic is a link error that names it.
    fn halfplane_can_panic() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    // SAFETY: a program that would call this does not link.
    unsafe { halfplane_can_panic() }
}

/// What [`input`] reads.
#[unsafe(no_mangle)]
#[unsafe(link_section = ".data")]
static mut INPUT: [u32; 64] = [0; 64];
/// What [`indices`] reads.
#[unsafe(no_mangle)]
#[unsafe(link_section = ".data")]
static mut INDICES: [u32; 192] = [0; 192];
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

/// The first `input(32)` indices, of at most 64 triangles.
#[inline(never)]
pub fn indices() -> &'static [u32] {
    let count = (input(32) as usize).min(192);
    // SAFETY: inside the array, and the program writes none of it.
    unsafe { slice::from_raw_parts(black_box((&raw const INDICES).cast()), count) }
}

/// Keeps a result from being optimised away.
#[inline(never)]
pub fn output(value: u64) {
    // SAFETY: there is one thread.
    unsafe { ptr::write_volatile(&raw mut OUTPUT, value) }
}

/// Ends the program: a system call of Linux, or of a debugger (semihosting) on Arm without an operating system. Elsewhere
/// nothing is there to return to.
pub fn exit(status: u32) -> ! {
    #[cfg(all(target_os = "linux", target_arch = "x86_64"))]
    // SAFETY: exit_group does not return.
    unsafe {
        core::arch::asm!("syscall", in("rax") 231, in("rdi") status, options(noreturn));
    }
    #[cfg(all(target_os = "linux", target_arch = "aarch64"))]
    // SAFETY: exit_group does not return.
    unsafe {
        core::arch::asm!("svc 0", in("x8") 94, in("x0") status, options(noreturn));
    }
    #[cfg(all(target_os = "none", target_arch = "arm"))]
    {
        // SYS_EXIT_EXTENDED, ADP_Stopped_ApplicationExit.
        let block = [0x20026, status];
        // SAFETY: the debugger reads the two words.
        unsafe { core::arch::asm!("bkpt 0xab", in("r0") 0x20, in("r1") &block) };
    }
    #[allow(unreachable_code, reason = "where there is an exit")]
    loop {
        output(u64::from(status));
    }
}

/// Defines the program's entry point: `$main` once with the static memory `$memory`, whose result is the exit status.
#[macro_export]
macro_rules! program {
    ($main:path, $memory:ty = $empty:expr) => {
        static mut MEMORY: $memory = $empty;

        extern "C" fn start() -> ! {
            // SAFETY: called once, in the only thread.
            let memory = unsafe { &mut *(&raw mut MEMORY) };
            $crate::exit($main(memory).unwrap_or_default())
        }

        // Where Linux enters a program, no return address lies on the stack, which a function of x86-64 counts on.
        #[cfg(target_arch = "x86_64")]
        #[unsafe(no_mangle)]
        #[unsafe(naked)]
        extern "C" fn _start() -> ! {
            core::arch::naked_asm!("and rsp, -16", "call {}", "ud2", sym start)
        }

        #[cfg(not(target_arch = "x86_64"))]
        #[unsafe(no_mangle)]
        extern "C" fn _start() -> ! {
            start()
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
