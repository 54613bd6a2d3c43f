// Millimetres on the picture: a line through the wing base across the span, and two points whose distance is known. They place
// stations, and are no part of the measurement.

var tool = null, ends = [];

// What is set: { axis, scale: two points each, or none; mm: length of the scale; tool: which is being set }.
function guides() {
  var own = known.state ? known.state.marks.guides : {};
  return { axis: tool === "axis" ? ends : own.axis, scale: tool === "scale" ? ends : own.scale, mm: own.mm, tool: tool };
}

// Distance of a place from the base line, mm; nothing while one of both is missing.
function millimetres(x, y) {
  var own = guides();
  if (own.axis.length < 2 || own.scale.length < 2 || !own.mm) return null;
  var a = own.axis[0], b = own.axis[1], c = own.scale[0], d = own.scale[1];
  var perPx = own.mm / Math.hypot(d[0] - c[0], d[1] - c[1]), long = Math.hypot(b[0] - a[0], b[1] - a[1]);
  return Math.abs((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / long * perPx;
}

// The line on which a station lies, on the side of the base line where a place is; nothing while it is not known.
function lineAt(r, place) {
  var own = guides(), a = own.axis[0], b = own.axis[1], here = millimetres(place[0], place[1]);
  if (here === null || here < 1e-6) return null;
  var long = Math.hypot(b[0] - a[0], b[1] - a[1]), side = (b[0] - a[0]) * (place[1] - a[1]) - (b[1] - a[1]) * (place[0] - a[0]);
  var px = r / here * Math.abs(side) / long * Math.sign(side), x = -(b[1] - a[1]) / long * px, y = (b[0] - a[0]) / long * px;
  return [[a[0] + x, a[1] + y], [b[0] + x, b[1] + y]];
}

// A click for a guide that is being set; whether it was one.
function guide(x, y) {
  if (!tool) return false;
  if (ends.length === 1 && Math.hypot(x - ends[0][0], y - ends[0][1]) < 1) return true;
  ends.push([round(x), round(y)]);
  if (ends.length === 2) {
    var own = tool, both = ends;
    tool = null;
    change(function (marks) { marks.guides[own] = both; });
  }
  tell("tool", tool);
  return true;
}

function guidesPanel() {
  var told = at("scale-told"), field = at("scale-mm");

  function show() {
    if (!known.state) return;
    var own = guides();
    ["axis", "scale"].forEach(function (name) { at("tool-" + name).setAttribute("aria-pressed", tool === name ? "true" : "false"); });
    var length = own.scale.length === 2 ? Math.hypot(own.scale[1][0] - own.scale[0][0], own.scale[1][1] - own.scale[0][1]) : null;
    say(told, length && own.mm ? plain(length / own.mm, 4) + " px per mm" : "");
    if (document.activeElement !== field) field.value = own.mm ? String(own.mm) : "";
  }

  ["axis", "scale"].forEach(function (name) {
    at("tool-" + name).addEventListener("click", function () {
      tool = tool === name ? null : name;
      ends = [];
      tell("tool", tool);
      if (tool) at("picture").focus();
    });
  });
  field.addEventListener("change", function () {
    var value = typed(field.value);
    field.setAttribute("aria-invalid", value > 0 ? "false" : "true");
    if (value > 0) change(function (own) { own.guides.mm = value; });
  });
  hear("tool", show);
  hear("state", show);
}
