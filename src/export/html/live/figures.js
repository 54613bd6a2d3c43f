// The numbers of the shape, each with its unit and what it differs by from the wing as stated.

function figures() {
  var holder = at("figures"), shown = {}, signature = "", first = {};

  function rows(shape) {
    var own = shape.numbers.filter(function (one) { return isNumber(one.value); }).slice();
    var count = shape.count || (shape.residuals || []).length;
    if (isNumber(shape.chi2)) {
      own.push({ key: "chi2", label: "chi-square" + (count ? " of " + count + (count === 1 ? " reading" : " readings") : ""), value: shape.chi2, unit: "" });
    }
    if (isNumber(shape.rms_deg)) own.push({ key: "rms_deg", label: known.state && known.state.of === "study" ? "rms error, as set" : "rms error", value: shape.rms_deg, unit: "deg" });
    if (isNumber(shape.mesh_error_deg)) own.push({ key: "mesh_error_deg", label: "mesh error", value: shape.mesh_error_deg, unit: "deg", isOwn: true });
    return own;
  }

  function build(own) {
    shown = {};
    fill(holder, own.map(function (one) {
      var value = make("span", { "class": "value" }), change = make("span", { "class": "change" });
      shown[one.key] = { value: value, change: change };
      return make("div", { "class": one.key === "tip_twist_deg" ? "main" : null }, [
        make("dt", { title: one.more }, one.label), make("dd", {}, [make("span", {}, [value, make("small", {}, one.unit === "1" ? "" : " " + one.unit)]), change])
      ]);
    }));
  }

  hear("shape", function (shape) {
    var own = rows(shape), words = own.map(function (one) { return one.key + one.label; }).join();
    if (words !== signature) build(own);
    signature = words;
    var before = first[shape.case] = first[shape.case] || {};
    holder.classList.toggle("stale", !shape.solved);
    own.forEach(function (one) {
      if (isNumber(one.original) || !(one.key in before)) before[one.key] = isNumber(one.original) ? one.original : one.value;
      var by = one.value - before[one.key];
      say(shown[one.key].value, plain(tidy(one.value), 3));
      var isMoved = !one.isOwn && Math.abs(by) > 0.002 * Math.abs(one.value) + 1e-9;
      say(shown[one.key].change, isMoved ? signed(by, 2) : "");
      shown[one.key].change.title = isMoved ? "as stated: " + withUnit(before[one.key], one.unit) : "";
    });
  });
  hear("state", function (state) {
    if (holder.hasAttribute("data-of") && holder.getAttribute("data-of") !== state.file) first = {};
    holder.setAttribute("data-of", state.file);
  });
}
