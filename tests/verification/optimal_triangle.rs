//! The optimal triangle on Cook's membrane against its own published values, term by term.
//!
//! With cells cut along their shorter diagonal and rotations free at the wall: 20.56, 22.45, 23.43 and 23.80 on 2, 4, 8 and
//! 16 cells a side (Felippa, Comput. Methods Appl. Mech. Eng. 192 (2003) 2125-2168, from memory).

use washout::verify::cases::cook_membrane::deflection;

#[test]
fn cook_s_membrane_moves_as_felippa_s_triangles_do() {
    for (cells, known) in [(2, 20.56), (4, 22.45), (8, 23.43), (16, 23.80)] {
        let value = deflection(cells).unwrap();
        assert!((value - known).abs() < 5.1e-3, "{cells}: {value} {known}");
    }
}
