// From where the wing is seen. Without perspective, so that lengths on the screen can be compared and a bar can say how long
// a millimetre is.

// Turn about z and tilt, rad. Over the stroke the chord hangs from the leading edge along y, and the wing sweeps along z: the eye
// looks along z then, or the arc would leave little room for the wing.
var HOME = { load: [-0.45, 0.5], stroke: [-0.3, -1.38] };
var eye = { turn: HOME.load[0], tilt: HOME.load[1], zoom: 1, pan: [0, 0], fit: 0, goal: null };

function views(mode) {
  var flat = Math.PI / 2;
  return [
    { name: "Oblique", title: "the first view (key 0)", at: HOME[mode] },
    { name: "Along the span", title: "from the tip to the base: the chords turn", at: [-flat, 0] },
    { name: "From the front", title: "onto the leading edge: the rod bends", at: [0, 0] },
    { name: "From the side", title: "onto the plane of the wing: its outline", at: [0, mode === "stroke" ? -flat : flat] }
  ];
}

// Unit vectors of the screen: to the right, upward, away from the eye.
function axes() {
  var ct = Math.cos(eye.turn), st = Math.sin(eye.turn), ci = Math.cos(eye.tilt), si = Math.sin(eye.tilt);
  return { right: [ct, -st, 0], up: [si * st, si * ct, ci], away: [ci * st, ci * ct, -si] };
}

function along(axis, points, i, centre) {
  return axis[0] * (points[i] - centre[0]) + axis[1] * (points[i + 1] - centre[1]) + axis[2] * (points[i + 2] - centre[2]);
}

// Middle and radius of clouds of points.
function bounds(clouds) {
  var low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  clouds.forEach(function (points) {
    for (var i = 0; i < points.length; i++) {
      low[i % 3] = Math.min(low[i % 3], points[i]);
      high[i % 3] = Math.max(high[i % 3], points[i]);
    }
  });
  return {
    clouds: clouds,
    centre: [0, 1, 2].map(function (k) { return (low[k] + high[k]) / 2; }),
    radius: Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2 || 1
  };
}

// Whether one room lies within another, and takes most of it.
function isWithin(own, other) {
  var apart = Math.hypot.apply(null, own.centre.map(function (at, k) { return at - other.centre[k]; }));
  return own.radius + 0.5 * apart < 1.02 * other.radius && own.radius > 0.6 * other.radius;
}

// Pixels per mm at which all of it is within the canvas, and its middle on the screen (mm), seen from here.
function fitting(box, width, height) {
  var screen = axes(), low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  box.clouds.forEach(function (points) {
    for (var i = 0; i < points.length; i += 3) {
      var at = [along(screen.right, points, i, box.centre), along(screen.up, points, i, box.centre)];
      for (var k = 0; k < 2; k++) {
        low[k] = Math.min(low[k], at[k]);
        high[k] = Math.max(high[k], at[k]);
      }
    }
  });
  var size = [Math.max(high[0] - low[0], 1e-3), Math.max(high[1] - low[1], 1e-3)];
  // Room below for the axes and the bar.
  return {
    scale: Math.min((width - 36) / size[0], (height - Math.min(130, 0.3 * height)) / size[1]),
    middle: [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2]
  };
}

// What takes points to the screen. Turned by hand the wing keeps its size while it fits; from a view of its own it fills the canvas.
function projection(box, width, height) {
  var fits = fitting(box, width, height);
  eye.fit = eye.fit ? Math.min(eye.fit, fits.scale) : fits.scale;
  var screen = axes(), scale = eye.fit * eye.zoom;
  screen.centre = box.centre;
  screen.radius = box.radius;
  screen.scale = scale;
  screen.shift = [0.5 * width + scale * (eye.pan[0] - fits.middle[0]), 0.45 * height - scale * (eye.pan[1] - fits.middle[1])];
  screen.width = width;
  screen.height = height;
  return screen;
}

// Pixels to the right and down, and mm away from the eye.
function project(screen, points) {
  var out = new Float64Array(points.length);
  for (var i = 0; i < points.length; i += 3) {
    out[i] = screen.shift[0] + screen.scale * along(screen.right, points, i, screen.centre);
    out[i + 1] = screen.shift[1] - screen.scale * along(screen.up, points, i, screen.centre);
    out[i + 2] = along(screen.away, points, i, screen.centre);
  }
  return out;
}

// Toward a view: at once where motion is not wanted.
function goTo(at, isStill) {
  eye.goal = at.slice();
  eye.zoom = 1;
  eye.pan = [0, 0];
  if (isStill) arrive();
}

function arrive() {
  if (!eye.goal) return;
  eye.turn = eye.goal[0];
  eye.tilt = eye.goal[1];
  eye.goal = null;
  eye.fit = 0;
}

// A step of the way; whether there is more to go.
function approach() {
  if (!eye.goal) return false;
  // The shorter way round.
  eye.turn -= 2 * Math.PI * Math.round((eye.turn - eye.goal[0]) / (2 * Math.PI));
  var way = [eye.goal[0] - eye.turn, eye.goal[1] - eye.tilt];
  if (Math.hypot(way[0], way[1]) < 0.02) arrive();
  else {
    eye.turn += 0.3 * way[0];
    eye.tilt += 0.3 * way[1];
    eye.fit = 0;
  }
  return eye.goal !== null;
}
