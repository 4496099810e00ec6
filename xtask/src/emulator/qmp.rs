//! QEMU's monitor protocol: one command and one answer at a time, each a line of JSON.
//!
//! It knows the protocol and no board. Written after the QEMU Machine Protocol Specification.

use std::io::{self, BufRead, BufReader, Read, Write};

use serde_json::{Value, json};

/// A conversation with QEMU's monitor over any stream.
#[derive(Debug)]
pub struct Monitor<S> {
    stream: BufReader<S>,
}

impl<S: Read + Write> Monitor<S> {
    /// Takes up the conversation: reads the greeting and asks for no extra capabilities.
    pub fn new(stream: S) -> Result<Self, Error> {
        let stream = BufReader::new(stream);
        let mut monitor = Self { stream };
        let greeting = monitor.message()?;
        if greeting.get("QMP").is_none() {
            return Err(Error::Protocol(greeting));
        }
        monitor.execute("qmp_capabilities", json!({}))?;
        Ok(monitor)
    }

    /// Has one command carried out and returns what it returns.
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
            // What else happens on the machine is told in between.
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

/// What can go wrong in a conversation.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The stream broke, or QEMU did not answer in time.
    #[error("QEMU's monitor does not answer: {0}")]
    Stream(#[from] io::Error),
    /// QEMU did not carry out a command, for the reason it gives.
    #[error("QEMU refuses `{command}`: {reason}")]
    Refused { command: String, reason: String },
    /// QEMU said something that is no part of the protocol.
    #[error("QEMU's monitor says {0}")]
    Protocol(Value),
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A monitor that has its answers ready and remembers what it was asked.
    struct Script {
        answers: io::Cursor<&'static str>,
        asked: Vec<u8>,
    }

    impl Read for Script {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            self.answers.read(buffer)
        }
    }

    impl Write for Script {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.asked.write(bytes)
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    fn monitor(answers: &'static str) -> Result<Monitor<Script>, Error> {
        Monitor::new(Script {
            answers: io::Cursor::new(answers),
            asked: Vec::new(),
        })
    }

    #[test]
    fn answer_is_found_among_the_events() {
        let mut monitor = monitor(concat!(
            "{\"QMP\": {}}\n",
            "{\"return\": {}}\n",
            "{\"event\": \"RESUME\"}\n",
            "{\"return\": {\"running\": true}}\n",
        ))
        .unwrap();
        let answer = monitor.execute("query-status", json!({})).unwrap();
        assert_eq!(answer, json!({ "running": true }));
        let asked = monitor.stream.into_inner().asked;
        let asked: Vec<Value> = asked
            .split_inclusive(|&byte| byte == b'\n')
            .map(|line| serde_json::from_slice(line).unwrap())
            .collect();
        assert_eq!(
            asked,
            [
                json!({ "execute": "qmp_capabilities", "arguments": {} }),
                json!({ "execute": "query-status", "arguments": {} }),
            ]
        );
    }

    #[test]
    fn refusal_names_the_command_and_the_reason() {
        let mut monitor = monitor(concat!(
            "{\"QMP\": {}}\n",
            "{\"return\": {}}\n",
            "{\"error\": {\"class\": \"GenericError\", \"desc\": \"no screen\"}}\n",
        ))
        .unwrap();
        let refusal = monitor.execute("screendump", json!({})).unwrap_err();
        assert_eq!(refusal.to_string(), "QEMU refuses `screendump`: no screen");
    }

    #[test]
    fn conversation_that_breaks_off_is_an_error() {
        assert!(matches!(monitor(""), Err(Error::Stream(_))));
        assert!(matches!(monitor("hello\n"), Err(Error::Protocol(_))));
        assert!(matches!(
            monitor("{\"return\": {}}\n"),
            Err(Error::Protocol(_))
        ));
    }
}
