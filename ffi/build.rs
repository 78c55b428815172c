//! Names the shared library by its ABI version, which cargo does not do.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    // The number is the major version of the ABI; see CRITREG_ABI_VERSION.
    if std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "linux") {
        println!("cargo:rustc-cdylib-link-arg=-Wl,-soname,libcritreg.so.0");
    }
}
