//! Makes numbers from random bytes.

use arbitrary::{Result, Unstructured};

/// Makes the numbers of one scene. Its lengths share one unit, and many of them are equal.
pub struct Numbers<'a> {
    /// Source of all numbers.
    pub bytes: Unstructured<'a>,
    /// Typical size of the scene's lengths.
    pub unit: f64,
    before: f64,
}

impl<'a> Numbers<'a> {
    /// Chooses the unit: a power of two from 2^-30 to 2^28, most often 1.
    pub fn read(mut bytes: Unstructured<'a>) -> Result<Self> {
        let unit = match bytes.int_in_range(0..=3)? {
            0 => 2f64.powi(bytes.int_in_range(-30..=28)?),
            _ => 1.0,
        };
        Ok(Self {
            bytes,
            unit,
            before: unit,
        })
    }

    /// Makes a number from 0 to `most`.
    pub fn count(&mut self, most: u32) -> Result<u32> {
        self.bytes.int_in_range(0..=most)
    }

    fn coordinate(&mut self) -> Result<f64> {
        let number = match self.count(7)? {
            0 => 0.0,
            1 => self.before,
            2 => -self.before,
            3 => self.unit,
            4 | 5 => self.unit * f64::from(self.bytes.arbitrary::<i8>()?) / 32.0,
            _ => self.unit * self.any_size()?,
        };
        if number != 0.0 {
            self.before = number;
        }
        Ok(number)
    }

    /// Makes a position.
    pub fn place(&mut self) -> Result<[f64; 3]> {
        three(|| self.coordinate())
    }

    /// Makes a radius, a height or an epsilon.
    pub fn size(&mut self) -> Result<f64> {
        Ok(self.coordinate()?.abs())
    }

    /// Makes a normal, an axis or an up vector, of any length.
    pub fn way(&mut self) -> Result<[f64; 3]> {
        three(|| {
            Ok(match self.count(3)? {
                0 => 0.0,
                1 => 1.0,
                2 => f64::from(self.bytes.arbitrary::<i8>()?),
                _ => self.any_size()?,
            })
        })
    }

    /// Makes a number with a magnitude from 2^-24 to 2^9 and either sign.
    fn any_size(&mut self) -> Result<f64> {
        let mantissa = 1.0 + f64::from(self.bytes.arbitrary::<u32>()?) / 2f64.powi(32);
        let size = mantissa * 2f64.powi(self.bytes.int_in_range(-24..=8)?);
        Ok(if self.bytes.arbitrary()? { size } else { -size })
    }

    /// Makes a number from 0 to 1, one of 65536.
    fn part(&mut self) -> Result<f64> {
        Ok(f64::from(self.bytes.arbitrary::<u16>()?) / 65535.0)
    }

    /// Makes a number from 0 to 1. 0 and 1 are frequent.
    pub fn share(&mut self) -> Result<f64> {
        match self.count(3)? {
            0 => Ok(0.0),
            1 => Ok(1.0),
            _ => self.part(),
        }
    }

    /// Makes a colour channel or a coefficient: 0 to 1, in one of four cases up to 16.
    pub fn brightness(&mut self) -> Result<f64> {
        let most = if self.count(3)? == 0 { 16.0 } else { 1.0 };
        Ok(most * self.share()?)
    }

    /// Makes a shininess of any size, often 0 or a whole number.
    pub fn shininess(&mut self) -> Result<f64> {
        Ok(match self.count(3)? {
            0 => 0.0,
            1 => f64::from(self.count(1 << 20)?),
            2 => f64::from(self.count(300)?),
            _ => self.any_size()?.abs() * 1e3,
        })
    }

    /// Makes a field of view: any that is accepted, and some that are not.
    pub fn field_of_view(&mut self) -> Result<f64> {
        let part = self.part()?;
        Ok(match self.count(3)? {
            0 => 0.001 + part,
            1 => 180.0 - part,
            _ => 20.0 + 100.0 * part,
        })
    }
}

/// Returns three results of a function.
pub fn three<T>(mut make: impl FnMut() -> Result<T>) -> Result<[T; 3]> {
    Ok([make()?, make()?, make()?])
}
