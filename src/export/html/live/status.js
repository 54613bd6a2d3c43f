// What is going on: solving, solved, refused, not reached. A screen reader hears the tip twist when it has come to rest, and refusals.

function status() {
  var line = at("status"), grey = at("grey"), heard = at("heard"), speaking = null, slow = null, isReached = true, before = null;

  function speak(text) {
    window.clearTimeout(speaking);
    speaking = window.setTimeout(function () { say(heard, text); }, 700);
  }

  function parts(shape) {
    var stability = shape.stability;
    var own = [];
    if (shape.interpolated) own.push(make("span", { "class": "bad" }, "\u2248 interpolated between solved points"));
    else if (shape.interpolated === false) own.push(make("span", { "class": "good" }, "\u2713 a solved point"));
    if (stability) own.push(make("span", { "class": stability.stable ? "good" : "bad" }, [stability.stable ? "\u2713 " : "\u26a0 ", stability.words]));
    if (shape.interpolated === undefined) own.push(make("span", {}, isNumber(shape.mesh_error_deg) ? "mesh error " + withUnit(shape.mesh_error_deg, "deg", 2) : "mesh error not known yet"));
    if (shape.note) own.push(make("span", { "class": "bad" }, "\u26a0 " + shape.note));
    if (shape.settled === false && shape.solved) own.push(make("span", { "class": "time" }, "from the last shape, being solved from rest \u2026"));
    else if (isNumber(shape.seconds)) own.push(make("span", { "class": "time" }, "solved in " + plain(shape.seconds, 2) + " s"));
    return own;
  }

  hear("shape", function (shape) {
    fill(line, parts(shape));
    grey.hidden = shape.solved;
    var isSought = !shape.solved && shape.settled === false;
    var reason = isSought ? "Nothing was found near it; the wing is being solved from rest, which can take a minute." : shape.refusal ? shape.refusal.message : "";
    // What can be said at an input is said there.
    var isPlaced = shape.refusal && known.state && known.state.inputs.some(function (own) { return own.key === shape.refusal.key; });
    say(at("grey-word"), isSought ? "Not solved yet." : "Not solved.");
    say(at("grey-why"), shape.solved || isPlaced ? "" : reason);
    var tip = shape.numbers.filter(function (own) { return own.key === "tip_twist_deg"; })[0];
    if (isWaiting() || !tip) return;
    var text = shape.solved ? "tip twist " + spoken(tip.value, "deg") : isSought ? "being solved from rest" : "not solved: " + reason;
    if (text !== before) speak(text);
    before = text;
  });

  // A solve that is quick needs no word.
  hear("waiting", function (isIt) {
    window.clearTimeout(slow);
    if (!isIt) at("solving").hidden = true;
    else slow = window.setTimeout(function () { at("solving").hidden = !isWaiting(); }, 250);
  });

  hear("reached", function (isIt) {
    if (isIt === isReached) return;
    isReached = isIt;
    notice(isIt ? null : "The program does not answer. Was it ended with Ctrl-C? The page tries again.");
  });

  hear("refused", function (own) { if (!own.isPlaced) notice(words(own.refusal)); });
  hear("accepted", function () { if (isReached) notice(null); });
  at("notice-close").addEventListener("click", function () { notice(null); });
}

// A sentence above everything, until it is closed or something succeeds.
function notice(text) {
  at("notice").hidden = !text;
  say(at("notice-text"), text || "");
}
