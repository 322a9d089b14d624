//! Tells the linker where libcontdyn is: in the folder of the file that the environment variable CONTDYN_LIBRARY names;
//! in build/src, when the crate lies in contdyn's sources; else wherever the linker looks.
use std::env;
use std::path::{Path, PathBuf};

fn folder() -> Option<PathBuf> {
    if let Some(named) = env::var_os("CONTDYN_LIBRARY") {
        let file = Path::new(&named);
        assert!(file.is_file(), "CONTDYN_LIBRARY names no file: {}", file.display());
        return file.parent().map(Path::to_path_buf);
    }
    let root = Path::new(&env::var_os("CARGO_MANIFEST_DIR")?).join("../..");
    let built = root.join("build/src");
    (root.join("include/contdyn/contdyn.h").exists() && built.exists()).then_some(built)
}

fn main() {
    println!("cargo:rerun-if-env-changed=CONTDYN_LIBRARY");
    let unix = env::var_os("CARGO_CFG_UNIX").is_some();
    if let Some(folder) = folder() {
        let folder = folder.canonicalize().expect("the library's folder");
        println!("cargo:rustc-link-search=native={}", folder.display());
        println!("cargo:lib_dir={}", folder.display()); // DEP_CONTDYN_LIB_DIR, for those that depend on this crate
        if unix {
            println!("cargo:rustc-link-arg=-Wl,-rpath,{}", folder.display()); // this crate's own tests only
        }
    }
    if env::var_os("CARGO_FEATURE_STATIC").is_some() {
        println!("cargo:rustc-link-lib=static=contdyn");
        if unix {
            println!("cargo:rustc-link-lib=m");
        }
    } else {
        println!("cargo:rustc-link-lib=dylib=contdyn");
    }
}
