// What mouse, fingers and keys do: turn, move, zoom, ask for a value.

function hands(canvas, soon, isStill, screen, home, pointAt) {
  function turn(right, down) {
    arrive();
    eye.turn += right;
    eye.tilt = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, eye.tilt + down));
    soon();
  }
  function zoom(by) {
    eye.zoom = Math.max(0.3, Math.min(20, eye.zoom * by));
    soon();
  }
  // Pixels on the screen, to the right and down.
  function move(right, down) {
    if (!screen()) return;
    eye.pan[0] += right / screen().scale;
    eye.pan[1] -= down / screen().scale;
    soon();
  }

  var fingers = {}, way = 0;
  function all() { return Object.keys(fingers).map(function (id) { return fingers[id]; }); }
  function spread() { var at = all(); return at.length < 2 ? 0 : Math.hypot(at[0][0] - at[1][0], at[0][1] - at[1][1]); }
  function within(event) {
    var room = canvas.getBoundingClientRect();
    return [event.clientX - room.left, event.clientY - room.top];
  }

  canvas.addEventListener("pointerdown", function (event) {
    if (!all().length) way = 0;
    fingers[event.pointerId] = [event.clientX, event.clientY];
    // A pointer that is gone already cannot be held.
    try { canvas.setPointerCapture(event.pointerId); } catch (error) { return; }
  });
  canvas.addEventListener("pointermove", function (event) {
    var from = fingers[event.pointerId];
    if (!from) {
      pointAt(within(event));
      return;
    }
    var before = spread(), by = [event.clientX - from[0], event.clientY - from[1]];
    way += Math.hypot(by[0], by[1]);
    fingers[event.pointerId] = [event.clientX, event.clientY];
    pointAt(null);
    if (before > 0) {
      zoom(spread() / before);
      move(0.5 * by[0], 0.5 * by[1]);
    } else if (event.shiftKey) move(by[0], by[1]);
    else turn(0.009 * by[0], 0.009 * by[1]);
  });
  canvas.addEventListener("pointerup", function (event) {
    // A finger cannot hover: a tap asks for the value.
    if (way < 6) pointAt(within(event));
    delete fingers[event.pointerId];
  });
  canvas.addEventListener("pointercancel", function (event) { delete fingers[event.pointerId]; });
  canvas.addEventListener("pointerleave", function (event) { if (event.pointerType === "mouse") pointAt(null); });
  // The wheel scrolls the page unless the picture was clicked.
  canvas.addEventListener("wheel", function (event) {
    if (document.activeElement !== canvas) return;
    event.preventDefault();
    zoom(Math.exp(-0.0015 * event.deltaY));
  }, { passive: false });
  canvas.addEventListener("keydown", function (event) {
    var isMoved = event.shiftKey;
    function arrow(right, down) {
      return function () { if (isMoved) move(30 * right, 30 * down); else turn(0.1 * right, 0.1 * down); };
    }
    var keys = {
      ArrowLeft: arrow(-1, 0), ArrowRight: arrow(1, 0), ArrowUp: arrow(0, -1), ArrowDown: arrow(0, 1),
      "+": function () { zoom(1.15); }, "=": function () { zoom(1.15); }, "-": function () { zoom(1 / 1.15); },
      "0": function () { goTo(home(), isStill()); soon(); }
    };
    if (!keys[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key]();
  });
}
