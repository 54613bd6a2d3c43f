// A picture along the span: axes with units, curves, readings with their errors, and what stands at a place under the cursor or the
// arrow keys. Behind it stands the same as a table.

var FRAME = { left: 44, right: 14, top: 20, bottom: 34 };

// `name`: of the element; `spec`: { title, x, y: { label, unit }, least: the smallest height of the y axis, isEven: as far below 0 as above }.
function chart(name, spec) {
  var holder = at(name), plot = make("div", { "class": "plot", tabindex: "0", role: "slider", "aria-orientation": "horizontal" });
  var readout = make("p", { "class": "readout", "aria-hidden": "true" }), legend = make("span", { "class": "legend" });
  var behind = make("details", { "class": "behind" }, make("summary", {}, "As a table")), svg = null, marks = null;
  var content = null, reach = null, room = null, place = null, rows = null;
  plot.setAttribute("aria-label", spec.title + ": read at a place along the span");
  fill(holder, [make("div", { "class": "head" }, [make("h2", {}, spec.title), legend]), plot, make("div", { "class": "below" }, [readout, behind])]);

  function lines() { return content.lines.filter(function (own) { return own.x.length > 1; }); }

  // The y axis keeps its ends while what is drawn fits and fills half of it: a curve that moves is seen to move.
  function ends() {
    var low = Infinity, high = -Infinity;
    function take(value) {
      if (!isNumber(value)) return;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    lines().forEach(function (own) { own.y.forEach(take); });
    content.points.forEach(function (own) {
      own.y.forEach(function (value, k) {
        take(value - (own.sigma ? own.sigma[k] || 0 : 0));
        take(value + (own.sigma ? own.sigma[k] || 0 : 0));
      });
    });
    content.bands.forEach(function (own) { own.low.concat(own.high).forEach(take); });
    take(0);
    if (spec.isEven) low = -(high = Math.max(-low, high));
    if (!(high - low >= (spec.least || 0))) {
      high = low < 0 && spec.isEven ? spec.least / 2 : Math.max(high, low + (spec.least || 1));
      if (spec.isEven) low = -high;
    }
    if (reach && (low < 0) === (reach[0] < 0) && low >= reach[0] && high <= reach[1] && high - low > 0.5 * (reach[1] - reach[0])) return;
    var step = ticks(low, high, steps()).step;
    reach = [Math.floor(low / step - 0.05) * step, Math.ceil(high / step + 0.05) * step];
    reach.step = step;
    if (low === 0) reach[0] = 0;
    if (high === 0) reach[1] = 0;
  }

  // As many as there is room for.
  function steps() { return Math.max(2, Math.min(5, Math.round(room.tall / 38))); }

  function stretch() {
    var most = 1;
    lines().concat(content.bands).forEach(function (own) { own.x.forEach(function (x) { most = Math.max(most, x); }); });
    // A reading at the very end would stand on the border.
    content.points.forEach(function (own) { own.x.forEach(function (x) { most = Math.max(most, lines().length ? x : 1.03 * x); }); });
    return most;
  }

  function xAt(x) { return FRAME.left + x / room.most * room.wide; }
  function yAt(y) { return FRAME.top + (reach[1] - y) / (reach[1] - reach[0]) * room.tall; }

  // The steps that the ends were rounded to, unless they have become too narrow.
  function upward() {
    var many = (reach[1] - reach[0]) / reach.step;
    return ticks(reach[0], reach[1], room.tall / many > 20 ? many : steps());
  }

  function frame() {
    var across = ticks(0, room.most, room.wide / 70), up = upward();
    up.at.forEach(function (y) {
      draw(svg, "line", { "class": y === 0 ? "zero" : "grid", x1: FRAME.left, x2: FRAME.left + room.wide, y1: yAt(y), y2: yAt(y) });
      draw(svg, "text", { x: FRAME.left - 6, y: yAt(y) + 4, "text-anchor": "end" }, plain(y, 4));
    });
    across.at.forEach(function (x) {
      draw(svg, "line", { "class": "grid", x1: xAt(x), x2: xAt(x), y1: FRAME.top + room.tall, y2: FRAME.top + room.tall + 4 });
      draw(svg, "text", { x: xAt(x), y: FRAME.top + room.tall + 16, "text-anchor": "middle" }, plain(x, 4));
    });
    draw(svg, "text", { x: 2, y: 11, "class": "axis" }, spec.y.label + " (" + spec.y.unit + ")");
    draw(svg, "text", { x: FRAME.left + room.wide, y: room.height - 4, "text-anchor": "end", "class": "axis" }, "distance from the base (mm)");
  }

  function path(own) {
    var text = "", isOn = false;
    own.x.forEach(function (x, k) {
      if (!isNumber(own.y[k])) isOn = false;
      else {
        text += (isOn ? "L" : "M") + xAt(x).toFixed(1) + " " + yAt(own.y[k]).toFixed(1);
        isOn = true;
      }
    });
    return text;
  }

  function band(own) {
    var there = own.x.map(function (x, k) { return xAt(x).toFixed(1) + " " + yAt(own.high[k]).toFixed(1); });
    var back = own.x.map(function (x, k) { return xAt(x).toFixed(1) + " " + yAt(own.low[k]).toFixed(1); }).reverse();
    draw(svg, "path", { "class": "band " + own.look, d: "M" + there.concat(back).join("L") + "Z" });
  }

  function readings(own) {
    own.x.forEach(function (x, k) {
      if (!isNumber(own.y[k]) || !isNumber(x)) return;
      var left = xAt(x), top = yAt(own.y[k]), sigma = own.sigma && own.sigma[k], bound = own.bound && own.bound[k];
      // A bound is a stroke with an arrow to the side that it allows, and no reading.
      if (bound === "upper" || bound === "lower") {
        var way = bound === "upper" ? 1 : -1;
        draw(svg, "path", { "class": "error " + own.look, d: "M" + (left - 6) + " " + top + "h12M" + left + " " + top + "v" + 14 * way + "m-4 " + -5 * way + "l4 " + 5 * way + "l4 " + -5 * way });
        return;
      }
      if (sigma) {
        var low = yAt(own.y[k] - sigma), high = yAt(own.y[k] + sigma);
        draw(svg, "path", { "class": "error " + own.look, d: "M" + left + " " + low + "V" + high + "M" + (left - 3) + " " + low + "h6M" + (left - 3) + " " + high + "h6" });
      }
      if (own.isStem) draw(svg, "line", { "class": "error " + own.look, x1: left, x2: left, y1: yAt(0), y2: top });
      draw(svg, "path", { "class": "reading " + own.look, d: shapeOf(own.mark || 0, left, top) });
    });
  }

  function render() {
    var wide = plot.clientWidth, tall = plot.clientHeight;
    if (!content || wide < 60 || tall < 60) return;
    room = { wide: wide - FRAME.left - FRAME.right, tall: tall - FRAME.top - FRAME.bottom, height: tall, most: stretch() };
    ends();
    if (svg) svg.remove();
    svg = draw(plot, "svg", { width: wide, height: tall, viewBox: "0 0 " + wide + " " + tall, "aria-hidden": "true" });
    content.bands.filter(function (own) { return own.x.length; }).forEach(band);
    frame();
    lines().forEach(function (own) { draw(svg, "path", { "class": "curve " + own.look, d: path(own) }); });
    content.points.forEach(readings);
    marks = draw(svg, "g", {});
    point();
  }

  // What stands at a place.
  function told(x) {
    var parts = lines().map(function (own) {
      var value = along(own, x);
      return value === null ? null : own.name + " " + withUnit(value, spec.y.unit, 3);
    });
    content.points.forEach(function (own) {
      var near = nearest(own, x);
      if (near !== null) {
        var sigma = own.sigma && own.sigma[near];
        parts.push(own.name + " " + withUnit(own.y[near], spec.y.unit, 3) + (sigma ? " \u00b1 " + withUnit(sigma, spec.y.unit, 2) : ""));
      }
    });
    return plain(Number(x.toFixed(1)), 4) + " mm: " + parts.filter(Boolean).join(", ");
  }

  function nearest(own, x) {
    var least = 0.02 * room.most, found = null;
    own.x.forEach(function (at, k) {
      if (Math.abs(at - x) < least) {
        least = Math.abs(at - x);
        found = k;
      }
    });
    return found;
  }

  function point() {
    if (marks) marks.textContent = "";
    var x = place === null ? null : Math.max(0, Math.min(room ? room.most : 0, place));
    dress(plot, { "aria-valuemin": 0, "aria-valuemax": room ? Number(room.most.toFixed(1)) : 0, "aria-valuenow": Number((x || 0).toFixed(1)) });
    if (x === null || !room || !content) {
      say(readout, "");
      plot.setAttribute("aria-valuetext", "arrow keys move along the span");
      return;
    }
    draw(marks, "line", { "class": "cursor", x1: xAt(x), x2: xAt(x), y1: FRAME.top, y2: FRAME.top + room.tall });
    lines().forEach(function (own) {
      var value = along(own, x);
      if (value !== null) draw(marks, "circle", { "class": "dot " + own.look, cx: xAt(x), cy: yAt(value), r: 3.5 });
    });
    var text = told(x);
    say(readout, text);
    plot.setAttribute("aria-valuetext", text);
  }

  plot.addEventListener("pointermove", function (event) {
    if (!room) return;
    place = (event.clientX - plot.getBoundingClientRect().left - FRAME.left) / room.wide * room.most;
    point();
  });
  plot.addEventListener("pointerleave", function () {
    place = null;
    point();
  });
  plot.addEventListener("keydown", function (event) {
    if (!room) return;
    var steps = { ArrowLeft: -0.01, ArrowRight: 0.01, ArrowDown: -0.01, ArrowUp: 0.01, PageDown: -0.1, PageUp: 0.1, Home: -2, End: 2 };
    if (!(event.key in steps) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    place = Math.max(0, Math.min(room.most, (place === null ? 0 : place) + steps[event.key] * room.most));
    point();
  });
  behind.addEventListener("toggle", tabulate);
  if (window.ResizeObserver) new ResizeObserver(function () { window.requestAnimationFrame(render); }).observe(plot);

  function tabulate() {
    if (!behind.open || !rows) return;
    while (behind.children.length > 1) behind.lastChild.remove();
    behind.appendChild(table(spec.title, rows.heads, rows.rows()));
  }

  function key() {
    var all = content.lines.concat(content.points).filter(function (own) { return own.x.length; });
    var words = all.map(function (own) { return own.look + (own.mark || 0) + own.name; }).join();
    if (legend.getAttribute("data-of") === words) return;
    legend.setAttribute("data-of", words);
    fill(legend, all.map(function (own) { return make("span", { "class": "key " + own.look }, [sample(own), make("span", { "class": "name", title: own.name }, own.name)]); }));
  }

  return {
    // `own`: { lines: [{ name, look, x, y }], points: [{ name, look, mark, x, y, sigma, isStem }], bands: [{ look, x, low, high }] };
    // `behindIt`: { heads, rows: a function }.
    show: function (own, behindIt) {
      content = own;
      rows = behindIt;
      render();
      key();
      tabulate();
    }
  };
}

// Readings of several runs or quantities are told apart by their marks.
function shapeOf(mark, x, y) {
  var s = 4;
  return [
    "M" + (x - s) + " " + y + "a" + s + " " + s + " 0 1 0 " + 2 * s + " 0a" + s + " " + s + " 0 1 0 " + -2 * s + " 0Z",
    "M" + (x - s) + " " + (y - s) + "h" + 2 * s + "v" + 2 * s + "h" + -2 * s + "Z",
    "M" + x + " " + (y - s - 1) + "L" + (x + s + 1) + " " + y + "L" + x + " " + (y + s + 1) + "L" + (x - s - 1) + " " + y + "Z",
    "M" + x + " " + (y - s - 1) + "L" + (x + s + 1) + " " + (y + s) + "H" + (x - s - 1) + "Z"
  ][mark % 4];
}

// A short piece of a curve, or one reading, for the legend.
function sample(own) {
  var svg = document.createElementNS(SVG, "svg");
  dress(svg, { width: 22, height: 12, "aria-hidden": "true" });
  if (own.sigma !== undefined || own.isStem) draw(svg, "path", { "class": "reading " + own.look, d: shapeOf(own.mark || 0, 11, 6) });
  else draw(svg, "path", { "class": "curve " + own.look, d: "M1 6H21" });
  return svg;
}
