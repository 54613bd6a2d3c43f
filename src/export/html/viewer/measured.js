// The measured twist as a ghost: every chord of the unloaded wing turned by it about the leading edge as modelled, since a
// measured twist says nothing of where that is. Only where twist was measured, or between two such places.

// Where the outline crosses a place along the span: on which edges (a, b, share of b), the leading edge first.
function edgesAt(wing, x) {
  var rest = wing.rest, low = null, high = null;
  wing.outline.forEach(function (edge) {
    var from = rest[3 * edge[0]], to = rest[3 * edge[1]];
    if ((x - from) * (x - to) > 1e-9) return;
    var share = to === from ? 0 : Math.max(0, Math.min(1, (x - from) / (to - from)));
    // An edge across the span is crossed at both of its ends.
    (to === from ? [0, 1] : [share]).forEach(function (part) {
      var y = rest[3 * edge[0] + 1] + part * (rest[3 * edge[1] + 1] - rest[3 * edge[0] + 1]);
      var at = { edge: edge, share: part, y: y };
      if (!low || y < low.y) low = at;
      if (!high || y > high.y) high = at;
    });
  });
  return low && [low, high];
}

function pointAt(points, at) {
  return [0, 1, 2].map(function (k) {
    var from = points[3 * at.edge[0] + k];
    return from + at.share * (points[3 * at.edge[1] + k] - from);
  });
}

function twistAt(stations, x) {
  for (var k = 0; k < stations.length; k++) {
    if (Math.abs(stations[k][0] - x) < 1e-6) return stations[k][1];
    if (k && stations[k - 1][0] < x && x < stations[k][0]) {
      var share = (x - stations[k - 1][0]) / (stations[k][0] - stations[k - 1][0]);
      return stations[k - 1][1] + share * (stations[k][1] - stations[k - 1][1]);
    }
  }
  return null;
}

function turned(wing, rest, leading, twistDeg) {
  var from = pointAt(wing.rest, leading), to = pointAt(wing.loaded, leading);
  var cos = Math.cos(twistDeg * Math.PI / 180), sin = Math.sin(twistDeg * Math.PI / 180);
  var y = rest[1] - from[1], z = rest[2] - from[2];
  return [to[0] + rest[0] - from[0], to[1] + cos * y - sin * z, to[2] + sin * y + cos * z];
}

// Points, the triangles that lie within the measured stretch, and the chords at the stations as lines on points of their own.
function measuredShape(wing, stations) {
  var points = [], known = [], triangles = [], lines = [];
  for (var i = 0; i < wing.rest.length; i += 3) {
    var rest = [wing.rest[i], wing.rest[i + 1], wing.rest[i + 2]];
    var twist = twistAt(stations, rest[0]), edges = twist === null ? null : edgesAt(wing, rest[0]);
    known.push(edges !== null);
    points.push.apply(points, edges ? turned(wing, rest, edges[0], twist) : rest);
  }
  for (var t = 0; t < wing.triangles.length; t += 3) {
    var corners = wing.triangles.slice(t, t + 3);
    if (corners.every(function (n) { return known[n]; })) triangles.push.apply(triangles, corners);
  }
  stations.forEach(function (station) {
    var edges = edgesAt(wing, station[0]);
    if (!edges) return;
    edges.forEach(function (edge) {
      points.push.apply(points, turned(wing, pointAt(wing.rest, edge), edges[0], station[1]));
    });
    lines.push([points.length / 3 - 2, points.length / 3 - 1]);
  });
  return { points: points, triangles: triangles, lines: lines };
}
