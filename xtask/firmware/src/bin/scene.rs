//! Draws the job's scene.
#![no_std]
#![no_main]

firmware::program!(|row| firmware::measure::<job::Job>(job::TICKET, row));
