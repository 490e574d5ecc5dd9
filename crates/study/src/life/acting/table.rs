//! Tables of a life in which wear acts: its strides, and the cells of both grooves at its end.

use super::{ActingLife, ActingStride};
use crate::ensemble::numbers_of;
use crate::error::StudyError;
use crate::sweep::{Cell, Column, Format, Kind, Rows, write_rows};
use std::path::Path;

impl ActingLife {
    /// Writes a row for each stride, `.parquet` or `.csv` by the name.
    ///
    /// # Errors
    /// A name with another ending, or a table that cannot be written.
    pub fn write_strides(&self, path: &Path) -> Result<(), StudyError> {
        let names = numbers_of(&ActingStride::default())?.into_iter().map(|(name, _)| name);
        let numbers = names.map(|name| Column::new(&name, Kind::Number, true));
        let columns: Vec<Column> = [Column::new("stride", Kind::Integer, false)].into_iter().chain(numbers).collect();
        let rows = self.strides.iter().enumerate().map(|(stride, row)| {
            let numbers = numbers_of(row)?.into_iter().map(|(_, cell)| cell);
            Ok([Cell::Integer(stride as i64)].into_iter().chain(numbers).collect())
        });
        write(path, &columns, &rows.collect::<Result<Vec<_>, StudyError>>()?)
    }

    /// Writes a row for each worn cell of both grooves: race, azimuth (absent where a race wears alike all round),
    /// contact angle, depth.
    ///
    /// # Errors
    /// As [`Self::write_strides`].
    pub fn write_map(&self, path: &Path) -> Result<(), StudyError> {
        let number = |name, absent| Column::new(name, Kind::Number, absent);
        let columns = [
            Column::new("cell", Kind::Integer, false),
            Column::new("race", Kind::Text, false),
            number("azimuth_deg", true),
            number("angle_deg", false),
            number("depth_um", false),
        ];
        let races = ["inner", "outer"].into_iter().zip(&self.fields);
        let spots = races.flat_map(|(race, field)| field.worn_cells().map(move |spot| (race, spot)));
        let row = |(cell, (race, spot)): (usize, (&str, tribodyn_wear::GrooveSpot))| {
            vec![
                Cell::Integer(cell as i64),
                Cell::Text(race.to_owned()),
                spot.azimuth.map_or(Cell::Null, |azimuth| Cell::Number(azimuth.to_degrees())),
                Cell::Number(spot.angle.to_degrees()),
                Cell::Number(spot.depth * 1e6),
            ]
        };
        write(path, &columns, &spots.enumerate().map(row).collect::<Vec<_>>())
    }
}

fn write(path: &Path, columns: &[Column], rows: &[Vec<Cell>]) -> Result<(), StudyError> {
    let notes = vec![("tribodyn.version".to_owned(), env!("CARGO_PKG_VERSION").to_owned())];
    write_rows(&Rows::in_memory(path, columns, rows), Format::of(path)?, notes)?;
    Ok(())
}
