//! Goes through the settings of the job.
#![no_std]
#![no_main]

firmware::program!(|row| firmware::sweep(job::TICKET, job::RUNS, row));
