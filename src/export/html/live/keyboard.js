// Keys for everything; `?` lists them. `parts`: what needs the program, and is not there without it.

function keyboard(parts) {
  var box = at("keys-box"), isOn = at("keys-on");

  function press(name) {
    return function () {
      var own = at(name);
      if (own && !own.disabled && !own.hidden) own.click();
    };
  }
  function focus(find) {
    return function () {
      var own = find();
      if (own) own.focus();
    };
  }
  var all = [["?", "this list", help], ["u", "undo (also Ctrl+Z)", press("undo")], ["r", "redo (also Ctrl+Y)", press("redo")]].concat(!parts.save ? [] : [
    ["m", "what is missing?", press("ask")], ["x", "stop the search", press("stop")],
    ["a", "add the hypothesis in focus, else the first", add],
    ["s", "save", parts.save.open], ["o", "open a table, a design or a study", parts.sheet.choose],
    ["]", "next case", function () { parts.cases.step(1, false); }], ["[", "case before", function () { parts.cases.step(-1, false); }]
  ], [
    ["w", "to the wing", focus(function () { return at("wing-canvas"); })],
    ["c", "to the curve", focus(function () { return document.querySelector("#curve .plot"); })],
    ["i", "to the inputs", focus(function () {
      return document.querySelector("#inputs-groups details[open] input[type=range]") || document.querySelector("#inputs-groups summary");
    })],
    ["/", "to the search of effects", focus(function () { return at("effects-search"); })]
  ]);

  function add() {
    var focused = document.activeElement.closest && document.activeElement.closest(".hypotheses li");
    var own = (focused || document).querySelector(".hypotheses button:not([disabled])");
    if (own) own.click();
  }

  function help() {
    if (box.open) return;
    box.showModal();
  }

  fill(at("keys"), all.map(function (own) { return make("div", {}, [make("dt", {}, key(own[0])), make("dd", {}, own[1])]); }).concat([
    make("div", {}, [make("dt", {}, key("\u2190 \u2192")), make("dd", {}, "on a slider: less, more; on a picture: move along the span; on the wing: turn it")]),
    make("div", {}, [make("dt", {}, key("0")), make("dd", {}, "on the wing: the view at first")]),
    make("div", {}, [make("dt", {}, key("Backspace")), make("dd", {}, "on a slider: back to the value as stated")])
  ]));
  at("help").addEventListener("click", help);
  at("keys-close").addEventListener("click", function () { box.close(); });

  function isTyping(own) {
    return own.tagName === "TEXTAREA" || own.tagName === "SELECT" || (own.tagName === "INPUT" && own.type !== "range" && own.type !== "checkbox");
  }

  window.addEventListener("keydown", function (event) {
    if (document.querySelector("dialog[open]")) return;
    var name = event.key.toLowerCase();
    if ((event.ctrlKey || event.metaKey) && !event.altKey && !isTyping(event.target)) {
      var own = name === "z" ? (event.shiftKey ? "redo" : "undo") : name === "y" ? "redo" : null;
      if (!own) return;
      event.preventDefault();
      press(own)();
      return;
    }
    if (event.ctrlKey || event.metaKey || event.altKey || !isOn.checked || isTyping(event.target)) return;
    var found = all.filter(function (one) { return one[0] === event.key; })[0];
    if (!found) return;
    event.preventDefault();
    found[2]();
  });
}
