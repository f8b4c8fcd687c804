//! Code as wide as the processor's registers.

/// Runs a closure, which is to be marked `#[inline(always)]`, compiled for the widest registers of the processor: what is marked so in it is compiled so too.
/// The bits are the same for any width, unless `work` itself multiplies and adds in one.
pub(crate) fn wide<R>(work: impl FnOnce() -> R) -> R {
    #[cfg(target_arch = "x86_64")]
    {
        if let Some(v4) = pulp::x86::V4::try_new() {
            return v4.vectorize(work);
        }
        if let Some(v3) = pulp::x86::V3::try_new() {
            return v3.vectorize(work);
        }
    }
    work()
}
