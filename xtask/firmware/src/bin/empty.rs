//! Draws nothing, as often as the other program draws the job's scene.
#![no_std]
#![no_main]

firmware::program!(|row| firmware::measure::<firmware::Nothing>(job::TICKET, row));
