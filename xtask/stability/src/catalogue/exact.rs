//! Follows a ray among mirroring spheres in any precision, with textbook formulas. The growth of
//! errors is measured with it; its quadruple precision is the reference.

use num_traits::Float;
use reflet::host::reference::Vector;

/// Converts a double to the number type in which a ray is followed: `f32`, `f64`, or quadruple
/// precision, the sum of two doubles.
fn of<R: Float>(value: f64) -> R {
    R::from(value).expect("every float has a value near a double")
}

type Triple<R> = [R; 3];

fn dot<R: Float>(a: Triple<R>, b: Triple<R>) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn along<R: Float>(start: Triple<R>, way: Triple<R>, length: R) -> Triple<R> {
    [0, 1, 2].map(|axis| start[axis] + way[axis] * length)
}

/// A sphere: its centre and its radius.
pub type Ball = ([f64; 3], f64);

/// One reflection of a ray off a sphere.
#[derive(Clone, Copy, Debug)]
pub struct Bounce {
    /// Start of the mirrored ray, epsilon above the sphere.
    pub origin: [f64; 3],
    /// Length of the ray before this reflection.
    pub flight: f64,
    /// Cosine of the angle between ray and normal; positive.
    pub cosine: f64,
    /// Radius of the sphere.
    pub radius: f64,
}

/// Follows a ray that stays outside of the spheres, which are all mirrors, for at most `most`
/// reflections.
pub fn bounces<R: Float>(
    balls: &[Ball],
    origin: [f64; 3],
    direction: [f64; 3],
    epsilon: f64,
    most: usize,
) -> Vec<Bounce> {
    let double = |value: R| value.to_f64().expect("every float has a double near it");
    let mut origin = origin.map(of::<R>);
    let direction = direction.map(of::<R>);
    let length = dot(direction, direction).sqrt();
    let mut direction = direction.map(|it| it / length);
    let mut found = Vec::new();
    while found.len() < most {
        let met = balls.iter().filter_map(|&(center, radius)| {
            let to_center = [0, 1, 2].map(|axis| of::<R>(center[axis]) - origin[axis]);
            let middle = dot(to_center, direction);
            let aside = along(to_center, direction, R::zero() - middle);
            let half_square = of::<R>(radius) * of::<R>(radius) - dot(aside, aside);
            let is_ahead = half_square > R::zero() && middle > R::zero();
            is_ahead.then(|| (middle - half_square.sqrt(), center, radius))
        });
        let met = met.filter(|(distance, ..)| *distance > R::zero());
        let Some((distance, center, radius)) =
            met.min_by(|a, b| a.0.partial_cmp(&b.0).expect("distances are numbers"))
        else {
            break;
        };
        let at = along(origin, direction, distance);
        let normal = [0, 1, 2].map(|axis| (at[axis] - of::<R>(center[axis])) / of::<R>(radius));
        let climb = dot(direction, normal);
        direction = along(direction, normal, of::<R>(-2.0) * climb);
        origin = along(at, normal, of::<R>(epsilon));
        found.push(Bounce {
            origin: origin.map(double),
            flight: double(distance),
            cosine: -double(climb),
            radius,
        });
    }
    found
}

/// Returns, for each bounce, the factor by which an error has grown from the start. The theory is
/// that of dispersing billiards: a front of curvature κ that flies the distance L then has κ / (1 +
/// L κ). A mirror of radius r at the cosine c adds 2 / (r c). The flight makes an error 1 + L κ
/// times as large (Chernov, Markarian, "Chaotic Billiards", AMS 2006, section 3.8). The front starts
/// at a point, like the rays of a camera.
pub fn growth(bounces: &[Bounce]) -> Vec<f64> {
    let mut factor = 1.0;
    let mut curvature = None;
    let step = |bounce: &Bounce| {
        let spread = match curvature {
            None => 1.0 / bounce.flight,
            Some(before) => {
                factor *= 1.0 + bounce.flight * before;
                before / (1.0 + bounce.flight * before)
            }
        };
        curvature = Some(spread + 2.0 / (bounce.radius * bounce.cosine));
        factor
    };
    bounces.iter().map(step).collect()
}

/// Returns the distance between two points.
pub fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    (Vector(a) - Vector(b)).length()
}
