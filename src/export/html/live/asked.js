// One question to the program that serves the page. What it refuses is an error with a `refusal`: { key, message, cure }.

var root = window.location.pathname.replace(/[^/]*$/, "") + "api/";

function fetched(path, options) {
  return window.fetch(root + path, options).then(function (response) {
    if (response.status === 204) return null;
    return response.json().catch(function () { return {}; }).then(function (body) {
      if (response.ok) return body;
      var refusal = body.error || { key: null, message: "the program answered " + response.status, cure: null };
      throw Object.assign(new Error(refusal.message), { refusal: refusal });
    });
  });
}

function post(path, body) {
  return fetched(path, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) });
}

// A refusal in words.
function words(refusal) {
  return refusal.message + (/[.!?]$/.test(refusal.message) || !refusal.cure ? "" : ".") + (refusal.cure ? " " + refusal.cure : "");
}
