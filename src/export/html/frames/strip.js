// Which frame is shown; which one shows the wing untwisted.

function strip() {
  var list = at("frame"), rest = at("is-rest");

  function go(index) {
    if (index < 0 || index >= known.state.frames.length || index === known.frame) return;
    known.frame = index;
    tell("frame", index);
    advance();
  }

  function show() {
    if (list.options.length !== known.state.frames.length) {
      fill(list, known.state.frames.map(function (name, k) { return make("option", { value: k }, name); }));
    }
    known.state.frames.forEach(function (name, k) {
      var count = marks().clicks.filter(function (own) { return own.frame === name; }).length;
      say(list.options[k], name + (marks().video.rest === name ? " (untwisted)" : "") + (count ? " \u2022 " + count : ""));
    });
    list.value = known.frame;
    rest.checked = marks().video.rest === frameName();
    at("frame-before").disabled = known.frame === 0;
    at("frame-next").disabled = known.frame === known.state.frames.length - 1;
  }

  list.addEventListener("change", function () { go(Number(list.value)); });
  at("frame-before").addEventListener("click", function () { go(known.frame - 1); });
  at("frame-next").addEventListener("click", function () { go(known.frame + 1); });
  rest.addEventListener("change", function () {
    change(function (own) { own.video.rest = rest.checked ? frameName() : null; });
  });
  hear("state", show);
  hear("frame", show);
  return { go: go };
}
