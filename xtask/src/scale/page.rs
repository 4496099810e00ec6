//! `docs/scale.md`, from what was measured.

use super::{COUNTS, FEW, HEAD, MANY, Scale};
use crate::{measure::cores::Core, table::markdown};

/// The page.
pub(super) fn write(core: &Core, scale: &Scale) -> String {
    let rows = scale.members.iter().map(|member| member.cells().to_vec());
    let table = markdown(0, &HEAD.map(str::to_owned), &rows.collect::<Vec<_>>());
    let (title, size, verdict) = (core.title, &scale.size, scale.verdict());
    let (last, full) = (COUNTS[COUNTS.len() - 1], MANY / FEW);
    format!(
        "\
<!-- Written by `cargo xtask scale`. Do not edit: the next run writes over it. -->

# What more spheres take

Measured by `cargo xtask scale`, which renders scenes of 1 to {last} spheres at {size} with four
reflections, Blinn-Phong shading and quality `Fast` on an emulated {title} (QEMU), and counts every
executed instruction. It measures other cores and sizes, too: `cargo xtask scale --help`.

The scenes come from `xtask/benchmark`: beads of one size hang along a spiral over a mirroring floor,
with one light; every other is a mirror. The more beads, the smaller they are, so that they fill
the same share of the picture, and what grows is the number of shapes alone. Each is a constant
scene with room for its own number of spheres, the last one a `Scene<{last}, 1, 0, 1, 5>`.

{verdict} A
cost in proportion to the spheres would be {full} times.

{table}
- `instr/pixel`: executed instructions of the whole frame, from the frame call to the last pixel and
  with its preparation, over the number of pixels.
- `times`: the quotient to the row above.
- `shuffled`: instructions a pixel of the same picture where the scene lists its spheres in random
  order. Otherwise it lists them along the spiral, neighbours after each other.
- `prepare`: executed instructions of the preparation of the frame alone.
- `flash`: bytes of code and constants beyond the same firmware with an empty frame.
- `seen`: the share of the pixels that show a sphere.
"
    )
}
