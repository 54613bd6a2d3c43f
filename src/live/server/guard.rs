//! Who may ask: the token stands in the path, the host is this machine, and what changes something comes from the page itself.

use hyper::header::{CONTENT_LENGTH, CONTENT_TYPE, HOST, HeaderMap, HeaderName, ORIGIN, TRANSFER_ENCODING};
use hyper::http::request::Parts;
use hyper::{Method, StatusCode};

use super::token::Token;

/// Bytes that a body may have.
const BODY: usize = 1024 * 1024;
/// The same of a table.
const TABLE: usize = 16 * 1024 * 1024;

/// Guards one server.
#[derive(Debug)]
pub struct Guard {
    token: Token,
    port: u16,
}

/// A request that may be answered.
#[derive(Debug, Clone, PartialEq)]
pub struct Passed {
    /// The path behind the token, without a slash in front; empty for the page.
    pub path: String,
    /// The query, parameter by parameter.
    pub query: Vec<(String, String)>,
    /// Whether it may change something.
    pub is_post: bool,
    /// Bytes of its body, at most.
    pub length: usize,
}

impl Guard {
    /// Of a server on a port of this machine.
    pub fn new(token: Token, port: u16) -> Guard {
        Guard { token, port }
    }

    /// The token.
    pub fn token(&self) -> &Token {
        &self.token
    }

    /// Lets a request pass, or says how it is refused.
    ///
    /// # Errors
    /// If it comes from elsewhere, or is not what a page sends.
    pub fn pass(&self, head: &Parts) -> Result<Passed, StatusCode> {
        let hosts = ["127.0.0.1", "localhost"].map(|name| format!("{name}:{}", self.port));
        let host = field(&head.headers, HOST)
            .filter(|host| hosts.iter().any(|own| own == host))
            .ok_or(StatusCode::FORBIDDEN)?;
        let (token, path) = head
            .uri
            .path()
            .strip_prefix('/')
            .and_then(|path| path.split_once('/'))
            .ok_or(StatusCode::NOT_FOUND)?;
        if !self.token.is(token) {
            return Err(StatusCode::NOT_FOUND);
        }
        // a page is named by its own words only
        let is_plain = |c: char| c.is_ascii_alphanumeric() || "/-_".contains(c);
        if !path.chars().all(is_plain) || path.contains("//") {
            return Err(StatusCode::NOT_FOUND);
        }
        // a body is as long as stated, or none
        if head.headers.contains_key(TRANSFER_ENCODING) {
            return Err(StatusCode::LENGTH_REQUIRED);
        }
        let is_post = match head.method {
            Method::GET => false,
            Method::POST => true,
            _ => return Err(StatusCode::METHOD_NOT_ALLOWED),
        };
        let length = match is_post {
            true => length_of_post(&head.headers, host, path)?,
            false => 0,
        };
        let query = head.uri.query().unwrap_or_default().split('&');
        Ok(Passed {
            path: path.to_string(),
            query: query
                .filter_map(|pair| {
                    let (name, value) = pair.split_once('=')?;
                    Some((name.to_string(), value.to_string()))
                })
                .collect(),
            is_post,
            length,
        })
    }
}

fn length_of_post(fields: &HeaderMap, host: &str, path: &str) -> Result<usize, StatusCode> {
    if field(fields, ORIGIN) != Some(&format!("http://{host}")) {
        return Err(StatusCode::FORBIDDEN);
    }
    let kind = field(fields, CONTENT_TYPE).map(|kind| kind.split(';').next().unwrap_or_default().trim());
    if kind.is_none_or(|kind| !kind.eq_ignore_ascii_case("application/json")) {
        return Err(StatusCode::UNSUPPORTED_MEDIA_TYPE);
    }
    let length = field(fields, CONTENT_LENGTH).ok_or(StatusCode::LENGTH_REQUIRED)?;
    if length.is_empty() || !length.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(StatusCode::BAD_REQUEST);
    }
    let most = if path == "api/table" { TABLE } else { BODY };
    let length = length.parse().ok().filter(|length| *length <= most);
    length.ok_or(StatusCode::PAYLOAD_TOO_LARGE)
}

