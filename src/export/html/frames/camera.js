// How the camera stood: what the video file says of it. A refusal stands at its key.

var VIEWS = [["span", "along the span"], ["stroke", "along the stroke (or the stream)"], ["flapping-axis", "along the flapping axis (or from above)"]];
var TURNS = [["counterclockwise", "against the clock"], ["clockwise", "as the clock"]];

// What is needed, in the words of the page.
var NEEDED = {
  "view.root_angle_deg": "Needed: the angle between the air and the untwisted chord, e.g. 45.",
  "sigma_px": "Needed: by how much a click errs, e.g. 0.5; or click each point twice.",
  "references.distance_mm": "Needed: their distance; or tick \u201cshows the wing untwisted\u201d in the frame at rest."
};

function needed(refusal) { return /^is missing/.test(refusal.message) && NEEDED[refusal.key] || words(refusal); }

function camera() {
  var form = at("camera-form"), refused = {}, shape = null;

  function get(video, path) {
    return path.split(".").reduce(function (own, part) { return own === null || own === undefined ? null : own[part]; }, video);
  }

  function put(path, value) {
    change(function (own) {
      var parts = path.split("."), last = parts.pop(), into = own.video;
      parts.forEach(function (part) {
        if (!into[part]) into[part] = {};
        into = into[part];
      });
      into[last] = value;
      var all = own.video.references;
      if (all && !isNumber(all.distance_mm) && !isNumber(all.sigma_mm)) own.video.references = null;
    });
  }

  function place(path) {
    refused[path] = make("p", { "class": "refusal", role: "alert", hidden: true });
    return refused[path];
  }

  function choice(label, path, words) {
    var own = make("select", { "data-key": path, onchange: function () { put(path, own.value || null); } }, words.map(function (word) { return make("option", { value: word[0] }, word[1]); }));
    own.value = get(marks().video, path) || "";
    return [make("label", {}, [label, own]), place(path)];
  }

  function number(label, path, unit, hint) {
    var value = get(marks().video, path);
    var field = make("input", { "class": "field", inputmode: "decimal", autocomplete: "off", "data-key": path, placeholder: hint || "", value: isNumber(value) ? String(value) : "" });
    field.addEventListener("change", function () {
      var read = field.value.trim() === "" ? null : typed(field.value), isBad = field.value.trim() !== "" && read === null;
      field.setAttribute("aria-invalid", isBad ? "true" : "false");
      if (!isBad) return put(path, read);
      refused[path].hidden = false;
      say(refused[path], "This is no number.");
    });
    return [make("label", {}, [label, make("span", { "class": "typed" }, [field, make("span", { "class": "unit" }, unit)])]), place(path)];
  }

  function text(label, path) {
    var field = make("input", { "class": "field wide", autocomplete: "off", "data-key": path, value: get(marks().video, path) || "" });
    field.addEventListener("change", function () { put(path, field.value); });
    return [make("label", {}, [label, field]), place(path)];
  }

  function along(value) {
    var view = { along: value };
    if (value === "span") view.washout = "counterclockwise";
    change(function (own) { own.video.view = view; });
  }

  function rows() {
    var isSpan = marks().video.view.along === "span", own = choice("it looks", "view.along", VIEWS);
    own[0].querySelector("select").onchange = function (event) { along(event.target.value); };
    if (isSpan) own = own.concat(choice("washout turns the chord", "view.washout", TURNS), number("error of the zero", "view.zero_sigma_deg", "deg", "0"));
    else own = own.concat(number("angle of attack of the untwisted chord", "view.root_angle_deg", "deg", "needed"), number("error of that angle", "view.root_angle_sigma_deg", "deg", "0"));
    return own.concat(number("error of a click", "sigma_px", "px", "repeats"), number("distance of the two points", "references.distance_mm", "mm"),
      number("error of that distance", "references.sigma_mm", "mm", "0"), text("name", "name"), text("source", "source"));
  }

  function show(state) {
    var now = state.marks.video.view.along;
    // Fields that are typed in stay; another view has other fields, and what is taken back other values.
    var wanted = JSON.stringify([now, state.marks.video]);
    if (shape !== wanted && !(form.contains(document.activeElement) && shape && JSON.parse(shape)[0] === now && document.activeElement.tagName === "INPUT")) {
      var focus = document.activeElement && document.activeElement.getAttribute("data-key");
      shape = wanted;
      fill(form, [].concat.apply([], rows()));
      var again = focus && form.querySelector("[data-key='" + focus + "']");
      if (again) again.focus();
    }
    var refusal = state.told.refusal;
    Object.keys(refused).forEach(function (path) {
      var isHere = !!refusal && refusal.key === path;
      refused[path].hidden = !isHere;
      say(refused[path], isHere ? needed(refusal) : "");
    });
  }

  hear("state", show);
  return { has: function (key) { return key in refused; } };
}
