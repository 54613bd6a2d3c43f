// Drawing on a plain canvas where WebGL is missing: the same triangles from the farthest to the nearest, one colour each.

function painter(canvas) {
  var pen = canvas.getContext("2d");
  if (!pen) return null;

  function colour(share, ink) {
    if (share < 0) return ink;
    var map = data.map, at = Math.max(0, Math.min(1, share)) * (map.length - 1);
    var k = Math.min(map.length - 2, Math.floor(at));
    return [0, 1, 2].map(function (c) { return (map[k][c] + (at - k) * (map[k + 1][c] - map[k][c])) / 255; });
  }

  function parts(screen, layer, all) {
    var own = layer.corners, least = layer.least / screen.scale;
    for (var t = 0; t < own.length; t += 3 * CORNER) {
      var at = [], normal = [0, 0, 0], share = 0;
      for (var c = t; c < t + 3 * CORNER; c += CORNER) {
        var radius = own[c + 6] > 0 ? Math.max(own[c + 6], least) : 0;
        for (var k = 0; k < 3; k++) {
          at.push(own[c + k] + radius * own[c + 3 + k]);
          normal[k] += own[c + 3 + k];
        }
        share += own[c + 7] / 3;
      }
      var seen = project(screen, at), light = 1;
      if (layer.isLit) light = 0.74 + 0.3 * Math.abs(along(screen.away, unit(normal), 0, [0, 0, 0]));
      var rgb = colour(share, layer.ink).map(function (part) { return Math.round(255 * Math.min(1, part * light)); });
      // What is glued to the film lies a hair before it, a ghost behind.
      var nearer = layer.isBehind ? -0.02 : own[t + 6] + own[t + 14] > 0 ? 0.02 : 0;
      all.push([(seen[2] + seen[5] + seen[8]) / 3 - nearer * screen.radius, seen, "rgb(" + rgb.join(",") + ")", layer.ink[3]]);
    }
  }

  return {
    name: "canvas",
    draw: function (screen, layers) {
      pen.setTransform(canvas.width / screen.width, 0, 0, canvas.height / screen.height, 0, 0);
      pen.clearRect(0, 0, screen.width, screen.height);
      var all = [];
      layers.forEach(function (layer) { parts(screen, layer, all); });
      all.sort(function (p, q) { return q[0] - p[0]; });
      pen.lineWidth = 0.6;
      all.forEach(function (part) {
        var at = part[1];
        pen.globalAlpha = part[3];
        pen.fillStyle = pen.strokeStyle = part[2];
        pen.beginPath();
        pen.moveTo(at[0], at[1]);
        pen.lineTo(at[3], at[4]);
        pen.lineTo(at[6], at[7]);
        pen.closePath();
        pen.fill();
        // Closes the seams between neighbours.
        if (part[3] === 1) pen.stroke();
      });
      pen.globalAlpha = 1;
    }
  };
}
