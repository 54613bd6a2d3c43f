//! What can be asked: each path of the page, what it takes and what it gives.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Deserialize;

use crate::live::asking;
use crate::live::desk::Desk;
use crate::live::refusal::Refusal;
use crate::live::table::{Table, beside};

use hyper::StatusCode;

use super::answer::{self, Answer};
use super::guard::Passed;
use super::service::{Fault, Page, Service, document, news, page, parameter, read, whole};
use super::token::Token;

/// Longest that a question for news is held, s.
const LONGEST: f64 = 30.0;

/// What can be asked of a desk.
pub struct Routes {
    desk: Arc<Desk>,
    page: Page,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Moves {
    values: BTreeMap<String, f64>,
    #[serde(default)]
    drag: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct EffectAt {
    name: String,
    value: Option<f64>,
    #[serde(default)]
    drag: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CaseAt {
    case: usize,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct HypothesisAt {
    hypothesis: usize,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Dropped {
    name: String,
    base64: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Ticket {
    ticket: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Text {
    name: String,
    text: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Nothing {}

impl Routes {
    /// Of a desk.
    pub fn new(desk: Arc<Desk>, page: Page) -> Routes {
        Routes { desk, page }
    }

    /// Reads a table and says what is understood; nothing is changed until it is confirmed.
    fn table(&self, dropped: &Dropped) -> Result<Answer, Fault> {
        let bytes = STANDARD
            .decode(&dropped.base64)
            .map_err(|_| Fault::Status(StatusCode::BAD_REQUEST))?;
        let table = Table::read(self.desk.session().opened(), &dropped.name, bytes)?;
        let ticket = Token::random().map_err(|error| Refusal::new(error.to_string()))?;
        let told = serde_json::json!({
            "understood": table.understood(),
            "rows": table.rows(),
            "ticket": ticket.text(),
        });
        self.desk.lay_out(ticket.text(), table);
        Ok(answer::json(StatusCode::OK, told.to_string()))
    }
}

impl Service for Routes {
    fn get(&self, asked: &Passed) -> Result<Answer, Fault> {
        let (after, wait) = (whole(asked, "after")?, wait(asked)?);
        match asked.path.as_str() {
            "" => page(self.page),
            "api/state" => document(&self.desk.state()),
            "api/shape" => Ok(news(
                self.desk.shape(after, wait).map(|text| text.as_bytes().to_vec()),
            )),
            "api/diagnosis" => {
                let told = self.desk.question(wait, |question| question.told(after));
                Ok(news(told.map(String::into_bytes)))
            }
            "api/hypothesis" => {
                let index = whole(asked, "index")?.ok_or(Fault::Status(StatusCode::BAD_REQUEST))?;
                let found = self.desk.ask(|question| question.found());
                let case = self.desk.session().case();
                let curve = found.and_then(|found| found.curve(index as usize, case));
                Ok(news(curve.and_then(|curve| serde_json::to_vec(&curve).ok())))
            }
            path if POSTED.contains(&path) => Err(Fault::Status(StatusCode::METHOD_NOT_ALLOWED)),
            _ => Err(Fault::Status(StatusCode::NOT_FOUND)),
        }
    }

    fn post(&self, path: &str, body: &[u8]) -> Result<Answer, Fault> {
        let desk = &self.desk;
        let found = match path {
            "api/set" => {
                let Moves { values, drag } = read(body)?;
                desk.change(|session| session.set(&values, drag))?
            }
            "api/effect" => {
                let EffectAt { name, value, drag } = read(body)?;
                desk.change(|session| session.effect(&name, value, drag))?
            }
            "api/case" => {
                let CaseAt { case } = read(body)?;
                desk.change(|session| session.show(case))?
            }
            "api/undo" => {
                let Nothing {} = read(body)?;
                desk.change(|session| session.undo())?
            }
            "api/redo" => {
                let Nothing {} = read(body)?;
                desk.change(|session| session.redo())?
            }
            "api/reset" => {
                let Nothing {} = read(body)?;
                desk.change(|session| {
                    session.reset();
                    Ok(())
                })?
            }
            "api/diagnose" => {
                let Nothing {} = read(body)?;
                asking::ask(desk)?;
                desk.state()
            }
            "api/diagnose/stop" => {
                let Nothing {} = read(body)?;
                desk.ask(|question| question.stop());
                desk.state()
            }
            "api/add" => {
                let HypothesisAt { hypothesis } = read(body)?;
                asking::add(desk, hypothesis)?
            }
            "api/save" => {
                let Nothing {} = read(body)?;
                let saved = asking::save(desk)?;
                return document(&saved);
            }
            "api/table" => return self.table(&read(body)?),
            "api/table/confirm" => {
                let Ticket { ticket } = read(body)?;
                let table = desk.laid_out(&ticket);
                let table =
                    table.ok_or_else(|| Refusal::new("this table is not there any more; drop it again"))?;
                desk.change(|session| session.take_in(&table))?
            }
            "api/open" => {
                let Text { name, text } = read(body)?;
                let path = beside(desk.session().opened(), &name, &text)?;
                desk.change(|session| session.reopen(&path, &[]))?
            }
            "api/bye" => {
                let Nothing {} = read(body)?;
                return Ok(answer::empty(StatusCode::NO_CONTENT));
            }
            "" | "api/state" | "api/shape" | "api/diagnosis" | "api/hypothesis" => {
                return Err(Fault::Status(StatusCode::METHOD_NOT_ALLOWED));
            }
            _ => return Err(Fault::Status(StatusCode::NOT_FOUND)),
        };
        document(&found)
    }
}

/// Paths that change something.
const POSTED: [&str; 14] = [
    "api/table",
    "api/table/confirm",
    "api/open",
    "api/set",
    "api/effect",
    "api/case",
    "api/undo",
    "api/redo",
    "api/reset",
    "api/diagnose",
    "api/diagnose/stop",
    "api/add",
    "api/save",
    "api/bye",
];

fn wait(asked: &Passed) -> Result<Duration, Fault> {
    let seconds: f64 = parameter(asked, "wait")
        .map_or(Ok(0.0), str::parse)
        .map_err(|_| Fault::Status(StatusCode::BAD_REQUEST))?;
    match seconds.is_finite() {
        true => Ok(Duration::from_secs_f64(seconds.clamp(0.0, LONGEST))),
        false => Err(Fault::Status(StatusCode::BAD_REQUEST)),
    }
}
