// Keys for everything; `?` lists them.

function keys(view) {
  var box = at("keys-box"), isOn = at("keys-on");

  function press(name) { return function () { if (!at(name).disabled) at(name).click(); }; }

  function station() {
    var r = view.here();
    if (r === null) return tell("notice", "Set the base line and the scale first: Stations from the picture.");
    addStation(Math.round(10 * r) / 10);
    choose({ mark: "leading", r: Math.round(10 * r) / 10 });
  }

  var all = [
    ["n", "next frame", press("frame-next")], ["b", "frame before", press("frame-before")], ["j", "next point", function () { step(1); }],
    ["k", "point before", function () { step(-1); }], ["Delete", "remove the last click on the current point", unmark],
    ["Backspace", "the same", unmark], ["t", "make a station of the place under the cross", station], ["+", "larger", press("zoom-in")],
    ["-", "smaller", press("zoom-out")], ["0", "the whole frame", press("zoom-fit")], ["u", "undo (also Ctrl+Z)", press("undo")],
    ["r", "redo (also Ctrl+Y)", press("redo")], ["s", "save", press("save")], ["p", "to the picture", function () { at("picture").focus(); }],
    ["?", "this list", function () { if (!box.open) box.showModal(); }]
  ];

  fill(at("keys"), all.map(function (own) { return make("div", {}, [make("dt", {}, key(own[0])), make("dd", {}, own[1])]); }).concat([
    make("div", {}, [make("dt", {}, key("\u2190 \u2191 \u2192 \u2193")), make("dd", {}, "on the picture: move the cross (Shift: far, Alt: a quarter)")]),
    make("div", {}, [make("dt", {}, key("Escape")), make("dd", {}, "out of a field")]),
    make("div", {}, [make("dt", {}, key("Enter")), make("dd", {}, "on the picture: set the current point there")])
  ]));
  at("help").addEventListener("click", function () { box.showModal(); });
  at("keys-close").addEventListener("click", function () { box.close(); });
  at("undo").addEventListener("click", undo);
  at("redo").addEventListener("click", redo);

  function isTyping(own) { return own.tagName === "SELECT" || own.tagName === "TEXTAREA" || (own.tagName === "INPUT" && own.type !== "checkbox"); }

  window.addEventListener("keydown", function (event) {
    // Out of a field, so that letters are keys again.
    if (event.key === "Escape" && isTyping(event.target)) event.target.blur();
    if (event.key === "Enter" && event.target.tagName === "INPUT" && event.target.id !== "station") event.target.blur();
    if (document.querySelector("dialog[open]") || isTyping(event.target) || event.altKey || !known.state) return;
    var name = event.key.toLowerCase(), does = null;
    if (event.ctrlKey || event.metaKey) does = name === "z" ? (event.shiftKey ? redo : undo) : name === "y" ? redo : null;
    else if (isOn.checked || event.key.length > 1) does = (all.filter(function (one) { return one[0] === event.key; })[0] || [])[2];
    if (!does) return;
    event.preventDefault();
    does();
  });
}
