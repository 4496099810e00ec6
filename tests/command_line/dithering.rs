//! Tests the option `--dither`.

use std::collections::BTreeSet;

use super::line_of_json;
use super::program::Folder;

#[test]
fn dithered_picture_has_the_levels_asked_for() {
    let folder = Folder::new("dithered");
    let render = |name: &str, arguments: &str| {
        let call = format!("mirror1 --size 24x24 --check --json {arguments} --raw {name}");
        let line = line_of_json(&folder, &call);
        (folder.read(name), line["psnr"].clone())
    };
    let (plain, psnr) = render("plain", "");
    for (name, levels) in [("binary", 2), ("gray2", 4), ("gray4", 16), ("rgb565", 32)] {
        let (dithered, of_dithered) = render(name, &format!("--dither {name}"));
        assert_eq!(of_dithered, psnr, "the picture is compared as it was");
        assert_eq!(dithered.len(), plain.len());
        assert_ne!(dithered, plain);
        let reds: BTreeSet<u8> = dithered.iter().copied().step_by(3).collect();
        assert!((2..=levels).contains(&reds.len()), "{name}: {reds:?}");
        let is_grey = dithered.chunks(3).all(|pixel| pixel == [pixel[0]; 3]);
        assert_eq!(is_grey, name != "rgb565");
    }
}
