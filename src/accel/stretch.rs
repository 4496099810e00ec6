//! Whether all rays of a stretch, the pixels between two traced ones, hit what its ends hit.
//!
//! The rays of a stretch start at one eye, the camera or its image in a plane, and lie in one plane. Both
//! ends hit the same side of the same shape. Bound: docs/internals/edges.md proves the rules below.

use super::active_list::{ActiveList, ActiveShape, Storage};
use super::active_lists::{ActiveLists, ActiveRoom, Tested};
use crate::number::{Length, root_of_square};
use crate::ray::{ANY_COLUMN, Span};
use crate::scene::access::{SceneAccess, ShapeId};
use crate::scene::shape_set::ShapeKind;
use crate::shape::bordered::{Ball, Bordered};
use crate::shape::plane::PreparedPlane;
use crate::vector::{Direction, Point, Vector};

/// The pixels between two traced ones, and the surface that both ends hit.
pub(crate) struct Stretch<'a> {
    /// Columns of the two ends.
    pub(crate) columns: [u32; 2],
    /// The shape that both ends hit; [`ShapeId::NONE`] if they hit nothing.
    pub(crate) shape: ShapeId,
    /// What bounds the shape.
    pub(crate) body: Body<'a>,
    /// Where all points that the stretch can show lie. `None` if they are not near, or if nothing is hit.
    pub(crate) chord: Option<Chord>,
    /// The eye: the camera, or its image in the plane that mirrored the rays.
    pub(crate) eye: Point,
    /// The plane that mirrored the rays.
    pub(crate) mirror: Option<&'a PreparedPlane>,
}

impl Stretch<'_> {
    /// Tests whether no plane comes in front of a shape between the ends of a stretch that shows its inside. An inside
    /// bulges away from the eye: a plane behind the points at both ends may still be in front of one between them.
    #[inline(never)]
    pub(super) fn is_before(&self, planes: &[PreparedPlane]) -> bool {
        let Some(chord) = self.chord.as_ref().filter(|chord| chord.is_hollow) else {
            return true;
        };
        let height = |plane: &PreparedPlane, end| (plane.height(end) >> 30).unsigned_abs();
        let reach = u64::from(chord.bulge.unsigned_abs());
        let mut planes = planes.iter();
        planes.all(|plane| chord.ends.iter().all(|end| height(plane, *end) > reach))
    }
}

/// The straight line between the points that a stretch shows at its two ends. The points between lie close to it.
pub(crate) struct Chord {
    /// Ball around all points.
    pub(crate) ball: Ball,
    pub(crate) ends: [Point; 2],
    /// Upper bound of the distance of a point from the line, in steps.
    pub(crate) bulge: i32,
    /// What rounding and epsilon may add to the distance from the eye, in steps.
    pub(crate) slack: i32,
    /// Whether a curved shape is hit from inside.
    pub(crate) is_hollow: bool,
}

impl Chord {
    /// Returns an upper bound of the distance from the eye to the points, in steps. The curve is not further from the eye
    /// than its chord.
    fn reach(&self, eye: Point) -> i32 {
        let [one, other] = self.ends.map(|end| root_of_square(eye.to(end).square()));
        one.max(other) + self.slack
    }

    /// Tests whether a ball surely holds no point of the chord.
    pub(crate) fn misses(&self, (center, radius): Ball) -> bool {
        is_apart(self.ends, center, radius + self.bulge)
    }
}

/// Tests whether a point lies further than `reach` steps from the segment between two others.
fn is_apart([first, last]: [Point; 2], point: Point, reach: i32) -> bool {
    is_off(first.to(last).normalised(), first.to(point), reach)
}

/// Tests whether a point lies further than `reach` steps from a segment, given by its direction and its length. `way` leads
/// from the segment's start to the point.
pub(super) fn is_off((direction, length): (Direction, Length), way: Vector, reach: i32) -> bool {
    let along = way.dot(direction).max(0).min(length.to_bits());
    let reach = u64::from(reach.unsigned_abs());
    way.without(direction, along).square() > reach * reach
}

