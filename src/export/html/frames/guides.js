// Millimetres on the picture: a line through the wing base across the span, and two points whose distance is known. They place
// stations, and are no part of the measurement.

var guides = { axis: [], scale: [], mm: null, tool: null };

// Distance of a place from the base line, mm; nothing while one of both is missing.
function millimetres(x, y) {
  if (guides.axis.length < 2 || guides.scale.length < 2 || !guides.mm) return null;
  var a = guides.axis[0], b = guides.axis[1], c = guides.scale[0], d = guides.scale[1];
  var perPx = guides.mm / Math.hypot(d[0] - c[0], d[1] - c[1]), long = Math.hypot(b[0] - a[0], b[1] - a[1]);
  return Math.abs((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / long * perPx;
}

// A click for a guide that is being set; whether it was one.
function guide(x, y) {
  if (!guides.tool) return false;
  var own = guides[guides.tool];
  if (own.length === 2) own.length = 0;
  if (own.length === 1 && Math.hypot(x - own[0][0], y - own[0][1]) < 1) return true;
  own.push([x, y]);
  if (own.length === 2) guides.tool = null;
  tell("guides", guides);
  return true;
}

function guidesPanel() {
  var told = at("scale-told"), field = at("scale-mm");

  function show() {
    ["axis", "scale"].forEach(function (name) { at("tool-" + name).setAttribute("aria-pressed", guides.tool === name ? "true" : "false"); });
    var isWhole = guides.axis.length === 2 && guides.scale.length === 2 && guides.mm;
    var length = guides.scale.length === 2 ? Math.hypot(guides.scale[1][0] - guides.scale[0][0], guides.scale[1][1] - guides.scale[0][1]) : null;
    say(told, isWhole ? plain(length / guides.mm, 4) + " px per mm" : guides.tool ? "Click two points in the frame." : "");
    if (guides.tool) at("picture").focus();
  }

  ["axis", "scale"].forEach(function (name) {
    at("tool-" + name).addEventListener("click", function () {
      guides.tool = guides.tool === name ? null : name;
      if (guides.tool) guides[name].length = 0;
      tell("guides", guides);
    });
  });
  field.addEventListener("change", function () {
    var value = typed(field.value);
    guides.mm = value > 0 ? value : null;
    field.setAttribute("aria-invalid", value > 0 ? "false" : "true");
    tell("guides", guides);
  });
  hear("guides", show);
}
