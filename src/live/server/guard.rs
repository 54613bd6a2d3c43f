//! Who may ask: the token stands in the path, the host is this machine, and what changes something comes from the page itself.

use super::answer::Status;
use super::request::Head;
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
    /// Bytes of its body.
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
    pub fn pass(&self, head: &Head) -> Result<Passed, Status> {
        let hosts = ["127.0.0.1", "localhost"].map(|name| format!("{name}:{}", self.port));
        let host = head
            .field("host")
            .filter(|host| hosts.iter().any(|own| own == host));
        let host = host.ok_or(Status::Forbidden)?;
        let (path, query) = head.target.split_once('?').unwrap_or((&head.target, ""));
        let (token, path) = path
            .strip_prefix('/')
            .and_then(|path| path.split_once('/'))
            .ok_or(Status::NotFound)?;
        if !self.token.is(token) {
            return Err(Status::NotFound);
        }
        // a page is named by its own words only
        let is_plain = |c: char| c.is_ascii_alphanumeric() || "/-_".contains(c);
        if !path.chars().all(is_plain) || path.contains("//") {
            return Err(Status::NotFound);
        }
        // a body is as long as stated, or none
        if head.has("transfer-encoding") {
            return Err(Status::NoLength);
        }
        let is_post = match head.method.as_str() {
            "GET" => false,
            "POST" => true,
            _ => return Err(Status::WrongMethod),
        };
        let length = match is_post {
            true => self.length_of_post(head, host, path)?,
            false if head.field("content-length").is_none_or(|length| length == "0") => 0,
            false => return Err(Status::Bad),
        };
        Ok(Passed {
            path: path.to_string(),
            query: query
                .split('&')
                .filter_map(|pair| {
                    let (name, value) = pair.split_once('=')?;
                    Some((name.to_string(), value.to_string()))
                })
                .collect(),
            is_post,
            length,
        })
    }

    fn length_of_post(&self, head: &Head, host: &str, path: &str) -> Result<usize, Status> {
        if head.field("origin") != Some(&format!("http://{host}")) {
            return Err(Status::Forbidden);
        }
        let kind = head
            .field("content-type")
            .map(|kind| kind.split(';').next().unwrap_or_default().trim());
        if kind.is_none_or(|kind| !kind.eq_ignore_ascii_case("application/json")) {
            return Err(Status::WrongType);
        }
        let length = head.field("content-length").ok_or(Status::NoLength)?;
        let is_number = !length.is_empty() && length.bytes().all(|byte| byte.is_ascii_digit());
        if !is_number {
            return Err(Status::Bad);
        }
        let most = if path == "api/table" { TABLE } else { BODY };
        let length = length.parse::<usize>().ok().filter(|length| *length <= most);
        length.ok_or(Status::TooLarge)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PORT: u16 = 4321;

    fn guard() -> Guard {
        Guard::new(Token::random().expect("random"), PORT)
    }

    fn request(guard: &Guard, method: &str, path: &str, fields: &[(&str, &str)]) -> Result<Passed, Status> {
        let target = format!("/{}/{path}", guard.token().text());
        let fields = fields
            .iter()
            .map(|(name, value)| (name.to_string(), value.to_string()));
        guard.pass(&Head {
            method: method.to_string(),
            target,
            fields: fields.collect(),
        })
    }

    const POST: [(&str, &str); 4] = [
        ("host", "127.0.0.1:4321"),
        ("origin", "http://127.0.0.1:4321"),
        ("content-type", "application/json"),
        ("content-length", "2"),
    ];

    fn post_with(name: &str, value: Option<&str>) -> Result<Passed, Status> {
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
            assert_eq!(post_with("host", host), Err(Status::Forbidden), "{host:?}");
        }
        for origin in [
            None,
            Some("null"),
            Some("http://evil.example"),
            Some("https://127.0.0.1:4321"),
            Some("http://localhost:4321"),
        ] {
            assert_eq!(post_with("origin", origin), Err(Status::Forbidden), "{origin:?}");
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
                Err(Status::WrongType),
                "{kind:?}"
            );
        }
        assert_eq!(post_with("content-length", None), Err(Status::NoLength));
        for length in ["-1", "+2", "2, 2", "", "0x2"] {
            assert_eq!(
                post_with("content-length", Some(length)),
                Err(Status::Bad),
                "{length}"
            );
        }
        for length in ["1048577", "99999999999999999999999"] {
            assert_eq!(
                post_with("content-length", Some(length)),
                Err(Status::TooLarge),
                "{length}"
            );
        }
        assert_eq!(
            post_with("transfer-encoding", Some("chunked")),
            Err(Status::NoLength)
        );
        assert_eq!(
            request(&guard(), "PUT", "api/set", &POST),
            Err(Status::WrongMethod)
        );
        assert_eq!(
            request(&guard(), "OPTIONS", "api/set", &POST),
            Err(Status::WrongMethod)
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
            String::new(),
        ];
        for target in paths {
            let head = Head {
                method: "GET".to_string(),
                target,
                fields: vec![("host".to_string(), "127.0.0.1:4321".to_string())],
            };
            assert_eq!(guard.pass(&head), Err(Status::NotFound), "{head:?}");
        }
        for path in ["../etc/passwd", "api/../../x", "%2e%2e/x", "api//state", "a\\b"] {
            assert_eq!(
                request(&guard, "GET", path, &POST[..1]),
                Err(Status::NotFound),
                "{path}"
            );
        }
    }
}
