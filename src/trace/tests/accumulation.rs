//! The accumulation in the library's own formats, on random α and c: the bounds of `docs/internals/theory.md`.

use std::vec::Vec;

use super::Scenery;

use super::series::{Chain, recursion};
use super::{Followed, followed_by, path};
use crate::color::Sum;
use crate::material::{Material, PreparedMaterial};
use crate::number::sweep::Sweep;
use crate::number::{Unit, share};
use crate::qualities::{Exact, Fast, Quality};
use crate::scene::access::SceneAccess;
use crate::shade::BlinnPhong;
use crate::vector::Position;

/// Number of steps of a sum that make white: 255/256 of 2²⁴.
const WHITE: f64 = 65_536.0 * 255.0;

/// Largest error of double precision, in steps of a sum.
const DOUBLE: f64 = 1e-3;

/// The state of the loop at its end.
struct Summed {
    sum: Sum,
    weight: Unit,
    reflections: usize,
}

/// Runs the loop of `Tracer::trace` without its rays. Follows no throughput below `smallest`.
fn looped(hits: &[PreparedMaterial], smallest: Unit) -> Summed {
    let (mut sum, mut weight) = (Sum::DARK, Unit::ONE);
    for (reflections, hit) in hits.iter().enumerate() {
        let reflected = share(weight, hit.mirror);
        sum.add(weight - reflected, hit.color);
        weight = reflected;
        if weight < smallest || reflections + 1 == hits.len() {
            return Summed {
                sum,
                weight,
                reflections,
            };
        }
    }
    unreachable!("a chain has a surface");
}

/// Returns a surface as the library stores it: α to 2⁻³⁰, the colour to 2⁻²⁶ and in levels.
fn held(alpha: f64, own: f64) -> PreparedMaterial {
    let material = Material::from_numbers([own; 3], 1, 0, (0, 1), alpha).unwrap();
    PreparedMaterial::new(&material)
}

fn held_all(chain: &Chain) -> Vec<PreparedMaterial> {
    let hits = chain.hits.iter();
    hits.map(|hit| held(hit.alpha, hit.own)).collect()
}

fn chains(seed: u64) -> impl Iterator<Item = Chain> {
    let mut sweep = Sweep::new(seed);
    (0..20_000).map(move |_| Chain::random(&mut sweep))
}

/// Returns by how many steps a sum may be too large, and by how many too small.
fn bound(reflections: usize, brightest: f64) -> (f64, f64) {
    let count = reflections as f64;
    let weights = (3.0 * count + 1.0) * brightest / 128.0;
    (weights + 0.375, count + 1.0 + weights + 0.125)
}

/// Returns by how many steps rounding made a sum too small. Light that was cut off because the throughput
/// was too small does not count.
fn missing(chain: &Chain, summed: &Summed) -> f64 {
    let (first, later) = chain.hits.split_at(summed.reflections + 1);
    let next = recursion(later, chain.end);
    let exact = recursion(first, next) - summed.weight.to_num::<f64>() * next;
    WHITE * exact - f64::from(summed.sum.to_bits()[0])
}

#[test]
fn sum_is_within_its_bound() {
    let (mut most, mut nearest) = (0.0_f64, (0.0_f64, 0.0_f64));
    for chain in chains(11) {
        let hits = held_all(&chain);
        for smallest in [Unit::DELTA, Fast::SMALLEST_WEIGHT] {
            let summed = looped(&hits, smallest);
            let (above, below) = bound(summed.reflections, chain.brightest);
            let missing = missing(&chain, &summed);
            assert!(
                (-above - DOUBLE..=below + DOUBLE).contains(&missing),
                "{missing} of {above} {below}: {chain:?}"
            );
            most = most.max(missing.abs());
            nearest = (
                nearest.0.max(-missing / above),
                nearest.1.max(missing / below),
            );
        }
    }
    println!("{most} steps at most, {nearest:?} of the bounds");
    // The bounds are tight: some chains come near them on either side.
    assert!(nearest.0 > 0.8 && nearest.1 > 0.9, "{nearest:?}");
}

#[test]
fn level_is_the_exact_one_or_beside_an_edge() {
    for chain in chains(12) {
        // The chain ends at its last surface, whatever share that mirrors.
        let summed = looped(&held_all(&chain), Unit::DELTA);
        let exact = 255.0 * recursion(&chain.hits[..=summed.reflections], 0.0);
        let (above, below) = bound(summed.reflections, chain.brightest);
        let levels = [
            exact - (below + DOUBLE) / 65_536.0,
            exact + (above + DOUBLE) / 65_536.0,
        ];
        let [least, most] = levels.map(|it| it.clamp(0.0, 255.0).round() as u8);
        assert!(most - least <= 1);
        for level in summed.sum.to_rgb8() {
            assert!((least..=most).contains(&level), "{level}, not {exact}");
        }
    }
}

