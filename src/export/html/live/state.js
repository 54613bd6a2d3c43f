// What the page knows: the document of the state, and the shape that was solved last.

var known = { state: null, shape: null, original: {}, before: null };
var gesture = null;

// An answer that comes late does not bring back what was before.
function learnState(state) {
  if (!state || !state.inputs || (known.state && state.revision < known.state.revision)) return;
  // The first shape may come before the first state.
  var isOther = known.state && known.state.file !== state.file;
  if (isOther) known.original = {};
  known.state = state;
  tell("state", state);
  tell("waiting", isWaiting());
}

function learnShape(shape) {
  if (!shape) return;
  // Before the first that is solved there is none at all.
  shape.twist = shape.twist || { r_mm: [], twist_deg: [], measured: [], other: null };
  shape.numbers = shape.numbers || [];
  known.shape = shape;
  if (shape.twist.other) known.original[shape.case] = shape.twist.other;
  else if (shape.solved && !known.original[shape.case]) known.original[shape.case] = Object.assign({ name: "at first" }, shape.twist);
  tell("waiting", isWaiting());
  soon();
}

// A change begins: the curve that was there is kept to be seen beside the new one. Moves of one gesture begin once.
function begins(what, isDrag) {
  if (gesture !== what && known.shape && known.shape.solved) known.before = { "case": known.shape.case, twist: known.shape.twist };
  gesture = isDrag ? what : null;
}

// Whether the shape is of an older state than the sliders.
function isWaiting() { return !!known.state && (!known.shape || known.shape.revision < known.state.revision); }

// All pictures of one shape are drawn in one frame; of shapes that come faster the newest is drawn.
var isDrawing = false;
function soon() {
  if (isDrawing) return;
  isDrawing = true;
  window.requestAnimationFrame(function () {
    isDrawing = false;
    if (known.shape) tell("shape", known.shape);
  });
}

// The title of a key, for sentences.
function nameOf(key) {
  var found = known.state.inputs.concat(known.state.effects).filter(function (own) { return own.key === key || own.name === key; })[0];
  return found ? found.label || found.title : key;
}
