// How numbers are written and read.

var plain = wingView.plain;

function isNumber(value) { return typeof value === "number" && isFinite(value); }

// What is left of a sum that is zero is none.
function tidy(value) { return Math.abs(value) < 1e-9 ? 0 : value; }

// With its unit; degrees as a sign.
function withUnit(value, unit, digits) {
  var text = plain(tidy(value), digits || 4);
  return unit === "deg" ? text + "\u00b0" : unit && unit !== "1" ? text + " " + unit : text;
}

function signed(value, digits) { return (value > 0 ? "+" : "") + plain(value, digits); }

// As it is spoken.
function spoken(value, unit) {
  var names = { deg: "degrees", mm: "millimetres", Hz: "hertz", mN: "millinewtons", mW: "milliwatts", "1": "" };
  return (plain(tidy(value), 3).replace("\u2212", "minus ") + " " + (unit in names ? names[unit] : unit)).trim();
}

// What somebody typed: a comma is a point; nothing if it is no number.
function typed(text) {
  var value = Number(text.trim().replace(",", ".").replace("\u2212", "-"));
  return text.trim() !== "" && isFinite(value) ? value : null;
}

// Round steps that cut a stretch into about `count`.
function ticks(low, high, count) {
  var rough = (high - low) / count, decade = Math.pow(10, Math.floor(Math.log10(rough))), share = rough / decade;
  var step = decade * (share > 5 ? 10 : share > 2 ? 5 : share > 1 ? 2 : 1), found = [];
  for (var k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(Number((k * step).toPrecision(12)));
  return { step: step, at: found };
}

// A curve between its points; nothing beside it.
function along(curve, x) {
  for (var k = 1; k < curve.x.length; k++) {
    var from = curve.x[k - 1], to = curve.x[k];
    if (x < Math.min(from, to) || x > Math.max(from, to) || from === to) continue;
    var share = (x - from) / (to - from), low = curve.y[k - 1], high = curve.y[k];
    return isNumber(low) && isNumber(high) ? low + share * (high - low) : null;
  }
  return null;
}
