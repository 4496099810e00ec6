//! Tests that `defmt` can print what a program on a board reports.
#![cfg(feature = "defmt")]

use defmt::Format;
use reflet::{Error, ErrorKind, Report};

#[test]
fn errors_and_reports_can_be_printed_by_defmt() {
    fn is_format<T: Format>() {}
    is_format::<Error>();
    is_format::<ErrorKind>();
    is_format::<Report>();
}
