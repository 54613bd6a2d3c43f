// Undo, redo, and back to the start; the buttons say what they take back.

function history(ask) {
  function button(name, word, does) {
    var own = at(name);
    own.addEventListener("click", does);
    return function (words, shortcut) {
      own.disabled = !words;
      own.title = words ? word + ": " + words + " (" + shortcut + ")" : word + ": nothing";
      own.ariaLabel = words ? word + ": " + words : word;
    };
  }
  var undo = button("undo", "Undo", ask.undo), redo = button("redo", "Redo", ask.redo), reset = button("reset", "Back to the start", ask.reset);

  hear("state", function (state) {
    undo(state.undo, "u");
    redo(state.redo, "r");
    var isMoved = !!state.undo || state.inputs.some(function (own) { return own.value !== own.original; });
    reset(isMoved ? "all as it was loaded; this can be undone" : null, "no key");
    say(at("name"), state.name);
    document.title = (state.dirty ? "\u2022 " : "") + state.name + " \u2013 washout";
    at("dirty").hidden = !state.dirty;
    at("open").hidden = state.takes_files === false;
  });
}
