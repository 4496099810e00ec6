//! Tests of the comparison of pictures.

use std::string::ToString;

use super::*;

fn row(pixels: &[[u8; 3]]) -> Picture {
    Picture {
        width: pixels.len() as u32,
        height: 1,
        pixels: pixels.to_vec(),
    }
}

/// Compares two rows of four pixels [100; 3], one pixel of the second replaced by `pixel`.
fn one_of_four(pixel: [u8; 3]) -> Difference {
    let (a, mut b) = (row(&[[100; 3]; 4]), row(&[[100; 3]; 4]));
    b.pixels[2] = pixel;
    let difference = compare(&a, &b).unwrap();
    assert_eq!(
        difference,
        compare(&b, &a).unwrap(),
        "the order does not matter"
    );
    difference
}

#[test]
fn equal_pictures_have_no_difference() {
    let perfect = Difference {
        same: 1.0,
        within1: 1.0,
        within8: 1.0,
        psnr: f64::INFINITY,
        max: 0,
    };
    assert_eq!(one_of_four([100; 3]), perfect);
    assert_eq!(compare(&row(&[]), &row(&[])), Ok(perfect));
}

#[test]
fn shares_end_at_their_limits_on_both_sides() {
    let shares = [
        (1, [0.75, 1.0, 1.0]),
        (2, [0.75, 0.75, 1.0]),
        (8, [0.75, 0.75, 1.0]),
        (9, [0.75, 0.75, 0.75]),
        (100, [0.75, 0.75, 0.75]),
    ];
    for (far, expected) in shares {
        for channel in 0..3 {
            for value in [100 - far, 100 + far] {
                let mut pixel = [100; 3];
                pixel[channel] = value;
                let found = one_of_four(pixel);
                assert_eq!(
                    [found.same, found.within1, found.within8],
                    expected,
                    "{pixel:?}"
                );
                assert_eq!(found.max, far);
            }
        }
    }
}

#[test]
fn pixel_counts_by_its_worst_channel() {
    let found = one_of_four([101, 99, 109]);
    assert_eq!([found.same, found.within1, found.within8], [0.75; 3]);
    assert_eq!(found.max, 9);
}

#[test]
fn psnr_is_taken_over_all_channels() {
    // The channels of one pixel differ by 3, 4 and 0: squares of 25 in sum, over twelve channels.
    let expected = 10.0 * (255.0 * 255.0 * 12.0 / 25.0_f64).log10();
    assert_eq!(one_of_four([103, 96, 100]).psnr, expected);
    assert!((44.942..44.944).contains(&expected), "{expected}");
}

#[test]
fn black_against_white_is_zero_decibels() {
    let found = compare(&row(&[[0; 3]; 5]), &row(&[[255; 3]; 5])).unwrap();
    assert_eq!((found.psnr, found.max, found.within8), (0.0, 255, 0.0));
}

#[test]
fn different_sizes_are_refused() {
    let (wide, mut tall) = (row(&[[0; 3]; 6]), row(&[[0; 3]; 6]));
    (tall.width, tall.height) = (2, 3);
    let error = compare(&wide, &tall).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a picture of 6x1 and one of 2x3 cannot be compared"
    );

    tall.pixels.pop();
    let error = compare(&tall, &wide).unwrap_err();
    let words = "a picture of 2x3 with 5 pixels and one of 6x1 cannot be compared";
    assert_eq!(error.to_string(), words);
}
