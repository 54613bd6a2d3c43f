// One number that can be moved: a slider with its plausible range shaded and its first value marked, a field to type it, a way back,
// and a place for a refusal.

var serial = 0, held = null;

// Ends a gesture that may still go on, before something else is done.
function settle() { if (held) held(); }

function inField(value) { return String(Number(value.toPrecision(5))).replace("-", "\u2212"); }

// `spec`: { label, unit, low, high, step, value, original, plausible }; `move` gets the value and whether the gesture goes on, and gives a promise of the answer.
function mover(spec, move) {
  var name = "move-" + (serial += 1), isHeld = false, isRefused = false, isShown = false, flying = 0, resting = null, sent = spec.value, accepted = spec.value;
  var unit = spec.unit === "1" ? "" : spec.unit;
  var hint = [
    spec.plausible ? "plausible " + plain(spec.plausible[0], 4) + " to " + plain(spec.plausible[1], 4) : null,
    isNumber(spec.original) ? "as stated " + withUnit(spec.original, unit) : null
  ].filter(Boolean).join(", ");
  var range = make("input", {
    type: "range", id: name, min: spec.low, max: spec.high, step: spec.step, "aria-label": spec.label, "aria-describedby": name + "-hint",
    title: hint, oninput: slid, onchange: rested, ondblclick: back, onkeydown: pressed
  });
  var field = make("input", {
    type: "text", inputmode: "decimal", autocomplete: "off", spellcheck: "false", "class": "field", "aria-label": spec.label + (unit ? " in " + unit : ""),
    onchange: entered, onkeydown: function (event) { if (event.key === "Enter") entered(); }
  });
  var home = make("button", { type: "button", "class": "back", onclick: back }, "\u21ba");
  var refusal = make("p", { "class": "refusal", role: "alert", hidden: true });
  var track = make("span", { "class": "track" }), plausible = make("span", { "class": "plausible" }), first = make("span", { "class": "first" });
  fill(track, [make("span", { "class": "rail" }), spec.plausible ? plausible : null, isNumber(spec.original) ? first : null, range]);
  home.title = home.ariaLabel = isNumber(spec.original) ? spec.label + ": back to " + withUnit(spec.original, unit) : "";

  // The thumb does not reach beyond the ends of its track.
  function place(value) {
    var share = Math.max(0, Math.min(1, (value - spec.low) / (spec.high - spec.low || 1)));
    return "calc(8px + (100% - 16px) * " + share.toFixed(4) + ")";
  }
  if (spec.plausible) {
    plausible.style.left = place(spec.plausible[0]);
    plausible.style.right = "calc(100% - " + place(spec.plausible[1]) + ")";
  }
  if (isNumber(spec.original)) first.style.left = place(spec.original);

  function write(value) {
    field.value = inField(value);
    range.setAttribute("aria-valuetext", spoken(value, unit));
  }

  function slid() {
    if (held !== end) settle();
    held = end;
    isHeld = true;
    sent = Number(range.value);
    write(sent);
    goOut(sent, true);
    rest(1500);
  }

  // Arrow keys rest after each step; those that follow soon belong to one gesture. A gesture whose end is never told ends too.
  function rested() { rest(400); }
  function rest(wait) {
    window.clearTimeout(resting);
    resting = window.setTimeout(end, wait);
  }
  function end() {
    window.clearTimeout(resting);
    if (held === end) held = null;
    isHeld = false;
    goOut(sent, false);
  }

  // Until the last move is answered, answers to those before it are old.
  function goOut(value, isDrag) {
    flying += 1;
    Promise.resolve(move(value, isDrag)).then(function () {
      flying -= 1;
      show(accepted);
    });
  }

  // What was typed stays as it was typed.
  function go(value, isTyped) {
    if (held === end) held = null;
    isHeld = false;
    window.clearTimeout(resting);
    range.value = value;
    sent = value;
    if (!isTyped) write(value);
    goOut(value, false);
  }

  function entered() {
    var value = typed(field.value);
    if (value === null) return refuse("This is not a number.");
    if (spec.integer && value !== Math.round(value)) return refuse("This must be a whole number.");
    if (inField(value) !== inField(sent)) go(value, true);
    else refuse(null);
    return null;
  }

  function back() { if (isNumber(spec.original)) go(spec.original); }

  function pressed(event) {
    if (event.key !== "Backspace" && event.key !== "Delete") return;
    event.preventDefault();
    back();
  }

  // Said until the value is another one.
  function refuse(words) {
    if (isRefused && !words) isShown = false;
    isRefused = !!words;
    if (words) range.value = sent = accepted;
    refusal.hidden = !words;
    say(refusal, words || "");
    dress(field, { "aria-invalid": words ? "true" : "false" });
  }

  var box = make("div", { "class": "mover" }, [
    make("label", { "for": name }, spec.label), make("span", { "class": "typed" }, [field, make("span", { "class": "unit" }, unit)]), home, track,
    make("span", { id: name + "-hint", "class": "unseen" }, (hint ? hint + "; " : "") + "Backspace goes back"), refusal
  ]);

  function show(value) {
    var isSame = accepted === value && sent === value && isShown;
    accepted = value;
    if (isHeld || isRefused || isSame || flying) return;
    isShown = true;
    sent = value;
    range.value = value;
    if (document.activeElement !== field || typed(field.value) === null) write(value);
    var isMoved = isNumber(spec.original) && Math.abs(value - spec.original) > 1e-9 * Math.max(1, Math.abs(spec.original));
    // Seen or not, it keeps its place and its focus.
    home.classList.toggle("idle", !isMoved);
    box.classList.toggle("moved", isMoved);
  }
  write(spec.value);
  show(spec.value);
  return { box: box, show: show, refuse: refuse, range: range, release: function () {
    window.clearTimeout(resting);
    if (held === end) held = null;
    isHeld = false;
  } };
}
