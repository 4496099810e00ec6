//! The command line of `cargo xtask profile`.

use clap::Args;

use crate::measure::arguments::Choice;

/// Counts the instructions that a frame takes, by stage and by function.
#[derive(Args, Debug)]
#[command(after_long_help = AFTER_HELP)]
pub struct Arguments {
    #[command(flatten)]
    pub(super) choice: Choice,

    /// Print the hottest functions, too
    #[arg(long)]
    pub(super) functions: bool,

    /// How many rows each table of functions has at most
    #[arg(long, value_name = "N", default_value_t = 40, requires = "functions")]
    pub(super) top: usize,

    /// Print lines of JSON instead of tables
    #[arg(long)]
    pub(super) json: bool,
}

const AFTER_HELP: &str = "\
Every executed instruction is counted, of the preparation and of every row, with all they call; so
the stages add up to the total exactly. `cargo xtask measure` counts up to a few dozen more for the
preparation and for each row, by which the firmware calls them.

  preparation  once a frame
  spans        what the rays of a row can meet, without and with a mirror before
  primary      the ray of a pixel, and what it meets first
  shading      normals, cosines, highlights and colours
  shadow       whether a light is blocked, and the choice of what may block it
  reflection   the mirrored rays, and what they meet
  output       from the sum of a path to the pixel
  other        the loop over the reflections, and what no rule names

A function belongs to the stage that xtask/src/profile/stages.rs gives it, or else to that of its
caller, inlined or not. What a ray meets is found by the same functions for all rays: it is counted
as reflection from a pixel's first mirrored ray on, and as primary before.

--functions prints four tables. The first has the library's functions, their own instructions with
those of foreign functions in them (integers, iterators, the compiler's multiplications), and in
all/pixel those of all that they call, as far as they are of the same stage. The second has the
functions at the bottom of all inlining, foreign ones too, the third the lines of the library. The
fourth has functions as they are linked, and how often they are called.

Ten million instructions take up to a minute, and a run may take ten: --size 16x16 is quicker, but
spans and preparation weigh more in a small picture. --core rv32 and --quality float are refused.

The JSON keys are stage, instructions, instructions_per_pixel and share, a line for each stage and
one for the `total`. With --functions the rows of the tables follow, with table (library, innermost,
line or linked) and name, and where they apply stage, all_per_pixel and calls_per_pixel.";
