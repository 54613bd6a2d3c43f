//! `washout live`: a design or a study on a page, where its inputs are moved and the wing follows; frames of a video, to be marked.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;

use crate::export::file::{refuse_any, write_new};
use crate::export::html::frames;
use crate::export::html::live::{alone, page};
use crate::live::follow::follow;
use crate::live::grid::grid;
use crate::live::marking::{Marking, cut, is_video};
use crate::live::server::Server;
use crate::live::{Desk, Refusal, Session};
use crate::page::text::significant;

use super::live_verbs::{ByCommands, Run};
use super::memory::refuse_beyond;
use super::{Console, Failure};

/// Arguments of `washout live`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout live designs/twist-v2.toml
  # a study: the misfit, what is missing, add it, see the error fall
  washout live studies/three-rods.toml
  # on the mesh half as fine, which answers at once
  washout live designs/twist-v2.toml --set mesh.refine=0.5
  # frames of a video: click both edges of the wing, see the twist grow
  washout live my-frames/
  # the address only, for a browser that is opened by hand
  washout live designs/twist-v2.toml --no-open --port 8080
  # one file for others, in which sliders move through solved wings
  washout live designs/twist-v2.toml --export twist-v2.html \\
    --over flapping.frequency_hz,root-flexure

The page is served on 127.0.0.1 alone, under an address that nobody guesses, and works without network. Nothing is written until something is saved on the page. Ctrl-C ends it.")]
pub struct Live {
    /// The design, the study, the folder of images (PNG, JPEG) or the video
    #[arg(value_name = "DESIGN|STUDY|FRAMES")]
    pub file: PathBuf,
    /// Set a key of the design, or of every design of the study; can be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Port on 127.0.0.1 [default: one that is free]
    #[arg(long, value_name = "PORT", default_value_t = 0, hide_default_value = true)]
    pub port: u16,
    /// Do not open the browser; print the address only
    #[arg(long)]
    pub no_open: bool,
    /// Serve nothing: solve a grid over the inputs and effects of --over, and write one file in which sliders move through it
    #[arg(long, value_name = "FILE", requires = "over")]
    pub export: Option<PathBuf>,
    /// One to three inputs (by key) or effects (by name), separated by commas
    #[arg(long, value_name = "KEY,KEY", value_delimiter = ',', requires = "export")]
    pub over: Vec<String>,
}

/// Where the page is.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LiveReport {
    /// Address of the page, on this machine alone, which whoever knows it can use; the file, if one was written.
    pub address: String,
    /// The file that was opened.
    pub file: String,
}

impl Live {
    /// Serves the page until Ctrl-C; `verbs` runs the commands that save.
    pub fn run(&self, verbs: Run, console: &Console) -> Result<(), Failure> {
        let stop = console.progress();
        if self.file.is_dir() || self.file.is_file() && is_video(&self.file) {
            return self.marked(console);
        }
        let session = Session::open(&self.file, &self.set, Arc::new(ByCommands(verbs)));
        let session = session.map_err(|refusal| self.refused(refusal))?;
        let nodes = session
            .wing()
            .map_err(|refusal| self.refused(refusal))?
            .model
            .mesh
            .nodes
            .len();
        refuse_beyond(&self.file, nodes, None)?;
        if let Some(file) = &self.export {
            return self.exported(&session, file, console);
        }
        let server = self.server()?;
        let desk = Desk::new(session);
        let threads = |error: std::io::Error| Failure::Threads(error.to_string());
        let follower = desk.start(follow).map_err(threads)?;
        self.open(&server, console)?;
        let served = server.serve(&desk, page, stop);
        desk.close();
        // it ends as soon as the solve that runs hears of it
        let _ = follower.join();
        served.map_err(Failure::Output)
    }

    /// Serves the frames of a folder or a video until Ctrl-C.
    fn marked(&self, console: &Console) -> Result<(), Failure> {
        let strange = [
            ("--set", !self.set.is_empty()),
            ("--export", self.export.is_some()),
        ];
        if let Some((option, _)) = strange.into_iter().find(|(_, stands)| *stands) {
            let reason = "belongs to a design or a study; these are frames to be marked".to_string();
            return Err(Failure::Option { option, reason });
        }
        let stop = console.progress();
        let folder = match self.file.is_dir() {
            true => self.file.clone(),
            false => {
                let frames = cut(&self.file, stop);
                stop.check()?;
                let frames = frames.map_err(|refusal| self.refused(refusal))?;
                console.note(frames.note);
                frames.folder
            }
        };
        let marking = Marking::open(&folder).map_err(|refusal| self.refused(refusal))?;
        if let [first, rest @ ..] = marking.images().left_out() {
            let more = if rest.is_empty() {
                String::new()
            } else {
                format!(" and {} more", rest.len())
            };
            console.note(format!(
                "left out, for only PNG and JPEG are shown: {first}{more}; save them as PNG or JPEG"
            ));
        }
        let server = self.server()?;
        self.open(&server, console)?;
        let served = server.serve_frames(Arc::new(marking), frames::page, stop);
        served.map_err(Failure::Output)
    }

    /// Listens.
    fn server(&self) -> Result<Server, Failure> {
        Server::bind(self.port).map_err(|error| Failure::Option {
            option: "--port",
            reason: format!("cannot listen on 127.0.0.1:{}: {error}", self.port),
        })
    }

    /// Says where the page is, and opens it.
    fn open(&self, server: &Server, console: &Console) -> Result<(), Failure> {
        let address = server.address();
        let page_of = format!(
            "{address}\n{} on this page; it is for this machine alone. Ctrl-C ends it.\n",
            self.file.display()
        );
        let report = LiveReport {
            address: address.clone(),
            file: self.file.display().to_string(),
        };
        console.result(&page_of, &report)?;
        if !self.no_open
            && let Err(error) = open::that_detached(&address)
        {
            console.note(format!(
                "no browser could be opened ({error}); open the address by hand"
            ));
        }
        Ok(())
    }

    /// Solves the grid and writes its page.
    fn exported(&self, session: &Session, file: &Path, console: &Console) -> Result<(), Failure> {
        refuse_any(file)?;
        let progress = console.progress();
        let grid = grid(session, &self.over, progress);
        progress.check()?;
        let page = alone(&grid.map_err(|refusal| self.refused(refusal))?);
        write_new(file, page.as_bytes())?;
        let report = LiveReport {
            address: file.display().to_string(),
            file: self.file.display().to_string(),
        };
        let said = format!(
            "{} written, {} MB: sliders move through the wings that were solved; between them it is interpolated, and says so\n",
            file.display(),
            significant(page.len() as f64 / 1e6, 2)
        );
        console.result(&said, &report)
    }

    /// A file that is refused, as every other verb says it.
    fn refused(&self, refusal: Refusal) -> Failure {
        let cure = refusal.cure.map_or(String::new(), |cure| format!(". {cure}"));
        let reason = match refusal.key {
            Some(key) => format!("{}: {key}: {}{cure}", self.file.display(), refusal.message),
            // it names its file itself
            None => format!("{}{cure}", refusal.message),
        };
        Failure::Option {
            option: "washout live",
            reason,
        }
    }
}
