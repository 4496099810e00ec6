//! The playground as a site: builds it with `cargo xtask playground`, and finds what the repository
//! keeps about it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;
use std::{env, fs};

use serde_json::Value;

use crate::driver::Tab;

pub fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../..")
}

/// Returns the command `cargo xtask playground`. The gate names the program that it has built.
pub fn playground() -> Command {
    let built = env::var_os("XTASK").map(Command::new);
    let mut command = built.unwrap_or_else(|| {
        let mut cargo = Command::new("cargo");
        cargo.arg("xtask");
        cargo
    });
    command.arg("playground").current_dir(repository());
    command
}

pub fn target() -> PathBuf {
    repository().join(env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()))
}

/// Builds the page once. Returns its address as a file, and what the command says of its size.
pub fn built() -> &'static (String, String) {
    static BUILT: OnceLock<(String, String)> = OnceLock::new();
    BUILT.get_or_init(|| {
        let folder = target().join("browser");
        let built = playground().arg("--out").arg(&folder).output().unwrap();
        let words = String::from_utf8_lossy(&built.stderr);
        assert!(built.status.success(), "{words}");
        let page = folder.join("index.html").canonicalize().unwrap();
        let size = String::from_utf8(built.stdout).unwrap();
        (format!("file://{}", page.display()), size)
    })
}

pub fn address() -> &'static str {
    &built().0
}

/// Returns the hashes that an emulated Cortex-M3 reported.
pub fn kept_hashes() -> BTreeMap<String, String> {
    let text = fs::read_to_string(repository().join("docs/measured/m3.jsonl")).unwrap();
    let rows = text.lines().map(serde_json::from_str::<Value>);
    let rows = rows.map(Result::unwrap);
    let fast = rows.filter(|row| row["quality"] == "fast");
    let word = |row: &Value, key: &str| row[key].as_str().unwrap().to_owned();
    fast.map(|row| (word(&row, "scene"), word(&row, "hash")))
        .collect()
}

impl Tab {
    /// Opens an address and waits for the picture.
    pub fn visit(&self, address: &str) {
        self.go(address);
        let state = self.settled();
        let reason = || format!("{} {:?}", self.text_of("error"), self.log());
        assert!(state == "ready", "{state}: {}", reason());
    }

    /// Waits until the page has drawn or refused what it was asked for last. Returns its state.
    pub fn settled(&self) -> String {
        // The page waits for the end of typing.
        self.wait(400);
        self.wait_for("return document.body.dataset.state !== 'drawing';");
        self.text("return document.body.dataset.state;")
    }

    /// Chooses a value of an element, as a user does.
    pub fn choose(&self, id: &str, value: &str) {
        self.run(&format!(
            "const it = document.getElementById('{id}'); it.value = {value:?};
             for (const kind of ['input', 'change']) it.dispatchEvent(new Event(kind, {{ bubbles: true }}));"
        ));
        assert_eq!(self.settled(), "ready", "{id}: {value}");
    }

    /// Returns the values of the list of scenes with the names that users see.
    pub fn scenes(&self) -> Vec<(String, String)> {
        let list = self.run("return [...document.getElementById('scene').options].map((it) => [it.value, it.text]);");
        let pairs = list.as_array().unwrap().iter();
        let word = |it: &Value| it.as_str().unwrap().to_owned();
        pairs.map(|it| (word(&it[0]), word(&it[1]))).collect()
    }

    pub fn text_of(&self, id: &str) -> String {
        let body = format!("return document.getElementById('{id}').textContent.trim();");
        self.text(&body)
    }

    pub fn hash(&self) -> String {
        self.text("return await window.reflet.hash();")
    }

    /// Replaces the text of the scene file. Returns the state of the page.
    pub fn edit(&self, text: &str) -> String {
        self.run(&format!("window.reflet.setText({});", Value::from(text)));
        self.settled()
    }
}
