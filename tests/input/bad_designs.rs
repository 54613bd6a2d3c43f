//! Designs that must be refused, each with its whole message.

use washout::input::Design;

/// A correct design; each case changes one place of it.
pub const WING: &str = include_str!("wing.toml");

/// Name of the case, what is replaced in [`WING`], by what, and the message.
type Case = (&'static str, &'static str, &'static str, &'static str);

const CASES: &[Case] = &[
    (
        "syntax: no value",
        "frequency_hz = 23.0",
        "frequency_hz =",
        "wing.toml:11:15: the value is missing.\n  \
         Write a value behind frequency_hz =, or delete the line",
    ),
    (
        "syntax: unclosed text",
        "name = \"wing\"",
        "name = \"wing",
        "wing.toml:2:13: the text has no closing quote.\n  \
         Write name = \"wing\"",
    ),
    (
        "syntax: unit after the number",
        "length_mm = 70.0",
        "length_mm = 70.0 mm",
        "wing.toml:5:13: a number stands without its unit.\n  \
         Write length_mm = 70.0, in the unit that the key names",
    ),
    (
        "syntax: word without quotes",
        "material = \"kapton\"",
        "material = kapton",
        "wing.toml:36:12: words stand in quotes.\n  \
         Write material = \"kapton\"",
    ),
    (
        "syntax: key twice",
        "frequency_hz = 23.0",
        "frequency_hz = 23.0\nfrequency_hz = 22.0",
        "wing.toml:12:1: frequency_hz is given twice.\n  \
         Keep one of them; segments, spars and loads are lists, written [[rod]], [[spar]], [[load]]",
    ),
    (
        "syntax: table twice",
        "[observation]",
        "[film]",
        "wing.toml:43:2: film is given twice.\n  \
         Keep one of them; segments, spars and loads are lists, written [[rod]], [[spar]], [[load]]",
    ),
    (
        "syntax: decimal comma",
        "mean_chord_mm = 20.5",
        "mean_chord_mm = 20,5",
        "wing.toml:6:19: a number has a decimal point, not a comma.\n  \
         Write mean_chord_mm = 20.5",
    ),
    (
        "format of the future",
        "format = 1",
        "format = 2",
        "wing.toml:1:10: format = 2: this program reads format 1.\n  \
         Write format = 1, or use the version of washout that the file was made for",
    ),
    (
        "format missing",
        "format = 1\n",
        "",
        "wing.toml: format is missing.\n  \
         Give the version of the file format, e.g. format = 1",
    ),
    (
        "name empty",
        "name = \"wing\"",
        "name = \"\"",
        "wing.toml:2:8: name = \"\": must not be empty.\n  \
         Use letters, digits, - and _, e.g. name = \"my-wing\"",
    ),
    (
        "name no folder",
        "name = \"wing\"",
        "name = \"../wing\"",
        "wing.toml:2:8: name = \"../wing\": must be usable as the name of a folder.\n  \
         Use letters, digits, - and _, e.g. name = \"my-wing\"",
    ),
    (
        "unknown key, a slip",
        "length_mm = 70.0",
        "lenght_mm = 70.0",
        "wing.toml:5:1: planform.lenght_mm = 70.0: unknown key.\n  \
         Did you mean length_mm? Allowed in planform: length_mm, mean_chord_mm, r2_hat, r1_hat, outline, root_offset_mm, base_closure, tip_cut",
    ),
    (
        "unknown key, a stranger",
        "root_offset_mm = 38.0",
        "colour = 38.0",
        "wing.toml:8:1: planform.colour = 38.0: unknown key.\n  \
         Allowed in planform: length_mm, mean_chord_mm, r2_hat, r1_hat, outline, root_offset_mm, base_closure, tip_cut",
    ),
    (
        "unknown key, of another table",
        "thickness_mm = 0.006",
        "thickness_mm = 0.006\nfrequency_hz = 23.0",
        "wing.toml:38:1: film.frequency_hz = 23.0: unknown key.\n  \
         frequency_hz belongs in [flapping]. Allowed in film: material, thickness_mm, compression, residual_compression, pretension_n_per_m",
    ),
    (
        "unknown table",
        "[observation]",
        "[observaton]",
        "wing.toml:43:2: observaton: unknown key.\n  \
         Did you mean observation? Allowed at the top level: format, name, materials, planform, flapping, steady, air, rod, spar, ribs, film, root, load, gravity, structure, mesh, coupling, observation, measured, material, assumed_choice, effects",
    ),
    (
        "unknown key of a section",
        "section = { shape = \"half-round\", diameter_mm = 1.0 }",
        "section = { shape = \"half-round\", radius = 0.5 }",
        "wing.toml:18:35: rod[0].section.radius = 0.5: unknown key.\n  \
         Allowed in rod[0].section of shape half-round: shape, diameter_mm, flat",
    ),
    (
        "key of another shape",
        "section = { shape = \"half-round\", diameter_mm = 1.0 }",
        "section = { shape = \"round\", diameter_mm = 1.0, flat = \"across\" }",
        "wing.toml:18:49: rod[0].section.flat = \"across\": unknown key.\n  \
         flat belongs to the shape half-round. Allowed in rod[0].section of shape round: shape, diameter_mm",
    ),
    (
        "wrong unit of a length",
        "length_mm = 70.0",
        "length_cm = 7.0",
        "wing.toml:5:1: planform.length_cm = 7.0: wrong unit, length_mm is expected.\n  \
         Give the length R from the wing base to the tip in millimetres, e.g. length_mm = 70.0",
    ),
    (
        "wrong unit of a frequency",
        "frequency_hz = 23.0",
        "frequency_rpm = 1380",
        "wing.toml:11:1: flapping.frequency_rpm = 1380: wrong unit, frequency_hz is expected.\n  \
         Give the flapping frequency in hertz, e.g. frequency_hz = 23.0",
    ),
    (
        "unit missing",
        "frequency_hz = 23.0",
        "frequency = 23.0",
        "wing.toml:11:1: flapping.frequency = 23.0: missing unit, frequency_hz is expected.\n  \
         Give the flapping frequency in hertz, e.g. frequency_hz = 23.0",
    ),
    (
        "wrong unit of a modulus",
        "e_gpa = 2.5",
        "e_mpa = 2500",
        "wing.toml:52:1: material.kapton.e_mpa = 2500: wrong unit, e_gpa is expected.\n  \
         Give the modulus of elasticity along the length or fibre in gigapascals, e.g. e_gpa = 2.5",
    ),
    (
        "text for a number",
        "length_mm = 70.0",
        "length_mm = \"70 mm\"",
        "wing.toml:5:13: planform.length_mm = \"70 mm\": must be a number, not text.\n  \
         Write the number without quotes and without unit. Give the length R from the wing base to the tip in millimetres, e.g. length_mm = 70.0",
    ),
    (
        "word for a number",
        "length_mm = 70.0",
        "length_mm = \"long\"",
        "wing.toml:5:13: planform.length_mm = \"long\": must be a number, not text.\n  \
         Give the length R from the wing base to the tip in millimetres, e.g. length_mm = 70.0",
    ),
    (
        "true for a number",
        "length_mm = 70.0",
        "length_mm = true",
        "wing.toml:5:13: planform.length_mm = true: must be a number, not true or false.\n  \
         Give the length R from the wing base to the tip in millimetres, e.g. length_mm = 70.0",
    ),
    (
        "number for text",
        "material = \"kapton\"",
        "material = 3",
        "wing.toml:36:12: film.material = 3: must be text in quotes, not a whole number.\n  \
         Give the name of its material, as in `[material.NAME]`, e.g. material = \"kapton\"",
    ),
    (
        "date for a number",
        "frequency_hz = 23.0",
        "frequency_hz = 2024-01-01",
        "wing.toml:11:16: flapping.frequency_hz = 2024-01-01: must be a number, not a date.\n  \
         Give the flapping frequency in hertz, e.g. frequency_hz = 23.0",
    ),
    (
        "table for a list",
        "[[load]]",
        "[load]",
        "wing.toml:39:1: load must be a list of tables, written [[load]], not a table.\n  \
         Give the bench loads besides air, one `[[load]]` table each",
    ),
    (
        "list of the wrong length",
        "force_n = [0.0, 0.0, 0.01]",
        "force_n = [0.0, 0.01]",
        "wing.toml:41:11: load[0].force_n = [0.0, 0.01]: must be a list of 3 values, not a list of 2.\n  \
         Give the dead force along x, y, z of the wing frame in newtons, e.g. force_n = [0.0, 0.0, 0.01]",
    ),
    (
        "number for a list",
        "force_n = [0.0, 0.0, 0.01]",
        "force_n = 0.01",
        "wing.toml:41:11: load[0].force_n = 0.01: must be a list of 3 values in brackets, not a decimal number.\n  \
         Give the dead force along x, y, z of the wing frame in newtons, e.g. force_n = [0.0, 0.0, 0.01]",
    ),
    (
        "text in a list",
        "stations_mm = [10.0, 30.0]",
        "stations_mm = [10.0, \"30\"]",
        "wing.toml:44:22: observation.stations_mm[1] = \"30\": must be a number, not text.\n  \
         Give the stations to read besides the spar ends in millimetres, e.g. stations_mm = [10.0, 30.0]",
    ),
    (
        "fraction for a count",
        "[observation]",
        "[mesh]\nchordwise = 12.5\n\n[observation]",
        "wing.toml:44:13: mesh.chordwise = 12.5: must be a whole number, not a decimal number.\n  \
         Give the number of elements across the mean chord at refinement 1, e.g. chordwise = 12",
    ),
    (
        "wrong sign",
        "frequency_hz = 23.0",
        "frequency_hz = -3",
        "wing.toml:11:16: flapping.frequency_hz = -3: must lie in 0.1 … 1000 Hz.\n  \
         Give the flapping frequency in hertz, e.g. frequency_hz = 23.0",
    ),
    (
        "out of range",
        "r2_hat = 0.54",
        "r2_hat = 54",
        "wing.toml:7:10: planform.r2_hat = 54: must lie in 0.4 … 0.8.\n  \
         Give the non-dimensional radius of the second moment of area, e.g. r2_hat = 0.54",
    ),
    (
        "range of an item",
        "force_n = [0.0, 0.0, 0.01]",
        "force_n = [0.0, 0.0, 1e9]",
        "wing.toml:41:22: load[0].force_n[2] = 1e9: must lie in -1000000 … 1000000 N.\n  \
         Give the dead force along x, y, z of the wing frame in newtons, e.g. force_n = [0.0, 0.0, 0.01]",
    ),
    (
        "not a number",
        "length_mm = 70.0",
        "length_mm = nan",
        "wing.toml:5:13: planform.length_mm = nan: must be a finite number.\n  \
         Give the length R from the wing base to the tip in millimetres, e.g. length_mm = 70.0",
    ),
    (
        "infinity",
        "frequency_hz = 23.0",
        "frequency_hz = -inf",
        "wing.toml:11:16: flapping.frequency_hz = -inf: must be a finite number.\n  \
         Give the flapping frequency in hertz, e.g. frequency_hz = 23.0",
    ),
    (
        "overflow",
        "length_mm = 70.0",
        "length_mm = 1e999",
        "wing.toml:5:13: planform.length_mm = 1e999: must be a finite number.\n  \
         Give the length R from the wing base to the tip in millimetres, e.g. length_mm = 70.0",
    ),
    (
        "NaN in a vector",
        "force_n = [0.0, 0.0, 0.01]",
        "force_n = [0.0, nan, 0.01]",
        "wing.toml:41:17: load[0].force_n[1] = nan: must be a finite number.\n  \
         Give the dead force along x, y, z of the wing frame in newtons, e.g. force_n = [0.0, 0.0, 0.01]",
    ),
    (
        "unknown word",
        "stations_mm = [10.0, 30.0]",
        "instrument = \"chord_rotaton\"",
        "wing.toml:44:14: observation.instrument = \"chord_rotaton\": must be one of chord_rotation, camera.\n  \
         Did you mean \"chord_rotation\"? Give the instrument, e.g. instrument = \"chord_rotation\"",
    ),
    (
        "unknown shape",
        "section = { shape = \"half-round\", diameter_mm = 1.0 }",
        "section = { shape = \"square\", diameter_mm = 1.0 }",
        "wing.toml:18:21: rod[0].section.shape = \"square\": must be one of round, half-round, tube, rectangle, laminate, given.\n  \
         Give the shape, e.g. shape = \"round\"",
    ),
    (
        "shape missing",
        "section = { shape = \"half-round\", diameter_mm = 1.0 }",
        "section = { diameter_mm = 1.0 }",
        "wing.toml:18:11: rod[0].section.shape is missing.\n  \
         Give the shape, e.g. shape = \"round\"; allowed are round, half-round, tube, rectangle, laminate, given",
    ),
    (
        "required key missing",
        "frequency_hz = 23.0\n",
        "",
        "wing.toml:10:1: flapping.frequency_hz is missing.\n  \
         Give the flapping frequency in hertz, e.g. frequency_hz = 23.0",
    ),
    (
        "required table missing",
        "[planform]\nlength_mm = 70.0\nmean_chord_mm = 20.5\nr2_hat = 0.54\nroot_offset_mm = 38.0\n",
        "",
        "wing.toml: planform is missing.\n  \
         Give the outline of the wing: a table [planform] with length_mm",
    ),
    (
        "assumed without range",
        "{ assumed = 34.5, range = [24.0, 45.0], why = \"not stated\" }",
        "{ assumed = 34.5 }",
        "wing.toml:12:22: flapping.half_amplitude_deg.range is missing.\n  \
         Write an assumed value as half_amplitude_deg = { assumed = 34.5, range = [LOW, HIGH], why = \"...\" }",
    ),
    (
        "assumed outside its range",
        "assumed = 34.5",
        "assumed = 50.0",
        "wing.toml:12:34: flapping.half_amplitude_deg.assumed = 50.0: must lie in its own range 24 … 45.\n  \
         Widen the range, or assume a value inside it",
    ),
    (
        "assumed out of the allowed range",
        "assumed = 34.5",
        "assumed = 345.0",
        "wing.toml:12:34: flapping.half_amplitude_deg.assumed = 345.0: must lie in 0.1 … 90 deg.\n  \
         Give the half-stroke amplitude (half of the peak-to-peak stroke angle) in degrees, e.g. half_amplitude_deg = 34.5",
    ),
    (
        "assumed range reversed",
        "range = [24.0, 45.0]",
        "range = [45.0, 24.0]",
        "wing.toml:12:48: flapping.half_amplitude_deg.range = [45.0, 24.0]: must rise from its lower to its upper end.\n  \
         Write range = [24.0, 45.0]",
    ),
    (
        "assumed range of one value",
        "range = [24.0, 45.0]",
        "range = [34.5, 34.5]",
        "wing.toml:12:48: flapping.half_amplitude_deg.range = [34.5, 34.5]: must rise from its lower to its upper end.\n  \
         A value without a range is stated, not assumed: write the number alone",
    ),
    (
        "assumed range beyond the allowed",
        "range = [24.0, 45.0]",
        "range = [0.0, 45.0]",
        "wing.toml:12:49: flapping.half_amplitude_deg.range = 0.0: must lie in 0.1 … 90 deg.\n  \
         Give the half-stroke amplitude (half of the peak-to-peak stroke angle) in degrees, e.g. half_amplitude_deg = 34.5",
    ),
    (
        "assumed range of three",
        "range = [24.0, 45.0]",
        "range = [24.0, 34.5, 45.0]",
        "wing.toml:12:48: flapping.half_amplitude_deg.range = [24.0, 34.5, 45.0]: must be a list of two numbers, [LOW, HIGH], not a list of 3.\n  \
         Write an assumed value as half_amplitude_deg = { assumed = 34.5, range = [LOW, HIGH], why = \"...\" }",
    ),
    (
        "assumed NaN",
        "assumed = 34.5",
        "assumed = nan",
        "wing.toml:12:34: flapping.half_amplitude_deg.assumed = nan: must be a finite number.\n  \
         Give the half-stroke amplitude (half of the peak-to-peak stroke angle) in degrees, e.g. half_amplitude_deg = 34.5",
    ),
    (
        "assumed misspelt",
        "assumed = 34.5",
        "value = 34.5",
        "wing.toml:12:24: flapping.half_amplitude_deg.value = 34.5: unknown key.\n  \
         Write an assumed value as half_amplitude_deg = { assumed = 34.5, range = [LOW, HIGH], why = \"...\" }; or state it as half_amplitude_deg = 34.5",
    ),
    (
        "flapping and steady",
        "[film]",
        "[steady]\nspeed_m_s = 8.0\nroot_angle_deg = 5.0\n\n[film]",
        "wing.toml:35:1: steady cannot stand together with flapping.\n  \
         Keep [flapping] or [steady]; delete both for bench loads only",
    ),
    (
        "table of coefficients missing",
        "[film]",
        "[air]\ncoefficients = \"table\"\n\n[film]",
        "wing.toml:36:16: air.coefficients = \"table\": needs air.table.\n  \
         Give table = \"coefficients.csv\" with the columns alpha_deg, cl, cd, or name another set",
    ),
    (
        "no mean chord",
        "mean_chord_mm = 20.5\n",
        "",
        "wing.toml:4:1: planform.mean_chord_mm is needed without an outline.\n  \
         Give mean_chord_mm and r2_hat for a beta chord, or outline = [[r_mm, chord_mm], ...]",
    ),
    (
        "radii of no wing",
        "r2_hat = 0.54",
        "r2_hat = 0.54\nr1_hat = 0.6",
        "wing.toml:8:10: planform.r1_hat = 0.6: no chord distribution has r1_hat = 0.6000 and r2_hat = 0.5400.\n  \
         r1_hat must lie between r2_hat squared and r2_hat, 0.2916 … 0.5400; without it Ellington's regression gives it for r2_hat up to 0.75",
    ),
    (
        "second radius too large",
        "r2_hat = 0.54",
        "r2_hat = 0.79",
        "wing.toml:7:10: planform.r2_hat = 0.79: no chord distribution has r1_hat = 0.8014 and r2_hat = 0.7900.\n  \
         r1_hat must lie between r2_hat squared and r2_hat, 0.6241 … 0.7900; without it Ellington's regression gives it for r2_hat up to 0.75",
    ),
    (
        "outline and mean chord",
        "r2_hat = 0.54",
        "outline = [[0, 10], [70, 10]]",
        "wing.toml:6:17: planform.mean_chord_mm = 20.5: cannot stand together with outline.\n  \
         Keep the outline, or mean_chord_mm and r2_hat; the outline has its own mean chord and radii",
    ),
    (
        "outline not rising",
        "mean_chord_mm = 20.5\nr2_hat = 0.54",
        "outline = [[0, 10], [40, 20], [40, 10], [70, 5]]",
        "wing.toml:6:32: planform.outline[2][0] = 40: r must rise, but the point before is at 40 mm.\n  \
         Sort the points by r, one point per r",
    ),
    (
        "outline with a negative chord",
        "mean_chord_mm = 20.5\nr2_hat = 0.54",
        "outline = [[0, 10], [40, -20], [70, 5]]",
        "wing.toml:6:26: planform.outline[1][1] = -20: the chord must not be negative.\n  \
         Give the chord in millimetres, 0 or more",
    ),
    (
        "outline too short",
        "mean_chord_mm = 20.5\nr2_hat = 0.54",
        "outline = [[0, 10], [40, 20]]",
        "wing.toml:6:11: planform.outline = [[0, 10], [40, 20]]: must run from 0 to 70 mm, but runs from 0 to 40.\n  \
         Add points at the wing base and at the tip",
    ),
    (
        "outline past the tip",
        "mean_chord_mm = 20.5\nr2_hat = 0.54",
        "outline = [[0, 10], [80, 20]]",
        "wing.toml:6:22: planform.outline[1][0] = 80: r must lie in 0 … 70 mm.\n  \
         Points run from the wing base (0) to the tip (length_mm)",
    ),
    (
        "outline of one point",
        "mean_chord_mm = 20.5\nr2_hat = 0.54",
        "outline = [[0, 10]]",
        "wing.toml:6:11: planform.outline = [[0, 10]]: needs at least two points.\n  \
         Give two points [r_mm, chord_mm] or more, r rising from 0 to the length",
    ),
    (
        "base closed outboard of the tip",
        "root_offset_mm = 38.0",
        "base_closure = 0.5\ntip_cut = 0.5",
        "wing.toml:8:16: planform.base_closure = 0.5: must be smaller than tip_cut = 0.5.\n  \
         The base is closed inboard of base_closure, the tip cut at tip_cut; usual are 0.02 and 0.99",
    ),
    (
        "rod with a gap",
        "from_mm = 40.0",
        "from_mm = 41.0",
        "wing.toml:21:11: rod[1].from_mm = 41.0: leaves a gap after rod[0], which ends at 40 mm.\n  \
         Write from_mm = 40.0, or let rod[0] end at 41.0",
    ),
    (
        "rod overlapping",
        "from_mm = 40.0",
        "from_mm = 39.0",
        "wing.toml:21:11: rod[1].from_mm = 39.0: overlaps rod[0], which ends at 40 mm.\n  \
         Write from_mm = 40.0, or let rod[0] end at 39.0",
    ),
    (
        "rod not from the base",
        "from_mm = 0.0",
        "from_mm = 2.0",
        "wing.toml:15:11: rod[0].from_mm = 2.0: the rod must start at the wing base, at 0.\n  \
         Write from_mm = 0.0 for the first segment",
    ),
    (
        "rod past the tip",
        "to_mm = 70.0",
        "to_mm = 71.0",
        "wing.toml:22:9: rod[1].to_mm = 71.0: runs past the tip at length_mm = 70.\n  \
         End the rod at 70 mm or before",
    ),
    (
        "rod that ends far from the tip",
        "to_mm = 70.0",
        "to_mm = 50.0",
        "wing.toml:22:9: rod[1].to_mm = 50.0: leaves the leading edge without a rod from 50 mm to the tip at 69.3 mm: the film hangs \
         on nothing there.\n  Let the last rod end at the tip, or at 55.44 mm at least",
    ),
    (
        "rod of no length",
        "to_mm = 40.0",
        "to_mm = 0.0",
        "wing.toml:16:9: rod[0].to_mm = 0.0: must be larger than from_mm = 0.\n  \
         Give the outer end of the segment, measured from the wing base",
    ),
    (
        "rod without material",
        "to_mm = 40.0\nmaterial = \"carbon\"",
        "to_mm = 40.0",
        "wing.toml:14:1: rod[0].material is missing.\n  \
         Name a material, e.g. material = \"carbon-rod\", and define it under [material.carbon-rod]",
    ),
    (
        "tube without a wall",
        "inner_diameter_mm = 0.3",
        "inner_diameter_mm = 0.5",
        "wing.toml:24:74: rod[1].section.inner_diameter_mm = 0.5: must be smaller than outer_diameter_mm = 0.5.\n  \
         A tube has a wall; for a solid rod write shape = \"round\" with diameter_mm",
    ),
    (
        "material unknown, a slip",
        "material = \"kapton\"",
        "material = \"kaptan\"",
        "wing.toml:36:12: film.material = \"kaptan\": there is no such material.\n  \
         Did you mean \"kapton\"? Defined are carbon, kapton; add a table [material.kaptan]",
    ),
    (
        "material unknown, a stranger",
        "to_mm = 40.0\nmaterial = \"carbon\"",
        "to_mm = 40.0\nmaterial = \"wood\"",
        "wing.toml:17:12: rod[0].material = \"wood\": there is no such material.\n  \
         Defined are carbon, kapton; add a table [material.wood]",
    ),
    (
        "material of a ply unknown",
        "{ material = \"carbon\", thickness_mm = 0.04 }",
        "{ material = \"m60j\", thickness_mm = 0.04 }",
        "wing.toml:33:71: spar[1].section.plies[0].material = \"m60j\": there is no such material.\n  \
         Defined are carbon, kapton; add a table [material.m60j]",
    ),
    (
        "laminate without plies",
        "plies = [{ material = \"carbon\", thickness_mm = 0.04 }]",
        "plies = []",
        "wing.toml:33:57: spar[1].section.plies = []: there is no ply.\n  \
         Give plies = [{ material = \"...\", thickness_mm = ... }, ...] from bottom to top",
    ),
    (
        "spar off the wing",
        "at_mm = 50.0",
        "at_mm = 72.0",
        "wing.toml:32:9: spar[1].at_mm = 72.0: is off the wing, which is cut at 69.3 mm (length_mm × tip_cut).\n  \
         Move the spar inboard",
    ),
    (
        "spar end off the wing",
        "at_mm = 50.0",
        "at_mm = 50.0\ntrailing_edge_at_mm = 69.5",
        "wing.toml:33:23: spar[1].trailing_edge_at_mm = 69.5: is off the wing, which is cut at 69.3 mm (length_mm × tip_cut).\n  \
         Move the spar inboard",
    ),
    (
        "spar twice",
        "at_mm = 50.0",
        "at_mm = 20.0",
        "wing.toml:32:9: spar[1].at_mm = 20.0: spar[0] stands at the same place.\n  \
         Delete one of them, or move it",
    ),
    (
        "spars too near",
        "at_mm = 50.0",
        "at_mm = 20.1",
        "wing.toml:32:9: spar[1].at_mm = 20.1: is only 0.1 mm from spar[0] at the leading edge.\n  \
         Keep 0.2 mm or more between spars, or merge them into a wider one",
    ),
    (
        "spars crossing",
        "at_mm = 50.0",
        "at_mm = 50.0\ntrailing_edge_at_mm = 15.0",
        "wing.toml:32:9: spar[1].at_mm = 50.0: crosses spar[0] between the leading and the trailing edge.\n  \
         Give spars that do not cross the same order along both edges",
    ),
    (
        "spar too near the tip",
        "at_mm = 50.0",
        "at_mm = 69.2",
        "wing.toml:32:9: spar[1].at_mm = 69.2: is only 0.1 mm from the tip cut, which leaves a sliver.\n  \
         Keep 0.2 mm or more, or lay the spar on the edge itself",
    ),
    (
        "unstable section",
        "section = { shape = \"half-round\", diameter_mm = 1.0 }",
        "section = { shape = \"given\", ea_n = 1e5, gj_n_m2 = 4e-4, ei_flap_n_m2 = 6e-3, ei_edge_n_m2 = 6e-3, coupling = [{ between = [\"twist\", \"bending-flap\"], value = 2e-3 }] }",
        "wing.toml:18:111: rod[0].section.coupling = [{ between = [\"twist\", \"bending-flap\"], value = 2e-3 }]: makes the stiffness matrix indefinite (scaled to a diagonal of 1, its smallest eigenvalue is -0.291).\n  \
         A coupling must be smaller than the square root of the product of its two diagonal terms",
    ),
    (
        "unstable section of two couplings",
        "section = { shape = \"half-round\", diameter_mm = 1.0 }",
        "section = { shape = \"given\", ea_n = 1e5, gj_n_m2 = 4e-4, ei_flap_n_m2 = 6e-3, ei_edge_n_m2 = 6e-3, coupling = [{ between = [\"twist\", \"bending-flap\"], value = 1.2e-3 }, { between = [\"twist\", \"bending-edge\"], value = 1.2e-3 }] }",
        "wing.toml:18:111: rod[0].section.coupling = [{ between = [\"twist\", \"bending-flap\"], value = 1.2e-3 },...: makes the stiffness matrix indefinite (scaled to a diagonal of 1, its smallest eigenvalue is -0.095).\n  \
         A coupling must be smaller than the square root of the product of its two diagonal terms",
    ),
    (
        "strain coupled with itself",
        "section = { shape = \"half-round\", diameter_mm = 1.0 }",
        "section = { shape = \"given\", ea_n = 1e5, gj_n_m2 = 4e-4, ei_flap_n_m2 = 6e-3, ei_edge_n_m2 = 6e-3, coupling = [{ between = [\"twist\", \"twist\"], value = 1e-5 }] }",
        "wing.toml:18:124: rod[0].section.coupling[0].between = [\"twist\", \"twist\"]: couples a strain with itself.\n  \
         Name two different strains; a diagonal term is ea_n, gj_n_m2, ei_flap_n_m2 or ei_edge_n_m2",
    ),
    (
        "coupling of an absent shear",
        "section = { shape = \"half-round\", diameter_mm = 1.0 }",
        "section = { shape = \"given\", ea_n = 1e5, gj_n_m2 = 4e-4, ei_flap_n_m2 = 6e-3, ei_edge_n_m2 = 6e-3, coupling = [{ between = [\"twist\", \"shear-flap\"], value = 1e-5 }] }",
        "wing.toml:18:124: rod[0].section.coupling[0].between = [\"twist\", \"shear-flap\"]: couples a shear that the section does not have, because ga_flap_n is absent.\n  \
         Give ga_flap_n, or leave the coupling out",
    ),
    (
        "coupling given twice",
        "section = { shape = \"half-round\", diameter_mm = 1.0 }",
        "section = { shape = \"given\", ea_n = 1e5, gj_n_m2 = 4e-4, ei_flap_n_m2 = 6e-3, ei_edge_n_m2 = 6e-3, coupling = [{ between = [\"twist\", \"axial\"], value = 1e-5 }, { between = [\"axial\", \"twist\"], value = 1e-5 }] }",
        "wing.toml:18:172: rod[0].section.coupling[1].between = [\"axial\", \"twist\"]: couples a pair that an earlier term couples already.\n  \
         The matrix is symmetric: give each pair once",
    ),
    (
        "Poisson's ratio too large",
        "poisson = 0.34",
        "poisson = 0.5",
        "wing.toml:53:11: material.kapton.poisson = 0.5: must lie in -1 … 0.5 (the ends excluded).\n  \
         Give the Poisson ratio (strain across per strain along the fibre), e.g. poisson = 0.34",
    ),
    (
        "orthotropic without shear modulus",
        "e_gpa = 2.5",
        "e_gpa = 2.5\ne2_gpa = 2.0",
        "wing.toml:51:1: material.kapton.g_gpa is needed where e2_gpa makes the material orthotropic.\n  \
         Give the shear modulus in gigapascals, e.g. g_gpa = 4.5, or leave e2_gpa out",
    ),
    (
        "orthotropic and unstable",
        "g_gpa = 4.0",
        "g_gpa = 4.0\ne2_gpa = 1000.0\npoisson = 0.4",
        "wing.toml:50:11: material.carbon.poisson = 0.4: must be smaller than √(e_gpa / e2_gpa) = 0.3661 in size.\n  \
         Give the strain across per strain along the fibre, and e_gpa along it",
    ),
    (
        "name of a material",
        "[material.kapton]",
        "[material.\"Kapton HN\"]",
        "wing.toml:51:11: material.\"Kapton HN\": a name must consist of letters, digits, _ and -.\n  \
         Rename it, e.g. [material.my-name]",
    ),
    (
        "load off the wing",
        "at_mm = 60.0",
        "at_mm = 80.0",
        "wing.toml:40:9: load[0].at_mm = 80.0: is off the wing, which ends at length_mm = 70.\n  \
         Give a place between 0 and 70 mm",
    ),
    (
        "load of nothing",
        "force_n = [0.0, 0.0, 0.01]\n",
        "",
        "wing.toml:39:1: load[0] loads nothing.\n  \
         Give force_n, moment_n_m or mass_kg, or delete the table",
    ),
    (
        "camera without axis",
        "stations_mm = [10.0, 30.0]",
        "instrument = \"camera\"",
        "wing.toml:44:14: observation.instrument = \"camera\": needs camera_axis.\n  \
         Give camera_axis = \"flapping-axis\" or \"stroke\", the axis along which the camera looks",
    ),
    (
        "station off the wing",
        "stations_mm = [10.0, 30.0]",
        "stations_mm = [10.0, 69.9]",
        "wing.toml:44:22: observation.stations_mm[1] = 69.9: is off the wing, which is cut at 69.3 mm (length_mm × tip_cut).\n  \
         Give stations on the wing",
    ),
    (
        "station twice",
        "stations_mm = [10.0, 30.0]",
        "stations_mm = [10.0, 10.0]",
        "wing.toml:44:22: observation.stations_mm[1] = 10.0: stands twice.\n  \
         Give every station once",
    ),
    (
        "tip beyond the cut",
        "stations_mm = [10.0, 30.0]",
        "tip_station = 0.995",
        "wing.toml:44:15: observation.tip_station = 0.995: lies beyond the tip cut at 0.99 of the length.\n  \
         Read the tip inboard of planform.tip_cut, usually at 0.97",
    ),
    (
        "assumed choice of no key",
        "[observation]",
        "[[assumed_choice]]\nkey = \"root.cord\"\nwhy = \"\"\n\n[observation]",
        "wing.toml:44:7: assumed_choice[0].key = \"root.cord\": no word stands under this key in the design.\n  \
         Give the dotted key of a choice, e.g. \"root.chord\"; assumed numbers are marked where they stand, { assumed = ..., range = [...] }",
    ),
    (
        "materials file without files",
        "format = 1",
        "format = 1\nmaterials = \"materials.toml\"",
        "wing.toml:2:13: materials = \"materials.toml\": cannot be followed, because the design is not read from a file.\n  \
         Write the materials into the design, as tables [material.NAME]",
    ),
    (
        "NaN in an effect",
        "[observation]",
        "[effects.tip_loss]\nstrength = nan\n\n[observation]",
        "wing.toml:44:12: effects.tip_loss.strength = nan: must be a finite number.\n  \
         Give a number that is neither nan nor infinite",
    ),
];

