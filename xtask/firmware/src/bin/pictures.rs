//! Draws the job's scenes, one after the other.
#![no_std]
#![no_main]

firmware::program!(|row| firmware::pictures(&job::ORDER, job::PICTURES, row));
