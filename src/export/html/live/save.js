// Saving: first what would be done, then what was written, with the commands that do the same.

function save(ask) {
  var box = at("save-box"), body = at("save-body"), button = at("save-now");

  function commands(list) {
    if (!list || !list.length) return [make("p", { "class": "quiet" }, "Nothing was changed: there is no command to give.")];
    var text = list.join("\n"), copy = make("button", {
      type: "button", onclick: function () {
        var done = function () { say(copy, "Copied"); };
        if (navigator.clipboard) navigator.clipboard.writeText(text).then(done, function () { say(copy, "Select the text to copy it"); });
      }
    }, "Copy");
    return [make("div", { "class": "row" }, [make("h3", {}, "Commands that do the same"), copy]), make("pre", { tabindex: "0" }, text)];
  }

  function open() {
    if (box.open || !known.state) return;
    fill(body, [make("p", {}, "Writes the design or study as it is now, and its report.")].concat(commands(known.state.save && known.state.save.commands)));
    button.hidden = false;
    box.showModal();
    button.focus();
  }

  button.addEventListener("click", function () {
    button.disabled = true;
    say(button, "Saving \u2026");
    ask.save().then(function (done) {
      button.hidden = true;
      fill(body, [
        make("h3", {}, "Written"), make("ul", { "class": "files" }, done.files.map(function (name) { return make("li", {}, make("code", {}, name)); }))
      ].concat(commands(done.commands)));
      say(at("heard"), done.files.length + " files written");
      at("save-close").focus();
      ask.refresh();
    }, function (error) {
      fill(body, [make("p", { "class": "refusal", role: "alert" }, error.refusal ? words(error.refusal) : "The program does not answer. Nothing was written.")]);
    }).then(function () {
      button.disabled = false;
      say(button, "Save the files");
    });
  });
  at("save").addEventListener("click", open);
  at("save-close").addEventListener("click", function () { box.close(); });
  return { open: open };
}
