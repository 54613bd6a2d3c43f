// The points of a frame: both edges at each station, and two points that do not move. One is the next to be clicked.

var MARKS = { leading: "leading edge", trailing: "trailing edge", reference_a: "reference a", reference_b: "reference b" };
var current = { mark: "leading", r: null };

function titleOf(mark, r) { return MARKS[mark] + (r === null ? "" : " at " + plain(r, 5) + " mm"); }

function isSame(point, mark, r) { return point && point.mark === mark && point.r === r; }

// All points of a frame in the order in which they are clicked; references once one of them was clicked somewhere, or chosen.
function allPoints() {
  var found = [];
  marks().stations_mm.forEach(function (r) { found.push({ mark: "leading", r: r }, { mark: "trailing", r: r }); });
  var isReferred = marks().clicks.some(function (own) { return own.r_mm === null; });
  if (isReferred) found.push({ mark: "reference_a", r: null }, { mark: "reference_b", r: null });
  return found;
}

function wanted() { return Number(at("repeats").value); }

function isDone(point) { return clicksOn(point.mark, point.r).length >= wanted(); }

// The next point that still wants a click, from the current one on.
function advance() {
  var all = allPoints(), from = 0;
  all.forEach(function (point, k) { if (isSame(current, point.mark, point.r)) from = k; });
  for (var k = 0; k < all.length; k++) {
    var own = all[(from + k) % all.length];
    if (!isDone(own)) return choose(own);
  }
  choose(null);
}

function choose(point) {
  current = point;
  tell("current", point);
}

// One point on or back.
function step(by) {
  var all = allPoints(), here = -1;
  if (!all.length) return;
  all.forEach(function (point, k) { if (isSame(current, point.mark, point.r)) here = k; });
  choose(all[(here + by + all.length) % all.length]);
}

// A click of this frame for the current point; the next one is chosen.
function mark(x, y) {
  if (!allPoints().length && !(current && /^reference/.test(current.mark))) return tell("notice", "Add a station first: its distance from the wing base.");
  if (!current) return tell("notice", "All points of this frame are clicked. Choose one to click it again, or go to the next frame (n).");
  var point = current;
  change(function (own) {
    own.clicks.push({ frame: frameName(), r_mm: point.r, mark: point.mark, x_px: round(x), y_px: round(y) });
  });
  say(at("heard"), titleOf(point.mark, point.r) + " set at " + Math.round(x) + ", " + Math.round(y));
  if (isDone(point)) advance();
  else tell("current", point);
}

function round(px) { return Math.round(100 * px) / 100; }

// The clicks on the current point, or the last one of them.
function unmark() {
  var list = current ? clicksOn(current.mark, current.r) : [];
  if (!list.length) return;
  change(function (own) { own.clicks.splice(own.clicks.lastIndexOf(list[list.length - 1]), 1); });
  say(at("heard"), "one click on " + titleOf(current.mark, current.r) + " removed");
}

function addStation(r) {
  change(function (own) {
    if (own.stations_mm.indexOf(r) < 0) own.stations_mm = own.stations_mm.concat(r).sort(function (a, b) { return a - b; });
  });
}

function points() {
  var list = at("points-list"), form = at("station-form"), field = at("station"), refused = at("station-refused");

  function cell(mark, r, name) {
    var count = clicksOn(mark, r).length, isOn = isSame(current, mark, r);
    return make("td", {}, make("button", {
      type: "button", "aria-pressed": isOn ? "true" : "false", "aria-label": titleOf(mark, r) + ", " + (count ? count + " clicks" : "not clicked"),
      onclick: function () {
        choose({ mark: mark, r: r });
        at("picture").focus();
      }
    }, (name || "") + (count >= wanted() ? "✓ " + count : count ? count + " of " + wanted() : "–")));
  }

  function remove(r) {
    return make("td", {}, make("button", {
      type: "button", "class": "out", title: "Remove the station and its clicks in all frames", "aria-label": "Remove the station at " + r + " mm",
      onclick: function () {
        change(function (own) {
          own.stations_mm = own.stations_mm.filter(function (other) { return other !== r; });
          own.clicks = own.clicks.filter(function (click) { return click.r_mm !== r; });
        });
        advance();
      }
    }, "×"));
  }

  function show() {
    if (!known.state) return;
    var focused = document.activeElement && list.contains(document.activeElement) ? document.activeElement.getAttribute("aria-label") : null;
    var rows = marks().stations_mm.map(function (r) {
      return make("tr", {}, [make("th", { scope: "row", "class": "n" }, plain(r, 5)), cell("leading", r), cell("trailing", r), remove(r)]);
    });
    var head = make("thead", {}, make("tr", {}, ["station (mm)", "leading", "trailing", ""].map(function (word) { return make("th", { scope: "col" }, word); })));
    var references = make("tr", {}, [make("th", { scope: "row" }, "two points that do not move (if the camera does)"), cell("reference_a", null, "a "), cell("reference_b", null, "b "), make("td", {})]);
    fill(list, make("table", {}, [head, make("tbody", {}, rows.concat(references))]));
    if (focused) [].forEach.call(list.querySelectorAll("button"), function (own) {
      if (own.getAttribute("aria-label").split(",")[0] === focused.split(",")[0]) own.focus();
    });
  }

  form.addEventListener("submit", function (event) {
    event.preventDefault();
    var all = field.value.split(/[;\s]+|,(?=\s)/).filter(Boolean).map(typed);
    var isBad = !all.length || all.some(function (r) { return r === null || r < 0 || r > 100000; });
    refused.hidden = !isBad;
    if (isBad) return say(refused, "Give distances from the wing base in millimetres, from 0 on, e.g. 35 or 20 40 60.");
    all.forEach(addStation);
    if (!current || current.r === null) choose(null);
    advance();
    field.value = "";
  });
  at("repeats").addEventListener("change", function () {
    advance();
    show();
  });
  // A station that was taken back is not to be clicked.
  hear("state", function () {
    if (current && current.r !== null && marks().stations_mm.indexOf(current.r) < 0) advance();
    else show();
  });
  hear("current", show);
  hear("frame", show);
}
