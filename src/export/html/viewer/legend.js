// What the picture is read by: the scale of colours, the axes, a bar that says how long a millimetre is.

function legend(field, range) {
  var bar = document.getElementById("wing-bar");
  var stops = data.map.map(function (rgb) { return "rgb(" + rgb.join(",") + ")"; });
  bar.querySelector(".strip").style.background = "linear-gradient(to right," + stops.join(",") + ")";
  bar.querySelector(".low").textContent = plain(range[0], 3);
  bar.querySelector(".mid").textContent = field.name + " (" + field.unit + ")";
  bar.querySelector(".high").textContent = plain(range[1], 3);
}

function drawn(parent, kind, attributes, text) {
  var element = document.createElementNS("http://www.w3.org/2000/svg", kind);
  Object.keys(attributes).forEach(function (name) { element.setAttribute(name, attributes[name]); });
  if (text) element.textContent = text;
  parent.appendChild(element);
}

// In space over the stroke the axes are others than those of the wing.
function marks(screen, isInSpace) {
  var svg = document.getElementById("wing-marks"), from = [44, screen.height - 40];
  svg.textContent = "";
  var names = isInSpace ? ["x", "y", "z"] : ["span", "chord", "z"];
  names.forEach(function (name, k) {
    var way = [screen.right[k], -screen.up[k]], long = Math.hypot(way[0], way[1]);
    // An axis that points at the eye is not drawn: its name would cover the others.
    if (long < 0.2) return;
    var to = [from[0] + 26 * way[0], from[1] + 26 * way[1]];
    drawn(svg, "line", { x1: from[0], y1: from[1], x2: to[0], y2: to[1] });
    drawn(svg, "text", {
      x: to[0] + 6 * way[0] / long, y: to[1] + 9 * way[1] / long + 4,
      "text-anchor": way[0] / long < -0.4 ? "end" : way[0] / long > 0.4 ? "start" : "middle"
    }, name);
  });
  // The longest of 1, 2, 5, 10, 20 … mm that takes no more than a quarter of the width.
  var most = Math.min(160, 0.25 * screen.width) / screen.scale, decade = Math.pow(10, Math.floor(Math.log10(most)));
  var long = decade * (most / decade >= 5 ? 5 : most / decade >= 2 ? 2 : 1);
  var right = screen.width - 14, left = right - long * screen.scale, y = screen.height - 16;
  drawn(svg, "path", { d: "M" + left + " " + (y - 4) + "v8M" + left + " " + y + "H" + right + "M" + right + " " + (y - 4) + "v8", fill: "none" });
  drawn(svg, "text", { x: (left + right) / 2, y: y - 7, "text-anchor": "middle" }, plain(long, 2) + " mm");
}
