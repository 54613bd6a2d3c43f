// The error, step by step: a bar for the readings that are fitted, a diamond for those held out, a line where the noise begins.

function ladder() {
  var holder = at("ladder-steps"), signature = "";

  function bar(step, most, noise) {
    function place(value) { return 100 * Math.min(1, value / most) + "%"; }
    var own = make("div", { "class": "bar", "aria-hidden": "true" });
    var fitted = make("span", { "class": "fitted" });
    fitted.style.width = isNumber(step.rms_deg) ? place(step.rms_deg) : "0";
    own.appendChild(fitted);
    if (isNumber(step.held_out_rms_deg)) {
      var held = make("span", { "class": "held" });
      held.style.left = place(step.held_out_rms_deg);
      own.appendChild(held);
    }
    if (isNumber(noise)) {
      var floor = make("span", { "class": "floor" });
      floor.style.left = place(noise);
      own.appendChild(floor);
    }
    return own;
  }

  hear("state", function (state) {
    var words = JSON.stringify([state.ladder, state.noise_deg]);
    if (words === signature) return;
    signature = words;
    var steps = state.ladder, hasHeld = steps.some(function (step) { return isNumber(step.held_out_rms_deg); });
    at("ladder").hidden = !steps.length;
    if (!steps.length) return;
    var most = isNumber(state.noise_deg) ? 1.2 * state.noise_deg : 0;
    steps.forEach(function (step) { most = Math.max(most, step.rms_deg || 0, step.held_out_rms_deg || 0); });
    most = 1.03 * most || 1;
    var heads = ["step", "", "rms (deg)"].concat(hasHeld ? ["held out (deg)"] : [], ["chi-square / readings"]);
    fill(holder, make("table", {}, [
      make("caption", { "class": "unseen" }, "The error, step by step"),
      make("thead", {}, make("tr", {}, heads.map(function (text, k) { return make("th", { scope: "col", "class": k > 1 ? "n" : null }, text); }))),
      make("tbody", {}, steps.map(function (step) {
        return make("tr", {}, [
          make("th", { scope: "row" }, step.label), make("td", { "class": "wide" }, bar(step, most, state.noise_deg)),
          make("td", { "class": "n" }, isNumber(step.rms_deg) ? plain(step.rms_deg, 3) : isNumber(step.chi2) ? "\u2013" : "\u2026")
        ].concat(hasHeld ? [make("td", { "class": "n" }, isNumber(step.held_out_rms_deg) ? plain(step.held_out_rms_deg, 3) : "")] : [], [
          make("td", { "class": "n" }, isNumber(step.chi2) ? plain(step.chi2, 3) + (step.count ? " / " + step.count : "") : "")
        ]));
      }))
    ]));
    fill(at("ladder-key"), [
      make("span", { "class": "key" }, [make("span", { "class": "fitted" }), hasHeld ? "readings that are fitted" : "readings"]),
      hasHeld ? make("span", { "class": "key" }, [make("span", { "class": "held" }), "held out"]) : null,
      isNumber(state.noise_deg) ? make("span", { "class": "key" }, [make("span", { "class": "floor" }), "noise " + withUnit(state.noise_deg, "deg", 2)]) : null
    ]);
  });
}
