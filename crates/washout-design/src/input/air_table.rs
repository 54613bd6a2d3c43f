//! Force coefficients from a CSV table, or from a polar as other programs write it.

use super::error::{InputError, Range};
use super::polar;
use super::table::Table;

/// Reads a table with the columns alpha_deg, cl, cd, or a polar; rows `[alpha_deg, cl, cd]` with α rising.
pub(crate) fn parse(file: &str, text: &str) -> Result<Vec<[f64; 3]>, InputError> {
    let of_polar = polar::as_table(text);
    let text = of_polar.as_deref().unwrap_or(text);
    let table = Table::parse(file, text, &["alpha_deg", "cl", "cd"], &[])?;
    let angles = Range {
        low: -180.0,
        high: 180.0,
        open: false,
        unit: "deg",
    };
    let coefficients = Range {
        low: -100.0,
        high: 100.0,
        open: false,
        unit: "",
    };
    let mut rows: Vec<[f64; 3]> = Vec::new();
    for record in &table.records {
        let alpha = record.number_in("alpha_deg", angles, "Give the angle of attack in degrees")?;
        let cl = record.number_in("cl", coefficients, "Give the lift coefficient")?;
        let cd = record.number_in("cd", coefficients, "Give the drag coefficient")?;
        if rows.last().is_some_and(|last| last[0] >= alpha) {
            let cure = "Sort the rows by alpha_deg, one row per angle";
            return Err(record.conflict("alpha_deg", "must be larger than in the row before", &[], cure));
        }
        rows.push([alpha, cl, cd]);
    }
    if rows.len() < 2 {
        return Err(InputError::about_file(
            file,
            "has one row only",
            "Give at least two angles",
        ));
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn rows_come_out_in_order_of_columns() {
        let rows = parse(
            "t.csv",
            "# wind tunnel\ncl,alpha_deg,cd\n-0.1,-5,0.02\n0.4, 5 ,0.03\n",
        )
        .unwrap();
        assert_eq!(rows, [[-5.0, -0.1, 0.02], [5.0, 0.4, 0.03]]);
    }

    #[test]
    fn a_polar_of_xflr5_is_a_table_and_its_faults_have_their_lines() {
        let polar = |cd: &str| {
            format!(
                "xflr5 v6.47\n\n Mach =   0.000     Re =     0.010 e 6     Ncrit =   9.000\n\n  alpha     CL        CD       CDp\n \
                 ------- -------- --------- ---------\n  -5.000  -0.5000   0.01500   0.008\n   5.000   0.5000   {cd}   0.008\n"
            )
        };
        let rows = parse("p.txt", &polar("0.01600")).unwrap();
        assert_eq!(rows, [[-5.0, -0.5, 0.015], [5.0, 0.5, 0.016]]);
        let error = parse("p.txt", &polar("0.x")).unwrap_err().to_string();
        assert!(error.starts_with("p.txt:8: cd = 0.x"), "{error}");
    }

    #[test]
    fn falling_angles_are_refused_with_their_line() {
        let error = parse("t.csv", "# c\nalpha_deg,cl,cd\n5,0,0\n4,0,0\n").unwrap_err();
        assert_eq!(
            error.to_string(),
            "t.csv:4: alpha_deg = 4: must be larger than in the row before.\n  \
             Sort the rows by alpha_deg, one row per angle"
        );
    }
}
