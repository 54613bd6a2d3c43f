// Saving: the video file and its marks, and the commands that go on from there.

function saving() {
  var box = at("save-box"), body = at("save-body");

  function save() {
    if (box.open || !known.state) return;
    if (known.isUnsent) return tell("notice", "Not saved: what you clicked last did not reach the program. Click again, or load this page again.");
    post("save", {}).then(function (done) {
      known.state.is_dirty = false;
      tell("state", known.state);
      var lacks = known.state.told.lacks.length;
      fill(body, [
        make("ul", { "class": "files" }, done.files.map(function (name) { return make("li", {}, [make("code", {}, name), /\.toml$/.test(name) ? " how the camera stood" : /-marks\.csv$/.test(name) ? " the clicks" : " the measurement"]); })),
        done.files.length < 3 ? make("p", { "class": "refusal" }, "No measurement was written, and one of before was left as it was: " + (lacks ? lacks + " points are still to be clicked." : known.state.told.refusal ? needed(known.state.told.refusal) : "say by how much a click errs, or click each point twice.")) : null,
        make("h3", {}, done.files.length < 3 ? "Once it is whole" : "The commands that do the same and go on"), make("pre", { tabindex: "0" }, done.commands.join("\n"))
      ]);
      say(at("heard"), done.files.length + " files written");
      box.showModal();
      at("save-close").focus();
    }, function (error) {
      if (error.refusal) tell("refused", error.refusal);
      else tell("reached", false);
    });
  }

  at("save").addEventListener("click", function () { whenSent(save); });
  at("save-close").addEventListener("click", function () { box.close(); });
  window.addEventListener("beforeunload", function (event) { if (known.state && (known.isUnsent || isSending)) event.preventDefault(); });
}
