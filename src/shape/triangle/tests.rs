mod borders;
mod mesh;
mod normals;

use super::*;
use crate::number::sweep::Sweep;
use crate::number::{Number, wide};
use crate::shape::fixture::*;
use crate::vector::Position;

/// Returns a flat triangle with corners in steps, `None` if it is too thin.
fn triangle(corners: [[i32; 3]; 3]) -> Option<PreparedTriangle> {
    prepared(corners, Normals(None))
}

fn prepared(corners: [[i32; 3]; 3], normals: Normals) -> Option<PreparedTriangle> {
    // One step is one scene unit.
    let grid = Grid::new(Position::ORIGIN, 1 << (28 + 64));
    let described = Triangle {
        corners: corners.into(),
        normals,
        material: MaterialId(7),
    };
    match described.fault() {
        None => PreparedTriangle::prepare(&described, &grid).ok(),
        Some(_) => None,
    }
}

const SIZE: i32 = 1 << 24;

/// Returns a right-angled triangle in the plane z = 0.
fn level() -> PreparedTriangle {
    triangle([[0; 3], [SIZE, 0, 0], [0, SIZE, 0]]).unwrap()
}

/// Returns the distance at which a ray hits a triangle. Does not test the ball around it.
fn intersect(triangle: &PreparedTriangle, ray: &Ray) -> Option<Length> {
    let range = Range {
        start: Length::from_bits(0),
        reach: EVERYWHERE,
    };
    triangle.met(&triangle.seen_from(ray.origin), &ray.direction, range)
}

fn corners_of(triangle: &PreparedTriangle) -> [Vector; 3] {
    let corner = triangle.corner.to_vector();
    let [one, other] = triangle.sides;
    [corner, corner.plus(one), corner.plus(other)]
}

/// Tests whether the line of a ray cuts a triangle, exactly.
fn is_cut(triangle: &PreparedTriangle, ray: &Ray) -> bool {
    let [a, b, c] = corners_of(triangle).map(|it| it.minus(ray.origin.to_vector()));
    let signs = [(a, b), (b, c), (c, a)].map(|(from, to)| {
        let [x, y, z] = from.cross_wide(to).map(i128::from);
        let Vector {
            x: dx,
            y: dy,
            z: dz,
        } = ray.direction.raw();
        (x * i128::from(dx) + y * i128::from(dy) + z * i128::from(dz)).signum()
    });
    signs.iter().all(|it| *it >= 0) || signs.iter().all(|it| *it <= 0)
}

/// Returns the distance at which the line of a ray cuts a triangle's plane, in double precision, and the steps along
/// the ray per step of height.
fn distance_of(triangle: &PreparedTriangle, ray: &Ray) -> (f64, f64) {
    let [one, other] = triangle.sides;
    let [x, y, z] = one.cross_wide(other).map(|it| it as f64);
    let normal = unit([x, y, z]);
    let climb = dot(unit(in_doubles(ray.direction.raw())), normal);
    let height = dot(in_doubles(ray.origin.to(triangle.corner)), normal);
    (height / climb, 1.0 / climb.abs())
}

/// Returns random triangles from needles to equilateral ones, each with a ray that is aimed at it or beside it.
fn pairs(seed: u64, count: u32) -> impl Iterator<Item = (PreparedTriangle, Ray)> {
    let mut sweep = Sweep::new(seed);
    (0..count).filter_map(move |number| {
        let center = sweep.triple(1 << 26);
        let size = sweep.octaves(8, 26);
        let near = |sweep: &mut Sweep, size: i32| {
            let by = sweep.triple(size);
            [0, 1, 2].map(|axis| center[axis] + by[axis])
        };
        let one = near(&mut sweep, size);
        let two = near(&mut sweep, size);
        let three = match number % 3 {
            // Near to the second corner: a needle.
            0 => {
                let by = sweep.triple((size >> 13).max(100));
                [0, 1, 2].map(|axis| two[axis] + by[axis])
            }
            _ => near(&mut sweep, size),
        };
        let triangle = triangle([one, two, three])?;
        let weights = [sweep.within(0, 1000), sweep.within(0, 1000), 300];
        let sum: i32 = weights.iter().sum();
        let inside = [0, 1, 2].map(|axis| {
            let corners = [one[axis], two[axis], three[axis]];
            let sum_of = corners
                .iter()
                .zip(weights)
                .map(|(at, by)| i64::from(*at) * i64::from(by));
            (sum_of.sum::<i64>() / i64::from(sum)) as i32
        });
        let aim = if number % 2 == 0 { 4 } else { size };
        Some((triangle, ray_towards(&mut sweep, inside, aim)))
    })
}

