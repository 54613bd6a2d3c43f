// Twist along the span: the model, the readings with their errors, the curve as stated, and what a hypothesis would do.

function curve() {
  var own = chart("curve", { title: "Twist along the span", y: { label: "twist, washout positive", unit: "deg" }, least: 2 });
  var tried = null;

  function show(shape) {
    var twist = shape.twist, original = known.original[shape.case], lines = [];
    if (original && !same(original.twist_deg, twist.twist_deg)) {
      lines.push({ name: original.name || "as stated", look: "ghost", x: original.r_mm, y: original.twist_deg });
    }
    var before = known.before && known.before.case === shape.case ? known.before.twist : null;
    if (before && original && !same(before.twist_deg, twist.twist_deg) && !same(before.twist_deg, original.twist_deg)) {
      lines.push({ name: "before", look: "before", x: before.r_mm, y: before.twist_deg });
    }
    lines.push({ name: shape.solved ? "model" : "last solved", look: shape.solved ? "model" : "stale", x: twist.r_mm, y: twist.twist_deg });
    if (tried) lines.push({ name: "with " + tried.name, look: "tried", x: tried.r_mm, y: tried.twist_deg });
    var points = (twist.measured || []).map(function (run, k) {
      var name = twist.measured.length > 1 && run.run ? "measured, " + run.run : "measured";
      return { name: name, look: "measured", mark: k, x: run.r_mm, y: run.twist_deg, sigma: run.sigma_deg || [], bound: run.bound || [] };
    });
    own.show({ lines: lines, points: points, bands: [] }, {
      heads: ["distance from the base (mm)"].concat(lines.map(function (line) { return line.name + " (deg)"; })),
      rows: function () {
        return twist.r_mm.map(function (r) {
          return [r].concat(lines.map(function (line) { return along(line, r); }));
        });
      }
    });
  }

  // What is shown is the model as it is set; the error step by step has the calibrated ones.
  hear("state", function (state) { say(at("curve").querySelector("h2"), "Twist along the span" + (state.of === "study" ? ", not calibrated" : "")); });
  hear("shape", show);
  // A curve to hold against the model, or null.
  hear("tried", function (other) {
    tried = other;
    soon();
  });
}

function same(a, b) {
  return a.length === b.length && a.every(function (value, k) { return Math.abs(value - b[k]) < 1e-3; });
}
