//! The table of a sweep as Parquet (feature `parquet`): numbers as DOUBLE, words as UTF-8, what is missing as null.

use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as PhysicalType};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use super::ExportError;
use super::sweep::figures;
use crate::sweep::{Row, SweepPlan};

/// A column, null where there is no value.
enum Column {
    Integers(Vec<i64>),
    Numbers(Vec<Option<f64>>),
    Words(Vec<Option<String>>),
}

/// `sweep.parquet`: the columns of `sweep.csv`; axes whose values are all numbers are numbers.
///
/// # Errors
/// If it cannot be encoded.
pub fn sweep(plan: &SweepPlan, rows: &[Row]) -> Result<Vec<u8>, ExportError> {
    let mut columns: Vec<(String, Column)> = vec![(
        "case".to_string(),
        Column::Integers(rows.iter().map(|row| row.case as i64).collect()),
    )];
    for (k, axis) in plan.axes.iter().enumerate() {
        let words = || rows.iter().map(|row| row.values[k].clone());
        let numbers: Option<Vec<Option<f64>>> = words().map(|word| word.parse().ok().map(Some)).collect();
        let column = numbers.map_or_else(|| Column::Words(words().map(Some).collect()), Column::Numbers);
        columns.push((axis.key.clone(), column));
    }
    for name in figures(rows) {
        let values = rows.iter().map(|row| row.figure(&name)).collect();
        columns.push((name, Column::Numbers(values)));
    }
    let failures = rows.iter().map(|row| row.failure.clone()).collect();
    columns.push(("failure".to_string(), Column::Words(failures)));
    encoded(&columns).map_err(|error| ExportError::Encoding {
        format: "Parquet",
        reason: error.to_string(),
    })
}

fn encoded(columns: &[(String, Column)]) -> Result<Vec<u8>, ParquetError> {
    let field = |(name, column): &(String, Column)| {
        let (physical, logical, repetition) = match column {
            Column::Integers(_) => (PhysicalType::INT64, None, Repetition::REQUIRED),
            Column::Numbers(_) => (PhysicalType::DOUBLE, None, Repetition::OPTIONAL),
            Column::Words(_) => (
                PhysicalType::BYTE_ARRAY,
                Some(LogicalType::String),
                Repetition::OPTIONAL,
            ),
        };
        let built = Type::primitive_type_builder(name, physical)
            .with_logical_type(logical)
            .with_repetition(repetition);
        built.build().map(Arc::new)
    };
    let fields = columns.iter().map(field).collect::<Result<Vec<_>, _>>()?;
    let schema = Arc::new(Type::group_type_builder("sweep").with_fields(fields).build()?);
    let mut bytes = Vec::new();
    let mut writer =
        SerializedFileWriter::new(&mut bytes, schema, Arc::new(WriterProperties::builder().build()))?;
    let mut group = writer.next_row_group()?;
    for (_, column) in columns {
        let Some(mut place) = group.next_column()? else {
            break;
        };
        match column {
            Column::Integers(values) => {
                place.typed::<Int64Type>().write_batch(values, None, None)?;
            }
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
    use crate::sweep::{Axis, Figure, Method};

    #[test]
    fn what_is_written_is_read_back_with_its_nulls() {
        let plan = SweepPlan {
            base: "wing.toml".into(),
            set: Vec::new(),
            axes: vec![Axis::parse("f=1,2").unwrap(), Axis::parse("law=a,b").unwrap()],
            method: Method::Grid,
            samples: 0,
            seed: 1,
            task_size: 10,
        };
        let row = |case: usize, values: [&str; 2], twist: Option<f64>| Row {
            case,
            values: values.map(str::to_string).to_vec(),
            figures: (twist.iter())
                .map(|&value| Figure {
                    name: "twist_deg".to_string(),
                    value,
                })
                .collect(),
            failure: twist.is_none().then(|| "no equilibrium".to_string()),
        };
        let rows = [row(0, ["1.5", "a"], Some(20.25)), row(1, ["2", "b"], None)];
        let bytes = bytes::Bytes::from(sweep(&plan, &rows).unwrap());
        let reader = SerializedFileReader::new(bytes).unwrap();
        let read: Vec<_> = reader.get_row_iter(None).unwrap().map(Result::unwrap).collect();
        assert_eq!(read[0].get_long(0).unwrap(), 0);
        assert_eq!(read[0].get_double(1).unwrap(), 1.5);
        assert_eq!(read[1].get_string(2).unwrap(), "b");
        assert_eq!(read[0].get_double(3).unwrap(), 20.25);
        assert!(read[1].get_double(3).is_err(), "null");
        assert_eq!(read[1].get_string(4).unwrap(), "no equilibrium");
    }
}
