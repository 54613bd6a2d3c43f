// The inputs, in groups that open and close.

var GROUPS = ["Motion", "Air", "Rods", "Spars", "Film", "Root", "Mass", "Uncertain", "Other"];

function inputs(ask) {
  var holder = at("inputs-groups"), movers = {}, signature = "", revision = null, isOpen = { Motion: true, Air: true };

  function build(state) {
    movers = {};
    var names = state.inputs.map(function (own) { return own.group; });
    var all = GROUPS.concat(names).filter(function (name, k, list) { return names.indexOf(name) >= 0 && list.indexOf(name) === k; });
    fill(holder, all.map(function (name, place) {
      var own = state.inputs.filter(function (one) { return one.group === name; });
      if (!(name in isOpen)) isOpen[name] = place === 0;
      var group = make("details", { open: isOpen[name], ontoggle: function () { isOpen[name] = group.open; } }, [
        make("summary", {}, [make("span", {}, name), make("span", { "class": "count", "data-group": name })])
      ].concat(own.map(function (one) {
        var mine = mover(one, function (value, isDrag) { return ask.set(one.key, value, isDrag); });
        mine.group = group;
        movers[one.key] = { own: mine, group: name };
        return mine.box;
      })));
      return group;
    }));
  }

  hear("state", function (state) {
    var words = JSON.stringify([state.file, state.inputs.map(function (own) {
      return [own.key, own.label, own.unit, own.low, own.high, own.step, own.original, own.plausible, own.group];
    })]);
    if (words !== signature) build(state);
    signature = words;
    var moved = {}, isNew = state.revision !== revision;
    revision = state.revision;
    state.inputs.forEach(function (own) {
      if (isNew && own.key !== known.refusedAt) movers[own.key].own.refuse(null);
      movers[own.key].own.show(own.value);
      if (own.value !== own.original) moved[own.group] = (moved[own.group] || 0) + 1;
    });
    Array.from(holder.querySelectorAll(".count")).forEach(function (count) {
      var many = moved[count.getAttribute("data-group")];
      say(count, many ? many + " changed" : "");
    });
  });

  function refuse(what, words) {
    var found = movers[what];
    if (!found) return false;
    found.own.refuse(words);
    if (words) {
      found.own.release();
      found.own.box.closest("details").open = true;
    }
    return true;
  }

  hear("accepted", function (what) { refuse(what, null); });
  hear("refused", function (own) {
    own.isPlaced = refuse(own.what, words(own.refusal)) || refuse(own.refusal.key, words(own.refusal)) || own.isPlaced;
  });
  // What the solver refuses is said at its input, until a shape is there again.
  hear("shape", function (shape) {
    if (known.refusedAt) refuse(known.refusedAt, null);
    known.refusedAt = null;
    if (shape.refusal && shape.refusal.key && refuse(shape.refusal.key, shape.refusal.message)) known.refusedAt = shape.refusal.key;
  });
}
