// Files in: a table of readings, a design or a study, dropped on the page or chosen. Of a table it is shown what was understood, and
// only then it is taken.

function sheet(ask) {
  var box = at("sheet-box"), body = at("sheet-body"), chooser = at("file"), veil = at("drop"), ticket = null;
  var MOST = 11e6;

  function take(file) {
    if (file.size > MOST) return notice(file.name + " has " + plain(file.size / 1e6, 3) + " MB; a table may have 11 MB.");
    if (/\.toml$/i.test(file.name)) return file.text().then(function (text) { return ask.open(file.name, text); });
    return file.arrayBuffer().then(function (bytes) {
      return ask.table(file.name, base64(new Uint8Array(bytes)));
    }).then(understood, function (error) {
      notice(error.refusal ? words(error.refusal) : "The program does not answer.");
    });
  }

  function base64(bytes) {
    var text = "";
    for (var k = 0; k < bytes.length; k += 0x8000) text += String.fromCharCode.apply(null, bytes.subarray(k, k + 0x8000));
    return window.btoa(text);
  }

  function understood(found) {
    ticket = found.ticket;
    var rows = found.rows || [];
    fill(body, [
      make("pre", { "class": "words", tabindex: "0" }, found.understood),
      rows.length > 1 ? table("What was read", rows[0].map(String), rows.slice(1, 13)) : null,
      rows.length > 13 ? make("p", { "class": "quiet" }, "and " + (rows.length - 13) + " rows more") : null
    ]);
    box.showModal();
    at("sheet-yes").focus();
  }

  at("sheet-yes").addEventListener("click", function () {
    box.close();
    ask.confirm(ticket);
  });
  at("sheet-no").addEventListener("click", function () { box.close(); });
  at("open").addEventListener("click", function () { chooser.click(); });
  chooser.addEventListener("change", function () {
    if (chooser.files.length) take(chooser.files[0]);
    chooser.value = "";
  });

  // Something is held over the page: it says what may be dropped.
  var depth = 0;
  function isFile(event) { return known.state && known.state.takes_files !== false && event.dataTransfer && Array.from(event.dataTransfer.types).indexOf("Files") >= 0; }
  window.addEventListener("dragenter", function (event) {
    if (!isFile(event)) return;
    depth += 1;
    veil.hidden = false;
  });
  window.addEventListener("dragleave", function () {
    depth = Math.max(0, depth - 1);
    if (!depth) veil.hidden = true;
  });
  window.addEventListener("dragover", function (event) { if (isFile(event)) event.preventDefault(); });
  window.addEventListener("drop", function (event) {
    depth = 0;
    veil.hidden = true;
    if (!isFile(event)) return;
    event.preventDefault();
    if (event.dataTransfer.files.length) take(event.dataTransfer.files[0]);
  });
  return { choose: function () { chooser.click(); } };
}
