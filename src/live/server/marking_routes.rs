//! What can be asked while frames are marked.

use std::sync::Arc;

use serde::Deserialize;

use crate::live::marking::{Marking, Marks};

use hyper::StatusCode;

use super::answer::{self, Answer};
use super::guard::Passed;
use super::service::{Fault, Page, Service, document, page, read, whole};

/// What can be asked of frames and their marks.
pub struct MarkingRoutes {
    marking: Arc<Marking>,
    page: Page,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Changed {
    revision: u64,
    marks: Marks,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Nothing {}

impl MarkingRoutes {
    /// Of frames.
    pub fn new(marking: Arc<Marking>, page: Page) -> MarkingRoutes {
        MarkingRoutes { marking, page }
    }
}

impl Service for MarkingRoutes {
    fn get(&self, asked: &Passed) -> Result<Answer, Fault> {
        match asked.path.as_str() {
            "" => page(self.page),
            "api/marks" => document(&self.marking.state()),
            "api/frame" => {
                let index = whole(asked, "index")?.ok_or(Fault::Status(StatusCode::BAD_REQUEST))?;
                let index = usize::try_from(index).map_err(|_| Fault::Status(StatusCode::BAD_REQUEST))?;
                let (kind, bytes) = self.marking.images().read(index)?;
                Ok(answer::picture(kind, bytes))
            }
            "api/save" => Err(Fault::Status(StatusCode::METHOD_NOT_ALLOWED)),
            _ => Err(Fault::Status(StatusCode::NOT_FOUND)),
        }
    }

    fn post(&self, path: &str, body: &[u8]) -> Result<Answer, Fault> {
        match path {
            "api/marks" => {
                let Changed { revision, marks } = read(body)?;
                document(&self.marking.change(revision, marks)?)
            }
            "api/save" => {
                let Nothing {} = read(body)?;
                document(&self.marking.save()?)
            }
            "" | "api/frame" => Err(Fault::Status(StatusCode::METHOD_NOT_ALLOWED)),
            _ => Err(Fault::Status(StatusCode::NOT_FOUND)),
        }
    }
}
