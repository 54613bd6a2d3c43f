// The page without a program behind it: what was solved on a grid, and between its points what lies between them in every direction
// (multilinear interpolation). Everything in between says so.

// `all`: { state, axes, shape, points } as `washout live --export` writes it; the last axis runs fastest.
function grid(all) {
  var start = JSON.parse(JSON.stringify(all.state)), state = all.state, undone = [], done = [], gesture = null, revision = 0;

  function valueOf(axis, from) {
    var name = axis.key.replace(/^effect:/, "");
    var own = from.inputs.concat(from.effects).filter(function (one) { return one.key === axis.key || (one.name === name && name !== axis.key); })[0];
    return own.value === null ? own.none : own.value;
  }

  // The points around a place and the share of each; a share of nothing is left out.
  function around() {
    return all.axes.reduce(function (found, axis) {
      var value = valueOf(axis, state), last = axis.values.length - 1, k = 0;
      while (k < last - 1 && value > axis.values[k + 1]) k += 1;
      var share = last ? (value - axis.values[k]) / (axis.values[k + 1] - axis.values[k]) : 0;
      share = Math.max(0, Math.min(1, Math.abs(share) < 1e-9 ? 0 : Math.abs(share - 1) < 1e-9 ? 1 : share));
      var next = [];
      found.forEach(function (own) {
        [[k, 1 - share], [Math.min(last, k + 1), share]].forEach(function (end) {
          if (end[1] > 0) next.push({ index: own.index * axis.values.length + end[0], share: own.share * end[1] });
        });
      });
      return next;
    }, [{ index: 0, share: 1 }]);
  }

  function mix(parts, valuesOf) {
    var out = null;
    parts.forEach(function (part) {
      var values = valuesOf(all.points[part.index]);
      out = out || values.map(function () { return 0; });
      for (var k = 0; k < values.length; k++) out[k] = out[k] === null || values[k] === null ? null : out[k] + part.share * values[k];
    });
    return out;
  }

  function solve() {
    var parts = around(), bad = parts.filter(function (part) { return !all.points[part.index].solved; });
    var shape = JSON.parse(JSON.stringify(bad.length && known.shape ? known.shape : all.shape));
    shape.revision = state.revision;
    shape.shape_revision = revision += 1;
    shape.solved = !bad.length;
    shape.mesh_error_deg = shape.seconds = shape.stability = null;
    shape.interpolated = parts.length > 1;
    if (bad.length) {
      shape.refusal = { key: null, message: all.points[bad[0].index].refusal || "One of the neighbours that it would be taken from was not solved." };
      return learnShape(shape);
    }
    shape.refusal = null;
    shape.twist.twist_deg = mix(parts, function (point) { return point.twist_deg; });
    if (shape.angle_of_attack && all.points[parts[0].index].angle_of_attack_deg) {
      shape.angle_of_attack.deg = mix(parts, function (point) { return point.angle_of_attack_deg; });
    }
    var numbers = mix(parts, function (point) { return point.numbers; });
    shape.numbers.forEach(function (own, k) { own.value = numbers[k]; });
    shape.wing.loaded = mix(parts, function (point) { return point.loaded; });
    shape.wing.stroke = null;
    shape.stroke_phases = null;
    shape.wing.fields = shape.wing.fields.slice(0, all.points[parts[0].index].fields.length);
    shape.wing.fields.forEach(function (field, k) { field.values = mix(parts, function (point) { return point.fields[k]; }); });
    compare(shape);
    return learnShape(shape);
  }

  // What the readings of the shape would be against this curve.
  function compare(shape) {
    var curve = { x: shape.twist.r_mm, y: shape.twist.twist_deg }, chi2 = 0, sum = 0, count = 0;
    shape.residuals = [];
    (shape.twist.measured || []).forEach(function (run) {
      run.r_mm.forEach(function (r, k) {
        var model = along(curve, r), sigma = run.sigma_deg && run.sigma_deg[k], by = model === null ? null : run.twist_deg[k] - model;
        if (by === null) return;
        sum += by * by;
        count += 1;
        if (!sigma) return;
        chi2 += by * by / sigma / sigma;
        shape.residuals.push({ quantity: "twist", r_mm: r, measured: run.twist_deg[k], modelled: model, sigma: sigma, in_sigma: by / sigma });
      });
    });
    shape.chi2 = shape.residuals.length ? chi2 : null;
    shape.rms_deg = count ? Math.sqrt(sum / count) : null;
    shape.count = shape.residuals.length;
  }

  function values() {
    return state.inputs.concat(state.effects).map(function (own) { return own.value; });
  }
  function put(list) {
    state.inputs.concat(state.effects).forEach(function (own, k) { own.value = list[k]; });
  }

  // Takes a change in; what belongs to one gesture is one step of undo.
  function change(what, words, isDrag, apply) {
    begins(what, isDrag);
    if (gesture !== what) {
      undone = [];
      done.push([words, values()]);
    } else done[done.length - 1][0] = words;
    gesture = isDrag ? what : null;
    apply();
    tell("accepted", what);
    return learn();
  }

  function learn() {
    state.revision += 1;
    state.undo = done.length ? done[done.length - 1][0] : null;
    state.redo = undone.length ? undone[undone.length - 1][0] : null;
    learnState(state);
    solve();
    return Promise.resolve(state);
  }

  function move(list, back) {
    settle();
    var step = list.pop();
    if (!step) return Promise.resolve(state);
    begins("undo", false);
    back.push([step[0], values()]);
    put(step[1]);
    gesture = null;
    return learn();
  }

  // Beyond the grid nothing is known.
  function isRefused(what, own, value) {
    if (value === null || (value >= own.low && value <= own.high)) return false;
    var message = "Between " + plain(own.low, 4) + " and " + plain(own.high, 4) + " " + own.unit + " alone was solved for this page.";
    tell("refused", { what: what, refusal: { key: what, message: message, cure: null } });
    return true;
  }

  function take(what, own, value, isDrag) {
    if (isRefused(what, own, value)) return Promise.resolve(null);
    if (own.value === value && gesture !== what) return Promise.resolve(state);
    var words = (own.label || own.title) + " " + (value === null ? "out" : withUnit(value, own.unit));
    return change(what, words, isDrag, function () { own.value = value; });
  }

  var nothing = function () { return Promise.resolve(null); };
  return {
    isAlone: true,
    begin: function () {
      learnState(state);
      solve();
    },
    set: function (key, value, isDrag) {
      return take(key, state.inputs.filter(function (own) { return own.key === key; })[0], value, isDrag);
    },
    effect: function (name, value, isDrag) {
      return take("effect:" + name, state.effects.filter(function (own) { return own.name === name; })[0], value, isDrag);
    },
    undo: function () { return move(done, undone); },
    redo: function () { return move(undone, done); },
    reset: function () {
      settle();
      return change("reset", "start over", false, function () {
        put(start.inputs.concat(start.effects).map(function (own) { return own.value; }));
      });
    },
    show: nothing, diagnose: nothing, stop: nothing, add: nothing, save: nothing, table: nothing, confirm: nothing, open: nothing,
    hypothesis: nothing, refresh: nothing
  };
}
