//! QEMU's monitor protocol: one command and one answer at a time, each a line of JSON.
//!
//! This module knows the protocol, but no board. It follows the QEMU Machine Protocol Specification.

use std::io;
use std::io::{BufRead, BufReader, Write};
use std::os::unix::net::UnixStream;
use std::path::Path;
use std::time::Duration;

use serde_json::{Value, json};

#[derive(Debug)]
pub struct Monitor {
    stream: BufReader<UnixStream>,
}

impl Monitor {
    pub fn connect(socket: &Path) -> Result<Self, Error> {
        /// Time limit for an answer. The monitor answers in milliseconds, on a busy machine in some
        /// more.
        const PATIENCE: Duration = Duration::from_secs(10);
        let stream = UnixStream::connect(socket)?;
        stream.set_read_timeout(Some(PATIENCE))?;
        Self::new(stream)
    }

    /// Reads the greeting and enables no extra capabilities.
    fn new(stream: UnixStream) -> Result<Self, Error> {
        let stream = BufReader::new(stream);
        let mut monitor = Self { stream };
        let greeting = monitor.message()?;
        if greeting.get("QMP").is_none() {
            return Err(Error::Protocol(greeting));
        }
        monitor.execute("qmp_capabilities", json!({}))?;
        Ok(monitor)
    }

    pub fn execute(&mut self, command: &str, arguments: Value) -> Result<Value, Error> {
        let request = json!({ "execute": command, "arguments": arguments });
        writeln!(self.stream.get_mut(), "{request}")?;
        loop {
            let mut message = self.message()?;
            if let Some(answer) = message.get_mut("return") {
                return Ok(answer.take());
            }
            if let Some(reason) = message["error"]["desc"].as_str() {
                return Err(Error::Refused {
                    command: command.to_owned(),
                    reason: reason.to_owned(),
                });
            }
            // Between the command and its answer the monitor reports other events.
            if message.get("event").is_none() {
                return Err(Error::Protocol(message));
            }
        }
    }

    fn message(&mut self) -> Result<Value, Error> {
        let mut line = String::new();
        if self.stream.read_line(&mut line)? == 0 {
            return Err(io::Error::from(io::ErrorKind::UnexpectedEof).into());
        }
        serde_json::from_str(&line).map_err(|_| Error::Protocol(Value::String(line)))
    }
}

#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("QEMU's monitor does not answer: {0}")]
    Stream(#[from] io::Error),
    #[error("QEMU refuses `{command}`: {reason}")]
    Refused { command: String, reason: String },
    #[error("QEMU's monitor says {0}")]
    Protocol(Value),
}

#[cfg(test)]
mod tests {
    use std::net::Shutdown;

    use super::*;

    /// Creates a monitor whose answers are already written. Returns it with the stream of its
    /// requests.
    fn monitor(answers: &str) -> (Result<Monitor, Error>, UnixStream) {
        let (stream, mut asked) = UnixStream::pair().unwrap();
        asked.write_all(answers.as_bytes()).unwrap();
        asked.shutdown(Shutdown::Write).unwrap();
        (Monitor::new(stream), asked)
    }

    #[test]
    fn answer_is_found_among_the_events() {
        let (monitor, asked) = monitor(concat!(
            "{\"QMP\": {}}\n",
            "{\"return\": {}}\n",
            "{\"event\": \"RESUME\"}\n",
            "{\"return\": {\"running\": true}}\n",
        ));
        let mut monitor = monitor.unwrap();
        let answer = monitor.execute("query-status", json!({})).unwrap();
        assert_eq!(answer, json!({ "running": true }));
        drop(monitor);
        let asked = serde_json::Deserializer::from_reader(asked).into_iter();
        let asked: Vec<Value> = asked.map(Result::unwrap).collect();
        let commands = ["qmp_capabilities", "query-status"];
        let expected = commands.map(|it| json!({ "execute": it, "arguments": {} }));
        assert_eq!(asked, expected);
    }

    #[test]
    fn refusal_names_the_command_and_the_reason() {
        let (monitor, _asked) = monitor(concat!(
            "{\"QMP\": {}}\n",
            "{\"return\": {}}\n",
            "{\"error\": {\"class\": \"GenericError\", \"desc\": \"no screen\"}}\n",
        ));
        let refusal = monitor.unwrap().execute("screendump", json!({}));
        let words = "QEMU refuses `screendump`: no screen";
        assert_eq!(refusal.unwrap_err().to_string(), words);
    }

    #[test]
    fn conversation_that_breaks_off_is_an_error() {
        let error = |answers| monitor(answers).0.unwrap_err();
        assert!(matches!(error(""), Error::Stream(_)));
        assert!(matches!(error("hello\n"), Error::Protocol(_)));
        assert!(matches!(error("{\"return\": {}}\n"), Error::Protocol(_)));
    }
}
