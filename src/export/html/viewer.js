// The wing in 3D: own code, no library, no network. Painter's algorithm on a 2D canvas: a wing has some thousand triangles,
// and a canvas is there where WebGL is not. The page without it shows a still picture instead.
(function () {
  "use strict";
  var holder = document.getElementById("wing-data");
  var canvas = document.getElementById("wing-canvas");
  if (!holder || !canvas || !canvas.getContext) return;
  var data = JSON.parse(holder.textContent);
  var pen = canvas.getContext("2d");
  var controls = document.getElementById("wing-controls");
  var bar = document.getElementById("wing-bar");
  var home = { turn: -0.45, tilt: 0.5, zoom: 1 };
  var view = { turn: home.turn, tilt: home.tilt, zoom: 1, wing: 0, field: 0, ghost: -1, scale: 1 };
  var frames = 0, waiting = false;

  data.wings.forEach(prepare);

  // Edges that belong to one triangle only are the outline.
  function prepare(wing) {
    var seen = {};
    for (var t = 0; t < wing.triangles.length; t += 3) {
      for (var k = 0; k < 3; k++) {
        var a = wing.triangles[t + k], b = wing.triangles[t + (k + 1) % 3];
        var key = Math.min(a, b) + "," + Math.max(a, b);
        seen[key] = seen[key] ? null : [a, b];
      }
    }
    wing.outline = Object.keys(seen).map(function (key) { return seen[key]; }).filter(Boolean);
  }

  // Micrometres are stored as whole numbers; shown are millimetres.
  function shape(wing, scale) {
    var out = new Float64Array(wing.rest.length);
    for (var i = 0; i < out.length; i++) out[i] = (wing.rest[i] + scale * (wing.loaded[i] - wing.rest[i])) / 1000;
    return out;
  }

  function middle(wing) {
    var low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    [wing.rest, wing.loaded].forEach(function (points) {
      for (var i = 0; i < points.length; i++) {
        low[i % 3] = Math.min(low[i % 3], points[i] / 1000);
        high[i % 3] = Math.max(high[i % 3], points[i] / 1000);
      }
    });
    return {
      at: [0, 1, 2].map(function (k) { return (low[k] + high[k]) / 2; }),
      size: Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) || 1
    };
  }

  // One scale of colours for all wings, so that they can be held against each other.
  function reach(name) {
    var low = Infinity, high = -Infinity;
    data.wings.forEach(function (wing) {
      wing.fields.forEach(function (field) {
        if (field.name !== name) return;
        field.values.forEach(function (value) { low = Math.min(low, value); high = Math.max(high, value); });
      });
    });
    return high > low ? [low, high] : [low - 0.5, low + 0.5];
  }

  function colour(share) {
    var map = data.map, at = Math.max(0, Math.min(1, share)) * (map.length - 1);
    var k = Math.min(map.length - 2, Math.floor(at)), part = at - k;
    return "rgb(" + [0, 1, 2].map(function (c) {
      return Math.round((map[k][c] + part * (map[k + 1][c] - map[k][c])));
    }).join(",") + ")";
  }

  // x along the span to the right, z up, y away from the eye; then turned about z and tilted.
  function camera(points, centre, width, height) {
    var ct = Math.cos(view.turn), st = Math.sin(view.turn), ci = Math.cos(view.tilt), si = Math.sin(view.tilt);
    var far = 2.6 * centre.size;
    var unit = view.zoom * Math.min(0.98 * width / centre.size, 1.9 * height / centre.size) * far;
    var out = new Float64Array(points.length);
    for (var i = 0; i < points.length; i += 3) {
      var x = points[i] - centre.at[0], y = points[i + 1] - centre.at[1], z = points[i + 2] - centre.at[2];
      var right = ct * x - st * y, away = st * x + ct * y;
      var up = ci * z + si * away, depth = ci * away - si * z + far;
      out[i] = width / 2 + unit * right / depth;
      out[i + 1] = height / 2 - unit * up / depth;
      out[i + 2] = depth;
    }
    return out;
  }

  function ink(name) { return getComputedStyle(document.documentElement).getPropertyValue(name).trim() || "#777"; }

  function draw() {
    waiting = false;
    var box = canvas.getBoundingClientRect(), dense = Math.min(window.devicePixelRatio || 1, 3);
    var width = Math.max(1, Math.round(box.width)), height = Math.max(1, Math.round(box.height));
    if (canvas.width !== width * dense || canvas.height !== height * dense) {
      canvas.width = width * dense;
      canvas.height = height * dense;
    }
    pen.setTransform(dense, 0, 0, dense, 0, 0);
    pen.clearRect(0, 0, width, height);
    var wing = data.wings[view.wing], centre = middle(wing);
    var field = wing.fields[Math.min(view.field, wing.fields.length - 1)];
    if (view.ghost > -2) ghost(wing, centre, width, height);
    film(wing, field, camera(shape(wing, view.scale), centre, width, height));
    triad(height);
    legend(field);
    frames += 1;
    canvas.setAttribute("data-frames", frames);
    canvas.setAttribute("data-drawn", wing.name + ": " + field.name);
  }

  // -1: the unloaded shape of the wing itself; from 0: another state of it.
  function ghost(wing, centre, width, height) {
    var other = view.ghost >= 0 ? data.wings[view.ghost] : wing;
    var at = camera(shape(other, view.ghost >= 0 ? view.scale : 0), centre, width, height);
    var triangles = other.triangles;
    pen.beginPath();
    for (var t = 0; t < triangles.length; t += 3) {
      for (var k = 0; k < 3; k++) {
        var n = 3 * triangles[t + k];
        if (k) pen.lineTo(at[n], at[n + 1]); else pen.moveTo(at[n], at[n + 1]);
      }
      pen.closePath();
    }
    pen.globalAlpha = 0.16;
    pen.fillStyle = ink("--quiet");
    pen.fill();
    pen.globalAlpha = 1;
    pen.strokeStyle = ink("--quiet");
    pen.lineWidth = 1.2;
    pen.setLineDash([5, 4]);
    pen.beginPath();
    other.outline.forEach(function (edge) {
      pen.moveTo(at[3 * edge[0]], at[3 * edge[0] + 1]);
      pen.lineTo(at[3 * edge[1]], at[3 * edge[1] + 1]);
    });
    pen.stroke();
    pen.setLineDash([]);
  }

  function film(wing, field, at) {
    var triangles = wing.triangles, lines = wing.lines, range = reach(field.name), parts = [];
    for (var t = 0; t < triangles.length; t += 3) {
      var a = 3 * triangles[t], b = 3 * triangles[t + 1], c = 3 * triangles[t + 2];
      parts.push([(at[a + 2] + at[b + 2] + at[c + 2]) / 3, t / 3, a, b, c]);
    }
    for (var l = 0; l < lines.length; l += 3) {
      var d = 3 * lines[l], e = 3 * lines[l + 1];
      // A hair nearer than the film it is glued to.
      parts.push([(at[d + 2] + at[e + 2]) / 2 * 0.997, -1, d, e, lines[l + 2]]);
    }
    parts.sort(function (p, q) { return q[0] - p[0]; });
    var rod = ink("--ink");
    parts.forEach(function (part) {
      pen.beginPath();
      pen.moveTo(at[part[2]], at[part[2] + 1]);
      pen.lineTo(at[part[3]], at[part[3] + 1]);
      if (part[1] < 0) {
        pen.strokeStyle = rod;
        pen.lineWidth = part[4] === 1 ? 3 : 1.4;
        pen.lineCap = "round";
        pen.stroke();
        return;
      }
      pen.lineTo(at[part[4]], at[part[4] + 1]);
      pen.closePath();
      var value = field.on === "cells" ? field.values[part[1]]
        : (field.values[part[2] / 3] + field.values[part[3] / 3] + field.values[part[4] / 3]) / 3;
      pen.fillStyle = pen.strokeStyle = colour((value - range[0]) / (range[1] - range[0]));
      pen.lineWidth = 0.7;
      pen.fill();
      pen.stroke();
    });
  }

  function triad(height) {
    var ct = Math.cos(view.turn), st = Math.sin(view.turn), ci = Math.cos(view.tilt), si = Math.sin(view.tilt);
    var from = [46, height - 40];
    pen.strokeStyle = pen.fillStyle = ink("--quiet");
    pen.lineWidth = 1.5;
    pen.font = "12px sans-serif";
    [["span", ct, si * st], ["chord", -st, si * ct], ["z", 0, ci]].forEach(function (axis) {
      var to = [from[0] + 26 * axis[1], from[1] - 26 * axis[2]];
      pen.beginPath();
      pen.moveTo(from[0], from[1]);
      pen.lineTo(to[0], to[1]);
      pen.stroke();
      pen.fillText(axis[0], to[0] + 3, to[1] - 2);
    });
  }

  function plain(value) {
    var size = Math.abs(value);
    return size !== 0 && size < 0.01 ? value.toExponential(1) : String(Number(value.toPrecision(3)));
  }

  function legend(field) {
    var range = reach(field.name), stops = data.map.map(function (rgb) { return "rgb(" + rgb.join(",") + ")"; });
    bar.querySelector(".strip").style.background = "linear-gradient(to right," + stops.join(",") + ")";
    bar.querySelector(".low").textContent = plain(range[0]);
    bar.querySelector(".mid").textContent = field.name + " (" + field.unit + ")";
    bar.querySelector(".high").textContent = plain(range[1]);
  }

  function soon() {
    if (waiting) return;
    waiting = true;
    window.requestAnimationFrame(draw);
  }

  function choice(label, names, chosen, apply) {
    var box = document.createElement("label"), list = document.createElement("select");
    names.forEach(function (entry) {
      var option = document.createElement("option");
      option.value = entry[0];
      option.textContent = entry[1];
      list.appendChild(option);
    });
    list.value = chosen;
    list.addEventListener("change", function () { apply(Number(list.value)); soon(); });
    box.appendChild(document.createTextNode(label + " "));
    box.appendChild(list);
    controls.appendChild(box);
  }

  // A ghost must be a state of the same wing: of as many points.
  function ghosts() {
    var names = [[-1, "unloaded"], [-2, "none"]], own = data.wings[view.wing];
    data.wings.forEach(function (wing, index) {
      if (index !== view.wing && wing.rest.length === own.rest.length) names.push([index, wing.name]);
    });
    return names;
  }

  function build() {
    controls.textContent = "";
    if (data.wings.length > 1) {
      choice("Wing", data.wings.map(function (wing, index) { return [index, wing.name]; }), view.wing, function (index) {
        view.wing = index;
        view.ghost = Math.min(view.ghost, -1);
        build();
      });
    }
    var fields = data.wings[view.wing].fields;
    choice("Colour", fields.map(function (field, index) { return [index, field.name]; }), view.field, function (index) {
      view.field = index;
    });
    choice("Ghost", ghosts(), view.ghost, function (index) { view.ghost = index; });
    choice("Deformation", [[1, "as it is"], [2, "× 2"], [5, "× 5"], [0, "none"]], view.scale, function (scale) {
      view.scale = scale;
    });
  }

  function turn(right, down) {
    view.turn += right;
    view.tilt = Math.max(-1.57, Math.min(1.57, view.tilt + down));
    soon();
  }

  function zoom(by) {
    view.zoom = Math.max(0.3, Math.min(20, view.zoom * by));
    soon();
  }

  var fingers = {};
  function spread() {
    var at = Object.keys(fingers).map(function (id) { return fingers[id]; });
    return at.length < 2 ? 0 : Math.hypot(at[0][0] - at[1][0], at[0][1] - at[1][1]);
  }
  canvas.addEventListener("pointerdown", function (event) {
    fingers[event.pointerId] = [event.clientX, event.clientY];
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", function (event) {
    var from = fingers[event.pointerId];
    if (!from) return;
    var before = spread();
    fingers[event.pointerId] = [event.clientX, event.clientY];
    if (before > 0) zoom(spread() / before);
    else turn(0.009 * (event.clientX - from[0]), 0.009 * (event.clientY - from[1]));
  });
  ["pointerup", "pointercancel"].forEach(function (name) {
    canvas.addEventListener(name, function (event) { delete fingers[event.pointerId]; });
  });
  // The wheel scrolls the page unless the picture was clicked.
  canvas.addEventListener("wheel", function (event) {
    if (document.activeElement !== canvas) return;
    event.preventDefault();
    zoom(Math.exp(-0.0015 * event.deltaY));
  }, { passive: false });
  canvas.addEventListener("keydown", function (event) {
    var keys = {
      ArrowLeft: function () { turn(-0.1, 0); }, ArrowRight: function () { turn(0.1, 0); },
      ArrowUp: function () { turn(0, -0.1); }, ArrowDown: function () { turn(0, 0.1); },
      "+": function () { zoom(1.15); }, "=": function () { zoom(1.15); }, "-": function () { zoom(1 / 1.15); },
      "0": function () { view.turn = home.turn; view.tilt = home.tilt; zoom(1 / view.zoom); }
    };
    if (!keys[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key]();
  });
  window.addEventListener("resize", soon);
  window.addEventListener("beforeprint", draw);
  if (window.matchMedia) {
    var dark = window.matchMedia("(prefers-color-scheme: dark)");
    if (dark.addEventListener) dark.addEventListener("change", soon);
  }

  document.getElementById("wing-live").hidden = false;
  document.getElementById("wing-still").hidden = true;
  build();
  draw();
})();