/// What bounds a shape: the set of points that a shape of its kind cannot leave.
pub(crate) enum Body<'a> {
    /// Nothing is hit.
    None,
    /// A bounded shape lies in a ball.
    Ball(Ball),
    /// A plane.
    Plane(&'a PreparedPlane),
}

impl Body<'_> {
    /// Tests whether a ball surely does not meet the body.
    fn is_apart_from<W: SceneAccess>(&self, (center, radius): Ball) -> bool {
        match self {
            Body::None => true,
            Body::Ball((own, size)) => {
                let reach = u64::from((radius + size).unsigned_abs());
                own.to(center).square() > reach * reach
            }
            // A scene without planes links no code for them.
            Body::Plane(plane) => {
                W::NEEDS.planes && {
                    (plane.height(center) >> 30).unsigned_abs() > u64::from(radius.unsigned_abs())
                }
            }
        }
    }
}

/// How a shape lies to the rays of a stretch.
enum Meeting {
    /// No ray between the ends hits the shape's solid.
    Never,
    /// Every ray cuts the solid, in the same part of its surface.
    Always,
    /// A border or a rim of the solid lies between the ends, or may do so.
    Changes,
}

/// Returns how a shape with this span lies to the rays between two columns.
#[inline(always)]
fn meeting<T: AsRef<[u16]>>(span: &Span<T>, [start, end]: [u32; 2]) -> Meeting {
    let (first, last) = (u32::from(span.first), u32::from(span.last));
    if end <= first || last <= start {
        Meeting::Never
    } else if span.is_sure
        && first <= start
        && end <= last
        // The ray of at least one end surely cuts the shape.
        && (first < start || end < last)
        && !has_rim(span, [start, end])
    {
        Meeting::Always
    } else {
        Meeting::Changes
    }
}

/// Tests whether a rim of a shape lies between two columns.
#[inline(always)]
fn has_rim<T: AsRef<[u16]>>(span: &Span<T>, [start, end]: [u32; 2]) -> bool {
    span.rims.as_ref().iter().any(|&rim| {
        let column = u32::from(rim);
        rim == ANY_COLUMN || column < end && start < column + 2
    })
}

macro_rules! keep {
    (
        $header:tt
        $({ $list:ident $($more:tt)* })*
    ) => {
        impl<R: ActiveRoom> ActiveLists<'_, R> {
            /// Tests whether all rays of a stretch surely hit the shape that both ends hit. If another shape may
            /// come to the front, returns the last column before it begins, or its last one, if it lies between.
            #[inline(never)]
            pub(super) fn keep<W: SceneAccess>(
                &self,
                world: &W,
                stretch: &Stretch<'_>,
            ) -> Result<(), Option<u32>> {
                if self.tested == Tested::All {
                    return Err(None);
                }
                let [$($list),*] = world.parts().kinds();
                $(
                    if W::NEEDS.$list {
                        self.$list.keeps::<W>($list, stretch)?;
                    }
                )*
                Ok(())
            }

            /// Returns the first and the last column in which rays can hit a shape. `None` if it is not active.
            #[inline(never)]
            fn columns_of<W: SceneAccess>(&self, world: &W, shape: ShapeId) -> Option<[u32; 2]> {
                let [$($list),*] = world.parts().kinds();
                $(
                    if W::NEEDS.$list {
                        if let Some(columns) = self.$list.columns_of($list, shape) {
                            return Some(columns);
                        }
                    }
                )*
                None
            }
        }
    };
}
kinds!(keep);

impl<R: ActiveRoom> ActiveLists<'_, R> {
    /// Returns the last column before a border between two columns, of which one shows the first shape and the other
    /// the second. The second shape begins there, or else the first one ends. `None` if neither does.
    pub(super) fn border<W: SceneAccess>(
        &self,
        world: &W,
        [start, end]: [u32; 2],
        [one, other]: [ShapeId; 2],
    ) -> Option<u32> {
        let begins = self.columns_of(world, other);
        let begins = begins.and_then(|[first, _]| first.checked_sub(1));
        let is_between = |column: &u32| start <= *column && *column < end;
        begins.filter(is_between).or_else(|| {
            let ends = self.columns_of(world, one);
            ends.map(|[_, last]| last).filter(is_between)
        })
    }
}

