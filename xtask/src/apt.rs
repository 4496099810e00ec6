//! Installs Debian packages with `apt-get`. No other module installs anything outside the Rust
//! toolchain.

use std::time::Duration;

use anyhow::{Context, Result, bail};

use crate::command::Program;

/// Time limit of one `apt-get` run: long enough for a slow mirror, short enough for a person to
/// wait.
const LIMIT: Duration = Duration::from_secs(10 * 60);

/// Installs packages with `apt-get`, as root or by a `sudo` that asks for no password.
pub fn install(packages: &[&str]) -> Result<()> {
    let privileges = privileges()?;
    let apt_get = |arguments: &[&str]| {
        let program = Program::new(privileges[0])
            .args(&privileges[1..])
            .args(["apt-get", "-qq", "-o", "Dpkg::Use-Pty=0"])
            .args(["-o", "DPkg::Lock::Timeout=120"])
            .args(arguments)
            .limit(LIMIT);
        eprintln!("       {program}");
        program.stream_to_stderr()
    };
    // Updating the package list may fail where the mirror is out of reach: an old list may be enough.
    let update = apt_get(&["update"]);
    let install = apt_get(&[&["install", "-y", "--no-install-recommends"], packages].concat());
    match update {
        Err(update) => install.with_context(|| update.to_string()),
        Ok(()) => Ok(install?),
    }
}

/// Returns the words that go before `apt-get`, so that it may install packages and asks no question.
fn privileges() -> Result<&'static [&'static str]> {
    const QUIET: &str = "DEBIAN_FRONTEND=noninteractive";
    if !Program::new("apt-get").args(["--version"]).succeeds() {
        bail!("there is no `apt-get` on this machine");
    }
    if Program::new("id").args(["-u"]).read()? == "0" {
        return Ok(&["env", QUIET]);
    }
    if Program::new("sudo").args(["-n", "true"]).succeeds() {
        return Ok(&["sudo", "-n", "env", QUIET]);
    }
    bail!("`apt-get` needs root, or a `sudo` that asks for no password")
}
