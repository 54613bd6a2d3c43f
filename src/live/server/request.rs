//! A request as it comes over the wire: bounded in size and in time.

use std::io::{ErrorKind, Read};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use super::answer::Status;

/// Bytes that the head of a request may have.
const HEAD: usize = 16 * 1024;
/// Header fields that it may have.
const FIELDS: usize = 64;
/// Time in which the head must have come.
const HEAD_TIME: Duration = Duration::from_secs(5);
/// Time in which the body must have come.
const BODY_TIME: Duration = Duration::from_secs(15);

/// The head of a request.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Head {
    /// `GET`, `POST`, …
    pub method: String,
    /// Path and query as sent.
    pub target: String,
    /// Header fields, names in small letters.
    pub fields: Vec<(String, String)>,
}

impl Head {
    /// The value of a field that stands once; none if it is absent or stands twice.
    pub fn field(&self, name: &str) -> Option<&str> {
        let mut found = self.fields.iter().filter(|(own, _)| own == name);
        let first = found.next()?;
        found.next().is_none().then_some(first.1.as_str())
    }

    /// Whether a field stands at all.
    pub fn has(&self, name: &str) -> bool {
        self.fields.iter().any(|(own, _)| own == name)
    }
}

/// Reads the head; gives besides what came of the body with it.
///
/// # Errors
/// If it is none, too long or too slow; nothing, if nobody is there any more.
pub fn head(stream: &mut TcpStream) -> Result<(Head, Vec<u8>), Option<Status>> {
    let until = Instant::now() + HEAD_TIME;
    let mut bytes = Vec::new();
    loop {
        if let Some((head, length)) = parsed(&bytes)? {
            return Ok((head, bytes.split_off(length)));
        }
        if bytes.len() >= HEAD {
            return Err(Some(Status::HeadTooLarge));
        }
        read_more(stream, &mut bytes, HEAD, until)?;
    }
}

/// Reads a body of `length` bytes, of which `came` came with the head.
///
/// # Errors
/// If it is too slow; nothing, if nobody is there any more.
pub fn body(stream: &mut TcpStream, mut came: Vec<u8>, length: usize) -> Result<Vec<u8>, Option<Status>> {
    let until = Instant::now() + BODY_TIME;
    while came.len() < length {
        read_more(stream, &mut came, length, until)?;
    }
    came.truncate(length);
    Ok(came)
}

fn parsed(bytes: &[u8]) -> Result<Option<(Head, usize)>, Option<Status>> {
    let mut fields = [httparse::EMPTY_HEADER; FIELDS];
    let mut request = httparse::Request::new(&mut fields);
    let length = match request.parse(bytes) {
        Ok(httparse::Status::Complete(length)) => length,
        Ok(httparse::Status::Partial) => return Ok(None),
        Err(httparse::Error::TooManyHeaders) => return Err(Some(Status::HeadTooLarge)),
        Err(_) => return Err(Some(Status::Bad)),
    };
    let field = |field: &httparse::Header| {
        let value = std::str::from_utf8(field.value).ok()?;
        Some((field.name.to_ascii_lowercase(), value.trim().to_string()))
    };
    let fields: Option<Vec<_>> = request.headers.iter().map(field).collect();
    let head = Head {
        method: request.method.unwrap_or_default().to_string(),
        target: request.path.unwrap_or_default().to_string(),
        fields: fields.ok_or(Some(Status::Bad))?,
    };
    Ok(Some((head, length)))
}

/// Adds what comes next, up to `most` bytes in all.
fn read_more(
    stream: &mut TcpStream,
    bytes: &mut Vec<u8>,
    most: usize,
    until: Instant,
) -> Result<(), Option<Status>> {
    let left = until.saturating_duration_since(Instant::now());
    if left.is_zero() || stream.set_read_timeout(Some(left)).is_err() {
        return Err(Some(Status::TooSlow));
    }
    let mut part = [0u8; 8192];
    let room = part.len().min(most - bytes.len());
    match stream.read(&mut part[..room]) {
        Ok(0) => Err(None),
        Ok(count) => {
            bytes.extend_from_slice(&part[..count]);
            Ok(())
        }
        Err(error) => match error.kind() {
            ErrorKind::Interrupted => Ok(()),
            ErrorKind::WouldBlock | ErrorKind::TimedOut => Err(Some(Status::TooSlow)),
            _ => Err(None),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_head_is_read_once_it_is_whole() {
        let text = b"POST /t/api/set HTTP/1.1\r\nHost: a\r\nX: 1\r\nX: 2\r\n\r\n{}";
        assert_eq!(parsed(&text[..30]), Ok(None));
        let (head, length) = parsed(text).expect("sound").expect("whole");
        assert_eq!(
            (head.method.as_str(), head.target.as_str()),
            ("POST", "/t/api/set")
        );
        assert_eq!(&text[length..], b"{}");
        assert_eq!(head.field("host"), Some("a"));
        assert_eq!((head.field("x"), head.has("x")), (None, true));
        assert_eq!(parsed(b"nonsense\r\n\r\n"), Err(Some(Status::Bad)));
    }
}