#[test]
fn triangle_is_met_where_its_line_cuts_it() {
    let (mut hits, mut misses, mut grazed) = (0, 0, 0);
    for (triangle, ray) in pairs(1, 120_000) {
        let (distance, stretch) = distance_of(&triangle, &ray);
        let slack = SLACK + (3.0 + distance.abs() / 2f64.powi(28)) * stretch;
        let found = steps(intersect(&triangle, &ray)).map(f64::from);
        if distance.abs() > slack {
            let is_hit = is_cut(&triangle, &ray) && distance > 0.0;
            assert_eq!(found.is_some(), is_hit, "{triangle:?} {ray:?}");
        }
        let Some(found) = found else {
            misses += 1;
            continue;
        };
        hits += 1;
        grazed += u32::from(stretch > 20.0);
        let off = found - distance;
        assert!(off.abs() <= slack, "{off}: {triangle:?} {ray:?}");
    }
    assert!(
        hits > 30_000 && misses > 30_000 && grazed > 300,
        "{hits} {misses} {grazed}"
    );
}

#[test]
fn triangle_that_is_met_is_left_out_by_nothing() {
    let mut sweep = Sweep::new(4);
    let mut hits = 0;
    for (triangle, ray) in pairs(2, 60_000) {
        let found = intersect(&triangle, &ray);
        let start = Length::from_bits(0);
        let range = |reach| Range { start, reach };
        assert_eq!(
            triangle.intersect(&ray, range(EVERYWHERE)),
            found,
            "{triangle:?} {ray:?}"
        );
        let from = triangle.seen_from_eye(ray.origin);
        let seen = triangle.intersect_from(&from, &ray.direction, range(EVERYWHERE));
        assert_eq!(seen, found);
        hits += u32::from(found.is_some());
        // A hit is found if it lies well before the end of the range, and has the same distance.
        let reach = Length::from_bits(sweep.within(1, 1 << 30));
        let before = triangle.intersect(&ray, range(reach));
        match found.filter(|it| it.to_bits() < reach.to_bits() - crate::shape::bounded::SURE) {
            Some(found) => assert_eq!(before, Some(found)),
            None => assert!(before.is_none() || before == found),
        }
        assert_eq!(triangle.blocks(&ray, reach), before.is_some());
    }
    assert!(hits > 15_000, "{hits}");
}

#[test]
fn every_corner_lies_in_the_ball() {
    for (triangle, _) in pairs(3, 20_000) {
        let (center, radius) = triangle.ball();
        for corner in corners_of(&triangle) {
            let away = length(in_doubles(corner.minus(center.to_vector())));
            assert!(away <= f64::from(radius), "{away}: {triangle:?}");
        }
    }
}

#[test]
fn triangle_is_met_from_both_sides_and_not_from_behind() {
    let triangle = level();
    for (z, towards, is_met) in [(1, -1, true), (-1, 1, true), (1, 1, false), (-1, -1, false)] {
        let ray = ray([SIZE / 4, SIZE / 4, z * SIZE], [0, 0, towards]);
        let found = steps(intersect(&triangle, &ray));
        assert_eq!(found.is_some(), is_met, "{z} {towards}");
        assert!(found.is_none_or(|it| (it - SIZE).abs() <= 1));
    }
}

