//! Whoever is not the page: refused, nothing written, and the server lives.

use std::io::Write;
use std::net::TcpStream;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::live::{Server, heard};
use crate::{design, entries, folder};

const MOVE: &str = "{\"values\":{\"flapping.frequency_hz\":30}}";

fn server(here: &tempfile::TempDir) -> Server {
    Server::start(
        here.path(),
        &[&design("twist-v1.toml"), "--set", "mesh.refine=0.3"],
    )
}

fn frequency(server: &Server) -> Value {
    let state = server.state();
    let inputs = state["inputs"].as_array().expect("inputs");
    let own = inputs
        .iter()
        .find(|input| input["key"] == "flapping.frequency_hz");
    own.expect("an input")["value"].clone()
}

#[test]
fn what_does_not_come_from_the_page_is_refused_and_changes_nothing() {
    let here = folder();
    let server = server(&here);
    let other = Server::start(
        here.path(),
        &[&design("twist-v1.toml"), "--set", "mesh.refine=0.3"],
    );
    let own = format!("127.0.0.1:{}", server.port);
    let set = server.path("api/set");
    let statuses = [
        (
            "another host",
            server.posted(&set, MOVE, &[("Host", "evil.example")]),
            403,
        ),
        (
            "a host that resolves to this machine",
            server.posted(&set, MOVE, &[("Host", &format!("localtest.me:{}", server.port))]),
            403,
        ),
        ("no host", server.posted(&set, MOVE, &[("Host", "")]), 403),
        (
            "another origin",
            server.posted(&set, MOVE, &[("Origin", "https://evil.example")]),
            403,
        ),
        (
            "another port of this machine",
            server.posted(
                &set,
                MOVE,
                &[("Origin", &format!("http://127.0.0.1:{}", other.port))],
            ),
            403,
        ),
        ("a file", server.posted(&set, MOVE, &[("Origin", "null")]), 403),
        ("no origin", server.posted(&set, MOVE, &[("Origin", "")]), 403),
        (
            "a form",
            server.posted(&set, MOVE, &[("Content-Type", "text/plain")]),
            415,
        ),
        ("no token", server.posted("/api/set", MOVE, &[]), 404),
        (
            "the token of another run",
            server.posted(&format!("/{}/api/set", other.token), MOVE, &[]),
            404,
        ),
        (
            "a path outside",
            server.posted(&server.path("../../../../etc/passwd"), MOVE, &[]),
            404,
        ),
        (
            "an encoded path outside",
            server.posted(&server.path("%2e%2e/%2e%2e/etc/passwd"), MOVE, &[]),
            404,
        ),
        (
            "a huge body",
            server.posted(&set, &"x".repeat(1_100_000), &[]),
            413,
        ),
        (
            "a body without length",
            server.posted(&set, MOVE, &[("Content-Length", "")]),
            411,
        ),
        (
            "a chunked body",
            server.posted(
                &set,
                MOVE,
                &[("Content-Length", ""), ("Transfer-Encoding", "chunked")],
            ),
            411,
        ),
        ("a body that is no JSON", server.posted(&set, "{", &[]), 400),
        (
            "numbers that are none",
            server.posted(&set, "{\"values\":{\"flapping.frequency_hz\":1e999}}", &[]),
            400,
        ),
        (
            "words that nobody knows",
            server.posted(&set, "{\"values\":{},\"more\":1}", &[]),
            400,
        ),
        (
            "another method",
            format!("DELETE {set} HTTP/1.1\r\nHost: {own}\r\n\r\n").into_bytes(),
            405,
        ),
        (
            "asking instead of posting",
            format!("GET {set} HTTP/1.1\r\nHost: {own}\r\n\r\n").into_bytes(),
            405,
        ),
        (
            "a read from another host",
            format!(
                "GET {} HTTP/1.1\r\nHost: evil.example\r\n\r\n",
                server.path("api/state")
            )
            .into_bytes(),
            403,
        ),
        ("no HTTP", b"\x16\x03\x01\x02\x00\x01\r\n\r\n".to_vec(), 400),
        (
            "an endless head",
            format!("GET / HTTP/1.1\r\nHost: {own}\r\nX: {}", "x".repeat(20_000)).into_bytes(),
            431,
        ),
    ];
    let before = frequency(&server);
    for (what, bytes, status) in statuses {
        let reply = server.raw(&bytes);
        assert_eq!(reply.status, status, "{what}: {reply:?}");
        assert_eq!(reply.body, "", "{what}");
    }
    assert_eq!(frequency(&server), before);
    assert_eq!(server.state()["revision"], 1);
    assert_eq!(entries(here.path()), [""; 0], "something was written");
    // the page itself is let in
    assert_eq!(server.raw(&server.posted(&set, MOVE, &[])).status, 200);
    assert_eq!(frequency(&server), json!(30.0));
}

