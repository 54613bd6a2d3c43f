// The effects that can be added to the model: a list to search, and a slider for the strength of each that is in.

function effects(ask) {
  var chosen = at("effects-in"), list = at("effects-list"), search = at("effects-search"), signature = "", inside = "", found = "", revision = null, movers = {}, rows = [], atNothing = null;

  // A strength to begin with: the middle of what is plausible, or its far end where that is none.
  function first(own) {
    var range = own.plausible || [own.low, own.high], middle = (range[0] + range[1]) / 2;
    return Number((Math.abs(middle - own.none) > 1e-12 ? middle : range[1]).toPrecision(3));
  }

  // One that is moved to nothing keeps its slider, until it is taken out or something else is brought back.
  function isIn(own) { return isNumber(own.value) || own.name === atNothing; }

  function build(state) {
    rows = state.effects.map(function (own) {
      var put = make("button", { type: "button", title: "At a strength that is set by hand", onclick: function () { ask.effect(own.name, first(own), false); } }, "Try");
      put.ariaLabel = "Try " + own.title;
      return {
        name: own.name, put: put, words: (own.name + " " + own.title + " " + own.sentence + " " + own.acts_on).toLowerCase(),
        box: make("li", {}, [
          make("span", { "class": "row" }, [make("strong", {}, own.title), put]),
          make("span", { "class": "quiet" }, own.sentence)
        ])
      };
    });
    fill(list, rows.map(function (row) { return row.box; }));
    find();
  }

  function buildInside(state) {
    var hadFocus = chosen.contains(document.activeElement);
    movers = {};
    fill(chosen, state.effects.filter(isIn).map(function (own) {
      var mine = mover({
        label: own.title, unit: own.unit, low: own.low, high: own.high, step: own.step, value: own.value || own.none, original: null, plausible: own.plausible
      }, function (value, isDrag) {
        if (value === own.none) atNothing = own.name;
        return ask.effect(own.name, value, isDrag);
      });
      movers[own.name] = mine;
      var out = make("button", { type: "button", "class": "out", title: "Take it out", onclick: function () {
        atNothing = null;
        ask.effect(own.name, null, false);
      } }, "\u00d7");
      out.ariaLabel = "Take out " + own.title;
      mine.box.replaceChild(out, mine.box.querySelector(".back"));
      // What is either there or not has no strength to move.
      if (own.all_or_none) mine.box.querySelector(".track").remove();
      if (own.all_or_none) mine.box.querySelector(".typed").remove();
      mine.box.appendChild(make("p", { "class": "meaning" }, own.sentence));
      if (own.meaning) mine.box.appendChild(make("p", { "class": "meaning" }, own.meaning));
      return mine.box;
    }));
    if (hadFocus) search.focus();
  }

  function find() {
    var asked = search.value.trim().toLowerCase().split(/\s+/), many = 0;
    rows.forEach(function (row) {
      row.box.hidden = row.isIn || !asked.every(function (word) { return row.words.indexOf(word) >= 0; });
      many += row.box.hidden ? 0 : 1;
    });
    say(at("effects-found"), search.value.trim() ? many + " found" : "");
  }

  hear("state", function (state) {
    var words = state.file + state.effects.map(function (own) { return own.name; }).join();
    if (words !== signature) build(state);
    var now = words + state.effects.filter(isIn).map(function (own) { return own.name; }).join();
    if (now !== inside) buildInside(state);
    signature = words;
    inside = now;
    var isOther = now !== found;
    found = now;
    rows.forEach(function (row, k) { row.isIn = isIn(state.effects[k]); });
    var isNew = state.revision !== revision;
    revision = state.revision;
    state.effects.filter(isIn).forEach(function (own) {
      if (isNew) movers[own.name].refuse(null);
      movers[own.name].show(own.value || own.none);
    });
    var many = state.effects.filter(function (own) { return isNumber(own.value); }).length;
    say(at("effects-count"), many ? many + " in the model" : "none in the model");
    if (isOther) find();
  });
  search.addEventListener("input", find);

  function refuse(what, words) {
    var found = movers[String(what).replace(/^effects?[:.]/, "").replace(/\.strength$/, "")];
    if (!found) return false;
    found.refuse(words);
    if (words) found.release();
    return true;
  }
  hear("accepted", function (what) {
    if (/^(undo|redo|reset|add|open|table\/confirm)$/.test(what)) atNothing = null;
    refuse(what, null);
  });
  hear("refused", function (own) { own.isPlaced = refuse(own.what, words(own.refusal)) || own.isPlaced; });
}