#[test]
fn ray_along_a_triangle_misses_it() {
    for height in [-1, 1] {
        let ray = ray([-SIZE, SIZE / 4, height], [1, 0, 0]);
        assert_eq!(intersect(&level(), &ray), None, "{height}");
    }
}

#[test]
fn needle_of_one_to_ten_thousand_is_met() {
    let long = 1 << 27;
    let needle = triangle([[-long, 0, 0], [long, 0, 0], [long, long / 5000, 0]]).unwrap();
    let mut met = 0;
    for x in 1..1000 {
        let at = -long + (i64::from(x) * i64::from(long) / 500) as i32;
        let middle = (wide(at + long, long / 10_000) / i64::from(2 * long)) as i32;
        met += u32::from(intersect(&needle, &ray([at, middle, SIZE], [0, 0, -1])).is_some());
        assert_eq!(intersect(&needle, &ray([at, -2, SIZE], [0, 0, -1])), None);
    }
    assert_eq!(met, 999);
}

#[test]
fn faults_name_what_is_wrong() {
    let fault = |corners: [[f64; 3]; 3], normals| {
        Triangle {
            corners: Corners::new(corners),
            normals: Normals::new(normals),
            material: MaterialId(0),
        }
        .fault()
    };
    let [a, b, c] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let up = [0.0, 0.0, 1.0];
    assert_eq!(fault([a, b, c], None), None);
    assert_eq!(fault([a, b, c], Some([up, up, b])), None);
    assert_eq!(
        fault([a, b, c], Some([up, [0.0; 3], up])),
        Some(ErrorKind::Normal)
    );
    assert_eq!(
        fault([a, b, c], Some([up, [f64::NAN; 3], up])),
        Some(ErrorKind::Coordinate)
    );
    for wrong in [f64::NAN, f64::INFINITY, 1.1e9, -1e300] {
        assert_eq!(
            fault([a, b, [wrong, 1.0, 0.0]], None),
            Some(ErrorKind::Coordinate),
            "{wrong}"
        );
    }
    for (corners, is_thin) in [
        ([a, a, b], true),
        ([a, a, a], true),
        ([a, b, [2.0, 0.0, 0.0]], true),
        ([[0.1, 0.2, 0.3], [0.2, 0.4, 0.6], [0.3, 0.6, 0.9]], true),
        ([a, b, [0.5, 0.9 / 1_048_576.0, 0.0]], true),
        ([a, b, [0.5, 1.1 / 1_048_576.0, 0.0]], false),
        ([a, [1e9, 0.0, 0.0], [0.0, 1e9, 0.0]], false),
        ([a, [1e-9, 0.0, 0.0], [0.0, 1e-9, 0.0]], false),
        ([a, [1e9, 0.0, 0.0], [5e8, 1e5, 0.0]], false),
    ] {
        let expected = is_thin.then_some(ErrorKind::Corners);
        assert_eq!(fault(corners, None), expected, "{corners:?}");
    }
}

#[test]
fn triangle_with_an_altitude_below_64_steps_is_tiny() {
    let grid = Grid::new(Position::ORIGIN, 1 << (28 + 64));
    for (height, is_laid) in [(62, false), (64, true)] {
        let described = Triangle {
            corners: [[0, 0, 0], [1 << 20, 0, 0], [1 << 19, height, 0]].into(),
            normals: Normals(None),
            material: MaterialId(0),
        };
        assert_eq!(described.fault(), None);
        let laid = PreparedTriangle::prepare(&described, &grid);
        assert_eq!(
            laid.err(),
            (!is_laid).then_some(ErrorKind::Tiny),
            "{height}"
        );
        let smallest = described.extent().smallest;
        assert!(
            (smallest.to_f64() - f64::from(height)).abs() < 0.1,
            "{smallest:?}"
        );
        assert!(described.extent().radius < Number::from(1 << 20));
    }
}
