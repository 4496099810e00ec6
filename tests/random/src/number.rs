//! Makes numbers from random bytes.

use arbitrary::{Result, Unstructured};

/// Makes the lengths of one scene. They share one unit, and many of them are equal.
pub struct Numbers {
    /// Typical size of the scene's lengths.
    pub unit: f64,
    /// Whether lights get a range.
    pub has_ranges: bool,
    before: f64,
}

impl Numbers {
    /// Chooses the unit: a power of two from 2^-30 to 2^28, most often 1.
    pub fn read(bytes: &mut Unstructured, has_ranges: bool) -> Result<Self> {
        let unit = match bytes.int_in_range(0..=3)? {
            0 => 2f64.powi(bytes.int_in_range(-30..=28)?),
            _ => 1.0,
        };
        Ok(Self {
            unit,
            has_ranges,
            before: unit,
        })
    }

    fn coordinate(&mut self, bytes: &mut Unstructured) -> Result<f64> {
        let number = match bytes.int_in_range(0..=7)? {
            0 => 0.0,
            1 => self.before,
            2 => -self.before,
            3 => self.unit,
            4 | 5 => self.unit * f64::from(bytes.arbitrary::<i8>()?) / 32.0,
            _ => self.unit * any_size(bytes)?,
        };
        if number != 0.0 {
            self.before = number;
        }
        Ok(number)
    }

    /// Makes a random position from the bytes of a fuzzer.
    pub fn place(&mut self, bytes: &mut Unstructured) -> Result<[f64; 3]> {
        let mut coordinate = || self.coordinate(bytes);
        Ok([coordinate()?, coordinate()?, coordinate()?])
    }

    /// Makes a radius, a height or an epsilon.
    pub fn size(&mut self, bytes: &mut Unstructured) -> Result<f64> {
        Ok(self.coordinate(bytes)?.abs())
    }

    /// Makes a normal, an axis or an up vector, of any length.
    pub fn way(&mut self, bytes: &mut Unstructured) -> Result<[f64; 3]> {
        let mut part = || -> Result<f64> {
            Ok(match bytes.int_in_range(0..=3)? {
                0 => 0.0,
                1 => 1.0,
                2 => f64::from(bytes.arbitrary::<i8>()?),
                _ => any_size(bytes)?,
            })
        };
        Ok([part()?, part()?, part()?])
    }
}

/// Makes a number with a magnitude from 2^-24 to 2^9 and either sign.
pub fn any_size(bytes: &mut Unstructured) -> Result<f64> {
    let mantissa = 1.0 + f64::from(bytes.arbitrary::<u32>()?) / 2f64.powi(32);
    let size = mantissa * 2f64.powi(bytes.int_in_range(-24..=8)?);
    Ok(if bytes.arbitrary()? { size } else { -size })
}

/// Makes a number from 0 to 1. 0 and 1 are frequent.
pub fn share(bytes: &mut Unstructured) -> Result<f64> {
    Ok(match bytes.int_in_range(0..=3)? {
        0 => 0.0,
        1 => 1.0,
        _ => f64::from(bytes.arbitrary::<u16>()?) / 65535.0,
    })
}

/// Makes a colour channel or a coefficient: 0 to 1, in one of four cases up to 16.
pub fn brightness(bytes: &mut Unstructured) -> Result<f64> {
    Ok(match bytes.int_in_range(0..=3)? {
        0 => 16.0 * share(bytes)?,
        _ => share(bytes)?,
    })
}

/// Makes a shininess of any size, often 0 or a whole number.
pub fn shininess(bytes: &mut Unstructured) -> Result<f64> {
    Ok(match bytes.int_in_range(0..=3)? {
        0 => 0.0,
        1 => f64::from(bytes.int_in_range(0..=1_u32 << 20)?),
        2 => f64::from(bytes.int_in_range(0..=300_u16)?),
        _ => any_size(bytes)?.abs() * 1e3,
    })
}

/// Makes a field of view: any that is accepted, and some that are not.
pub fn field_of_view(bytes: &mut Unstructured) -> Result<f64> {
    let part = f64::from(bytes.arbitrary::<u16>()?) / 65535.0;
    Ok(match bytes.int_in_range(0..=3)? {
        0 => 0.001 + part,
        1 => 180.0 - part,
        _ => 20.0 + 100.0 * part,
    })
}
