//! `washout schema`.

use crate::{design, schema};

#[test]
fn the_shipped_designs_conform_to_the_schema_of_designs_and_a_wrong_key_does_not() {
    let validator = jsonschema::validator_for(&schema(&[])).expect("a schema");
    for name in ["rigid.toml", "twist-v1.toml", "twist-v2.toml"] {
        let text = std::fs::read_to_string(design(name)).expect("a design");
        let mut document: serde_json::Value = toml::from_str(&text).expect("TOML");
        let errors: Vec<String> = validator
            .iter_errors(&document)
            .map(|error| error.to_string())
            .collect();
        assert!(errors.is_empty(), "{name}: {errors:?}");
        document["planform"]["lenght_mm"] = 70.0.into();
        assert!(!validator.is_valid(&document), "{name}");
    }
}
