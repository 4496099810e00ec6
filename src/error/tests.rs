use std::string::ToString;

use super::*;

#[test]
fn compiler_and_program_say_the_same() {
    for error in [
        Error::at("sphere", 120, ErrorKind::Radius),
        Error::of("camera", ErrorKind::Up),
        Error::at("material", 0, ErrorKind::Brightness),
    ] {
        let stopped = std::panic::catch_unwind(|| error.stop()).unwrap_err();
        assert_eq!(
            *stopped.downcast::<std::string::String>().unwrap(),
            error.to_string()
        );
    }
}
