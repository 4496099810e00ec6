//! What can be measured: a renderer with its scene and its settings.

use core::hint::black_box;
use core::marker::PhantomData;

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb888;
use reflet::__private::{Apart, Everything as Whole};
use reflet::needs::{Limited, MostReflections};
use reflet::quality::Quality;
use reflet::shading::Shading;
use reflet::{Camera, PreparedFrame};

use crate::{Clock, report};

/// A renderer, ready to be measured. What a program may learn only while it runs (camera, size,
/// reflections) is hidden from the optimiser, for all contestants alike.
pub trait Contestant {
    type Scene;
    /// Type of a frame that is prepared for one size of picture.
    type Picture;

    /// Makes the scene, once a program. Its instructions are not counted.
    fn scene() -> Self::Scene;

    /// Moves a part of the scene and returns the instructions that it took; `None` if nothing moves.
    fn moved(_: &Clock, _: &mut Self::Scene) -> Option<u32> {
        None
    }

    /// Prepares a frame of the scene for one size of picture.
    fn prepare(scene: &Self::Scene, size: (u32, u32)) -> Self::Picture;

    /// Renders row `y` of the picture into `row`.
    fn row(seen: (&Self::Scene, &Self::Picture), y: u32, row: &mut [Rgb888]);
}

/// View of a scene of the library: its camera.
pub trait View {
    const CAMERA: Camera;
}

/// Writes the two functions of a [`Contestant`] whose instructions are counted, for a scene that the library draws.
macro_rules! counted {
    () => {
        #[inline(never)]
        fn prepare(scene: &Self::Scene, (width, height): (u32, u32)) -> Self::Picture {
            scene
                .frame(black_box(&V::CAMERA))
                .reflections(N)
                .quality::<Q>()
                .shading::<K>()
                .prepare(Size::new(width, height))
        }

        #[inline(never)]
        fn row((scene, frame): (&Self::Scene, &Self::Picture), y: u32, row: &mut [Rgb888]) {
            match frame.on(scene) {
                Ok(rows) => rows.next_row(crate::seam(), y, 0, row),
                Err(_) => report::stop("the frame"),
            };
        }
    };
}

pub(crate) use counted;

/// Renders scene `S` with the library: view `V`, quality `Q`, shading `K`, at most `N` reflections.
pub struct Fixed<S, V, Q, K, const N: u8>(PhantomData<(S, V, Q, K)>);

/// A constant scene, of which mirrors are linked for at most `N` reflections.
type Once<S, const N: u8> = Limited<'static, S, MostReflections<N>>;

impl<S: Apart, V: View, Q: Quality, K: Shading, const N: u8> Contestant for Fixed<S, V, Q, K, N> {
    type Scene = Once<S, N>;
    type Picture = PreparedFrame<Once<S, N>, Q, K>;

    fn scene() -> Self::Scene {
        Limited::new(S::INSTANCE).unwrap_or_else(|_| report::stop("the limit"))
    }

    counted!();
}

/// Renders scene `S` with the library, and links all code that any scene needs.
pub struct Everything<S, V, Q, K, const N: u8>(PhantomData<(S, V, Q, K)>);

impl<S: Apart, V: View, Q: Quality, K: Shading, const N: u8> Contestant
    for Everything<S, V, Q, K, N>
{
    type Scene = Whole<'static, S>;
    type Picture = PreparedFrame<Whole<'static, S>, Q, K>;

    fn scene() -> Self::Scene {
        Whole::of(S::INSTANCE)
    }

    counted!();
}

/// Scene, camera and settings that the float port renders.
pub trait FloatView {
    const SCENE: float_port::Scene<'static>;
    const CAMERA: float_port::Camera;
    const REFLECTIONS: u32;
    const SHADING: float_port::Shading;
}

/// The float port, with view `V`; its scene and shading are constants, as the library's are.
pub struct Float<V>(PhantomData<V>);

impl<V: FloatView> Contestant for Float<V> {
    type Scene = ();
    type Picture = float_port::View;

    fn scene() {}

    #[inline(never)]
    fn prepare(_: &(), size: (u32, u32)) -> Self::Picture {
        float_port::View::new(black_box(&V::CAMERA), size)
    }

    #[inline(never)]
    fn row((_, view): (&(), &Self::Picture), y: u32, row: &mut [Rgb888]) {
        let reflections = black_box(V::REFLECTIONS);
        for (x, pixel) in (0..).zip(row) {
            let [red, green, blue] =
                float_port::pixel(&V::SCENE, V::SHADING, &view.ray(x, y), reflections);
            *pixel = Rgb888::new(red, green, blue);
        }
    }
}

/// A renderer that draws nothing: its firmware is what other firmware is compared with.
pub struct Nothing;

impl Contestant for Nothing {
    type Scene = ();
    type Picture = ();

    fn scene() {}

    #[inline(never)]
    fn prepare(_: &(), _: (u32, u32)) {}

    #[inline(never)]
    fn row(_: (&(), &()), _: u32, _: &mut [Rgb888]) {}
}
