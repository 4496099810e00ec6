//! Numbers made of bytes.

use arbitrary::{Result, Unstructured};

/// The lengths of one scene: all in one unit, many of them alike.
pub struct Numbers {
    /// What the scene's lengths are about as large as.
    pub unit: f64,
    before: f64,
}

impl Numbers {
    /// Chooses the unit: 2^-30 to 2^28.
    pub fn read(bytes: &mut Unstructured) -> Result<Self> {
        let unit = match bytes.int_in_range(0..=3)? {
            0 => 2f64.powi(bytes.int_in_range(-30..=28)?),
            _ => 1.0,
        };
        Ok(Self { unit, before: unit })
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

    /// A position.
    pub fn place(&mut self, bytes: &mut Unstructured) -> Result<[f64; 3]> {
        let mut coordinate = || self.coordinate(bytes);
        Ok([coordinate()?, coordinate()?, coordinate()?])
    }

    /// A radius, a height or an epsilon.
    pub fn size(&mut self, bytes: &mut Unstructured) -> Result<f64> {
        Ok(self.coordinate(bytes)?.abs())
    }

    /// A normal, an axis or what is up: of any length.
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

/// A number of any size from 2^-24 to 2^8, of either sign.
pub fn any_size(bytes: &mut Unstructured) -> Result<f64> {
    let mantissa = 1.0 + f64::from(bytes.arbitrary::<u32>()?) / 2f64.powi(32);
    let size = mantissa * 2f64.powi(bytes.int_in_range(-24..=8)?);
    Ok(if bytes.arbitrary()? { size } else { -size })
}

/// 0 to 1, both often.
pub fn share(bytes: &mut Unstructured) -> Result<f64> {
    Ok(match bytes.int_in_range(0..=3)? {
        0 => 0.0,
        1 => 1.0,
        _ => f64::from(bytes.arbitrary::<u16>()?) / 65535.0,
    })
}

/// A colour or a coefficient: 0 to 1, and in one of four cases up to 16.
pub fn brightness(bytes: &mut Unstructured) -> Result<f64> {
    Ok(match bytes.int_in_range(0..=3)? {
        0 => 16.0 * share(bytes)?,
        _ => share(bytes)?,
    })
}

/// A shininess of any size, often none or a whole number.
pub fn shininess(bytes: &mut Unstructured) -> Result<f64> {
    Ok(match bytes.int_in_range(0..=3)? {
        0 => 0.0,
        1 => f64::from(bytes.int_in_range(0..=1_u32 << 20)?),
        2 => f64::from(bytes.int_in_range(0..=300_u16)?),
        _ => any_size(bytes)?.abs() * 1e3,
    })
}

/// Any field of view that is accepted, and some that are not.
pub fn field_of_view(bytes: &mut Unstructured) -> Result<f64> {
    let part = f64::from(bytes.arbitrary::<u16>()?) / 65535.0;
    Ok(match bytes.int_in_range(0..=3)? {
        0 => 0.001 + part,
        1 => 180.0 - part,
        _ => 20.0 + 100.0 * part,
    })
}
