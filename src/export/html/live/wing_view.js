// The wing of the report, for shapes that come one after the other: it keeps its camera.

// Rounder than a rod of some pixels needs to be; it is drawn anew with every move.
SIDES = 8;

var data = { map: JSON.parse(document.getElementById("wing-map").textContent), wings: [] }, handle = null, last = null, shown = null;

// `shape` as the program gives it. Of another case the wing finds its frame anew.
function showWing(shape) {
  if (shape === shown) return;
  shown = shape;
  if (!shape.wing) {
    document.getElementById("wing-live").hidden = false;
    return;
  }
  var isOther = last !== null && last !== shape.case;
  last = shape.case;
  summary = shape.stroke_phases ? { stroke: { phases: shape.stroke_phases } } : {};
  if (handle) handle.show([shape.wing], !shape.solved, isOther);
  else {
    data.wings = [shape.wing];
    handle = start(document.getElementById("wing-canvas"));
    if (handle) handle.show([shape.wing], !shape.solved, true);
  }
}

return { show: showWing, plain: plain };
