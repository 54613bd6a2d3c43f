//! Tables as Parquet (feature `parquet`): a column in which every cell is a number or empty as DOUBLE, all others as UTF-8, an empty
//! cell as null.

use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as PhysicalType};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use super::ExportError;

/// A column, null where there is no value.
enum Column {
    Numbers(Vec<Option<f64>>),
    Words(Vec<Option<String>>),
}

impl Column {
    fn of(cells: &[&str]) -> Column {
        let filled = |cell: &&str| Some(cell.to_string()).filter(|cell| !cell.is_empty());
        let number = |cell: &&str| match *cell {
            "" => Some(None),
            cell => cell.parse().ok().map(Some),
        };
        match cells.iter().map(number).collect() {
            Some(numbers) => Column::Numbers(numbers),
            None => Column::Words(cells.iter().map(filled).collect()),
        }
    }
}

/// A table that was written as CSV, row by row and column by column.
///
/// # Errors
/// If it is no table, or cannot be encoded.
pub fn of_csv(bytes: &[u8]) -> Result<Vec<u8>, ExportError> {
    let refuse = |reason: String| ExportError::Encoding {
        format: "Parquet",
        reason,
    };
    let mut reader = csv::Reader::from_reader(bytes);
    let head = reader
        .headers()
        .cloned()
        .map_err(|error| refuse(error.to_string()))?;
    let rows: Result<Vec<csv::StringRecord>, csv::Error> = reader.records().collect();
    let rows = rows.map_err(|error| refuse(error.to_string()))?;
    let columns: Vec<(String, Column)> = head
        .iter()
        .enumerate()
        .map(|(k, name)| {
            let cells: Vec<&str> = rows.iter().map(|row| row.get(k).unwrap_or_default()).collect();
            (name.to_string(), Column::of(&cells))
        })
        .collect();
    encoded(&columns).map_err(|error| refuse(error.to_string()))
}

fn encoded(columns: &[(String, Column)]) -> Result<Vec<u8>, ParquetError> {
    let field = |(name, column): &(String, Column)| {
        let (physical, logical) = match column {
            Column::Numbers(_) => (PhysicalType::DOUBLE, None),
            Column::Words(_) => (PhysicalType::BYTE_ARRAY, Some(LogicalType::String)),
        };
        let built = Type::primitive_type_builder(name, physical)
            .with_logical_type(logical)
            .with_repetition(Repetition::OPTIONAL);
        built.build().map(Arc::new)
    };
    let fields = columns.iter().map(field).collect::<Result<Vec<_>, _>>()?;
    let schema = Arc::new(Type::group_type_builder("table").with_fields(fields).build()?);
    let mut bytes = Vec::new();
    let mut writer =
        SerializedFileWriter::new(&mut bytes, schema, Arc::new(WriterProperties::builder().build()))?;
    let mut group = writer.next_row_group()?;
    for (_, column) in columns {
        let Some(mut place) = group.next_column()? else {
            break;
        };
        match column {
            Column::Numbers(values) => {
                let (known, levels) = known(values);
                place
                    .typed::<DoubleType>()
                    .write_batch(&known, Some(&levels), None)?;
            }
            Column::Words(values) => {
                let (known, levels) = known(values);
                let known: Vec<ByteArray> = known.iter().map(|word| ByteArray::from(word.as_str())).collect();
                place
                    .typed::<ByteArrayType>()
                    .write_batch(&known, Some(&levels), None)?;
            }
        }
        place.close()?;
    }
    group.close()?;
    writer.close()?;
    Ok(bytes)
}

/// The values that there are, and for each row whether there is one.
fn known<T: Clone>(values: &[Option<T>]) -> (Vec<T>, Vec<i16>) {
    let levels = values.iter().map(|value| i16::from(value.is_some())).collect();
    (values.iter().flatten().cloned().collect(), levels)
}

#[cfg(test)]
mod tests {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::RowAccessor;

    use super::*;

    #[test]
    fn what_is_written_is_read_back_with_its_nulls() {
        let table = "case,f,law,twist_deg,failure\n0,1.5,a,20.25,\n1,2,b,,no equilibrium\n";
        let bytes = bytes::Bytes::from(of_csv(table.as_bytes()).unwrap());
        let reader = SerializedFileReader::new(bytes).unwrap();
        let read: Vec<_> = reader.get_row_iter(None).unwrap().map(Result::unwrap).collect();
        assert_eq!(read[1].get_double(0).unwrap(), 1.0);
        assert_eq!(read[0].get_double(1).unwrap(), 1.5);
        assert_eq!(read[1].get_string(2).unwrap(), "b");
        assert_eq!(read[0].get_double(3).unwrap(), 20.25);
        assert!(read[1].get_double(3).is_err(), "null");
        assert_eq!(read[1].get_string(4).unwrap(), "no equilibrium");
        assert!(read[0].get_string(4).is_err(), "null");
    }
}
