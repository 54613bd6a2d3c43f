//! docs/reference says what the code says.

use clap::CommandFactory;
use washout::cli::Arguments;
use washout::cli::reference::reference_pages;

use crate::text_of;

#[test]
fn the_reference_pages_are_what_the_code_gives() {
    for (name, now) in reference_pages(Arguments::command()) {
        let page = format!("docs/reference/{name}");
        let shown = text_of(&page);
        let differs = shown.lines().zip(now.lines()).find(|(shown, now)| shown != now);
        assert!(
            shown == now,
            "{page} differs from the code ({differs:?}); run `washout schema --pages docs/reference`"
        );
    }
}
