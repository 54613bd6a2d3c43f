// The angle of attack along the span, and the residuals: measured minus modelled in units of their standard deviation.

function attack() {
  var own = chart("attack", { title: "Angle of attack", y: { label: "angle of attack", unit: "deg" }, least: 2 });
  hear("shape", function (shape) {
    var angle = shape.angle_of_attack;
    at("attack").hidden = !angle;
    if (!angle) return;
    own.show({ lines: [{ name: "model", look: shape.solved ? "model" : "stale", x: angle.r_mm, y: angle.deg }], points: [], bands: [] }, {
      heads: ["distance from the base (mm)", "angle of attack (deg)"],
      rows: function () { return angle.r_mm.map(function (r, k) { return [r, angle.deg[k]]; }); }
    });
  });
}

function residuals() {
  var own = chart("residuals", {
    title: "Measured minus model, not calibrated (grey: 1 and 2 \u03c3)", y: { label: "difference", unit: "\u03c3" }, least: 4, isEven: true
  });
  var rest = make("p", { "class": "quiet" });
  at("residuals").appendChild(rest);
  hear("shape", function (shape) {
    var all = shape.residuals || [], placed = all.filter(function (one) { return isNumber(one.r_mm); });
    at("residuals").hidden = !all.length;
    if (!all.length) return;
    var kinds = [];
    all.forEach(function (one) { if (kinds.indexOf(one.quantity) < 0) kinds.push(one.quantity); });
    var most = Math.max.apply(null, [1].concat(shape.twist.r_mm, placed.map(function (one) { return one.r_mm; })));
    own.show({
      lines: [],
      points: kinds.map(function (kind, k) {
        var found = placed.filter(function (one) { return one.quantity === kind; });
        return {
          name: kind, look: "measured", mark: k, isStem: true,
          x: found.map(function (one) { return one.r_mm; }), y: found.map(function (one) { return one.in_sigma; })
        };
      }),
      bands: [{ look: "two", x: [0, most], low: [-2, -2], high: [2, 2] }, { look: "one", x: [0, most], low: [-1, -1], high: [1, 1] }]
    }, {
      heads: ["reading", "at (mm)", "measured", "model", "\u03c3", "unit", "in \u03c3"],
      rows: function () {
        return all.map(function (one) { return [one.quantity, one.r_mm, one.measured, one.modelled, one.sigma, one.unit || "", one.in_sigma]; });
      }
    });
    say(rest, all.filter(function (one) { return !isNumber(one.r_mm); }).map(function (one) {
      return one.quantity + " " + signed(one.in_sigma, 2) + " \u03c3";
    }).join(", "));
  });
}
