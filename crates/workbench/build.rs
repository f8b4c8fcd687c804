//! The stack of the module: the linker's default of 1 MiB is less than the 8 MiB that programs have elsewhere.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_FAMILY").is_ok_and(|family| family.split(',').any(|name| name == "wasm")) {
        println!("cargo:rustc-link-arg-cdylib=-zstack-size=8388608");
    }
}
