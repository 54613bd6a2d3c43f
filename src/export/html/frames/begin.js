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
  hear("current", function (point) {
    notice(null);
    say(at("next-point"), !point ? "All points of this frame are clicked." : point.r === null && !/^reference/.test(point.mark) ? "Add a station: its distance from the wing base." : "Now click: " + titleOf(point.mark, point.r));
  });
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
    if (!current) choose(allPoints().length ? null : { mark: "leading", r: null });
  }, function () { tell("reached", false); });
}

begin();
