//! Serves a folder to browsers on this machine. It never leaves the folder.

use std::fs;
use std::io::Cursor;
use std::net::Ipv4Addr;
use std::path::{Component, Path, PathBuf};

use anyhow::Result;
use tiny_http::{Header, Method, Request, Response};

use crate::{misuse::Misuse, print};

/// A server that has its port.
pub struct Server {
    http: tiny_http::Server,
}

/// Takes the port. With port 0 the system chooses one.
pub fn open(port: u16) -> Result<Server, Misuse> {
    let refused = |error| Misuse::new(format!("--serve {port}: {error}"));
    let http = tiny_http::Server::http((Ipv4Addr::LOCALHOST, port)).map_err(refused)?;
    Ok(Server { http })
}

impl Server {
    /// Prints the address and answers until the process ends.
    pub fn run(&self, folder: &Path) -> Result<()> {
        print(format!(
            "http://{}/ (Ctrl+C ends it)\n",
            self.http.server_addr()
        ))?;
        loop {
            let request = self.http.recv()?;
            // A browser that goes away before the answer is no error of the server.
            let _ = answer(request, folder);
        }
    }
}

fn answer(request: Request, folder: &Path) -> std::io::Result<()> {
    if !matches!(request.method(), Method::Get | Method::Head) {
        return request.respond(Response::empty(405));
    }
    let file = requested(request.url()).map(|file| folder.join(file));
    let found = file.and_then(|file| Some((fs::read(&file).ok()?, file)));
    let Some((bytes, file)) = found else {
        return request.respond(Response::from_string("not found\n").with_status_code(404));
    };
    request.respond(response(&file, bytes))
}

/// Returns the path inside of the folder that an address names.
fn requested(url: &str) -> Option<PathBuf> {
    let path = url.split(['?', '#']).next()?.strip_prefix('/')?;
    let path = Path::new(if path.is_empty() { "index.html" } else { path });
    let is_inside = path
        .components()
        .all(|part| matches!(part, Component::Normal(_)));
    is_inside.then(|| path.to_owned())
}

fn response(file: &Path, bytes: Vec<u8>) -> Response<Cursor<Vec<u8>>> {
    let kind = match file.extension().and_then(|it| it.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("json") => "application/json",
        Some("wasm") => "application/wasm",
        _ => "application/octet-stream",
    };
    let kind = Header::from_bytes("Content-Type", kind).expect("a header in ASCII");
    Response::from_data(bytes).with_header(kind)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_outside_of_the_folder_name_no_file() {
        assert_eq!(requested("/"), Some("index.html".into()));
        assert_eq!(requested("/index.html?a#b"), Some("index.html".into()));
        for outside in ["", "/../a", "//etc/passwd", "/a/../../b", "/./a"] {
            assert_eq!(requested(outside), None, "{outside}");
        }
    }
}
