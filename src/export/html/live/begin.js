// Everything is put together, and the program is asked for the first time.

function begin() {
  var ask = server();
  // What is said of the shape stands on it.
  at("wing-stage").appendChild(at("grey"));
  at("wing-stage").appendChild(at("solving"));
  status();
  history(ask);
  inputs(ask);
  effects(ask);
  curve();
  attack();
  residuals();
  figures();
  ladder();
  missing(ask);
  hear("shape", wingView.show);
  keyboard(ask, { cases: cases(ask), save: save(ask), sheet: sheet(ask) });
  ask.begin();
}

begin();
