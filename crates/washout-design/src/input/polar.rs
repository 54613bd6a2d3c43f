//! Polars as XFLR5, XFoil and airfoiltools.com write them: their lines become those of a table of coefficients, each where it stood.

/// Columns of a polar that are read, as its header names them, and as a table of coefficients does.
const COLUMNS: [[&str; 2]; 3] = [["alpha", "alpha_deg"], ["cl", "cl"], ["cd", "cd"]];

/// The text as a table of coefficients with the same number of lines; none if it is no polar.
pub(super) fn as_table(text: &str) -> Option<String> {
    let header = text.lines().position(|line| places(line).is_some())?;
    let places = places(text.lines().nth(header)?)?;
    let table = text.lines().enumerate().map(|(index, line)| {
        let fields = fields(line);
        let is_ruled = line.trim_start().starts_with("--");
        match index {
            index if index == header => COLUMNS.map(|[_, own]| own).join(","),
            index if index < header || is_ruled || fields.is_empty() => "#".to_string(),
            _ => {
                let found = places.map(|place| fields.get(place).copied().unwrap_or_default());
                found.join(",")
            }
        }
    });
    Some(table.collect::<Vec<_>>().join("\n") + "\n")
}

/// Where the columns stand in the header of a polar; none if the line is no such header.
fn places(line: &str) -> Option<[usize; 3]> {
    let names: Vec<String> = fields(line).iter().map(|name| name.to_lowercase()).collect();
    let mut places = [0; 3];
    for (place, [name, _]) in places.iter_mut().zip(COLUMNS) {
        *place = names.iter().position(|own| own == name)?;
    }
    Some(places)
}

/// What stands between commas, or else between spaces.
fn fields(line: &str) -> Vec<&str> {
    match line.contains(',') {
        true => line.split(',').map(str::trim).collect(),
        false => line.split_whitespace().collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polar_keeps_its_lines_and_a_table_of_ones_own_is_none() {
        let polar = "xflr5 v6.47\n\n Calculated polar for: flat plate\n\n  alpha     CL        CD       CDp       Cm\n \
                     ------- -------- --------- --------- --------\n  -5.000  -0.5000   0.01500   0.00800   0.0010\n   \
                     5.000   0.5000   0.01600   0.00800   0.0010\n\n";
        let table = as_table(polar).expect("a polar");
        assert_eq!(
            table,
            "#\n#\n#\n#\nalpha_deg,cl,cd\n#\n-5.000,-0.5000,0.01500\n5.000,0.5000,0.01600\n#\n"
        );
        let commas = "Xfoil polar\nAlpha,Cl,Cd,Cdp\n1,0.1,0.02,0.01\n";
        assert_eq!(
            as_table(commas).as_deref(),
            Some("#\nalpha_deg,cl,cd\n1,0.1,0.02\n")
        );
        assert_eq!(as_table("# own\ncl,alpha_deg,cd\n0.4,5,0.03\n"), None);
    }
}
