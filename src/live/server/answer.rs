//! An answer as it goes over the wire.

use std::io::{self, Write};

/// How a request ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// It was done.
    Done,
    /// There is nothing new.
    Nothing,
    /// It is none.
    Bad,
    /// It does not come from this page.
    Forbidden,
    /// There is no such thing.
    NotFound,
    /// Not in this way.
    WrongMethod,
    /// It was not sent in time.
    TooSlow,
    /// Its length is not stated.
    NoLength,
    /// It is longer than allowed.
    TooLarge,
    /// It is no JSON.
    WrongType,
    /// It is refused, and the answer says why.
    Refused,
    /// Its head is longer than allowed.
    HeadTooLarge,
    /// Too many ask at a time.
    Busy,
}

impl Status {
    fn line(self) -> &'static str {
        match self {
            Status::Done => "200 OK",
            Status::Nothing => "204 No Content",
            Status::Bad => "400 Bad Request",
            Status::Forbidden => "403 Forbidden",
            Status::NotFound => "404 Not Found",
            Status::WrongMethod => "405 Method Not Allowed",
            Status::TooSlow => "408 Request Timeout",
            Status::NoLength => "411 Length Required",
            Status::TooLarge => "413 Content Too Large",
            Status::WrongType => "415 Unsupported Media Type",
            Status::Refused => "422 Unprocessable Content",
            Status::HeadTooLarge => "431 Request Header Fields Too Large",
            Status::Busy => "503 Service Unavailable",
        }
    }
}

/// What goes back.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    status: Status,
    kind: &'static str,
    /// Nonce of the page's scripts and styles.
    nonce: String,
    body: Vec<u8>,
}

impl Answer {
    /// One without a word.
    pub fn empty(status: Status) -> Answer {
        Answer {
            status,
            kind: "text/plain; charset=utf-8",
            nonce: String::new(),
            body: Vec::new(),
        }
    }

    /// JSON.
    pub fn json(status: Status, text: impl Into<Vec<u8>>) -> Answer {
        Answer {
            kind: "application/json",
            body: text.into(),
            ..Answer::empty(status)
        }
    }

    /// A picture.
    pub fn picture(kind: &'static str, bytes: Vec<u8>) -> Answer {
        Answer {
            kind,
            body: bytes,
            ..Answer::empty(Status::Done)
        }
    }

    /// A page whose scripts and styles are known by a nonce.
    pub fn page(html: String, nonce: String) -> Answer {
        Answer {
            kind: "text/html; charset=utf-8",
            nonce,
            body: html.into_bytes(),
            ..Answer::empty(Status::Done)
        }
    }

    /// Sends it; the connection ends with it.
    ///
    /// # Errors
    /// If nobody takes it.
    pub fn send(&self, stream: &mut impl Write) -> io::Result<()> {
        let policy = match self.nonce.as_str() {
            "" => "default-src 'none'; frame-ancestors 'none'".to_string(),
            nonce => format!(
                "default-src 'none'; script-src 'nonce-{nonce}'; style-src 'nonce-{nonce}'; img-src data: blob:; connect-src 'self'; \
                 base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
            ),
        };
        let mut head = format!(
            "HTTP/1.1 {}\r\nConnection: close\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n\
             Referrer-Policy: no-referrer\r\nCross-Origin-Opener-Policy: same-origin\r\nCross-Origin-Resource-Policy: same-origin\r\n\
             Content-Security-Policy: {policy}\r\n",
            self.status.line()
        );
        if self.status != Status::Nothing {
            head += &format!(
                "Content-Type: {}\r\nContent-Length: {}\r\n",
                self.kind,
                self.body.len()
            );
        }
        head += "\r\n";
        stream.write_all(head.as_bytes())?;
        stream.write_all(&self.body)?;
        stream.flush()
    }
}
