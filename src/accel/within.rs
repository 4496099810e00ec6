//! Scenes for which less code is linked than their type allows ([`Limited`]), or all code ([`Everything`]).

use core::marker::PhantomData;

use super::any_scene::AnyScene;
use super::{Tables, World};
use crate::error::Error;
use crate::scene::access::{SceneAccess, if_needed};
use crate::scene::{Needs, NeedsLimit, Parts};

/// A scene that was checked to need no more than the limit `L`. The code that `L` leaves out is not
/// linked.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
/// use reflet::needs::{Limited, Needs, NeedsLimit};
/// use reflet::{Camera, Material, RuntimeScene, room};
///
/// struct Matte;
/// impl NeedsLimit for Matte {
///     const NEEDS: Needs = Needs::ALL.without_mirrors();
/// }
/// const CAMERA: Camera = Camera::look_at([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
///
/// let mut scene = RuntimeScene::<room!(spheres: 1)>::new();
/// let chalk = scene.add_material(Material::new([0.9; 3]))?;
/// scene.add_sphere([0, 0, 0], 1, chalk)?;
/// let scene = scene.build()?;
/// let mut display = MockDisplay::<Rgb888>::new();
/// Limited::<_, Matte>::new(&scene)?.frame(&CAMERA).draw(&mut display).unwrap();
///
/// let mut scene = RuntimeScene::<room!(spheres: 1)>::new();
/// let glass = scene.add_material(Material::new([0.9; 3]).mirror(0.5))?;
/// scene.add_sphere([0, 0, 0], 1, glass)?;
/// let error = Limited::<_, Matte>::new(&scene.build()?).err().unwrap();
/// assert_eq!(error.part(), "mirrors");
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Debug)]
pub struct Limited<'a, S, L> {
    scene: &'a S,
    limit: PhantomData<fn() -> L>,
}

impl<'a, S: AnyScene, L: NeedsLimit> Limited<'a, S, L> {
    /// Whether no scene of this type needs more than the limit: then none is looked at.
    const ALWAYS_FITS: bool = S::World::<'a>::NEEDS.within(&L::NEEDS).is_ok();

    /// Checks that a scene needs no more than the limit `L`, and limits it.
    ///
    /// # Errors
    /// [`ErrorKind::Limit`](crate::ErrorKind::Limit) if the scene needs more; the error's part is the
    /// name of the first need that the limit leaves out.
    pub fn new(scene: &'a S) -> Result<Self, Error> {
        if !Self::ALWAYS_FITS {
            scene.world().parts().needs().within(&L::NEEDS)?;
        }
        Ok(Self {
            scene,
            limit: PhantomData,
        })
    }

    /// Returns the scene that is limited, as it is without its limit of needs.
    pub(super) fn scene(&self) -> &'a S {
        self.scene
    }
}

/// A scene as the kernels read it, with no more needs than the limit `B` allows, or with all of them if `B` says so.
pub struct Within<W, B> {
    world: W,
    bound: PhantomData<B>,
}

impl<W, B> Within<W, B> {
    /// Limits a scene without a check. The caller has checked that the scene needs no more than `B`.
    pub(crate) const fn new(world: W) -> Self {
        Self {
            world,
            bound: PhantomData,
        }
    }
}

impl<W: Clone, B> Clone for Within<W, B> {
    fn clone(&self) -> Self {
        Self::new(self.world.clone())
    }
}

impl<W: Copy, B> Copy for Within<W, B> {}

impl<W: SceneAccess, B: NeedsLimit> SceneAccess for Within<W, B> {
    const NEEDS: Needs = if B::IS_LINKED_WHOLE { B::NEEDS } else { W::NEEDS.both(&B::NEEDS) };
    const HAS_BLANK: bool = W::HAS_BLANK || B::IS_LINKED_WHOLE;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        self.world.parts().within(&B::NEEDS)
    }
}

/// A scene for which all code of the library is linked. Measurements use it to show what needs save.
pub type Everything<'a, S> = Limited<'a, S, EveryNeed>;

/// The limit of [`Everything`]: the scene has every need, so all code is linked.
#[derive(Debug)]
pub struct EveryNeed;

impl NeedsLimit for EveryNeed {
    const NEEDS: Needs = Needs::ALL;
    const IS_LINKED_WHOLE: bool = true;
}

impl<'a, S> Everything<'a, S> {
    /// Links all code for a scene.
    pub const fn of(scene: &'a S) -> Self {
        let limit = PhantomData;
        Self { scene, limit }
    }
}

impl<W: World, B: NeedsLimit> World for Within<W, B> {
    type Room = W::Room;
    const IS_CROWD: bool = W::IS_CROWD;

    #[inline(always)]
    fn tables(&self) -> Tables<'_, W::Room> {
        let tables = self.world.tables();
        Tables {
            light_occluders: if_needed(B::NEEDS.lights, tables.light_occluders),
            ..tables
        }
    }
}
