// The wing in 3D: what is shown, and what mouse, fingers and keys do to it. The page without it shows a still picture.

function start(canvas) {
  var pen = webgl(canvas) || painter(canvas);
  if (!pen) return null;
  // `load`: share of the way from the unloaded to the loaded shape; `phase`: index into the stroke while that is shown.
  var state = { wing: 0, field: "twist", ghost: "rest", times: 1, mode: "load", load: 1, phase: 0, isPlaying: null, isStale: false };
  var part = function (name) { return document.getElementById("wing-" + name); };
  var waiting = false, playing = null, cursor = null;
  // Ends of the colours of what was shown first, where one wing takes the place of another.
  var kept = { isOn: false };
  // What is shown once the stroke is left.
  var coming = null;
  // Made when they are needed: what is drawn, the room that it takes, the ends of the colours; and where it lies on the screen.
  var layers = null, box = null, range = null, screen = null, seen = null, points = null;
  var isStill = function () { return !!window.matchMedia && matchMedia("(prefers-reduced-motion: reduce)").matches; };

  data.wings.forEach(prepare);

  function wing() { return data.wings[state.wing]; }
  function phase() { return state.mode === "stroke" ? wing().stroke[state.phase] : null; }
  function field() { return fieldOf(wing(), phase(), state.field); }
  function share() { return state.times * (phase() ? 1 : state.load); }
  function now() { return phase() ? shapeAtPhase(wing(), phase(), share()) : shape(wing(), share()); }

  // All that is shown of this wing: the picture keeps its frame while it moves.
  function frame() {
    if (phase()) return strokeFrame();
    var clouds = [wing().rest, shape(wing(), state.times)];
    if (state.ghost.indexOf("measured") === 0) clouds.push(measuredShape(wing(), measured().stations).points);
    if (state.ghost.indexOf("wing") === 0) clouds.push(shape(otherWing(), state.times));
    return bounds(clouds);
  }
  // The unloaded wing at all phases, and the moving one; film that flies off farther than a part of the wing leaves the picture.
  function strokeFrame() {
    var most = 1e-9;
    wing().stroke.forEach(function (own) { own.moved.forEach(function (by) { most = Math.max(most, Math.abs(by)); }); });
    var shown = Math.min(state.times, 0.3 * bounds([wing().rest]).radius / most), clouds = [];
    wing().stroke.forEach(function (own) { clouds.push(shapeAtPhase(wing(), own, 0), shapeAtPhase(wing(), own, shown)); });
    return bounds(clouds);
  }
  function otherWing() { return data.wings[Number(state.ghost.split(":")[1])]; }
  function measured() { return wing().measured[Number(state.ghost.split(":")[1])]; }

  function ink(name, opacity) {
    var text = getComputedStyle(document.documentElement).getPropertyValue(name).trim(), value = parseInt(text.slice(1), 16) || 0;
    var rgb = [value >> 16, value >> 8, value].map(function (own) { return (own & 255) / 255; });
    return rgb.concat(opacity);
  }

  function layer(corners, colour, least, more) {
    return Object.assign({ corners: corners, ink: colour, least: least, isLit: false, isBehind: false }, more);
  }

  function ghost() {
    if (state.ghost === "none") return [];
    var grey = ink("--quiet", 0.2), line = ink("--quiet", 1), zero = function () { return -1; };
    if (state.ghost.indexOf("measured") === 0) {
      var own = measuredShape(wing(), measured().stations);
      return [
        layer(chords(own.points, own.lines, 0.0028 * bounds([wing().rest]).radius), ink("--mind-line", 1), 1.2, { isLit: true }),
        layer(film(own.points, own.triangles, zero), ink("--mind-line", 0.22), 0, { isBehind: true })
      ];
    }
    var other = state.ghost === "rest" ? wing() : otherWing();
    var points = phase() ? shapeAtPhase(other, phase(), 0) : shape(other, state.ghost === "rest" ? 0 : share());
    var outline = other.triangles.length ? other.outline : beams(other);
    return [
      layer(dashes(points, outline), line, 0.7, { isBehind: true }),
      layer(film(points, other.triangles, zero), grey, 0, { isBehind: true })
    ];
  }
  function beams(own) {
    var pairs = [];
    for (var l = 0; l < own.lines.length; l += 3) pairs.push([own.lines[l], own.lines[l + 1]]);
    return pairs;
  }

  function layersOf(own) {
    points = now();
    function shareOf(node, triangle) {
      return state.isStale ? -1 : Math.max(0, (own.values[own.on === "cells" ? triangle : node] - range[0]) / (range[1] - range[0]));
    }
    return [
      layer(film(points, wing().triangles, shareOf), ink(state.isStale ? "--stale" : "--ink", 1), 0, { isLit: true }),
      layer(rods(wing(), points, own.on === "points" && shareOf), ink("--rod", 1), 0.8, { isLit: true })
    ].concat(ghost());
  }

  function draw() {
    waiting = false;
    var room = canvas.getBoundingClientRect(), dense = Math.min(window.devicePixelRatio || 1, 3);
    var width = Math.max(1, Math.round(room.width)), height = Math.max(1, Math.round(room.height));
    if (canvas.width !== Math.round(width * dense) || canvas.height !== Math.round(height * dense)) {
      canvas.width = Math.round(width * dense);
      canvas.height = Math.round(height * dense);
      eye.fit = 0;
    }
    var isOnTheWay = approach();
    box = box || frame();
    var own = field();
    range = range || widened(own.name, reach(own.name, phase() && wing().stroke));
    layers = layers || layersOf(own);
    screen = projection(box, width, height);
    seen = project(screen, points);
    pen.draw(screen, layers);
    marks(screen, state.mode === "stroke");
    legend(own, range);
    tell();
    point();
    canvas.setAttribute("data-pen", pen.name);
    if (isOnTheWay) soon();
  }

  function soon() {
    if (waiting) return;
    waiting = true;
    window.requestAnimationFrame(draw);
  }

  // Something else is shown: its frame and its colours are found anew.
  function anew(isFrame) {
    range = layers = null;
    if (isFrame) {
      box = null;
      eye.fit = 0;
    }
    soon();
  }

  // A ghost must be a state of the same wing: of as many points. Over the stroke the measured wing would stand elsewhere.
  function ghosts() {
    var names = [["rest", "unloaded"], ["none", "none"]];
    if (state.mode === "stroke") return names;
    wing().measured.forEach(function (own, index) { names.push(["measured:" + index, own.name]); });
    data.wings.forEach(function (own, index) {
      if (index !== state.wing && own.rest.length === wing().rest.length) names.push(["wing:" + index, own.name]);
    });
    return names;
  }

  // What was shown first of a wing keeps its colours: a wing that twists less becomes darker.
  function widened(name, own) {
    var first = kept[state.mode + name] = kept[state.mode + name] || own;
    return kept.isOn ? [Math.min(first[0], own[0]), Math.max(first[1], own[1])] : own;
  }

  function build() {
    buildLists();
    anew(true);
  }

  function buildLists() {
    var lists = part("controls");
    lists.textContent = "";
    if (data.wings.length > 1) {
      choice(lists, "Wing", data.wings.map(function (own, index) { return [index, own.name]; }), state.wing, function (index) {
        state.wing = Number(index);
        mode("load");
      });
    }
    if (wing().stroke) {
      choice(lists, "Show", [["load", "under load"], ["stroke", "over the stroke"]], state.mode, mode);
    }
    state.field = field().name;
    choice(lists, "Colour", fieldsOf(wing(), phase()).map(function (own) { return [own.name, own.name]; }), state.field, function (name) {
      state.field = name;
      anew(false);
    });
    var names = ghosts();
    if (!names.some(function (entry) { return entry[0] === state.ghost; })) state.ghost = "rest";
    choice(lists, "Ghost", names, state.ghost, function (name) { state.ghost = name; anew(true); });
    choice(lists, "Deformation", [[1, "as it is"], [2, "× 2"], [5, "× 5"]], state.times, function (times) {
      state.times = Number(times);
      anew(true);
    });
    buildViews();
    buildMotion();
  }

  function buildViews() {
    part("views").textContent = "";
    views(state.mode).forEach(function (own) {
      button(part("views"), own.name, own.title, function () { goTo(own.at, isStill()); soon(); });
    });
  }

  function buildMotion() {
    var row = part("motion"), isStroke = state.mode === "stroke";
    row.textContent = "";
    playing = null;
    // Who wants no motion moves the slider.
    if (!isStill()) {
      playing = button(row, "", isStroke ? "the stroke, over and over" : "from the unloaded to the loaded shape", function () {
        if (state.isPlaying) stop(); else play();
      });
      playing.id = "wing-play";
    }
    var own = slider(row, isStroke ? "Phase of the stroke" : "From unloaded to loaded", isStroke ? wing().stroke.length - 1 : 100,
      isStroke ? state.phase : Math.round(100 * state.load), function (at) { stop(); to(at); });
    own.id = "wing-slider";
    row.appendChild(document.createElement("output")).id = "wing-told";
    stop();
  }

  function mode(name) {
    stop();
    state.mode = name;
    state.load = 1;
    state.phase = 0;
    goTo(HOME[name], true);
    if (coming) show.apply(null, coming);
    build();
  }

  function to(at) {
    if (state.mode === "stroke") state.phase = at; else state.load = at / 100;
    part("slider").value = at;
    layers = null;
    soon();
  }

  function tell() {
    say(part("told"));
    part("slider").setAttribute("aria-valuetext", part("told").textContent);
  }
  function say(out) {
    out.textContent = "";
    if (!phase()) {
      out.textContent = state.load === 0 ? "unloaded" : state.load === 1 ? "loaded" : Math.round(100 * state.load) + " % of the way";
      return;
    }
    var place = "/stroke/phases/" + phase().row;
    numberOf(out, "phase ", place + "/phase_deg", "°");
    numberOf(out, ", tip twist ", place + "/tip_twist_deg", "°");
  }

  function stop() {
    state.isPlaying = null;
    if (playing) playing.textContent = "▶ Play";
  }

  // The load once, in a second; the stroke over and over, in three: what is shown are the phases that were solved, none between.
  function play() {
    var isStroke = state.mode === "stroke", from = null, first = state.phase, own = {};
    state.isPlaying = own;
    playing.textContent = "Pause";
    window.requestAnimationFrame(function step(time) {
      // Stopped, or started anew.
      if (state.isPlaying !== own) return;
      from = from === null ? time : from;
      if (isStroke) to((first + Math.floor((time - from) / 3000 * wing().stroke.length)) % wing().stroke.length);
      else to(Math.min(100, Math.round((time - from) / 12)));
      if (!isStroke && state.load === 1) stop(); else window.requestAnimationFrame(step);
    });
  }

  function point() {
    var at = cursor && valueAt(wing(), field(), seen, cursor[0], cursor[1]);
    showValue(part("value"), field(), at, cursor && cursor[0], cursor && cursor[1], screen);
  }

  // What the lists offer.
  function offer() {
    return JSON.stringify([
      data.wings.map(function (own) { return own.name; }), fieldsOf(wing(), phase()).map(function (own) { return own.name; }),
      ghosts(), !!wing().stroke, wing().stroke && wing().stroke.length
    ]);
  }

  // Other shapes in the place of those shown, seen from the same side and as large while they fit. `isStale`: none of them is the
  // answer, and they are drawn grey; `isOther`: they are of another wing, and it finds its frame anew. A stroke that is watched
  // stays, in grey, until the one that follows has been solved.
  function show(wings, isStale, isOther) {
    var offered = offer(), old = box;
    if (state.mode === "stroke" && !wings[0].stroke) {
      coming = [wings, isStale, isOther];
      state.isStale = true;
      anew(false);
      return;
    }
    coming = null;
    wings.forEach(prepare);
    data.wings = wings;
    if (isOther) kept = {};
    kept.isOn = true;
    state.isStale = isStale;
    state.wing = Math.min(state.wing, wings.length - 1);
    state.phase = Math.min(state.phase, (wing().stroke || [0]).length - 1);
    if (offer() !== offered) buildLists();
    range = layers = box = null;
    if (isOther) eye.fit = 0;
    else if (old && isWithin(frame(), old)) box = old;
    soon();
  }

  build();
  canvas.addEventListener("webglcontextlost", function (event) { event.preventDefault(); });
  canvas.addEventListener("webglcontextrestored", function () { pen.again(); soon(); });
  hands(canvas, soon, isStill, function () { return screen; }, function () { return HOME[state.mode]; }, function (at) {
    cursor = at;
    if (seen) point();
  });
  window.addEventListener("resize", soon);
  if (window.ResizeObserver) new ResizeObserver(soon).observe(canvas);
  // Printing does not wait for the next frame.
  window.addEventListener("beforeprint", function () { layers = null; arrive(); draw(); });
  if (window.matchMedia) {
    ["(prefers-color-scheme: dark)", "(prefers-reduced-motion: reduce)"].forEach(function (query) {
      var own = matchMedia(query);
      if (own.addEventListener) own.addEventListener("change", function () { buildMotion(); anew(false); });
    });
  }
  part("live").hidden = false;
  part("still").hidden = true;
  draw();
  return { show: show };
}
