//! The settings of Cargo by which the measuring firmware is compiled. It measures nothing.

/// A build profile of the package `xtask/firmware`.
#[derive(Debug, PartialEq, Eq)]
pub struct BuildProfile {
    pub name: &'static str,
    /// Arguments of `cargo build` that choose the build profile.
    pub arguments: &'static [&'static str],
    /// Folder in which Cargo puts the programs of the build profile.
    pub folder: &'static str,
}

/// The profiles whose figures are kept, the recommended one first.
pub const PROFILES: [BuildProfile; 5] = [
    BuildProfile {
        name: "lto = true, codegen-units = 1",
        arguments: &["--release"],
        folder: "release",
    },
    BuildProfile {
        name: "Cargo's default release",
        arguments: &[
            "--release",
            "--config=profile.release.lto=false",
            "--config=profile.release.codegen-units=16",
        ],
        folder: "release",
    },
    BuildProfile {
        name: "lto = true, codegen-units = 1, opt-level = \"s\"",
        arguments: &["--release", "--config=profile.release.opt-level=\"s\""],
        folder: "release",
    },
    BuildProfile {
        name: "lto = true, codegen-units = 1, opt-level = \"z\"",
        arguments: &["--release", "--config=profile.release.opt-level=\"z\""],
        folder: "release",
    },
    BuildProfile {
        name: "Cargo's default dev (debug)",
        arguments: &[],
        folder: "debug",
    },
];

impl BuildProfile {
    /// What every firmware is measured with unless several profiles are compared.
    pub const RECOMMENDED: &Self = &PROFILES[0];
}