/// The design of a case.
fn design_of(case: &Case) -> String {
    let (name, from, to, _) = case;
    assert_eq!(
        WING.matches(from).count(),
        1,
        "{name}: \"{from}\" must stand once in the wing"
    );
    WING.replace(from, to)
}

#[test]
fn the_wing_itself_is_accepted() {
    if let Err(error) = Design::from_toml(WING, "wing.toml") {
        panic!("{error}");
    }
}

#[test]
fn every_bad_design_is_refused_with_its_message() {
    let mut wrong = Vec::new();
    for case in CASES {
        let message = match Design::from_toml(&design_of(case), "wing.toml") {
            Ok(_) => "(accepted)".to_string(),
            Err(error) => error.to_string(),
        };
        if message != case.3 {
            wrong.push(format!(
                "{}\n  expected: {}\n  found:    {message}",
                case.0, case.3
            ));
        }
    }
    assert!(
        wrong.is_empty(),
        "{} of {} messages differ:\n{}",
        wrong.len(),
        CASES.len(),
        wrong.join("\n")
    );
}

#[test]
fn there_are_many_cases_and_no_two_alike() {
    let mut names: Vec<&str> = CASES.iter().map(|case| case.0).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), CASES.len());
    assert!(CASES.len() >= 60, "{}", CASES.len());
}
