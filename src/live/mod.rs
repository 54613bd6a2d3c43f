//! The model alive: what `washout live` holds while somebody moves its inputs on a page.
//!
//! A [`Session`] is a value: what was opened, what was moved, what can be taken back. It knows the wing that is to be solved next, and
//! solves nothing. A [`Desk`] has a session and a thread that follows it: after each move it finds the shape from the last one at once,
//! and then the shape from rest, which is the answer. A [`server::Server`] lets a browser on the same machine ask the desk.

pub mod refusal;

pub mod inputs;

pub mod effects;

pub mod values;

pub mod opened;

pub mod history;

pub mod verbs;

pub mod state;

pub mod held;

pub mod table;

pub mod session;

pub mod shape;

pub mod stroke;

pub mod ladder;

pub mod grid;

pub mod job;

pub mod desk;

pub mod follow;

pub mod found;

pub mod question;

pub mod asking;

pub mod marking;

pub mod server;

pub use desk::Desk;
pub use refusal::Refusal;
pub use session::Session;
pub use verbs::Verbs;
