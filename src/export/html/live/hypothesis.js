// One hypothesis: its probability as a bar, where on the wing it acts, its strength, what it would do to the curve, and a way to add it.

function hypothesis(ask, own, index) {
  var asked = false, isAdding = false, note = make("span", { "class": "quiet", role: "status" }), curve = own.curve || null;

  function strength(one) {
    var unit = one.unit === "1" ? "" : one.unit;
    return one.effect + " = " + plain(one.value, 3) + (one.standard_error > 0 ? " \u00b1 " + plain(one.standard_error, 2) : "") + (unit ? " " + unit : "") + (one.meaning ? " (" + one.meaning + ")" : "");
  }

  // How many degrees it makes on the case that is shown, where it makes most.
  function size() {
    var model = known.shape && known.shape.solved ? { x: known.shape.twist.r_mm, y: known.shape.twist.twist_deg } : null, most = 0, where = 0;
    if (!model || !curve) return;
    curve.r_mm.forEach(function (r, k) {
      var there = along(model, r);
      if (there !== null && isNumber(curve.twist_deg[k]) && Math.abs(curve.twist_deg[k] - there) > Math.abs(most)) {
        most = curve.twist_deg[k] - there;
        where = r;
      }
    });
    say(note, most ? "makes " + signed(most, 2) + "\u00b0 here, at " + plain(Math.round(where), 4) + " mm" : "");
  }

  // On hover and on focus its curve stands beside the model.
  function look() {
    if (curve) tell("tried", Object.assign({ name: own.title }, curve));
    else if (!asked && ask.hypothesis) {
      asked = true;
      ask.hypothesis(index).then(function (found) {
        curve = found;
        size();
        if (curve && box.matches(":hover, :focus-within")) look();
      });
    }
  }
  function leave() { tell("tried", null); }

  var percent = share(own.probability);
  var bar = make("span", { "class": "probability", "aria-hidden": "true" }, make("span", {}));
  bar.firstChild.style.width = 100 * Math.max(0.005, Math.min(1, own.probability)) + "%";
  var add = make("button", {
    type: "button", hidden: !own.can_add, title: "Its strength is fitted to all readings", onclick: function () {
      if (isAdding) return ask.stop();
      leave();
      busy(true);
      return ask.add(index).then(function () { busy(false); });
    }
  }, "Add");
  // Its strengths are fitted, which takes some seconds; until then the button stops it.
  function busy(isIt) {
    isAdding = isIt;
    add.textContent = isIt ? "Stop" : "Add";
    add.ariaLabel = isIt ? "Stop adding " + own.title : "Add " + own.title + " to the model";
    say(note, isIt ? "fitting its strength \u2026" : "");
  }
  add.ariaLabel = "Add " + own.title + " to the model";
  var box = make("li", { onpointerenter: look, onpointerleave: leave, onfocusin: look, onfocusout: leave }, [
    place(own.effects),
    make("div", { "class": "what" }, [
      make("span", { "class": "row" }, [make("strong", {}, own.title), make("span", { "class": "percent" }, percent)]), bar,
      make("span", {}, own.sentence || ""),
      make("span", { "class": "quiet" }, (own.strengths || []).map(strength).join(", ") + (own.in_set === false ? " \u2013 outside the 95 % set" : "")), note
    ]),
    add
  ]);
  // What is in the model already is not added again.
  function hold(state) {
    if (isAdding || !state) return;
    var isIn = own.effects.every(function (name) { return state.effects.some(function (one) { return one.name === name && isNumber(one.value); }); });
    add.disabled = isIn;
    add.textContent = isIn ? "In the model" : "Add";
  }
  hold(known.state);
  return { box: box, hold: hold };
}

// A small wing that shows what an effect acts on: the rod, the film, the root, the tip, the air or the camera.
function place(names) {
  var svg = document.createElementNS(SVG, "svg"), seams = names.map(seamOf);
  dress(svg, { viewBox: "0 0 44 26", width: 44, height: 26, "class": "place", "aria-hidden": "true" });
  function on(seam) { return seams.indexOf(seam) >= 0 ? "on" : "off"; }
  draw(svg, "path", { "class": "film " + on("film"), d: "M3 7H41C41 15 33 22 20 22C10 22 3 19 3 13Z" });
  draw(svg, "path", { "class": "spars " + on("spars"), d: "M14 7V21M26 7V21M36 7V16" });
  draw(svg, "path", { "class": "rod " + on("rod"), d: "M3 7H41" });
  if (on("air") === "on") draw(svg, "path", { "class": "air on", d: "M8 3q3 -3 6 0t6 0t6 0t6 0" });
  if (on("root") === "on") draw(svg, "circle", { "class": "root on", cx: 4, cy: 9, r: 3.5 });
  if (on("tip") === "on") draw(svg, "circle", { "class": "root on", cx: 40, cy: 9, r: 3.5 });
  if (on("picture") === "on") draw(svg, "path", { "class": "air on", d: "M10 11h24v9h-24zM19 11l2 -3h4l2 3" });
  return svg;
}

function seamOf(name) {
  var found = known.state && known.state.effects.filter(function (own) { return own.name === name; })[0];
  var words = name + " " + (found ? found.acts_on : "");
  var seams = [["root", /root|hinge|stop/], ["tip", /^tip|tip-/], ["spars", /spar|rib/], ["rod", /rod|torsion|warping|shear/], ["film", /film|skin|slack/], ["picture", /picture|camera|instrument/]];
  var hit = seams.filter(function (own) { return own[1].test(words); })[0];
  return hit ? hit[0] : "air";
}

// A probability in words; never one of 0 or 1.
function share(value) {
  return value >= 0.995 ? "> 99 %" : value < 0.01 ? "< 1 %" : Math.round(100 * value) + " %";
}
