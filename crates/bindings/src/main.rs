//! `bindings MODULE NAME FOLDER`: from a module of WebAssembly the module that a browser loads and the JavaScript and types that call it,
//! as `wasm-bindgen --target web --out-name NAME --out-dir FOLDER MODULE` writes them. That program has to be installed in the version of
//! `Cargo.lock`; this one always is of it.

use std::process::ExitCode;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [module, name, folder] = &words[..] else {
        return told("bindings MODULE NAME FOLDER");
    };
    let mut writer = wasm_bindgen_cli_support::Bindgen::new();
    let written =
        writer.input_path(module).out_name(name).web(true).and_then(|writer| writer.typescript(true).generate(folder));
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => told(&format!("{error:#}")),
    }
}

/// What went wrong, on standard error.
#[allow(clippy::print_stderr)]
fn told(words: &str) -> ExitCode {
    eprintln!("{words}");
    ExitCode::FAILURE
}
