// The twist as it grows: the frame that is shown, the others, and what is still to be clicked.

function twist(camera) {
  var own = chart("curve", { title: "Twist along the span", y: { label: "twist, washout positive", unit: "deg" }, least: 4 });
  var told = at("told"), table_of = at("readings"), lacks = at("lacks");

  function points(report) {
    var names = [];
    report.readings.forEach(function (one) { if (names.indexOf(one.frame) < 0) names.push(one.frame); });
    var shown = names.filter(function (name) { return name !== frameName(); }).slice(0, 3).concat(names.indexOf(frameName()) < 0 ? [] : frameName());
    return shown.map(function (name, k) {
      var list = report.readings.filter(function (one) { return one.frame === name; });
      function pick(key) { return list.map(function (one) { return one[key]; }); }
      return { name: name, look: name === frameName() ? "measured" : "rest", mark: k, x: pick("r_mm"), y: pick("twist_deg"), sigma: pick("sigma_deg"), bound: pick("bound") };
    });
  }

  function summary(report) {
    var text = "An error of " + plain(report.sigma_px, 2) + " px in a click, " + (report.sigma_kind === "repeats" ? "as repeats scatter" : "as stated") + ".";
    if (known.state.told.is_assumed) text = "The errors are those of clicks that err by 1 px, which is a guess: click each point twice, or say by how much a click errs.";
    var isTwisted = report.readings.filter(function (one) { return one.twist_deg < -2 * one.sigma_deg; }).length;
    if (2 * isTwisted > report.readings.length) text += " Most of the twist is negative: is the right frame ticked as untwisted?";
    var frames = report.readings.map(function (one) { return one.frame; }).filter(function (name, k, all) { return all.indexOf(name) === k; }).length;
    if (frames > points(report).length) text += " The picture shows " + points(report).length + " of " + frames + " frames, the table all.";
    return text + (report.few_repeats ? " The repeats are few: click more points twice." : "");
  }

  function missing(state) {
    fill(lacks, state.told.lacks.slice(0, 6).map(function (one) {
      return make("li", {}, [titleOf(one.mark, one.r_mm) + " is not clicked in " + one.frame + " ", make("button", {
        type: "button", onclick: function () {
          tell("go", state.frames.indexOf(one.frame));
          choose({ mark: one.mark, r: one.r_mm });
        }
      }, "Go there")]);
    }).concat(state.told.lacks.length > 6 ? make("li", {}, "and " + (state.told.lacks.length - 6) + " more points") : []));
  }

  function show(state) {
    var report = state.told.report, refusal = state.told.refusal;
    own.show({ lines: [], points: report ? points(report) : [], bands: [] }, { heads: [], rows: function () { return []; } });
    say(told, report ? summary(report) : refusal && !camera.has(refusal.key) ? needed(refusal) : refusal ? "No twist yet: see how the camera stood." : "");
    fill(table_of, !report ? [] : table("Twist", ["frame", "r (mm)", "twist (deg)", "\u03c3 (deg)", "shared (deg)", ""], report.readings.map(function (one) {
      return [one.frame, plain(one.r_mm, 5), plain(tidy(one.twist_deg), 4), plain(one.sigma_deg, 2), plain(tidy(one.shared_deg), 2), { none: "", lower: "at least", upper: "at most" }[one.bound]];
    })));
    missing(state);
  }

  hear("state", show);
  hear("frame", function () { show(known.state); });
}
