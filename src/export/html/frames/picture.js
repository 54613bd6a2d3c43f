// The frame with its marks: zoomed by wheel or keys, moved by dragging; a click sets the current point, a mark can be dragged.

var COLOURS = { leading: "#ffb000", trailing: "#35c4f0", reference_a: "#ff6fa8", reference_b: "#ff6fa8" };
var NEAR = 9;

function picture() {
  var canvas = at("picture"), pen = canvas.getContext("2d"), image = null, view = null, cross = null, held = null, isKeys = false;
  var told = at("cursor"), serial = 0, wide = 0, tall = 0;

  function size() {
    var ratio = window.devicePixelRatio || 1;
    wide = canvas.clientWidth;
    tall = canvas.clientHeight;
    canvas.width = Math.max(1, Math.round(wide * ratio));
    canvas.height = Math.max(1, Math.round(tall * ratio));
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  function fit() {
    if (!image || !wide) return;
    var scale = Math.min(wide / image.naturalWidth, tall / image.naturalHeight);
    view = { scale: scale, left: (wide - scale * image.naturalWidth) / 2, top: (tall - scale * image.naturalHeight) / 2, isWhole: true };
    render();
  }

  function toScreen(x, y) { return [view.left + x * view.scale, view.top + y * view.scale]; }
  function toPicture(x, y) { return [(x - view.left) / view.scale, (y - view.top) / view.scale]; }

  function zoom(by, x, y) {
    if (!view) return;
    var here = toPicture(x, y), scale = Math.max(0.02, Math.min(60, view.scale * by));
    view = { scale: scale, left: x - here[0] * scale, top: y - here[1] * scale };
    render();
  }

  function line(a, b, colour, dash) {
    pen.beginPath();
    pen.setLineDash(dash || []);
    pen.strokeStyle = colour;
    pen.lineWidth = 1.5;
    pen.moveTo(a[0], a[1]);
    pen.lineTo(b[0], b[1]);
    pen.stroke();
    pen.setLineDash([]);
  }

  function dot(own, isOn) {
    var place = toScreen(own.x_px, own.y_px), colour = COLOURS[own.mark];
    pen.beginPath();
    pen.arc(place[0], place[1], isOn ? 7 : 5, 0, 7);
    pen.lineWidth = 3.5;
    pen.strokeStyle = "#000000";
    pen.stroke();
    pen.lineWidth = 2;
    pen.strokeStyle = colour;
    pen.stroke();
    pen.fillStyle = colour;
    pen.fillRect(place[0] - 0.75, place[1] - 0.75, 1.5, 1.5);
    if (own.mark === "trailing") return;
    pen.font = "12px system-ui, sans-serif";
    pen.lineWidth = 3;
    pen.strokeStyle = "#000000";
    var text = own.r_mm === null ? own.mark.slice(-1) : plain(own.r_mm, 5);
    pen.strokeText(text, place[0] + 9, place[1] - 6);
    pen.fillText(text, place[0] + 9, place[1] - 6);
  }

  function chords() {
    marks().stations_mm.forEach(function (r) {
      var both = ["leading", "trailing"].map(function (mark) {
        var list = clicksOn(mark, r), sum = [0, 0];
        list.forEach(function (own) { sum = [sum[0] + own.x_px / list.length, sum[1] + own.y_px / list.length]; });
        return list.length ? toScreen(sum[0], sum[1]) : null;
      });
      if (both[0] && both[1]) line(both[0], both[1], "rgba(255,255,255,0.75)");
    });
  }

  function render() {
    pen.fillStyle = "#22272b";
    pen.fillRect(0, 0, wide, tall);
    if (!image || !view || !known.state) return;
    pen.imageSmoothingEnabled = view.scale < 2;
    pen.drawImage(image, view.left, view.top, view.scale * image.naturalWidth, view.scale * image.naturalHeight);
    [["axis", "#7ddf7d"], ["scale", "#e0c0ff"]].forEach(function (own) {
      var ends = guides()[own[0]].map(function (end) { return toScreen(end[0], end[1]); });
      if (ends.length === 2) line(ends[0], ends[1], own[1], [6, 4]);
      ends.forEach(function (end) { line([end[0] - 5, end[1]], [end[0] + 5, end[1]], own[1]); line([end[0], end[1] - 5], [end[0], end[1] + 5], own[1]); });
    });
    var middle = [image.naturalWidth / 2, image.naturalHeight / 2], at = current && current.r !== null && (!marks().video.rest || marks().video.rest === frameName()) ? lineAt(current.r, middle) : null;
    if (at) line(toScreen(at[0][0], at[0][1]), toScreen(at[1][0], at[1][1]), "rgba(125,223,125,0.8)", [2, 5]);
    chords();
    marks().clicks.forEach(function (own) { if (own.frame === frameName()) dot(own, isSame(current, own.mark, own.r_mm)); });
    if (cross && isKeys) {
      var here = toScreen(cross[0], cross[1]);
      line([here[0] - 14, here[1]], [here[0] + 14, here[1]], "#ffffff");
      line([here[0], here[1] - 14], [here[0], here[1] + 14], "#ffffff");
    }
  }

  function read() {
    if (!cross) return say(told, "");
    var mm = millimetres(cross[0], cross[1]);
    say(told, "x " + cross[0].toFixed(1) + " px, y " + cross[1].toFixed(1) + " px" + (mm === null ? "" : ", " + plain(mm, 4) + " mm from the base"));
  }

  function place(event) {
    var box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  // The click of this frame under the pointer.
  function clickAt(x, y) {
    var least = NEAR, found = null;
    marks().clicks.forEach(function (own) {
      if (own.frame !== frameName()) return;
      var there = toScreen(own.x_px, own.y_px), far = Math.hypot(there[0] - x, there[1] - y);
      if (far < least) {
        least = far;
        found = own;
      }
    });
    return found;
  }

  function set() {
    if (!cross || !image) return;
    if (guide(cross[0], cross[1])) return;
    if (cross[0] < 0 || cross[1] < 0 || cross[0] > image.naturalWidth || cross[1] > image.naturalHeight) return tell("notice", "Click within the frame.");
    mark(cross[0], cross[1]);
  }

  canvas.addEventListener("pointerdown", function (event) {
    if (!view || !known.state) return;
    var at = place(event), isMoving = event.button === 1 || event.button === 2 || event.shiftKey;
    canvas.setPointerCapture(event.pointerId);
    held = { from: at, last: at, click: isMoving || tool ? null : clickAt(at[0], at[1]), isMoving: isMoving, has: false };
    // Another mark is chosen; a click on one of the current point is a repeat.
    if (held.click && isSame(current, held.click.mark, held.click.r_mm)) held.isRepeat = true;
    else if (held.click) choose({ mark: held.click.mark, r: held.click.r_mm });
  });
  canvas.addEventListener("pointermove", function (event) {
    if (!view) return;
    var at = place(event);
    isKeys = false;
    cross = toPicture(at[0], at[1]);
    if (held && Math.hypot(at[0] - held.from[0], at[1] - held.from[1]) > 4) held.has = true;
    if (held && held.has) {
      if (held.click) move(held.click, cross);
      else {
        view = { scale: view.scale, left: view.left + at[0] - held.last[0], top: view.top + at[1] - held.last[1] };
      }
      held.last = at;
      render();
    }
    read();
  });
  canvas.addEventListener("pointerup", function (event) {
    var own = held;
    held = null;
    known.what = null;
    if (!own || own.has || own.isMoving || (own.click && !own.isRepeat)) return;
    var at = place(event);
    cross = toPicture(at[0], at[1]);
    set();
  });
  canvas.addEventListener("pointercancel", function () { held = null; });
  canvas.addEventListener("contextmenu", function (event) { event.preventDefault(); });
  canvas.addEventListener("wheel", function (event) {
    event.preventDefault();
    var at = place(event);
    zoom(Math.exp(-event.deltaY * 0.0015), at[0], at[1]);
  }, { passive: false });

  function move(click, to) {
    change(function (own) {
      var found = own.clicks.filter(function (other) { return JSON.stringify(other) === JSON.stringify(click); })[0];
      if (!found) return;
      found.x_px = click.x_px = round(to[0]);
      found.y_px = click.y_px = round(to[1]);
    }, "drag");
  }

  function nudge(x, y) {
    if (!view) return;
    if (!cross) cross = toPicture(wide / 2, tall / 2);
    isKeys = true;
    cross = [cross[0] + x / view.scale, cross[1] + y / view.scale];
    // It stays in sight.
    var here = toScreen(cross[0], cross[1]);
    if (here[0] < 20 || here[1] < 20 || here[0] > wide - 20 || here[1] > tall - 20) {
      view = { scale: view.scale, left: view.left + wide / 2 - here[0], top: view.top + tall / 2 - here[1] };
    }
    render();
    read();
  }

  canvas.addEventListener("keydown", function (event) {
    if (event.ctrlKey || event.metaKey) return;
    var far = event.shiftKey ? 20 : event.altKey ? 0.25 : 2;
    var ways = { ArrowLeft: [-far, 0], ArrowRight: [far, 0], ArrowUp: [0, -far], ArrowDown: [0, far] };
    if (ways[event.key]) nudge(ways[event.key][0], ways[event.key][1]);
    else if (event.key === "Enter" || event.key === " ") set();
    else return;
    event.preventDefault();
  });

  function load() {
    var own = ++serial;
    known.isLoaded = false;
    window.fetch(root + "frame?index=" + known.frame).then(function (response) {
      if (response.ok) return response.blob();
      return response.json().catch(function () { return {}; }).then(function (body) { throw new Error(body.error ? words(body.error) : "The program does not answer."); });
    }).then(function (blob) {
      var next = new Image(), address = URL.createObjectURL(blob);
      return new Promise(function (yes, no) {
        next.onload = function () { yes(next); };
        next.onerror = function () { no(new Error("This frame is no picture that the browser can show.")); };
        next.src = address;
      }).then(function (shown) {
        if (own !== serial) return;
        var isOther = !image || image.naturalWidth !== shown.naturalWidth || image.naturalHeight !== shown.naturalHeight;
        if (image) URL.revokeObjectURL(image.src);
        image = shown;
        known.isLoaded = true;
        // Frames of one size keep the view, so that the eye can compare them.
        if (isOther) fit();
        else render();
      });
    }).catch(function (error) {
      if (own !== serial) return;
      image = null;
      render();
      tell("notice", frameName() + ": " + error.message);
    });
  }

  function middle(by) { return function () { zoom(by, wide / 2, tall / 2); }; }
  at("zoom-in").addEventListener("click", middle(1.4));
  at("zoom-out").addEventListener("click", middle(1 / 1.4));
  at("zoom-fit").addEventListener("click", fit);
  new ResizeObserver(function () {
    size();
    if (!view || view.isWhole) fit();
    else render();
  }).observe(canvas);
  ["state", "current", "tool"].forEach(function (what) { hear(what, render); });
  hear("state", read);
  hear("frame", load);

  return {
    // Millimetres under the cross, to make a station of.
    here: function () { return cross ? millimetres(cross[0], cross[1]) : null; }
  };
}
