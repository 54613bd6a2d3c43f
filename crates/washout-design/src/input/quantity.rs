//! A number in a design file: stated, or assumed with a range and a reason.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, Deserialize, Deserializer, MapAccess, Visitor, value::MapAccessDeserializer};
use serde::{Deserialize as DeriveDeserialize, Serialize};

/// A number as it stands in a design file.
///
/// Either stated (`half_amplitude_deg = 34.5`) or assumed
/// (`half_amplitude_deg = { assumed = 34.5, range = [24.0, 45.0], why = "not stated in the paper" }`).
/// The unit is in the name of the key that holds it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Quantity {
    /// A value that the design states as a fact.
    Stated(f64),
    /// A value that is assumed, with the range that is thought possible.
    Assumed(Assumed),
}

/// An assumed value with its range.
#[derive(Debug, Clone, PartialEq, Serialize, DeriveDeserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Assumed {
    /// The value that is used, in the unit of the key.
    #[schemars(extend("examples" = [34.5]))]
    pub assumed: f64,
    /// The lower and upper end of the plausible range, in the unit of the key.
    #[schemars(extend("examples" = [[24.0, 45.0]]))]
    pub range: [f64; 2],
    /// Why it is assumed, in a few words.
    #[serde(default)]
    #[schemars(extend("examples" = ["not stated in the paper"]))]
    pub why: String,
}

impl Quantity {
    /// The value that is used, in the unit of the key.
    pub fn value(&self) -> f64 {
        match self {
            Quantity::Stated(value) => *value,
            Quantity::Assumed(assumed) => assumed.assumed,
        }
    }

    /// The assumption, if the value is assumed.
    pub fn assumption(&self) -> Option<&Assumed> {
        match self {
            Quantity::Stated(_) => None,
            Quantity::Assumed(assumed) => Some(assumed),
        }
    }
}

impl From<f64> for Quantity {
    fn from(value: f64) -> Self {
        Quantity::Stated(value)
    }
}

impl<'de> Deserialize<'de> for Quantity {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(QuantityVisitor)
    }
}

struct QuantityVisitor;

impl<'de> Visitor<'de> for QuantityVisitor {
    type Value = Quantity;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "a number, or {{ assumed = NUMBER, range = [LOW, HIGH], why = \"...\" }}"
        )
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Quantity, E> {
        Ok(Quantity::Stated(value))
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Quantity, E> {
        Ok(Quantity::Stated(value as f64))
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Quantity, E> {
        Ok(Quantity::Stated(value as f64))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Quantity, A::Error> {
        Assumed::deserialize(MapAccessDeserializer::new(map)).map(Quantity::Assumed)
    }
}

impl JsonSchema for Quantity {
    fn schema_name() -> Cow<'static, str> {
        "Quantity".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let assumed = generator.subschema_for::<Assumed>();
        json_schema!({
            "description": "A number, stated, or assumed with a range and a reason. Its unit is in the name of its key.",
            "anyOf": [{ "type": "number" }, assumed],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Quantity, toml::de::Error> {
        let table: toml::Table = toml::from_str(text)?;
        Quantity::deserialize(table["x"].clone())
    }

    #[test]
    fn integers_and_floats_are_stated() {
        assert_eq!(read("x = 3").unwrap(), Quantity::Stated(3.0));
        assert_eq!(read("x = 3.5").unwrap(), Quantity::Stated(3.5));
    }

    #[test]
    fn a_table_is_assumed() {
        let quantity = read("x = { assumed = 4, range = [3, 6.0] }").unwrap();
        assert_eq!(quantity.value(), 4.0);
        assert_eq!(quantity.assumption().unwrap().range, [3.0, 6.0]);
    }

    #[test]
    fn text_is_refused_with_both_forms_named() {
        let message = read("x = \"3\"").unwrap_err().to_string();
        assert!(message.contains("a number, or { assumed = NUMBER"), "{message}");
    }
}