/// The value of a field that stands once; none if it is absent or stands twice.
fn field(fields: &HeaderMap, name: HeaderName) -> Option<&str> {
    let mut found = fields.get_all(name).iter();
    let first = found.next()?.to_str().ok()?;
    found.next().is_none().then_some(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    const PORT: u16 = 4321;

    fn guard() -> Guard {
        Guard::new(Token::random().expect("random"), PORT)
    }

    fn head(method: &str, target: &str, fields: &[(&str, &str)]) -> Parts {
        let request = hyper::Request::builder().method(method).uri(target);
        let request = fields
            .iter()
            .fold(request, |request, (name, value)| request.header(*name, *value));
        request.body(()).expect("a request").into_parts().0
    }

    fn request(
        guard: &Guard,
        method: &str,
        path: &str,
        fields: &[(&str, &str)],
    ) -> Result<Passed, StatusCode> {
        guard.pass(&head(
            method,
            &format!("/{}/{path}", guard.token().text()),
            fields,
        ))
    }

    const POST: [(&str, &str); 4] = [
        ("host", "127.0.0.1:4321"),
        ("origin", "http://127.0.0.1:4321"),
        ("content-type", "application/json"),
        ("content-length", "2"),
    ];

    fn post_with(name: &str, value: Option<&str>) -> Result<Passed, StatusCode> {
        let mut fields: Vec<(&str, &str)> = POST.into_iter().filter(|(own, _)| *own != name).collect();
        fields.extend(value.map(|value| (name, value)));
        request(&guard(), "POST", "api/set", &fields)
    }

    #[test]
    fn the_page_asks_and_is_let_pass() {
        let passed = request(&guard(), "POST", "api/set", &POST).expect("passes");
        assert_eq!(
            (passed.path.as_str(), passed.length, passed.is_post),
            ("api/set", 2, true)
        );
        let passed = request(&guard(), "GET", "api/shape?after=3&wait=20", &POST[..1]).expect("passes");
        assert_eq!(
            passed.query,
            [("after".into(), "3".into()), ("wait".into(), "20".into())]
        );
        let local = [
            ("host", "localhost:4321"),
            ("origin", "http://localhost:4321"),
            POST[2],
            POST[3],
        ];
        assert!(request(&guard(), "POST", "api/set", &local).is_ok());
    }

    #[test]
    fn other_hosts_and_pages_are_refused() {
        for host in [
            None,
            Some("evil.example:4321"),
            Some("127.0.0.1"),
            Some("127.0.0.1:80"),
            Some("127.0.0.1.evil.example:4321"),
        ] {
            assert_eq!(post_with("host", host), Err(StatusCode::FORBIDDEN), "{host:?}");
        }
        for origin in [
            None,
            Some("null"),
            Some("http://evil.example"),
            Some("https://127.0.0.1:4321"),
            Some("http://localhost:4321"),
        ] {
            assert_eq!(
                post_with("origin", origin),
                Err(StatusCode::FORBIDDEN),
                "{origin:?}"
            );
        }
    }

    #[test]
    fn what_no_page_sends_is_refused() {
        for kind in [
            None,
            Some("text/plain"),
            Some("application/x-www-form-urlencoded"),
            Some("multipart/form-data"),
        ] {
            assert_eq!(
                post_with("content-type", kind),
                Err(StatusCode::UNSUPPORTED_MEDIA_TYPE),
                "{kind:?}"
            );
        }
        assert_eq!(
            post_with("content-length", None),
            Err(StatusCode::LENGTH_REQUIRED)
        );
        for length in ["-1", "+2", "2, 2", "", "0x2"] {
            assert_eq!(
                post_with("content-length", Some(length)),
                Err(StatusCode::BAD_REQUEST),
                "{length}"
            );
        }
        for length in ["1048577", "99999999999999999999999"] {
            assert_eq!(
                post_with("content-length", Some(length)),
                Err(StatusCode::PAYLOAD_TOO_LARGE),
                "{length}"
            );
        }
        assert_eq!(
            post_with("transfer-encoding", Some("chunked")),
            Err(StatusCode::LENGTH_REQUIRED)
        );
        assert_eq!(
            request(&guard(), "PUT", "api/set", &POST),
            Err(StatusCode::METHOD_NOT_ALLOWED)
        );
        assert_eq!(
            request(&guard(), "OPTIONS", "api/set", &POST),
            Err(StatusCode::METHOD_NOT_ALLOWED)
        );
    }

    #[test]
    fn without_its_token_nothing_is_there() {
        let guard = guard();
        let other = Token::random().expect("random");
        let paths = [
            "/".to_string(),
            "/api/state".to_string(),
            format!("/{}/api/state", other.text()),
            "//".to_string(),
            "/api".to_string(),
        ];
        for target in paths {
            let head = head("GET", &target, &POST[..1]);
            assert_eq!(guard.pass(&head), Err(StatusCode::NOT_FOUND), "{head:?}");
        }
        for path in ["../etc/passwd", "api/../../x", "%2e%2e/x", "api//state", "a.b"] {
            assert_eq!(
                request(&guard, "GET", path, &POST[..1]),
                Err(StatusCode::NOT_FOUND),
                "{path}"
            );
        }
    }
}
