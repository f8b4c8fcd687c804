//! What the module's host calls. Texts cross as a place in the module's memory and a length; an answer is a number with its
//! place in the upper and its length in the lower half, and belongs to the host until it gives it back.

// Exported names and memory that crosses the border of the module are unsafe by their nature.
#![allow(unsafe_code, unreachable_pub)]

/// Memory for the host to write a file to.
#[unsafe(no_mangle)]
pub extern "C" fn take(length: usize) -> *mut u8 {
    Box::into_raw(vec![0u8; length].into_boxed_slice()).cast()
}

/// Memory given back.
///
/// # Safety
/// It must be from [`take`] or an answer, with its own length, and not given back yet.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn give_back(at: *mut u8, length: usize) {
    // SAFETY: as asked of the caller, it is a boxed slice of this length.
    drop(unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(at, length)) });
}

/// [`crate::collapse`].
///
/// # Safety
/// As for [`give_back`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn collapse(at: *const u8, length: usize, method: u32) -> u64 {
    // SAFETY: as asked of the caller.
    out(crate::collapse(unsafe { file(at, length) }, method))
}

/// [`crate::sweep`].
///
/// # Safety
/// As for [`give_back`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sweep(at: *const u8, length: usize) -> u64 {
    // SAFETY: as asked of the caller.
    out(crate::sweep(unsafe { file(at, length) }))
}

/// [`crate::respond`].
///
/// # Safety
/// As for [`give_back`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn respond(at: *const u8, length: usize) -> u64 {
    // SAFETY: as asked of the caller.
    out(crate::respond(unsafe { file(at, length) }))
}

/// # Safety
/// The memory must be readable and stay as it is while the slice is used.
unsafe fn file<'a>(at: *const u8, length: usize) -> &'a [u8] {
    // SAFETY: as asked of the caller.
    unsafe { std::slice::from_raw_parts(at, length) }
}

fn out(answer: String) -> u64 {
    let bytes = answer.into_bytes().into_boxed_slice();
    let length = bytes.len() as u64;
    ((Box::into_raw(bytes).cast::<u8>() as u64) << 32) | length
}
