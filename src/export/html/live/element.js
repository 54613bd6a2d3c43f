// Elements of the page: made, filled, found.

function at(id) { return document.getElementById(id); }

// A child is an element or text; an attribute `on…` is a listener, one that is null or false is left out.
function make(kind, attributes, children) {
  var own = document.createElement(kind);
  dress(own, attributes);
  return fill(own, children);
}

function dress(own, attributes) {
  Object.keys(attributes || {}).forEach(function (name) {
    var value = attributes[name];
    if (value === null || value === undefined || value === false) return;
    if (typeof value === "function") own.addEventListener(name.slice(2), value);
    else own.setAttribute(name, value === true ? "" : value);
  });
}

function fill(own, children) {
  own.textContent = "";
  [].concat(children === undefined ? [] : children).forEach(function (child) {
    if (child !== null) own.appendChild(typeof child === "object" ? child : document.createTextNode(child));
  });
  return own;
}

// Text that stays the same is left alone: a screen reader would read it again.
function say(own, text) {
  if (own.textContent !== text) own.textContent = text;
}

var SVG = "http://www.w3.org/2000/svg";

function draw(parent, kind, attributes, text) {
  var own = document.createElementNS(SVG, kind);
  dress(own, attributes);
  if (text !== undefined) own.textContent = text;
  parent.appendChild(own);
  return own;
}

function key(name) { return make("kbd", {}, name); }

// A table of a caption, heads and rows of text or elements; numbers stand to the right.
function table(caption, heads, rows) {
  function cells(kind, row) {
    return make("tr", {}, row.map(function (cell, k) {
      var isNumber = typeof rows[0][k] === "number" || (rows[0][k] !== null && /^[<>]?[\u2212-]?[\d.]+$/.test(rows[0][k]));
      var text = typeof cell === "number" ? plain(cell, 4) : cell === null ? "" : cell;
      return make(kind, { "class": isNumber ? "n" : null, scope: kind === "th" ? "col" : null }, text);
    }));
  }
  if (!rows.length) return make("p", { "class": "quiet" }, "Nothing yet.");
  return make("div", { "class": "table", tabindex: "0", role: "region", "aria-label": caption }, make("table", {}, [
    make("caption", { "class": "unseen" }, caption),
    make("thead", {}, cells("th", heads)),
    make("tbody", {}, rows.map(function (row) { return cells("td", row); }))
  ]));
}
