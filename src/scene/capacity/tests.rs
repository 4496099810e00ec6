use super::*;

#[derive(Clone, Copy, Debug)]
struct Numbers<R: Capacity> {
    spheres: R::Spheres<u8>,
    planes: R::Planes<u8>,
}

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize>
    Numbers<Room<S, P, C, L, M>>
{
    const fn new(last: u8) -> Self {
        let mut numbers = Self {
            spheres: [0; S],
            planes: [0; P],
        };
        numbers.spheres[S - 1] = last;
        numbers
    }
}

impl<R: Capacity> Numbers<R> {
    fn sum(&self) -> u8 {
        let spheres = self.spheres.as_ref().iter();
        spheres.chain(self.planes.as_ref()).sum()
    }
}

#[test]
fn constants_index_arrays_that_depend_on_the_room() {
    const NUMBERS: Numbers<Room<3, 1, 0, 0>> = Numbers::new(5);
    assert_eq!(NUMBERS.spheres, [0, 0, 5]);
    assert_eq!(NUMBERS.sum(), 5);
    assert_eq!(Room::<3, 1, 0, 0>::COUNTS.materials, 8);
}
