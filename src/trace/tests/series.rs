//! The accumulation over reflections in double precision, on random α and c. Checks the facts that
//! `docs/internals/theory.md` proves.

use std::vec::Vec;

use crate::number::sweep::Sweep;

/// Largest error of double precision after 256 steps, as a share of the brightest colour.
const ROUNDED: f64 = 1e-13;

/// A surface: the share α that it mirrors, and its own colour.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hit {
    pub(super) alpha: f64,
    pub(super) own: f64,
}

/// The surfaces that a path hits, and the colour along the ray that leaves the last one.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub(super) hits: Vec<Hit>,
    pub(super) end: f64,
    /// Upper bound on all colours.
    pub(super) brightest: f64,
}

impl Chain {
    /// Returns 1 to 256 random surfaces. Most of them lose between all and a millionth of the light.
    pub(super) fn random(sweep: &mut Sweep) -> Self {
        let count = match sweep.within(0, 1) {
            0 => sweep.within(1, 8),
            _ => sweep.within(9, 256),
        };
        let (brightest, loss) = (power_of_two(sweep, -8, 4), power_of_two(sweep, -20, 0));
        let mut colour = || brightest * share(sweep);
        let end = colour();
        let own: Vec<f64> = (0..count).map(|_| colour()).collect();
        let hit = |own| {
            let alpha = match sweep.within(0, 255) {
                0 => 0.0,
                1..=15 => 1.0,
                _ => 1.0 - loss * share(sweep),
            };
            Hit { alpha, own }
        };
        Self {
            hits: own.into_iter().map(hit).collect(),
            end,
            brightest,
        }
    }
}

/// Returns 2 to the power of a random whole number from `low` to `high`.
fn power_of_two(sweep: &mut Sweep, low: i32, high: i32) -> f64 {
    f64::exp2(f64::from(sweep.within(low, high)))
}

/// Returns a random number from 0 to 1, both included. Few of these numbers are exact in 53 bits.
fn share(sweep: &mut Sweep) -> f64 {
    f64::from(sweep.within(0, i32::MAX)) / f64::from(i32::MAX)
}

/// Returns the colour by the recursion cⁱ = (1 − αᵢ) cᵢ + αᵢ cⁱ⁺¹, computed as written.
pub(super) fn recursion(hits: &[Hit], end: f64) -> f64 {
    match hits {
        [] => end,
        [hit, later @ ..] => (1.0 - hit.alpha) * hit.own + hit.alpha * recursion(later, end),
    }
}

/// Returns Σ (1 − αᵢ) (Π over k < i of αₖ) cᵢ and Π over all αₖ, computed as written.
fn formula(hits: &[Hit]) -> (f64, f64) {
    let product = |hits: &[Hit]| hits.iter().map(|hit| hit.alpha).product::<f64>();
    let term = |(i, hit): (usize, &Hit)| (1.0 - hit.alpha) * product(&hits[..i]) * hit.own;
    (hits.iter().enumerate().map(term).sum(), product(hits))
}

/// Returns the sum and the throughput of the loop after these surfaces.
fn looped(hits: &[Hit]) -> (f64, f64) {
    hits.iter().fold((0.0, 1.0), |(sum, weight), hit| {
        let reflected = weight * hit.alpha;
        (sum + (weight - reflected) * hit.own, reflected)
    })
}

fn chains(seed: u64) -> impl Iterator<Item = Chain> {
    let mut sweep = Sweep::new(seed);
    (0..2000).map(move |_| Chain::random(&mut sweep))
}

#[test]
fn recursive_and_iterative_form_agree() {
    for chain in chains(1) {
        let near = chain.brightest * ROUNDED;
        for end in [0.0, chain.end] {
            let recursive = recursion(&chain.hits, end);
            for (sum, weight) in [formula(&chain.hits), looped(&chain.hits)] {
                let apart = (sum + weight * end - recursive).abs();
                assert!(apart <= near, "{apart:e} of {}", chain.brightest);
            }
        }
    }
}

#[test]
fn remainder_is_the_weight_times_the_colour_along_the_next_ray() {
    for Chain {
        hits,
        end,
        brightest,
    } in chains(2)
    {
        let all = recursion(&hits, end);
        for count in 0..=hits.len() {
            let (first, later) = hits.split_at(count);
            let (sum, weight) = looped(first);
            let apart = (sum + weight * recursion(later, end) - all).abs();
            assert!(apart <= brightest * ROUNDED, "{apart:e} after {count}");
        }
    }
}

