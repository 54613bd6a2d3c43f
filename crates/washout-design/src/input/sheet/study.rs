//! The study of a table: its cases, and what the design assumes as what is uncertain.

use std::fmt::Write;
use std::path::Path;

use super::Sheet;
use super::zeros::zeros;
use crate::input::assumption::Assumption;

/// Where the texts of a study point to, as they stand in it.
#[derive(Debug, Clone, Copy)]
pub struct Names<'a> {
    /// The study.
    pub study: &'a str,
    /// The design, relative to the study.
    pub design: &'a str,
    /// The measurement file, relative to the study.
    pub readings: &'a str,
}

impl Sheet {
    /// The text of a study file in which no fit sees the cases `held_out`. What the design assumes, `assumed`, is uncertain in it; all
    /// effects that can act may be tried.
    pub fn study(&self, names: Names, held_out: &[String], assumed: &[Assumption]) -> String {
        let text = |words: &str| toml::Value::from(words).to_string();
        let path = Path::new(&self.measurement.file);
        let file = path.file_name().unwrap_or(path.as_os_str());
        let mut study = format!(
            "# Made of a table of readings. All keys: washout schema --study, and docs/studies.md\n\n\
             format = 1\nname = {}\ntitle = {}\n\n\
             # A diagnosis tries all effects that can act. To try fewer: candidates = [\"root-flexure\"]\n",
            text(names.study),
            text(&format!(
                "{}: the readings of {}",
                self.loaded.design.name,
                file.to_string_lossy()
            )),
        );
        for family in &self.families {
            let set: Vec<String> = family.set.iter().map(|set| text(set)).collect();
            let held = family.cases.iter().filter(|case| held_out.contains(case));
            let held: Vec<String> = held.map(|case| text(case)).collect();
            let last = text(family.cases.last().map_or("", String::as_str));
            let line = match held.is_empty() {
                true => format!("# held_out = [{last}]"),
                false => format!("held_out = [{}]", held.join(", ")),
            };
            // writing to a String cannot fail
            let _ = write!(
                study,
                "\n# {}\n[[case]]\ndesign = {}\nset = [{}]\nmeasurement = {}\nmeasured = {}\n\
                 # Cases that no fit ever sees, so that they test it.\n{line}\n",
                family.cases.join(", "),
                text(names.design),
                set.join(", "),
                text(names.readings),
                text(&family.form),
            );
        }
        let set: Vec<&str> = self
            .families
            .iter()
            .flat_map(|family| &family.set)
            .filter_map(|set| Some(set.split_once('=')?.0))
            .collect();
        for assumed in assumed
            .iter()
            .filter(|assumed| !set.contains(&assumed.key.as_str()))
        {
            let _ = write!(
                study,
                "\n[[uncertain]]\nkey = {}\nwhy = {}\n",
                text(&assumed.key),
                text(&format!("assumed by the design: {}", assumed.why)),
            );
        }
        for (channel, sigma) in zeros(&self.measurement) {
            let _ = write!(
                study,
                "\n# An error of the zero moves all readings of a run together; sigma is in the unit of the channel.\n[[ruler]]\nkind = \"offset\"\nchannel = \"{}\"\nsigma = {sigma:?}\nwhy = \"assumed: the zero was read as a reading is\"\n",
                channel.name()
            );
        }
        study
    }
}
