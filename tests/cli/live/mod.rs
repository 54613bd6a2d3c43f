//! `washout live` as a browser meets it, over the wire.

mod answers;

mod frames;

mod refused;

mod saved;

mod table;

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::program;

/// A program that serves a page.
pub struct Server {
    child: Child,
    /// Its port.
    pub port: u16,
    /// Its token.
    pub token: String,
}

/// What came back.
#[derive(Debug)]
pub struct Reply {
    /// The status; 0 where nothing came back.
    pub status: u16,
    /// All of the head.
    pub head: String,
    /// The body.
    pub body: String,
}

impl Reply {
    /// The body as JSON.
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.body).unwrap_or_else(|error| panic!("{error}: {self:?}"))
    }
}

impl Server {
    /// Serves a file, the program being started in a folder.
    pub fn start(folder: &Path, arguments: &[&str]) -> Server {
        Server::start_with(folder, arguments, &[])
    }

    /// The same with variables of the environment.
    pub fn start_with(folder: &Path, arguments: &[&str], variables: &[(&str, &str)]) -> Server {
        let mut child = program(folder)
            .envs(variables.iter().copied())
            .arg("live")
            .args(arguments)
            .args(["--no-open", "--threads", "1"])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut line = String::new();
        let out = child.stdout.as_mut().expect("a pipe");
        BufReader::new(out).read_line(&mut line).expect("a line");
        let rest = line.trim().strip_prefix("http://127.0.0.1:").unwrap_or_else(|| {
            let mut said = String::new();
            let _ = child.stderr.take().expect("a pipe").read_to_string(&mut said);
            panic!("no address: {line:?} {said}")
        });
        let (port, path) = rest.split_once('/').expect("a path");
        Server {
            child,
            port: port.parse().expect("a port"),
            token: path.trim_end_matches('/').to_string(),
        }
    }

    /// A connection.
    pub fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(("127.0.0.1", self.port)).expect("a connection");
        let wait = Some(Duration::from_secs(300));
        stream.set_read_timeout(wait).expect("a timeout");
        stream
    }

    /// What comes back for these bytes.
    pub fn raw(&self, bytes: &[u8]) -> Reply {
        let mut stream = self.connect();
        // the server may answer, and close, before all is sent
        let _ = stream.write_all(bytes);
        heard(&mut stream)
    }

    /// Path behind the token.
    pub fn path(&self, path: &str) -> String {
        format!("/{}/{path}", self.token)
    }

    /// Asks for a path behind the token.
    pub fn get(&self, path: &str) -> Reply {
        let path = self.path(path);
        self.raw(format!("GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n", self.port).as_bytes())
    }

    /// What a page of this server posts.
    pub fn post(&self, path: &str, body: &Value) -> Reply {
        self.raw(&self.posted(&self.path(path), &body.to_string(), &[]))
    }

    /// Bytes of a post, with fields in the place of those that a page sends; an empty one is left out.
    pub fn posted(&self, path: &str, body: &str, other: &[(&str, &str)]) -> Vec<u8> {
        let own = format!("127.0.0.1:{}", self.port);
        let mut fields = vec![
            ("Host", own.clone()),
            ("Origin", format!("http://{own}")),
            ("Content-Type", "application/json".to_string()),
            ("Content-Length", body.len().to_string()),
        ];
        for (name, value) in other {
            fields.retain(|(own, _)| own != name);
            fields.push((name, value.to_string()));
        }
        let fields = fields.iter().filter(|(_, value)| !value.is_empty());
        let head: String = fields
            .map(|(name, value)| format!("{name}: {value}\r\n"))
            .collect();
        format!("POST {path} HTTP/1.1\r\n{head}\r\n{body}").into_bytes()
    }

    /// The state.
    pub fn state(&self) -> Value {
        self.get("api/state").json()
    }

    /// A change that is done; gives the state.
    pub fn change(&self, path: &str, body: Value) -> Value {
        let reply = self.post(path, &body);
        assert_eq!(reply.status, 200, "{path} {body}: {reply:?}");
        reply.json()
    }

    /// The shape that is found from rest, of the state as it stands.
    pub fn settled(&self) -> Value {
        let revision = self.state()["revision"].as_u64().expect("a revision");
        self.shape_where(|shape| {
            shape["revision"].as_u64() == Some(revision) && shape["settled"] == json!(true)
        })
    }

    /// The first shape of which that is true.
    pub fn shape_where(&self, is_it: impl Fn(&Value) -> bool) -> Value {
        let (until, mut after) = (Instant::now() + Duration::from_secs(120), 0);
        while Instant::now() < until {
            let reply = self.get(&format!("api/shape?after={after}&wait=10"));
            if reply.status == 204 {
                continue;
            }
            let shape = reply.json();
            if is_it(&shape) {
                return shape;
            }
            after = shape["shape_revision"].as_u64().expect("a revision");
        }
        panic!("no such shape")
    }

    /// Whether the program still serves.
    pub fn lives(&self) -> bool {
        self.get("api/state").status == 200
    }

    /// Ends it by Ctrl-C, and gives its exit code and what it said.
    pub fn interrupted(mut self) -> (Option<i32>, String) {
        let sent = Command::new("kill")
            .args(["-INT", &self.child.id().to_string()])
            .status();
        assert!(sent.expect("kill runs").success());
        let status = self.child.wait().expect("the program ends");
        let mut said = String::new();
        let _ = self
            .child
            .stderr
            .take()
            .expect("a pipe")
            .read_to_string(&mut said);
        (status.code(), said)
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// What comes back on a connection.
pub fn heard(stream: &mut TcpStream) -> Reply {
    let mut bytes = Vec::new();
    // a connection that is cut off has said what it had to say
    let _ = stream.read_to_end(&mut bytes);
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let (head, body) = text.split_once("\r\n\r\n").unwrap_or((&text, ""));
    Reply {
        status: head
            .split(' ')
            .nth(1)
            .and_then(|status| status.parse().ok())
            .unwrap_or(0),
        head: head.to_string(),
        body: body.to_string(),
    }
}
