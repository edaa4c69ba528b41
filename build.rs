//! Lists what the crate carries, so that nobody has to: the shipped circuits and scenarios, which the binary takes to
//! any folder, and the blocks.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets it"));
    fs::write(out.join("shipped.rs"), shipped(&root.join("circuits"))?)?;
    fs::write(out.join("registry.rs"), registry(&root.join("src/blocks"))?)
}

/// A slice of (path below `root`, text) for every circuit, scenario and memory image.
fn shipped(root: &Path) -> io::Result<String> {
    let mut text = String::from("&[\n");
    for file in files(root, &["v", "toml", "glyphs"])? {
        let name = file.strip_prefix(root).expect("below the root").to_string_lossy().replace('\\', "/");
        writeln!(text, "({name:?}, include_str!({:?})),", file.display().to_string()).expect("a string takes all");
    }
    Ok(text + "]")
}

/// A slice of every `pub static NAME: Block` in the folders below `root`.
fn registry(root: &Path) -> io::Result<String> {
    let mut text = String::from("&[\n");
    for file in files(root, &["rs"])? {
        let module = file.with_extension("");
        let module: Vec<_> =
            module.strip_prefix(root).expect("below the root").iter().map(|s| s.to_string_lossy()).collect();
        for line in fs::read_to_string(&file)?.lines() {
            let name = line.strip_prefix("pub static ").and_then(|rest| rest.split_once(": Block ="));
            if let Some((name, _)) = name {
                writeln!(text, "&{}::{name},", module.join("::")).expect("a string takes all");
            }
        }
    }
    Ok(text + "]")
}

/// All files below `root` with one of these endings, in order of path.
fn files(root: &Path, endings: &[&str]) -> io::Result<Vec<PathBuf>> {
    println!("cargo:rerun-if-changed={}", root.display());
    let mut found = Vec::new();
    collect(root, endings, &mut found)?;
    found.sort();
    Ok(found)
}

fn collect(folder: &Path, endings: &[&str], found: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, endings, found)?;
        } else if path.extension().is_some_and(|ending| endings.iter().any(|known| ending == *known)) {
            found.push(path);
        }
    }
    Ok(())
}