impl<'a, K: Bordered, V: Storage<ActiveShape<'a, K>>> ActiveList<'a, K, V> {
    /// Returns the first and the last column in which rays can hit a shape. `None` if it is not active, or of another
    /// kind.
    fn columns_of(&self, kind: ShapeKind, shape: ShapeId) -> Option<[u32; 2]> {
        let mut active = self.active.as_ref().iter();
        let found = active.find(|it| kind.id(it.index.into()) == shape)?;
        Some([found.span.first.into(), found.span.last.into()])
    }

    /// Tests whether no shape of this kind comes to the front in a stretch. If one may, returns one of its borders, as
    /// [`ActiveLists::keep`] does.
    #[inline(always)]
    fn keeps<W: SceneAccess>(
        &self,
        kind: ShapeKind,
        stretch: &Stretch<'_>,
    ) -> Result<(), Option<u32>> {
        let id = |it: &ActiveShape<'_, K>| kind.id(it.index.into());
        let mut active = self.active.as_ref().iter();
        match active.find(|it| !it.is_kept::<W>(id(it), stretch)) {
            None => Ok(()),
            Some(it) => Err(it.border(stretch.columns)),
        }
    }
}

impl<K: Bordered> ActiveShape<'_, K> {
    /// Tests whether the shape `id` surely does not come to the front in a stretch, or is the one that it shows.
    #[inline(always)]
    fn is_kept<W: SceneAccess>(&self, id: ShapeId, stretch: &Stretch<'_>) -> bool {
        let ([start, end], [left, right]) = (stretch.columns, self.columns.map(u32::from));
        if end < left || right < start {
            return true;
        }
        match meeting(&self.span, stretch.columns) {
            Meeting::Never => true,
            // The two ends hit a convex body, so all rays between do.
            _ if id == stretch.shape => !has_rim(&self.span, stretch.columns),
            Meeting::Always => self.never_crosses::<W>(stretch),
            Meeting::Changes => {
                self.begins_behind::<W>(stretch) && self.never_crosses::<W>(stretch)
            }
        }
    }

    /// Returns the last column before the shape begins, or else its last one, if it lies between two columns.
    fn border(&self, [start, end]: [u32; 2]) -> Option<u32> {
        let [first, last] = [self.span.first, self.span.last].map(u32::from);
        let is_between = |column: &u32| (start..end).contains(column);
        let before = first.checked_sub(1).filter(is_between);
        before.or(Some(last).filter(is_between))
    }

    /// Tests whether the shape surely crosses no point that the stretch shows.
    fn never_crosses<W: SceneAccess>(&self, stretch: &Stretch<'_>) -> bool {
        stretch.chord.as_ref().is_none_or(|chord| {
            self.shape.is_apart_from(chord.ball)
                || stretch.body.is_apart_from::<W>(self.shape.bounding_ball())
                || chord.misses(self.shape.bounding_ball())
        })
    }

    /// Tests whether the shape begins and ends behind the surface that the stretch shows.
    fn begins_behind<W: SceneAccess>(&self, stretch: &Stretch<'_>) -> bool {
        let Some(chord) = stretch.chord.as_ref().filter(|chord| !chord.is_hollow) else {
            return false;
        };
        // An end that cuts a closed shape shows that the shape is behind there.
        let (first, last) = (u32::from(self.span.first), u32::from(self.span.last));
        let is_seen = (K::IS_BALL || K::IS_FLAT)
            && self.span.is_sure
            && stretch.columns.iter().any(|&end| first < end && end < last)
            && stretch.mirror.is_none_or(|mirror| {
                Body::Plane(mirror).is_apart_from::<W>(self.shape.bounding_ball())
            });
        is_seen || self.shape.outline_distance(&self.from) > chord.reach(stretch.eye)
    }
}