#[test]
fn shares_and_the_weight_left_add_up_to_exactly_one_in_fixed_point() {
    for chain in chains(13) {
        let (mut weight, mut shares) = (Unit::ONE, Unit::ZERO);
        for hit in held_all(&chain) {
            let reflected = share(weight, hit.mirror);
            assert!(reflected >= Unit::ZERO);
            if hit.mirror < Unit::ONE && weight > Unit::ZERO {
                assert!(reflected < weight)
            } else {
                assert_eq!(reflected, weight)
            }
            shares += weight - reflected;
            weight = reflected;
            assert_eq!(shares + weight, Unit::ONE);
        }
    }
}

#[test]
fn weight_is_within_its_bound() {
    for chain in chains(14) {
        let (mut weight, mut exact) = (Unit::ONE, 1.0);
        for (reflections, (hit, held)) in chain.hits.iter().zip(held_all(&chain)).enumerate() {
            weight = share(weight, held.mirror);
            exact *= hit.alpha;
            let off = (exact - weight.to_num::<f64>()) / f64::exp2(-30.0);
            let count = reflections as f64;
            // Too large by half a step at each surface, and too small by a whole step more at each but
            // the first.
            let (above, below) = ((count + 1.0) / 2.0, (3.0 * count + 1.0) / 2.0);
            assert!(
                (-above - 1e-3..=below + 1e-3).contains(&off),
                "{off} {count}"
            );
        }
    }
}

#[test]
fn nothing_is_added_after_a_weight_of_zero_in_fixed_point() {
    let mut spent = 0;
    for chain in chains(15) {
        let hits = held_all(&chain);
        let stopped = looped(&hits, Unit::DELTA);
        let whole = looped(&hits, Unit::ZERO);
        assert_eq!((stopped.sum, stopped.weight), (whole.sum, whole.weight));
        spent += usize::from(stopped.reflections < whole.reflections);
    }
    assert!(spent > 1000, "{spent} chains were left early");
}

#[test]
fn path_that_is_cut_off_loses_no_more_than_its_weight_says() {
    for chain in chains(16) {
        let summed = looped(&held_all(&chain), Fast::SMALLEST_WEIGHT);
        let weight = summed.weight.to_num::<f64>();
        if summed.reflections + 1 < chain.hits.len() {
            assert!(weight < 1.0 / 256.0);
        }
        let (above, below) = bound(summed.reflections, chain.brightest);
        let exact = recursion(&chain.hits, chain.end);
        let lost = WHITE * exact - f64::from(summed.sum.to_bits()[0]);
        let most = below + WHITE * weight * chain.brightest;
        assert!(
            (-above - DOUBLE..=most + DOUBLE).contains(&lost),
            "{lost} {most}"
        );
    }
}

/// A path straight up and down hits the floor and the ceiling in turn. Their colours are whole 4096ths,
/// so light of brightness 1 on them is exact in every format.
#[test]
fn traced_path_is_the_loop_bit_for_bit() {
    let mut sweep = Sweep::new(17);
    for _ in 0..300 {
        let loss = sweep.within(0, 20);
        let mut scene = Scenery::new();
        let walls = [0, 1].map(|height| {
            let alpha = 1.0 - f64::from(sweep.within(0, 1 << 30 >> loss)) / f64::from(1 << 30);
            let own = f64::from(sweep.within(0, 16 << 12)) / 4096.0;
            let made = Material::from_numbers([own; 3], 1, 0, (0, 1), alpha).unwrap();
            let made = scene.add_material(made).unwrap();
            scene.add_plane([0, 0, height], [0, 0, 1], made).unwrap();
            held(alpha, own)
        });
        let scene = scene.build().unwrap();
        let from = scene.parts().grid.place(Position::new([0.0, 0.0, 0.5]));
        for reflections in [0, 1, 2, 7, sweep.within(8, 255) as u8] {
            let down = path(from, [0.0, 0.0, -1.0]);
            let Followed { sum, rays, cut_off } =
                followed_by::<BlinnPhong, Exact, _>(&scene, down, reflections);
            let hits: Vec<_> = (0..=usize::from(reflections))
                .map(|i| walls[i % 2])
                .collect();
            let expected = looped(&hits, Unit::DELTA);
            assert_eq!((sum, cut_off), (expected.sum, expected.weight));
            assert_eq!(rays as usize, expected.reflections + 1);
        }
    }
}
