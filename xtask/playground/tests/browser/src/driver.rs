//! A tab of headless Chromium, driven by chromedriver. Never knows what the page is for.

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use fantoccini::wd::WebDriverCompatibleCommand;
use fantoccini::{Client, ClientBuilder};
use http::Method;
use hyper_util::client::legacy::connect::HttpConnector;
use serde_json::{Value, json};
use tempfile::TempDir;
use tokio::runtime::{Builder, Runtime};
use url::{ParseError, Url};

/// Arguments of Chromium: no window, nothing from the network, and no sandbox, which root cannot have.
const ARGUMENTS: [&str; 8] = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
];

/// A process that ends with this value.
pub struct Ended(pub Child);

impl Drop for Ended {
    fn drop(&mut self) {
        // It may have ended already.
        let _ = self.0.kill().and_then(|()| self.0.wait());
    }
}

/// Starts a program. Returns it and what follows `words` in the first line that contains them.
pub fn started(command: &mut Command, words: &str) -> (Ended, String) {
    let child = command.stdout(Stdio::piped()).spawn();
    let mut child = child.unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let after = |line: std::io::Result<String>| Some(line.ok()?.split_once(words)?.1.to_owned());
    let found = lines.find_map(after);
    // Reads on, because a program without a reader ends.
    thread::spawn(move || lines.for_each(drop));
    (Ended(child), found.expect("the program says so"))
}

/// A tab. Only one is open at a time: some tests take times.
pub struct Tab {
    runtime: Runtime,
    client: Client,
    _driver: Ended,
    _profile: TempDir,
    _alone: MutexGuard<'static, ()>,
}

impl Tab {
    /// Opens a tab as wide as on a desk.
    pub fn open() -> Self {
        Self::with(
            json!({ "width": 1280, "height": 900, "pixelRatio": 1, "touch": false, "mobile": false }),
        )
    }

    /// Opens a tab of a telephone, 390 pixels wide.
    pub fn narrow() -> Self {
        Self::with(
            json!({ "width": 390, "height": 844, "pixelRatio": 2, "touch": true, "mobile": true }),
        )
    }

    fn with(metrics: Value) -> Self {
        static ALONE: Mutex<()> = Mutex::new(());
        let alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
        let profile = tempfile::tempdir().unwrap();
        let mut arguments = ARGUMENTS.map(str::to_owned).to_vec();
        arguments.push(format!("--user-data-dir={}", profile.path().display()));
        let capabilities = json!({
            "goog:chromeOptions": {
                "args": arguments,
                "mobileEmulation": { "deviceMetrics": metrics },
            },
            "goog:loggingPrefs": { "browser": "ALL" },
            "timeouts": { "script": 120_000 },
        });
        let mut driver = Command::new("chromedriver");
        // Chromium leaves empty folders there.
        driver.env("TMPDIR", profile.path());
        let (driver, port) = started(driver.arg("--port=0"), "started successfully on port ");
        let address = format!("http://127.0.0.1:{}", port.trim_end_matches('.'));
        let runtime = Builder::new_current_thread().enable_all().build().unwrap();
        let mut builder = ClientBuilder::new(HttpConnector::new());
        builder.capabilities(capabilities.as_object().unwrap().clone());
        let client = runtime.block_on(builder.connect(&address)).unwrap();
        Self {
            runtime,
            client,
            _driver: driver,
            _profile: profile,
            _alone: alone,
        }
    }

    pub fn go(&self, address: &str) {
        // A new fragment alone would not load the page again.
        for address in ["about:blank", address] {
            self.runtime.block_on(self.client.goto(address)).unwrap();
        }
    }

    /// Runs the body of an asynchronous function in the page and returns what it returns.
    pub fn run(&self, body: &str) -> Value {
        let script = format!(
            "const done = arguments[0]; (async () => {{ {body} }})().then(\
             (value) => done({{ value }}), (error) => done({{ error: String(error) }}));"
        );
        let answer = self.client.execute_async(&script, vec![]);
        let mut answer = self.runtime.block_on(answer).unwrap();
        assert!(answer["error"].is_null(), "{body}: {}", answer["error"]);
        answer["value"].take()
    }

    /// Runs the body and returns the text that it returns.
    pub fn text(&self, body: &str) -> String {
        let value = self.run(body);
        let text = value.as_str().map(str::to_owned);
        text.unwrap_or_else(|| panic!("{body}: {value}"))
    }

    /// Returns what the browser has logged since the last call: errors, warnings and `console`.
    pub fn log(&self) -> Vec<Value> {
        let entries = self.runtime.block_on(self.client.issue_cmd(Log));
        entries.unwrap().as_array().unwrap().clone()
    }

    pub fn wait(&self, milliseconds: u64) {
        thread::sleep(Duration::from_millis(milliseconds));
    }

    /// Waits until the body returns `true`, for 20 s at most.
    pub fn wait_for(&self, body: &str) {
        let is_true = |_| {
            self.wait(20);
            self.run(body) == json!(true)
        };
        assert!((0..1000).any(is_true), "{body}");
    }
}

impl Drop for Tab {
    fn drop(&mut self) {
        // Ends Chromium, too. A failing test tells its own reason.
        let _ = self.runtime.block_on(self.client.clone().close());
    }
}

/// Chromedriver's own command for the log of the browser.
#[derive(Debug)]
struct Log;

impl WebDriverCompatibleCommand for Log {
    fn endpoint(&self, base: &Url, session: Option<&str>) -> Result<Url, ParseError> {
        base.join(&format!("session/{}/se/log", session.unwrap_or_default()))
    }

    fn method_and_body(&self, _: &Url) -> (Method, Option<String>) {
        (Method::POST, Some(json!({ "type": "browser" }).to_string()))
    }
}
