use super::looked_up;
use crate::number::sweep::Sweep;

#[test]
fn zeros_looked_up_are_those_counted() {
    let mut sweep = Sweep::new(12);
    let edges = (0..32).flat_map(|bit| [1 << bit, (1 << bit) - 1, u32::MAX >> bit]);
    let any = (0..1000).map(|_| sweep.within(i32::MIN, i32::MAX) as u32);
    let any: std::vec::Vec<u32> = any.collect();
    for number in edges.chain(any) {
        assert_eq!(looked_up(number), number.leading_zeros());
    }
}
