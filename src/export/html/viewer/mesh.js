// Triangles to be drawn, eight numbers a corner: place, normal, radius by which it is moved along the normal, share of the
// colour map (below 0: ink). A radius is widened where it would be thinner than a line.

var SIDES = 12;
var CORNER = 8;

function unit(v) {
  var size = Math.hypot(v[0], v[1], v[2]) || 1;
  return [v[0] / size, v[1] / size, v[2] / size];
}

function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function minus(points, a, b) {
  return [points[3 * a] - points[3 * b], points[3 * a + 1] - points[3 * b + 1], points[3 * a + 2] - points[3 * b + 2]];
}

// The film; its normals are the mean at each point, so that it looks round where it is.
function film(points, triangles, shareOf) {
  var normals = new Float64Array(points.length), out = new Float32Array(triangles.length * CORNER);
  for (var t = 0; t < triangles.length; t += 3) {
    var a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
    var normal = cross(minus(points, b, a), minus(points, c, a));
    [a, b, c].forEach(function (n) { for (var k = 0; k < 3; k++) normals[3 * n + k] += normal[k]; });
  }
  for (var i = 0; i < triangles.length; i++) {
    var n = triangles[i], at = i * CORNER;
    var own = unit([normals[3 * n], normals[3 * n + 1], normals[3 * n + 2]]);
    for (var k = 0; k < 3; k++) {
      out[at + k] = points[3 * n + k];
      out[at + 3 + k] = own[k];
    }
    out[at + 7] = shareOf(n, Math.floor(i / 3));
  }
  return out;
}

// Two directions across a line, the same for lines that go on from each other.
function across(direction) {
  var aside = Math.abs(direction[2]) < 0.95 ? [0, 0, 1] : [0, 1, 0];
  var u = unit(cross(aside, direction));
  return [u, cross(direction, u)];
}

// Lines as tubes with flat ends. Where two of a kind meet they share the mean direction, so that they join without a gap.
function tubes(points, lines, sides) {
  var mean = {};
  lines.forEach(function (line) {
    var own = unit(minus(points, line.to, line.from));
    [line.from, line.to].forEach(function (node) {
      var key = line.kind + "," + node, sum = mean[key] || [0, 0, 0];
      // A line drawn the other way still goes on.
      var sign = sum[0] * own[0] + sum[1] * own[1] + sum[2] * own[2] < 0 ? -1 : 1;
      mean[key] = [0, 1, 2].map(function (k) { return sum[k] + sign * own[k]; });
    });
  });
  var out = new Float32Array(lines.length * sides * 12 * CORNER), at = 0;
  function corner(node, normal, radius, share) {
    for (var k = 0; k < 3; k++) {
      out[at + k] = points[3 * node + k];
      out[at + 3 + k] = normal[k];
    }
    out[at + 6] = radius;
    out[at + 7] = share;
    at += CORNER;
  }
  lines.forEach(function (line) {
    var own = unit(minus(points, line.to, line.from));
    var rings = [line.from, line.to].map(function (node, end) {
      var direction = unit(mean[line.kind + "," + node]);
      if (direction[0] * own[0] + direction[1] * own[1] + direction[2] * own[2] < 0) {
        direction = direction.map(function (x) { return -x; });
      }
      var frame = across(direction), ring = [];
      for (var s = 0; s <= sides; s++) {
        var angle = 2 * Math.PI * s / sides, cos = Math.cos(angle), sin = Math.sin(angle);
        ring.push([0, 1, 2].map(function (k) { return cos * frame[0][k] + sin * frame[1][k]; }));
      }
      return { node: node, ring: ring, share: line.shares[end], out: direction.map(function (x) { return end ? x : -x; }) };
    });
    var a = rings[0], b = rings[1], r = line.radius;
    for (var s = 0; s < sides; s++) {
      corner(a.node, a.ring[s], r, a.share); corner(b.node, b.ring[s], r, b.share); corner(b.node, b.ring[s + 1], r, b.share);
      corner(a.node, a.ring[s], r, a.share); corner(b.node, b.ring[s + 1], r, b.share); corner(a.node, a.ring[s + 1], r, a.share);
      [a, b].forEach(function (end) {
        corner(end.node, end.out, 0, end.share);
        corner(end.node, end.ring[s], r, end.share);
        corner(end.node, end.ring[s + 1], r, end.share);
      });
    }
  });
  return out;
}

// Rod, spars and ribs. A wing without film carries the colours on them.
function rods(wing, points, shareOf) {
  var lines = [], thin = 0.002 * bounds([wing.rest]).radius;
  for (var l = 0; l < wing.lines.length; l += 3) {
    var ends = [wing.lines[l], wing.lines[l + 1]];
    var share = wing.triangles.length || !shareOf ? [-1, -1] : ends.map(function (node) { return shareOf(node, l / 3); });
    lines.push({
      from: ends[0], to: ends[1], kind: wing.lines[l + 2], radius: 0.5 * wing.diameters[l / 3] || thin, shares: share
    });
  }
  return tubes(points, lines, SIDES);
}

// Lines as dashes of one length, on from one line to the next; thin at any size.
function dashes(points, pairs) {
  var next = {}, cut = [], lines = [], period = 0.045 * bounds([points]).radius, way = 0;
  pairs.forEach(function (pair, index) {
    pair.forEach(function (node) { (next[node] = next[node] || []).push(index); });
  });
  var isDone = pairs.map(function () { return false; });
  function walk(index, from) {
    while (index !== undefined) {
      isDone[index] = true;
      var to = pairs[index][0] === from ? pairs[index][1] : pairs[index][0], step = minus(points, to, from);
      var long = Math.hypot(step[0], step[1], step[2]);
      for (var at = 0; at < long - 1e-9;) {
        var inPeriod = (way + at) % period, isDash = inPeriod < 0.6 * period;
        var end = Math.min(long, at + Math.max(1e-6 * period, (isDash ? 0.6 : 1) * period - inPeriod));
        if (isDash) {
          [at, end].forEach(function (along) {
            for (var k = 0; k < 3; k++) cut.push(points[3 * from + k] + along / long * step[k]);
          });
          lines.push({ from: cut.length / 3 - 2, to: cut.length / 3 - 1, kind: 0, radius: 1e-6, shares: [-1, -1] });
        }
        at = end;
      }
      way += long;
      from = to;
      index = next[to].filter(function (own) { return !isDone[own]; })[0];
    }
  }
  pairs.forEach(function (pair, index) { if (!isDone[index]) walk(index, pair[0]); });
  return tubes(cut, lines, 4);
}

// Measured chords, thicker than a rib without a diameter, which may lie where one was measured.
function chords(points, pairs, radius) {
  return tubes(points, pairs.map(function (pair, index) {
    return { from: pair[0], to: pair[1], kind: index, radius: radius, shares: [-1, -1] };
  }), SIDES);
}
