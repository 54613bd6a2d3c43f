//! Answers, each sealed against other pages.

use http_body_util::Full;
use hyper::body::Bytes;
use hyper::header::{
    CACHE_CONTROL, CONTENT_SECURITY_POLICY, CONTENT_TYPE, HeaderName, HeaderValue, REFERRER_POLICY,
    X_CONTENT_TYPE_OPTIONS,
};
use hyper::{Response, StatusCode};

/// What goes back.
pub type Answer = Response<Full<Bytes>>;

/// What every answer carries: it is kept nowhere, read as nothing else, and used by no other page.
const SEAL: [(HeaderName, &str); 6] = [
    (CACHE_CONTROL, "no-store"),
    (X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (REFERRER_POLICY, "no-referrer"),
    (
        HeaderName::from_static("cross-origin-opener-policy"),
        "same-origin",
    ),
    (
        HeaderName::from_static("cross-origin-resource-policy"),
        "same-origin",
    ),
    (
        CONTENT_SECURITY_POLICY,
        "default-src 'none'; frame-ancestors 'none'",
    ),
];

/// One without a word.
pub fn empty(status: StatusCode) -> Answer {
    body(status, "text/plain; charset=utf-8", Vec::new())
}

/// JSON.
pub fn json(status: StatusCode, text: impl Into<Vec<u8>>) -> Answer {
    body(status, "application/json", text.into())
}

/// A picture.
pub fn picture(kind: &'static str, bytes: Vec<u8>) -> Answer {
    body(StatusCode::OK, kind, bytes)
}

/// A page whose scripts and styles are known by a nonce of hexadecimal digits.
pub fn page(html: String, nonce: &str) -> Answer {
    let policy = format!(
        "default-src 'none'; script-src 'nonce-{nonce}'; style-src 'nonce-{nonce}'; img-src data: blob:; connect-src 'self'; \
         base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    );
    let mut answer = body(StatusCode::OK, "text/html; charset=utf-8", html.into_bytes());
    let policy = HeaderValue::try_from(policy).expect("digits and words");
    answer.headers_mut().insert(CONTENT_SECURITY_POLICY, policy);
    answer
}

fn body(status: StatusCode, kind: &'static str, bytes: Vec<u8>) -> Answer {
    let mut answer = Response::new(Full::from(bytes));
    *answer.status_mut() = status;
    let fields = answer.headers_mut();
    for (name, value) in SEAL {
        fields.insert(name, HeaderValue::from_static(value));
    }
    fields.insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    answer
}
