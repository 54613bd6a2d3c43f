// Drawing by WebGL 1, which every browser has that shows a page like this. Written by hand: one program of forty lines draws
// everything here, where the smallest library would be several times the size of the whole viewer.

var VERTEX = "attribute vec3 place, normal; attribute vec2 look;" +
  "uniform vec3 right, up, away, centre; uniform vec4 frame; uniform float least, depth;" +
  "varying vec3 turned; varying float share;" +
  "void main() {" +
  "  vec3 at = place - centre;" +
  "  if (look.x > 0.0) at += normal * max(look.x, least);" +
  "  turned = vec3(dot(normal, right), dot(normal, up), -dot(normal, away));" +
  "  share = look.y;" +
  "  gl_Position = vec4(dot(at, right) * frame.x + frame.z, dot(at, up) * frame.y + frame.w, dot(at, away) * depth, 1.0);" +
  "}";

// Both sides of the film are lit, by one light over the left shoulder; never so dark that a colour is another one of the map.
var FRAGMENT = "precision highp float;" +
  "uniform vec3 map[9]; uniform vec4 ink; uniform float lit;" +
  "varying vec3 turned; varying float share;" +
  "void main() {" +
  "  vec3 colour = ink.rgb;" +
  "  if (share >= 0.0) {" +
  "    colour = map[0];" +
  "    for (int k = 1; k < 9; k++) colour = mix(colour, map[k], clamp(share * 8.0 - float(k - 1), 0.0, 1.0));" +
  "  }" +
  "  vec3 normal = normalize(turned);" +
  "  if (normal.z < 0.0) normal = -normal;" +
  "  float light = 0.78 + 0.27 * max(dot(normal, vec3(-0.33, 0.52, 0.79)), 0.0);" +
  "  float shine = 0.16 * pow(max(dot(normal, vec3(-0.17, 0.27, 0.947)), 0.0), 40.0);" +
  "  colour = mix(colour, colour * light + shine, lit);" +
  "  gl_FragColor = vec4(colour * ink.a, ink.a);" +
  "}";

// A pen that draws layers of triangles; none where there is no WebGL.
function webgl(canvas) {
  var gl = canvas.getContext("webgl", { antialias: true, preserveDrawingBuffer: true });
  if (!gl) return null;
  // Layers that are drawn again, turned or moved, are on the card already.
  var place = {}, attributes = [], buffers = [], uploaded = null;

  function compiled(kind, source) {
    var shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    return shader;
  }

  function prepare() {
    var program = gl.createProgram();
    gl.attachShader(program, compiled(gl.VERTEX_SHADER, VERTEX));
    gl.attachShader(program, compiled(gl.FRAGMENT_SHADER, FRAGMENT));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return false;
    gl.useProgram(program);
    ["right", "up", "away", "centre", "frame", "least", "depth", "map", "ink", "lit"].forEach(function (name) {
      place[name] = gl.getUniformLocation(program, name);
    });
    buffers = [];
    uploaded = null;
    attributes = [["place", 3, 0], ["normal", 3, 12], ["look", 2, 24]].map(function (own) {
      var at = gl.getAttribLocation(program, own[0]);
      gl.enableVertexAttribArray(at);
      return [at, own[1], own[2]];
    });
    gl.uniform3fv(place.map, [].concat.apply([], data.map).map(function (part) { return part / 255; }));
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    return true;
  }

  function upload(layers) {
    if (uploaded === layers) return;
    uploaded = layers;
    buffers.forEach(function (own) { gl.deleteBuffer(own); });
    buffers = layers.map(function (layer) {
      var own = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, own);
      gl.bufferData(gl.ARRAY_BUFFER, layer.corners, gl.STATIC_DRAW);
      return own;
    });
  }

  if (!prepare()) return null;
  return {
    name: "webgl",
    again: prepare,
    draw: function (screen, layers) {
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.clearColor(0, 0, 0, 0);
      gl.depthMask(true);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      ["right", "up", "away", "centre"].forEach(function (name) { gl.uniform3fv(place[name], screen[name]); });
      var half = [screen.width / 2, screen.height / 2];
      gl.uniform4f(place.frame, screen.scale / half[0], screen.scale / half[1],
        screen.shift[0] / half[0] - 1, 1 - screen.shift[1] / half[1]);
      gl.uniform1f(place.depth, 0.4 / screen.radius);
      upload(layers);
      layers.forEach(function (layer, index) {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffers[index]);
        attributes.forEach(function (own) { gl.vertexAttribPointer(own[0], own[1], gl.FLOAT, false, 4 * CORNER, own[2]); });
        gl.uniform1f(place.least, layer.least / screen.scale);
        gl.uniform4fv(place.ink, layer.ink);
        gl.uniform1f(place.lit, layer.isLit ? 1 : 0);
        // A ghost hides nothing, and where it lies on the film it stays behind it.
        gl.depthMask(layer.ink[3] === 1);
        if (layer.isBehind) gl.enable(gl.POLYGON_OFFSET_FILL); else gl.disable(gl.POLYGON_OFFSET_FILL);
        gl.polygonOffset(2, 8);
        gl.drawArrays(gl.TRIANGLES, 0, layer.corners.length / CORNER);
      });
    }
  };
}
