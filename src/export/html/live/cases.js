// The cases of a study as tabs; a design has one and shows none.

function cases(ask) {
  var holder = at("cases"), signature = "", shown = null;

  function build(state) {
    fill(holder, state.cases.map(function (own, index) {
      return make("button", {
        type: "button", role: "tab", id: "case-" + index, "aria-controls": "wing", onclick: function () { ask.show(index); },
        onkeydown: function (event) {
          var by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
          if (!by) return;
          event.preventDefault();
          step(by, true);
        }
      }, [
        make("span", {}, own.name), own.held_out ? make("span", { "class": "tag" }, "held out") : null,
        isNumber(own.rms_deg) ? make("span", { "class": "rms", title: "rms error of the twist in this case, calibrated" }, plain(own.rms_deg, 2) + "\u00b0") : null
      ]);
    }));
  }

  // The next case, or the one before.
  function step(by, isFocused) {
    var many = known.state.cases.length, index = (known.state["case"] + by + many) % many;
    if (many < 2) return;
    ask.show(index).then(function () { if (isFocused) at("case-" + index).focus(); });
  }

  hear("state", function (state) {
    holder.hidden = state.cases.length < 2;
    var words = JSON.stringify([state.file, state.cases]), hadFocus = holder.contains(document.activeElement);
    if (words !== signature) build(state);
    signature = words;
    state.cases.forEach(function (own, index) {
      var isShown = index === state["case"], tab = at("case-" + index);
      dress(tab, { "aria-selected": isShown ? "true" : "false", tabindex: isShown ? "0" : "-1" });
      if (isShown && hadFocus && document.activeElement !== tab) tab.focus();
      if (isShown && !holder.hidden && shown !== index) {
        shown = index;
        var left = tab.offsetLeft - holder.offsetLeft;
        if (left < holder.scrollLeft || left + tab.offsetWidth > holder.scrollLeft + holder.clientWidth) holder.scrollLeft = left - 40;
      }
    });
  });
  return { step: step };
}
