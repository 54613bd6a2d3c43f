// The value under the cursor: of the film nearest to the eye there, with the station that it belongs to.

// Triangle, shares of its corners and distance under a place of the screen.
function under(seen, triangles, x, y) {
  var found = null;
  for (var t = 0; t < triangles.length; t += 3) {
    var a = 3 * triangles[t], b = 3 * triangles[t + 1], c = 3 * triangles[t + 2];
    var area = (seen[b] - seen[a]) * (seen[c + 1] - seen[a + 1]) - (seen[c] - seen[a]) * (seen[b + 1] - seen[a + 1]);
    if (Math.abs(area) < 1e-9) continue;
    var v = ((x - seen[a]) * (seen[c + 1] - seen[a + 1]) - (seen[c] - seen[a]) * (y - seen[a + 1])) / area;
    var w = ((seen[b] - seen[a]) * (y - seen[a + 1]) - (x - seen[a]) * (seen[b + 1] - seen[a + 1])) / area;
    if (v < -1e-9 || w < -1e-9 || v + w > 1 + 1e-9) continue;
    var away = seen[a + 2] + v * (seen[b + 2] - seen[a + 2]) + w * (seen[c + 2] - seen[a + 2]);
    if (!found || away < found.away) {
      found = { triangle: t / 3, nodes: [a / 3, b / 3, c / 3], shares: [1 - v - w, v, w], away: away };
    }
  }
  return found;
}

// Of a wing without film: the node next to the place.
function nearest(seen, x, y) {
  var found = null, least = 14;
  for (var i = 0; i < seen.length; i += 3) {
    var far = Math.hypot(seen[i] - x, seen[i + 1] - y);
    if (far < least) {
      least = far;
      found = { triangle: 0, nodes: [i / 3], shares: [1] };
    }
  }
  return found;
}

function blend(found, values, step) {
  return found.nodes.reduce(function (sum, node, k) { return sum + found.shares[k] * values[step * node]; }, 0);
}

// Twist is that of the chord through the place; pressure and tension are those of the triangle.
function valueAt(wing, field, seen, x, y) {
  var found = wing.triangles.length ? under(seen, wing.triangles, x, y) : nearest(seen, x, y);
  if (!found || (field.on === "cells" && !wing.triangles.length)) return null;
  return {
    value: field.on === "cells" ? field.values[found.triangle] : blend(found, field.values, 1),
    r: blend(found, wing.rest, 3)
  };
}

function showValue(box, field, at, x, y, screen) {
  box.hidden = !at;
  if (!at) return;
  box.textContent = "";
  [["strong", field.name + " " + plain(at.value, 4) + " " + field.unit], ["span", "r = " + at.r.toFixed(1) + " mm"]].forEach(function (line) {
    var element = document.createElement(line[0]);
    element.textContent = line[1];
    box.appendChild(element);
  });
  // Beside the cursor, within the picture.
  var left = x + 14 + box.offsetWidth > screen.width ? x - 14 - box.offsetWidth : x + 14;
  var top = y - 10 - box.offsetHeight < 0 ? y + 18 : y - 10 - box.offsetHeight;
  box.style.left = Math.max(0, left) + "px";
  box.style.top = Math.min(top, screen.height - box.offsetHeight) + "px";
}
