// Lists, buttons and the slider above and below the picture.

function choice(parent, label, names, chosen, apply) {
  var box = document.createElement("label"), list = document.createElement("select");
  names.forEach(function (entry) {
    var option = document.createElement("option");
    option.value = entry[0];
    option.textContent = entry[1];
    list.appendChild(option);
  });
  list.value = String(chosen);
  list.addEventListener("change", function () { apply(list.value); });
  box.appendChild(document.createTextNode(label + " "));
  box.appendChild(list);
  parent.appendChild(box);
}

function button(parent, name, title, press) {
  var own = document.createElement("button");
  own.type = "button";
  own.textContent = name;
  own.title = title;
  own.addEventListener("click", press);
  parent.appendChild(own);
  return own;
}

function slider(parent, name, steps, at, move) {
  var own = document.createElement("input");
  own.type = "range";
  own.min = 0;
  own.max = steps;
  own.step = 1;
  own.value = at;
  own.setAttribute("aria-label", name);
  own.addEventListener("input", function () { move(Number(own.value)); });
  parent.appendChild(own);
  return own;
}

// A number of the summary of the run between words, as all numbers of the page say where they are from; nothing where there is none.
var summary = null;
function numberOf(parent, before, place, after) {
  var holder = document.getElementById("summary");
  summary = summary || (holder && JSON.parse(holder.textContent));
  var value = place.split("/").slice(1).reduce(function (at, key) { return at && at[key]; }, summary);
  if (typeof value !== "number") return;
  var shown = document.createElement("data");
  shown.value = String(value);
  shown.setAttribute("data-in", "summary");
  shown.setAttribute("data-of", place);
  shown.textContent = value.toFixed(1);
  parent.appendChild(document.createTextNode(before));
  parent.appendChild(shown);
  parent.appendChild(document.createTextNode(after));
}
