use super::halves;
use crate::number::sweep::Sweep;

#[test]
fn products_put_together_of_halves_are_exact() {
    let edges = [i32::MIN, i32::MIN + 1, -65_537, -65_536, -65_535, -1, 0, 1];
    let edges = edges.into_iter().flat_map(|edge| [edge, !edge]);
    let mut sweep = Sweep::new(11);
    let any = (0..1000).map(|_| sweep.within(i32::MIN, i32::MAX));
    let all: std::vec::Vec<i32> = edges.chain(any).collect();
    for &a in &all {
        for &b in &all {
            let product = i64::from(a) * i64::from(b);
            assert_eq!(halves::wide(a, b), product, "{a} * {b}");
            assert_eq!(i64::from(halves::high(a, b)), product >> 32, "{a} * {b}");
            if a >= 0 && b >= 0 {
                assert_eq!(halves::wide_positive(a, b), product, "{a} * {b}");
            }
            let (a, b) = (a as u32, b as u32);
            let product = u64::from(a) * u64::from(b);
            assert_eq!(halves::wide_unsigned(a, b), product, "{a} * {b}");
            let short = b & 0xffff;
            let product = u64::from(a) * u64::from(short);
            let scaled = halves::scaled_unsigned(a, short);
            assert_eq!(u64::from(scaled), product >> 17, "{a} * {short}");
        }
    }
}
