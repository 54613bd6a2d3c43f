// What is asked of the page of `washout live`: looked at as a person would, not by its own functions.
window.probe = (function () {
  "use strict";
  function all(query) { return Array.from(document.querySelectorAll(query)); }
  function isSeen(own) {
    if (!own.checkVisibility || !own.checkVisibility({ checkVisibilityCSS: true, checkOpacity: true })) return false;
    return !own.closest(".unseen, .skip");
  }
  // Elements that hold text of their own, with the room that the text takes; what is scrolled out of sight is cut off.
  function texts() {
    var found = [], dialog = document.querySelector("dialog[open]");
    var walker = document.createTreeWalker(dialog || document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
      var node = walker.currentNode, own = node.parentElement;
      if (!node.textContent.trim() || !isSeen(own) || /SCRIPT|STYLE|OPTION|SELECT/.test(own.tagName)) continue;
      var range = document.createRange();
      range.selectNodeContents(node);
      Array.from(range.getClientRects()).forEach(function (box) {
        var room = clipped(box, own);
        if (room) found.push({ own: own, text: node.textContent.trim().slice(0, 40), room: room, box: box });
      });
    }
    return found;
  }
  function clipped(box, own) {
    var room = { left: box.left, right: box.right, top: box.top, bottom: box.bottom };
    for (var up = own; up; up = up.parentElement) {
      if (getComputedStyle(up).overflowX === "visible" && getComputedStyle(up).overflowY === "visible") continue;
      var edge = up.getBoundingClientRect();
      room.left = Math.max(room.left, edge.left);
      room.right = Math.min(room.right, edge.right);
      room.top = Math.max(room.top, edge.top);
      room.bottom = Math.min(room.bottom, edge.bottom);
    }
    return room.right - room.left > 1 && room.bottom - room.top > 1 ? room : null;
  }
  // Texts that lie on each other.
  function overlaps() {
    var found = [], list = texts().filter(function (own) { return !own.own.closest("#wing-marks, #wing-value, #grey, #solving"); });
    // What sticks to the top of a phone lies over what scrolls below it, and is opaque.
    var sticky = document.getElementById("curve");
    var isSticky = getComputedStyle(sticky).position === "sticky";
    list.forEach(function (a, k) {
      list.slice(k + 1).forEach(function (b) {
        if (isSticky && sticky.contains(a.own) !== sticky.contains(b.own)) return;
        if (a.own === b.own) return;
        var wide = Math.min(a.room.right, b.room.right) - Math.max(a.room.left, b.room.left);
        var tall = Math.min(a.room.bottom, b.room.bottom) - Math.max(a.room.top, b.room.top);
        if (wide > 2 && tall > 4) found.push(a.text + " / " + b.text + " (" + Math.round(wide) + " x " + Math.round(tall) + ")");
      });
    });
    return found;
  }
  // Text that is cut off where nothing scrolls.
  function cut() {
    return texts().filter(function (own) {
      if (own.own.closest(".legend, #cases, .table, pre, main > section, #inputs, dialog, #effects-list")) return false;
      return own.box.right > window.innerWidth + 1 || own.box.left < -1;
    }).map(function (own) { return own.text; }).concat(all("main > section").filter(function (own) {
      return own.scrollWidth > own.clientWidth + 1;
    }).map(function (own) { return own.id + " is too wide"; }), all("button, label, dt, dd, summary, h1, h2, h3, th").filter(function (own) {
      return isSeen(own) && own.scrollWidth > own.clientWidth + 1 && own.clientWidth > 0 && getComputedStyle(own).overflowX !== "visible";
    }).map(function (own) { return own.textContent; }));
  }
  function rgb(text) {
    var parts = text.match(/[\d.]+/g).map(Number);
    return parts.length > 3 ? parts : parts.concat(1);
  }
  function behind(own) {
    for (var up = own; up; up = up.parentElement) {
      var colour = rgb(getComputedStyle(up).backgroundColor);
      if (colour[3] > 0.9) return colour;
    }
    return rgb(getComputedStyle(document.documentElement).backgroundColor);
  }
  function light(colour) {
    return [0.2126, 0.7152, 0.0722].reduce(function (sum, share, k) {
      var part = colour[k] / 255;
      return sum + share * (part <= 0.03928 ? part / 12.92 : Math.pow((part + 0.055) / 1.055, 2.4));
    }, 0);
  }
  // Text that is too pale (WCAG 2.1: 4.5 to 1); what cannot be used now may be.
  function pale() {
    var found = {};
    texts().forEach(function (one) {
      if (one.own.closest(":disabled")) return;
      var style = getComputedStyle(one.own), ink = rgb(one.own.closest("svg") ? style.fill : style.color);
      var a = light(ink), b = light(behind(one.own)), ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
      if (ratio < 4.5) found[one.text] = ratio.toFixed(2);
    });
    return found;
  }
  // Frames a second while something is done in each, and the longest wait.
  function frames(seconds, each) {
    return new Promise(function (done) {
      var first = null, last = null, count = 0, worst = 0;
      window.requestAnimationFrame(function step(time) {
        if (first === null) first = time;
        else {
          count += 1;
          worst = Math.max(worst, time - last);
        }
        last = time;
        each(count);
        if (time - first < 1000 * seconds) window.requestAnimationFrame(step);
        else done({ frames: 1000 * count / (time - first), worst_ms: worst });
      });
    });
  }
  var canvas = document.getElementById("wing-canvas");
  function turn(count) {
    canvas.dispatchEvent(new KeyboardEvent("keydown", { key: ["ArrowLeft", "ArrowUp", "ArrowRight", "ArrowDown"][(count >> 4) % 4], cancelable: true }));
  }
  function curve() {
    var own = document.querySelector("#curve .plot .curve.model, #curve .plot .curve.stale");
    return own ? own.getAttribute("d") : null;
  }
  function slide(range, value, isOver) {
    range.value = value;
    range.dispatchEvent(new Event("input", { bubbles: true }));
    if (isOver) range.dispatchEvent(new Event("change", { bubbles: true }));
  }
  // From a move of a slider to the new curve, in ms; null where the curve stays.
  function moved(range, value) {
    return new Promise(function (done) {
      var before = curve(), from = performance.now();
      slide(range, value, true);
      (function look() {
        if (curve() !== before) done(performance.now() - from);
        else if (performance.now() - from > 5000) done(null);
        else setTimeout(look, 2);
      })();
    });
  }
  // One of a list, by a number between 0 and 1.
  function pick(query, share) {
    var list = all(query);
    return list[Math.floor(share * list.length)];
  }
  function press(query, share) {
    var own = pick(query, share || 0);
    if (own && own.checkVisibility()) own.click();
  }
  function along(own, share) { return Number(own.min) + share * (own.max - own.min); }
  var actions = {
    slide: function (a, b) {
      var own = pick("#inputs-groups input[type=range]", a);
      slide(own, along(own, b), 7 * a % 1 < 0.8);
    },
    type: function (a, b) {
      var own = pick("#inputs-groups .field", a), value = Number(own.value.replace("\u2212", "-"));
      own.value = b < 0.1 ? "1e9" : b < 0.2 ? "x" : String(value * (0.7 + 0.6 * b));
      own.dispatchEvent(new Event("change"));
    },
    back: function (a) { press(".back:not(.idle)", a); },
    add: function (a) { press("#effects-list button", a); },
    out: function (a) { press(".out", a); },
    strength: function (a, b) {
      var own = pick("#effects-in input[type=range]", a);
      if (own) slide(own, along(own, b), true);
    },
    "case": function (a) { press("#cases button", a); },
    undo: function () { press("#undo"); },
    redo: function () { press("#redo"); },
    reset: function () { press("#reset"); },
    ask: function (a) { press(a < 0.5 ? "#ask" : "#stop"); },
    hover: function (a) {
      var own = pick(".hypotheses li", a);
      if (own) own.dispatchEvent(new PointerEvent(3 * a % 1 < 0.7 ? "pointerenter" : "pointerleave"));
    },
    hypothesis: function (a) { press(".hypotheses button", a); },
    search: function (a) {
      var own = document.getElementById("effects-search");
      own.value = ["", "rod", "zzz", "tip"][Math.floor(4 * a)];
      own.dispatchEvent(new Event("input"));
    },
    view: function (a) { press("#wing-views button", a); },
    list: function (a, b) {
      var own = pick("#wing-controls select", a);
      own.selectedIndex = Math.floor(b * own.options.length);
      own.dispatchEvent(new Event("change"));
    },
    play: function () { press("#wing-play"); },
    table: function (a) {
      var own = pick(".behind", a);
      own.open = !own.open;
    },
    help: function () { press(document.querySelector("dialog[open]") ? "#keys-close" : "#help"); }
  };
  return {
    act: function (name, a, b) { actions[name](a, b); },
    overlaps: overlaps, cut: cut, pale: pale, frames: frames, turn: turn, moved: moved, slide: slide,
    isReady: function () { return all(".mover").length > 1 && !document.getElementById("wing-live").hidden && curve() !== null; },
    isResting: function () {
      var isSought = !document.getElementById("grey").hidden && document.getElementById("grey-word").textContent === "Not solved yet.";
      return document.getElementById("solving").hidden && !isSought;
    },
    text: function (query) {
      var own = document.querySelector(query);
      return own ? own.textContent : null;
    },
    ladder: function () {
      return all("#ladder tbody tr").map(function (row) { return Array.from(row.children).map(function (cell) { return cell.textContent; }); });
    },
    ranges: function () { return all("#inputs-groups input[type=range]"); }
  };
})();
