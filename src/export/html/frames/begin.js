// Everything is put together, and the program is asked for the first time.

function begin() {
  document.querySelector("main").className = "frames";
  var shown = strip(), view = picture(), form = camera();
  points();
  guidesPanel();
  twist(form);
  saving();
  keys(view);
  function notice(text) {
    at("notice").hidden = !text;
    say(at("notice-text"), text || "");
  }
  at("notice-close").addEventListener("click", function () { notice(null); });
  hear("notice", notice);
  hear("go", shown.go);
  hear("reached", function (isReached) { if (!isReached) notice("The program does not answer. What you click now is lost when the page is closed."); });
  hear("refused", function (refusal) { notice(words(refusal)); });
  function ask() {
    var isEmpty = !allPoints().length;
    if (guides().tool) return say(at("next-point"), guides().tool === "axis" ? "Click two points on the line through the wing base." : "Click two points whose distance you know.");
    if (!marks().video.rest && !marks().clicks.length) return say(at("next-point"), "Go to a frame that shows the wing untwisted, if there is one, and tick it. Then " + (isEmpty ? "add a station." : "click: " + titleOf((current || allPoints()[0]).mark, (current || allPoints()[0]).r)));
    if (isEmpty && (!current || !/^reference/.test(current.mark))) return say(at("next-point"), "Add a station: its distance from the wing base.");
    say(at("next-point"), current ? "Now click: " + titleOf(current.mark, current.r) : "All points of this frame are clicked.");
  }
  hear("current", function () {
    notice(null);
    ask();
  });
  hear("state", ask);
  hear("tool", ask);
  hear("state", function (state) {
    say(at("name"), state.marks.video.name);
    document.title = (state.is_dirty ? "\u2022 " : "") + state.marks.video.name + " \u2013 washout";
    at("dirty").hidden = !state.is_dirty;
    at("undo").disabled = !known.past.length;
    at("redo").disabled = !known.future.length;
  });
  fetched("marks").then(function (state) {
    learn(state);
    tell("frame", 0);
    advance();
    choose(current);
  }, function () { tell("reached", false); });
}

begin();
