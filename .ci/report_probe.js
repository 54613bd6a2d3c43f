// Runs in a report after it has loaded: works every control of the wing and writes down what was seen, as #told.
window.addEventListener("load", function () {
  "use strict";
  var told = { faults: window.faults, ready_ms: Math.round(performance.now()), pictures: document.querySelectorAll(".picture svg").length };
  var canvas = document.getElementById("wing-canvas");
  var copy = document.createElement("canvas").getContext("2d", { willReadFrequently: true });

  function finish() {
    var element = document.createElement("script"), text = JSON.stringify(told);
    element.type = "application/json";
    element.id = "told";
    element.textContent = text.replace(/</g, "\\u003c");
    document.body.appendChild(element);
    // A page in a frame cannot be read from outside.
    if (window.parent !== window) window.parent.postMessage(text, "*");
  }
  function part(name) { return document.getElementById("wing-" + name); }
  function lists() { return Array.from(document.querySelectorAll("#wing-controls select")); }
  function list(label) {
    return lists().filter(function (own) { return own.parentNode.textContent.indexOf(label) === 0; })[0];
  }
  function choose(own, value) {
    own.value = value;
    own.dispatchEvent(new Event("change"));
  }
  function values(own) { return own ? Array.from(own.options).map(function (option) { return option.value; }) : []; }

  // Opaque pixels, colours, and a number that another picture does not have. Printing draws at once.
  function picture() {
    window.dispatchEvent(new Event("beforeprint"));
    copy.canvas.width = canvas.width;
    copy.canvas.height = canvas.height;
    copy.drawImage(canvas, 0, 0);
    var pixels = copy.getImageData(0, 0, canvas.width, canvas.height).data, seen = {}, opaque = 0, sum = 0;
    for (var i = 0; i < pixels.length; i += 4) {
      if (pixels[i + 3] !== 255) continue;
      opaque += 1;
      seen[pixels[i] + "," + pixels[i + 1] + "," + pixels[i + 2]] = true;
      sum = (sum * 31 + i + pixels[i] * 7 + pixels[i + 1] * 5 + pixels[i + 2]) % 4294967291;
    }
    return [opaque, Object.keys(seen).length, sum];
  }
  function drawn(what) {
    var now = picture();
    if (now[0] < told.least || now[1] < 20) window.faults.push("hardly anything drawn: " + what + ": " + now);
    return now[2];
  }
  function differ(what, sums) {
    if (new Set(sums).size !== sums.length) window.faults.push(what + " do not differ");
  }

  function at(kind, x, y) {
    var room = canvas.getBoundingClientRect();
    var event = { clientX: room.left + x * room.width, clientY: room.top + y * room.height, pointerId: 1, pointerType: "mouse" };
    canvas.dispatchEvent(new PointerEvent(kind, event));
  }
  // What is said under the cursor all over the picture, and whether it stands within it.
  function values_under() {
    var found = [], stage = part("stage").getBoundingClientRect();
    for (var i = 0; i <= 24; i++) for (var j = 1; j < 16; j++) {
      at("pointermove", i / 24, j / 16);
      var box = part("value");
      if (box.hidden) continue;
      var room = box.getBoundingClientRect();
      if (room.left < stage.left - 1 || room.right > stage.right + 1 || room.top < stage.top - 1 || room.bottom > stage.bottom + 1) {
        window.faults.push("the value stands outside the picture");
      }
      found.push([box.children[0].textContent, box.children[1].textContent]);
    }
    at("pointerleave", 0, 0);
    if (!part("value").hidden) window.faults.push("the value stays when the cursor has left");
    return found;
  }

  function slide(place) {
    var own = part("slider");
    own.value = place;
    own.dispatchEvent(new Event("input"));
    return drawn("slider at " + place) + " " + part("told").textContent;
  }

  function work(mode) {
    var own = { mode: mode, colours: [], values: [], told: [] };
    // The least of the picture that a wing takes, seen along its edge; over the stroke the picture has room for the whole arc.
    told.least = (mode === "stroke" ? 0.0008 : 0.004) * canvas.width * canvas.height;
    if (list("Show")) choose(list("Show"), mode);
    var wings = values(list("Wing"));
    wings.forEach(function (wing) {
      choose(list("Wing"), wing);
      drawn("wing " + wing);
    });
    if (wings.length) choose(list("Wing"), wings[0]);
    differ("colours", values(list("Colour")).map(function (name) {
      choose(list("Colour"), name);
      var sum = drawn("colour " + name);
      own.colours.push(name);
      own.values.push(values_under());
      return sum;
    }));
    choose(list("Colour"), own.colours[0]);
    var first = drawn("the first view"), buttons = Array.from(document.querySelectorAll("#wing-views button"));
    own.views = buttons.map(function (button) { return button.textContent; });
    differ("views", buttons.map(function (button) {
      button.click();
      return drawn("view " + button.textContent);
    }));
    var keys = ["ArrowLeft", "ArrowUp", "ArrowRight", "ArrowDown", "+", "-"].map(function (key) {
      canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "0", cancelable: true }));
      canvas.dispatchEvent(new KeyboardEvent("keydown", { key: key, cancelable: true }));
      return drawn("key " + key);
    });
    differ("keys", keys.concat(first));
    canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "0", cancelable: true }));
    if (drawn("key 0") !== first) window.faults.push("key 0 does not give the first view");
    at("pointerdown", 0.4, 0.4);
    at("pointermove", 0.6, 0.5);
    at("pointerup", 0.6, 0.5);
    if (drawn("dragged") === first) window.faults.push("dragging does not turn the wing");
    buttons[0].click();
    own.ghosts = values(list("Ghost"));
    // An unloaded wing that hides behind the loaded one is still another picture with a ghost than without.
    differ("ghosts", own.ghosts.map(function (name) {
      choose(list("Ghost"), name);
      return drawn("ghost " + name);
    }));
    choose(list("Ghost"), "rest");
    differ("deformations", values(list("Deformation")).map(function (times) {
      choose(list("Deformation"), times);
      return drawn("deformation " + times);
    }));
    choose(list("Deformation"), "1");
    var most = Number(part("slider").max), places = mode === "stroke" ? [] : [0, 0.5, 1];
    for (var k = 0; mode === "stroke" && k <= most; k += Math.ceil(most / 8)) places.push(k / most);
    differ("places of the slider", places.map(function (share) {
      var sum = slide(Math.round(share * most));
      own.told.push(part("told").innerHTML);
      if (mode === "stroke") own.values.push(values_under());
      return sum;
    }));
    return own;
  }

  // By itself the picture stands still; played, it moves, until it is stopped.
  function played(done) {
    var play = part("play"), left = 60;
    told.has_play = !!play;
    if (!play) return done();
    slide(0);
    setTimeout(function () {
      told.is_still = part("slider").value === "0";
      play.click();
      setTimeout(function look() {
        told.is_moved = part("slider").value !== "0";
        left -= 1;
        if (!told.is_moved && left > 0) return setTimeout(look, 100);
        play.click();
        done();
      }, 100);
    }, 300);
  }

  told.overflow = document.documentElement.scrollWidth - document.documentElement.clientWidth;
  if (!canvas) return finish();
  told.pen = canvas.getAttribute("data-pen");
  told.still_is_hidden = part("still").hidden;
  if (!told.still_is_hidden) return finish();
  var room = canvas.getBoundingClientRect();
  told.size = [room.width, room.height];
  told.works = [work("load")];
  if (values(list("Show")).length) told.works.push(work("stroke"));
  played(finish);
});
