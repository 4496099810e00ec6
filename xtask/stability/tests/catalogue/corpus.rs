//! Tests that the inputs that the fuzzer kept are drawn without an overflow. Needs neither the
//! fuzzer nor its C++ compiler.

use std::fs;

use wild::Wild;

const KEPT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fuzz/corpus/scene");

/// Some inputs are kept because the library refuses them for a reason of their own; most are drawn.
#[test]
fn corpus_of_the_fuzzer_is_drawn() {
    let (mut files, mut drawn, mut rays) = (0, 0, 0);
    for entry in fs::read_dir(KEPT).unwrap() {
        let path = entry.unwrap().path();
        // Printed before it is drawn, so that a panic shows which file caused it.
        println!("{}", path.display());
        let bytes = fs::read(&path).unwrap();
        files += 1;
        if let Some(followed) = Wild::read(&bytes).and_then(|wild| wild.draw()) {
            drawn += 1;
            rays += followed;
        }
    }
    println!("{drawn} scenes of {files} files, {rays} rays");
    assert!(files >= 60, "{files} files are too few");
    assert!(2 * drawn >= files, "{drawn} scenes of {files} files");
}
