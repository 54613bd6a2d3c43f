// The wings of the page: shapes in mm, what they are coloured by, their outlines.

// Micrometres are stored as whole numbers. Done once for a wing.
function prepare(wing) {
  if (wing.outline) return;
  ["rest", "loaded", "diameters"].forEach(function (name) {
    wing[name] = Float64Array.from(wing[name], function (um) { return um / 1000; });
  });
  (wing.stroke || []).forEach(function (phase) {
    phase.moved = Float64Array.from(phase.moved, function (um) { return um / 1000; });
  });
  // Edges that belong to one triangle only are the outline.
  var seen = {};
  for (var t = 0; t < wing.triangles.length; t += 3) {
    for (var k = 0; k < 3; k++) {
      var a = wing.triangles[t + k], b = wing.triangles[t + (k + 1) % 3];
      var key = Math.min(a, b) + "," + Math.max(a, b);
      seen[key] = seen[key] ? null : [a, b];
    }
  }
  wing.outline = Object.keys(seen).map(function (key) { return seen[key]; }).filter(Boolean);
}

// The shape between the unloaded (0) and the loaded one (1), straight; beyond 1 the deformation is enlarged.
function shape(wing, share) {
  return wing.rest.map(function (rest, i) { return rest + share * (wing.loaded[i] - rest); });
}

// The shape at a phase of the stroke, in space; at share 0 the unloaded wing at the same place.
function shapeAtPhase(wing, phase, share) {
  var pose = phase.pose, out = new Float64Array(wing.rest.length), p = [0, 0, 0];
  for (var i = 0; i < out.length; i += 3) {
    for (var k = 0; k < 3; k++) p[k] = wing.rest[i + k] + share * phase.moved[i + k];
    for (k = 0; k < 3; k++) {
      out[i + k] = pose[4 * k] * p[0] + pose[4 * k + 1] * p[1] + pose[4 * k + 2] * p[2] + pose[4 * k + 3];
    }
  }
  return out;
}

// What a wing can be coloured by: over the stroke by twist and pressure of the phase.
function fieldsOf(wing, phase) {
  if (!phase) return wing.fields;
  return [["twist", "deg"], ["pressure", "Pa"]].map(function (field) {
    return { name: field[0], unit: field[1], on: "points", values: phase[field[0]] };
  });
}

function fieldOf(wing, phase, name) {
  var fields = fieldsOf(wing, phase);
  return fields.filter(function (field) { return field.name === name; })[0] || fields[0];
}

// One scale of colours for all wings, and one for all phases of a stroke, so that they can be held against each other.
function reach(name, stroke) {
  var low = Infinity, high = -Infinity;
  function take(values) {
    values.forEach(function (value) { low = Math.min(low, value); high = Math.max(high, value); });
  }
  if (stroke) stroke.forEach(function (phase) { take(phase[name]); });
  else data.wings.forEach(function (wing) {
    wing.fields.forEach(function (field) { if (field.name === name) take(field.values); });
  });
  return high > low ? [low, high] : [low - 0.5, low + 0.5];
}