#[test]
fn shares_and_the_weight_left_add_up_to_one() {
    for mut chain in chains(3) {
        chain.hits.iter_mut().for_each(|hit| hit.own = 1.0);
        let (sum, weight) = looped(&chain.hits);
        assert!((sum + weight - 1.0).abs() <= ROUNDED, "{sum} {weight}");
    }
}

#[test]
fn miss_is_a_last_surface_that_mirrors_nothing() {
    for Chain { mut hits, end, .. } in chains(4) {
        let missed = recursion(&hits, end);
        hits.push(Hit {
            alpha: 0.0,
            own: end,
        });
        assert_eq!(recursion(&hits, f64::MAX), missed);
    }
}

#[test]
fn nothing_is_added_after_a_weight_of_zero() {
    for Chain { mut hits, end, .. } in chains(5) {
        let last = hits.len() / 2;
        hits[last].alpha = 0.0;
        let (sum, weight) = looped(&hits[..=last]);
        assert_eq!(weight, 0.0);
        assert_eq!(looped(&hits), (sum, 0.0));
        assert_eq!(recursion(&hits, end), recursion(&hits[..=last], 0.0));
    }
}

#[test]
fn error_and_its_bound_fall_with_each_reflection() {
    for Chain {
        hits,
        end,
        brightest,
    } in chains(6)
    {
        let (all, near) = (recursion(&hits, end), brightest * ROUNDED);
        let (mut last_error, mut last_bound) = (all, brightest);
        for count in 1..=hits.len() {
            let (sum, weight) = looped(&hits[..count]);
            let (error, bound) = (all - sum, weight * brightest);
            assert!((-near..=bound + near).contains(&error), "{error} {bound}");
            assert!(error <= last_error + near, "{error} after {last_error}");
            if hits[count - 1].alpha < 1.0 && last_bound > 0.0 {
                assert!(bound < last_bound, "{bound} after {last_bound}")
            } else {
                assert_eq!(bound, last_bound)
            }
            (last_error, last_bound) = (error, bound);
        }
    }
}

#[test]
fn reflections_until_half_a_level_is_left_are_those_of_the_page() {
    let mut sweep = Sweep::new(7);
    for (largest, reflections) in [(0.5_f64, 8), (0.9, 59), (0.99, 620)] {
        let half = 1.0 / 510.0;
        assert!(largest.powi(reflections) > half && largest.powi(reflections + 1) <= half);
        for _ in 0..100 {
            let mut hit = || Hit {
                alpha: match sweep.within(0, reflections) {
                    0 => largest * share(&mut sweep),
                    _ => largest,
                },
                own: 1.0,
            };
            let hits: Vec<Hit> = (0..=reflections).map(|_| hit()).collect();
            let (sum, weight) = looped(&hits);
            let apart = recursion(&hits, 1.0) - sum;
            assert!(weight <= half && apart <= half + ROUNDED, "{apart}");
        }
    }
}

#[test]
fn weight_that_stays_above_zero_leaves_the_colour_open() {
    // α = 1 − 1/(i + 2)² takes light at every surface, and half of the light remains forever.
    let alpha = |i: u32| 1.0 - (f64::from(i) + 2.0).powi(-2);
    let mut weight = 1.0;
    for i in 0..10_000 {
        let exact = (f64::from(i) + 2.0) / (2.0 * (f64::from(i) + 1.0));
        assert!((weight - exact).abs() <= 1e-11, "{weight} {exact}");
        // With black surfaces, 0 is one colour along the rays that the recursion allows, and 1 / wᵢ
        // another.
        let (here, next) = (1.0 / weight, 1.0 / (weight * alpha(i)));
        assert!((here - alpha(i) * next).abs() <= 1e-12 && next <= 2.0);
        weight *= alpha(i);
    }
}

#[test]
fn loop_shows_black_between_perfect_mirrors_and_the_recursion_any_colour() {
    let hits = [Hit {
        alpha: 1.0,
        own: 0.75,
    }; 256];
    assert_eq!(looped(&hits), (0.0, 1.0));
    for end in [0.0, 0.25, 16.0] {
        assert_eq!(recursion(&hits, end), end);
    }
}
