//! docs/effects.md says what the cards say.

use std::path::Path;

use washout::effects::{ALL, Card};
use washout::export::effects::effects_page;

#[test]
fn the_page_of_documentation_says_what_the_cards_say() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/effects.md");
    let page = std::fs::read_to_string(path).expect("the page");
    let cards: Vec<Card> = ALL.iter().map(|effect| effect.card()).collect();
    let renew = "run `washout effects --page docs/effects.md`";
    assert!(
        page == effects_page(&cards),
        "docs/effects.md differs from the cards; {renew}"
    );
}
