//! Flow, coefficients, centre of pressure, strips. Knows no structure.
