//! Frames of a video on a page: both edges of the wing are clicked there, and the twist grows beside them.
//!
//! [`Images`] are the frames of a folder. [`Marks`] are what was clicked and how the camera stood, as the page holds them. A [`Marking`]
//! has both, says what the marks give so far ([`Told`]), and writes the files that `washout measure` reads.

mod cut;

mod images;

mod marks;

mod shared;

mod told;

pub use cut::{Frames, cut, is_video};
pub use images::Images;
pub use marks::{Guides, Marks};
pub use shared::{Marking, MarkingState};
pub use told::{Lack, Told};
