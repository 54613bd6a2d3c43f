// What is missing: the diagnosis, how far it is, and its answer in rows.

function missing(ask) {
  var button = at("ask"), progress = at("asked"), bar = at("asked-bar"), answer = at("answer"), shown = null, answeredAt = null, file = null, models = {}, rows = [];

  button.addEventListener("click", ask.diagnose);
  at("stop").addEventListener("click", ask.stop);

  hear("state", function (state) {
    // The answer belongs to what was open.
    if (file !== null && file !== state.file) {
      fill(answer, []);
      answeredAt = null;
      tell("tried", null);
    }
    file = state.file;
    button.disabled = !state.measured;
    at("no-readings").hidden = state.measured;
    at("hint").hidden = !state.measured || answer.children.length > 0 || !progress.hidden;
    // That which was asked about is remembered, and while a question runs every one.
    if (progress.hidden) models = answeredAt in models ? Object.fromEntries([[answeredAt, models[answeredAt]]]) : {};
    models[state.revision] = modelOf(state);
    rows.forEach(function (row) { row.hold(state); });
    at("answer-old").hidden = answeredAt === null || models[answeredAt] === modelOf(state);
    answer.classList.toggle("old", !at("answer-old").hidden);
  });

  // What an answer depends on: values that come back by undo are the same model.
  function modelOf(state) { return JSON.stringify(state.inputs.concat(state.effects).map(function (own) { return own.value; })); }

  hear("diagnosis", function (own) {
    progress.hidden = !own.running;
    button.hidden = own.running;
    at("hint").hidden = own.running || !!own.answer;
    if (own.running) {
      say(at("stage"), (own.stage || "starting") + (isNumber(own.seconds_left) ? ", about " + plain(Math.ceil(own.seconds_left), 3) + " s left" : ""));
      if (isNumber(own.done)) bar.value = own.done;
      else bar.removeAttribute("value");
    }
    if (own.error) notice(own.error);
    if (own.answer && own.serial !== shown) {
      shown = own.serial;
      answeredAt = isNumber(own.revision) ? own.revision : known.state && known.state.revision;
      build(own.answer);
      at("answer-old").hidden = true;
    }
    if (!own.answer && !own.running) fill(answer, []);
  });

  function build(own) {
    rows = own.hypotheses.map(function (one, index) { return hypothesis(ask, one, index); });
    var all = rows.map(function (row) { return row.box; });
    var likely = all.slice(0, 5), rest = all.slice(5);
    fill(answer, [
      make("p", { "class": "sentence" }, own.sentence),
      all.length ? make("ol", { "class": "hypotheses" }, likely) : null,
      rest.length ? make("details", {}, [make("summary", {}, rest.length + " less likely"), make("ol", { "class": "hypotheses" }, rest)]) : null,
      make("div", { id: "cause" }),
      own.next ? next(own.next) : null,
      isNumber(own.probability_nothing) || isNumber(own.probability_unknown) ? make("p", { "class": "quiet" }, [
        isNumber(own.probability_nothing) ? "Nothing is missing: " + share(own.probability_nothing) + ". " : null,
        isNumber(own.probability_unknown) ? "The cause is none of these: " + share(own.probability_unknown) + "." : null
      ]) : null,
      make("p", { "class": "quiet" }, own.tried + " effects were tried" + (isNumber(own.of) && own.of !== own.tried ? " of " + own.of : "") + "."),
      (own.notes || []).length ? make("details", {}, [make("summary", {}, "Notes"), make("ul", { "class": "quiet" }, own.notes.map(function (text) { return make("li", {}, text); }))]) : null
    ]);
    cause(own.unknown_cause);
    say(at("heard"), own.sentence);
  }
}

// What to measure next, and how far apart the hypotheses are expected there: from three standard deviations on they are distinguished.
function next(own) {
  var most = own.candidates.reduce(function (found, one) { return Math.max(found, one.separation_sigma); }, 3);
  var rows = own.candidates.map(function (one) {
    var bar = make("span", { "class": "probability", "aria-hidden": "true" }, make("span", {}));
    bar.firstChild.style.width = 100 * one.separation_sigma / most + "%";
    return make("li", {}, [make("span", { "class": "row" }, [one.name, make("span", { "class": "percent" }, plain(one.separation_sigma, 2) + " \u03c3 apart")]), one.conditions ? make("span", { "class": "quiet" }, one.conditions) : null, bar]);
  });
  return make("div", {}, [
    make("h3", {}, "What to measure next"), make("p", {}, own.words), make("p", { "class": "quiet" }, "Experiments that the study lists, or readings that could be added:"),
    rows.length ? make("ul", { "class": "candidates", "aria-label": "Where the hypotheses part" }, rows) : null
  ]);
}

// Where the moment of an unknown cause acts along the span, with its band.
function cause(own) {
  if (!own) return;
  chart("cause", { title: "The moment that is missing", y: { label: "moment", unit: "mN mm per mm" }, least: 1e-6 }).show({
    lines: [{ name: "unknown cause", look: "tried", x: own.r_mm, y: own.moment_mnm_per_m }], points: [],
    bands: [{ look: "tried", x: own.r_mm, low: own.low, high: own.high }]
  }, {
    heads: ["distance from the base (mm)", "moment (mN mm per mm)", "at least", "at most"],
    rows: function () { return own.r_mm.map(function (r, k) { return [r, own.moment_mnm_per_m[k], own.low[k], own.high[k]]; }); }
  });
}
