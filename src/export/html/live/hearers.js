// Who wants to hear of a change.

var hearers = {};

function hear(what, own) { (hearers[what] = hearers[what] || []).push(own); }

function tell(what, news) {
  (hearers[what] || []).forEach(function (own) { own(news); });
}
