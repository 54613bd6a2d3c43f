// What the page asks of the program that serves it. Changes go out one at a time, in order; of moves of one slider that wait
// only the newest goes out.

function server() {
  var queue = [], isSending = false, diagnosing = false;
  var asking = null;

  function next() {
    if (isSending || !queue.length) return;
    var own = queue.shift();
    isSending = true;
    post(own.path, own.body).then(function (answer) {
      tell("reached", true);
      own.done.forEach(function (done) { done[0](answer); });
    }, function (error) {
      if (!error.refusal) tell("reached", false);
      own.done.forEach(function (done) { done[1](error); });
    }).then(function () {
      isSending = false;
      next();
    });
  }

  // The move of a slider that waits, unless something else was asked after it.
  function waiting(what) {
    for (var k = queue.length - 1; k >= 0 && queue[k].what; k--) if (queue[k].what === what) return queue[k];
    return null;
  }

  // `what`: moves of the same take each other's place while they wait.
  function send(path, body, what) {
    return new Promise(function (yes, no) {
      var old = what && waiting(what);
      if (old) {
        old.body = body;
        old.done.push([yes, no]);
      } else queue.push({ path: path, body: body, what: what, done: [[yes, no]] });
      next();
    });
  }

  // A change answers the state; what is refused is said at its place.
  function change(path, body, what) {
    if (path !== "set" && path !== "effect") settle();
    if (/^(set|effect|add|undo|redo|reset)$/.test(path)) begins(what || path, !!body.drag);
    return send(path, body, what).then(function (state) {
      tell("accepted", what || path);
      learnState(state);
      return state;
    }, function (error) {
      tell("refused", { what: what || path, refusal: error.refusal || { key: null, message: "The program does not answer.", cure: null } });
      return null;
    });
  }

  // Asks again and again for what is newer, longer apart while nobody answers.
  function follow(path, serialOf, got, isOn) {
    var serial = 0, pause = 0;
    function ask() {
      if (!isOn()) return;
      fetched(path + "?after=" + serial + "&wait=20").then(function (answer) {
        tell("reached", true);
        pause = 0;
        if (answer) {
          serial = Math.max(serial, serialOf(answer));
          got(answer);
        }
        ask();
      }, function (error) {
        if (!error.refusal) tell("reached", false);
        pause = Math.min(5000, 2 * pause + 250);
        window.setTimeout(ask, pause);
      });
    }
    ask();
  }

  function followDiagnosis() {
    if (diagnosing) return;
    diagnosing = true;
    follow("diagnosis", function (own) { return own.serial; }, function (own) {
      diagnosing = own.running;
      tell("diagnosis", own);
    }, function () { return diagnosing; });
  }

  function refresh() { return fetched("state").then(learnState, function () {}); }

  function always() { return true; }

  return {
    begin: function () {
      refresh();
      follow("shape", function (own) { return own.shape_revision; }, function (shape) {
        learnShape(shape);
        // The ladder grows with the shape; another window may have changed something.
        window.clearTimeout(asking);
        asking = window.setTimeout(refresh, 250);
      }, always);
      fetched("diagnosis").then(function (own) {
        if (!own) return;
        tell("diagnosis", own);
        if (own.running) followDiagnosis();
      }, function () {});
    },
    set: function (key, value, isDrag) {
      var values = {};
      values[key] = value;
      return change("set", { values: values, drag: isDrag }, key);
    },
    effect: function (name, value, isDrag) { return change("effect", { name: name, value: value, drag: isDrag }, "effect:" + name); },
    show: function (index) { return change("case", { "case": index }); },
    undo: function () { return change("undo", {}); },
    redo: function () { return change("redo", {}); },
    reset: function () { return change("reset", {}); },
    diagnose: function () { return change("diagnose", {}).then(followDiagnosis); },
    // It does not wait for what it stops.
    stop: function () { return post("diagnose/stop", {}).then(learnState, function () {}); },
    hypothesis: function (index) { return fetched("hypothesis?index=" + index).catch(function () { return null; }); },
    add: function (index) { return change("add", { hypothesis: index }); },
    save: function () {
      settle();
      return send("save", {});
    },
    table: function (name, base64) { return send("table", { name: name, base64: base64 }); },
    confirm: function (ticket) { return change("table/confirm", { ticket: ticket }); },
    open: function (name, text) { return change("open", { name: name, text: text }); },
    refresh: refresh
  };
}
