// What the page knows: the frames, the marks, what they give, and what can be taken back. Every change goes to the program whole.

var known = { state: null, frame: 0, past: [], future: [] };
var isSending = false, isWaiting = false, afterwards = [];

function copy(value) { return JSON.parse(JSON.stringify(value)); }

function marks() { return known.state.marks; }

function frameName() { return known.state.frames[known.frame]; }

function learn(state) {
  known.state = state;
  tell("state", state);
}

// `does` changes the marks; `what`: changes of the same, one after the other, are one step to take back.
function change(does, what) {
  var before = copy(marks());
  does(marks());
  if (JSON.stringify(before) === JSON.stringify(marks())) return;
  if (!what || known.what !== what) known.past.push(before);
  known.what = what || null;
  known.future = [];
  known.state.is_dirty = true;
  tell("state", known.state);
  send();
}

// One at a time; of what changes meanwhile the newest goes out.
function send() {
  if (isSending) {
    isWaiting = true;
    return;
  }
  isSending = true;
  isWaiting = false;
  post("marks", { revision: known.state.revision, marks: marks() }).then(function (state) {
    known.isUnsent = false;
    tell("reached", true);
    if (isWaiting) {
      known.state.revision = state.revision;
      known.state.told = state.told;
    } else learn(state);
  }, function (error) {
    known.isUnsent = true;
    if (error.refusal) tell("refused", error.refusal);
    else tell("reached", false);
  }).then(function () {
    isSending = false;
    if (isWaiting) return send();
    afterwards.splice(0).forEach(function (does) { does(); });
  });
}

// Once the program knows all that was changed.
function whenSent(does) {
  if (isSending) afterwards.push(does);
  else does();
}

function taken(from, to) {
  if (!from.length) return;
  to.push(copy(marks()));
  known.state.marks = from.pop();
  known.what = null;
  tell("state", known.state);
  send();
}

function undo() { taken(known.past, known.future); }

function redo() { taken(known.future, known.past); }

// Clicks on one point of this frame.
function clicksOn(mark, r) {
  return marks().clicks.filter(function (own) { return own.frame === frameName() && own.mark === mark && own.r_mm === r; });
}