#[test]
fn the_page_and_its_answers_carry_what_keeps_others_out() {
    let here = folder();
    let server = server(&here);
    let page = server.get("");
    let field = |head: &str, name: &str| {
        let mut lines = head.lines().filter_map(|line| line.split_once(": "));
        let found = lines.find(|(own, _)| own.eq_ignore_ascii_case(name));
        found.unwrap_or_else(|| panic!("no {name}: {head}")).1.to_string()
    };
    assert_eq!(page.status, 200);
    for head in [
        &page.head,
        &server.get("api/state").head,
        &server.get("nothing").head,
    ] {
        assert_eq!(field(head, "Cache-Control"), "no-store");
        assert_eq!(field(head, "X-Content-Type-Options"), "nosniff");
        assert_eq!(field(head, "Referrer-Policy"), "no-referrer");
        assert!(field(head, "Content-Security-Policy").starts_with("default-src 'none'"));
        assert!(!head.to_ascii_lowercase().contains("access-control"), "{head}");
    }
    let nonces = |reply: &crate::live::Reply| {
        let policy = field(&reply.head, "Content-Security-Policy");
        let nonce = policy
            .split("script-src 'nonce-")
            .nth(1)
            .expect("a nonce")
            .split('\'')
            .next();
        nonce.expect("a nonce").to_string()
    };
    assert_ne!(nonces(&page), nonces(&server.get("")), "a nonce is used once");
    assert!(page.body.contains(&format!("nonce=\"{}\"", nonces(&page))));
}

#[test]
fn two_hundred_open_connections_and_slow_senders_keep_nobody_waiting() {
    let here = folder();
    let server = server(&here);
    server.settled();
    let own = format!("127.0.0.1:{}", server.port);
    let slow: Vec<TcpStream> = (0..200)
        .map(|number| {
            let mut stream = server.connect();
            let part = match number % 4 {
                0 => String::new(),
                1 => format!("GET {} HTTP/1.1\r\nHo", server.path("api/state")),
                2 => format!("POST {} HTTP/1.1\r\nHost: {own}\r\n", server.path("api/set")),
                _ => format!(
                    "POST {} HTTP/1.1\r\nHost: {own}\r\nOrigin: http://{own}\r\nContent-Type: application/json\r\nContent-Length: 1000\r\n\r\n{{",
                    server.path("api/set")
                ),
            };
            let _ = stream.write_all(part.as_bytes());
            stream
        })
        .collect();
    let start = Instant::now();
    let state = server.get("api/state");
    assert_eq!(state.status, 200);
    assert!(start.elapsed() < Duration::from_secs(2), "{:?}", start.elapsed());
    drop(slow);
    // all at once, each with a whole request
    let answered: Vec<u16> = std::thread::scope(|scope| {
        let asking: Vec<_> = (0..200)
            .map(|_| scope.spawn(|| server.get("api/state").status))
            .collect();
        asking
            .into_iter()
            .map(|asked| asked.join().expect("no panic"))
            .collect()
    });
    assert!(
        answered.iter().all(|status| [200, 503, 0].contains(status)),
        "{answered:?}"
    );
    assert!(answered.contains(&200));
    assert!(server.lives());
    assert_eq!(server.state()["revision"], 1);
}

#[test]
fn who_sends_too_slowly_is_let_go() {
    let here = folder();
    let server = server(&here);
    let mut head = server.connect();
    head.write_all(b"GET / HTTP/1.1\r\n").expect("sent");
    let mut body = server.connect();
    let mut post = server.posted(&server.path("api/set"), MOVE, &[]);
    post.pop();
    body.write_all(&post).expect("sent");
    let start = Instant::now();
    assert_eq!(heard(&mut head).status, 0, "half a head has no answer");
    assert!(start.elapsed() < Duration::from_secs(10));
    assert_eq!(heard(&mut body).status, 408);
    assert!(start.elapsed() < Duration::from_secs(20));
    assert!(server.lives());
}

#[test]
fn it_is_not_to_be_reached_from_another_machine() {
    let here = folder();
    let server = server(&here);
    // every address of this machine but the loop
    let others = std::net::UdpSocket::bind("0.0.0.0:0").and_then(|socket| {
        socket.connect("192.0.2.1:9")?;
        socket.local_addr()
    });
    if let Ok(other) = others.map(|address| address.ip()).and_then(|ip| {
        if ip.is_loopback() {
            Err(std::io::Error::other("none"))
        } else {
            Ok(ip)
        }
    }) {
        let tried = TcpStream::connect_timeout(&(other, server.port).into(), Duration::from_secs(1));
        assert!(tried.is_err(), "{other} is served");
    }
    assert!(server.lives());
}
