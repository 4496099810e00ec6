//! Serves a page to browsers on this machine, and nothing else.

use std::net::Ipv4Addr;

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
    pub fn run(&self, page: &str) -> Result<()> {
        print(format!(
            "http://{}/ (Ctrl+C ends it)\n",
            self.http.server_addr()
        ))?;
        loop {
            let request = self.http.recv()?;
            // A browser that goes away before the answer is no error of the server.
            let _ = answer(request, page);
        }
    }
}

fn answer(request: Request, page: &str) -> std::io::Result<()> {
    if !matches!(request.method(), Method::Get | Method::Head) {
        return request.respond(Response::empty(405));
    }
    let path = request.url().split(['?', '#']).next();
    if !path.is_some_and(|path| ["/", "/index.html"].contains(&path)) {
        return request.respond(Response::from_string("not found\n").with_status_code(404));
    }
    let kind = Header::from_bytes("Content-Type", "text/html; charset=utf-8");
    let kind = kind.expect("a header in ASCII");
    request.respond(Response::from_string(page).with_header(kind))
}
