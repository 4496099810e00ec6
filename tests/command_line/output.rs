//! Tests where the picture and the messages of the render example go.

use std::fs;
#[cfg(unix)]
use std::process::Command;
use std::thread;

use super::program::Folder;
use super::{changed, printed, refused};

#[test]
fn file_that_is_named_twice_is_refused_before_it_is_written() {
    let folder = Folder::new("twice");
    fs::create_dir(folder.path("a")).unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink("a", folder.path("link")).unwrap();
    for (out, raw) in [
        ("x", "x"),
        ("x", "./x"),
        ("a/../x", "x"),
        ("-", "-"),
        #[cfg(unix)]
        ("a/x", "link/x"),
    ] {
        let call = format!("floor --size 2x2 --out {out} --raw {raw}");
        let line = refused(&folder, &call);
        assert_eq!(line, "--out and --raw name the same file", "{out} {raw}");
    }
    assert!(folder.files().iter().all(|it| it == "a" || it == "link"));
    assert!(fs::read_dir(folder.path("a")).unwrap().next().is_none());
}

#[test]
fn renders_at_once_write_a_file_each() {
    let folder = Folder::new("at_once");
    thread::scope(|scope| {
        let calls = [(); 8].map(|()| scope.spawn(|| printed(&folder, "floor --size 16x16")));
        let mut said = calls.map(|call| {
            let words = call.join().unwrap();
            let (_, name) = words.rsplit_once("written to ").unwrap();
            name.trim().to_owned()
        });
        said.sort();
        assert_eq!(folder.files(), said);
    });
    for name in folder.files() {
        assert_eq!(folder.png(&name).dimensions(), (16, 16));
    }
}

#[test]
fn picture_on_standard_output_is_all_that_is_there() {
    let folder = Folder::new("standard_output");
    printed(&folder, "mirror1 --size 5x4 --raw file --out file.png");
    for (option, file) in [("--raw", "file"), ("--out", "file.png")] {
        for words in ["", "--json", "--check"] {
            let call = format!("mirror1 --size 5x4 {option} - {words}");
            let (code, stdout, stderr) = folder.render_bytes(&call);
            assert_eq!((code, stderr.contains("5x4")), (0, true), "{call}");
            assert_eq!(stdout, folder.read(file), "{call}");
        }
    }
    assert_eq!(folder.files(), ["file", "file.png"]);
    let unread = folder.render_unread("mirror1 --size 99x99 --raw -");
    let lines = unread.stderr.lines().count();
    assert_eq!((unread.code, lines), (0, 1), "{}", unread.stderr);
}

/// Drawing would fail first for lack of memory at this size, so the path must have been refused
/// before it.
#[cfg(target_os = "linux")]
#[test]
fn path_that_cannot_be_written_is_refused_before_rendering() {
    let folder = Folder::new("unwritable");
    fs::create_dir(folder.path("folder")).unwrap();
    let long = "a".repeat(300);
    for option in ["--out", "--raw"] {
        for path in ["folder", "folder/new/", "no/x", "/proc/x", &long] {
            let line = refused(&folder, &format!("--size 65535x65535 {option} {path}"));
            assert!(line.starts_with(path), "{line}");
        }
    }
}

#[test]
fn format_that_is_not_written_is_refused() {
    let folder = Folder::new("format");
    for (option, path) in [("--out", "a.jpg"), ("-o", "a.b.JPEG")] {
        let line = refused(&folder, &format!("floor --size 2x2 {option} {path}"));
        let stem = path.rsplit_once('.').unwrap().0;
        let expected = format!("{path}: pictures are written as PNG only: name it {stem}.png");
        assert_eq!(line, expected);
    }
    printed(&folder, "floor --size 2x2 -o a.PNG");
    assert_eq!(folder.files(), ["a.PNG"]);
}

#[test]
fn control_characters_of_names_are_escaped() {
    let folder = Folder::new("escapes");
    let scene = changed(|it| it["name"] = "\u{1b}[31m\u{7}\u{9b}".into());
    folder.write("it.json", scene);
    let no_controls = |text: &str| !text.replace('\n', "").contains(char::is_control);
    for call in [
        "--size 1x1",
        "--needs",
        "--size 1x1 --json",
        "--size 1x1 --check",
    ] {
        let words = printed(&folder, &format!("it.json {call}"));
        assert!(no_controls(&words), "{words:?}");
        assert!(words.contains("[31m"), "{words:?}");
    }
    for out in ["\u{1b}a.png", "\u{1b}/a.png", "\u{1b}a.jpg"] {
        let outcome = folder.run(&["it.json", "--size", "1x1", "--out", out]);
        assert!(no_controls(&(outcome.stdout + &outcome.stderr)), "{out:?}");
    }
}

#[cfg(unix)]
#[test]
fn pipes_are_written_one_after_the_other() {
    let folder = Folder::new("pipes");
    let read = "mkfifo a b && touch ready && cat a > read && cat b >> read";
    let mut reader = Command::new("sh");
    let reader = reader.args(["-c", read]).current_dir(folder.path(""));
    let mut reader = reader.spawn().unwrap();
    while !folder.path("ready").exists() {
        thread::yield_now();
    }
    printed(&folder, "floor --size 2x2 --out a --raw b");
    assert!(reader.wait().unwrap().success());
    printed(&folder, "floor --size 2x2 --out c --raw d");
    let files = ["c", "d"].map(|name| folder.read(name));
    assert_eq!(folder.read("read"), files.concat());
}

#[test]
fn version_is_the_librarys() {
    let folder = Folder::new("version");
    let expected = concat!("render ", env!("CARGO_PKG_VERSION"), "\n");
    assert_eq!(printed(&folder, "--version"), expected);
}

#[test]
fn file_that_is_too_large_is_refused() {
    let folder = Folder::new("large");
    let text = changed(|_| ());
    let padded = |bytes: usize| text.clone() + &" ".repeat(bytes - text.len());
    folder.write("most.json", padded(16_000_000));
    printed(&folder, "most.json --size 1x1 --json");
    folder.write("more.json", padded(16_000_001));
    let words = "a scene file may have 16 MB at most";
    let line = refused(&folder, "more.json");
    assert_eq!(line, format!("more.json: {words}"));
    // A device without an end.
    #[cfg(target_os = "linux")]
    assert_eq!(refused(&folder, "/dev/zero"), format!("/dev/zero: {words}"));
}
