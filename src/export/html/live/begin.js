// Everything is put together, and the program is asked for the first time.

function begin() {
  var solved = at("grid"), ask = solved ? grid(JSON.parse(solved.textContent)) : server();
  if (ask.isAlone) document.body.classList.add("alone");
  // What is said of the shape stands on it.
  at("wing-stage").appendChild(at("grey"));
  at("wing-stage").appendChild(at("solving"));
  history(ask);
  inputs(ask);
  effects(ask);
  // After those that have a place for a refusal.
  status();
  curve();
  attack();
  residuals();
  figures();
  ladder();
  hear("shape", wingView.show);
  if (ask.isAlone) keyboard({});
  else {
    missing(ask);
    keyboard({ cases: cases(ask), save: save(ask), sheet: sheet(ask) });
  }
  ask.begin();
}

begin();
