//! Attacks on the server, by hand: what a browser would not let a page do is done here too.

use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver};
use std::time::{Duration, Instant};

use super::limiter::ConnectionLimiter;
use super::{Hub, Received};
use crate::ModelFiles;
use crate::messages::{FromViewer, Selection};
use vfs::testing::Tree;

struct Rig {
    hub: Arc<Hub>,
    tree: Tree,
    files: Arc<ModelFiles>,
    said: Receiver<Received>,
}

fn rig() -> Rig {
    let tree = Tree::new();
    tree.write("mesh.stl", "solid x\nendsolid x\n");
    tree.write("secret.txt", "secret");
    let files = Arc::new(ModelFiles::default());
    let (say, said) = mpsc::channel();
    let hub = Hub::start(files.clone(), tree.vfs().clone(), move |received| {
        drop(say.send(received))
    })
    .unwrap();
    hub.open(1);
    Rig {
        hub,
        tree,
        files,
        said,
    }
}

impl Rig {
    fn port(&self) -> u16 {
        self.hub.port()
    }

    fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(("127.0.0.1", self.port())).unwrap();
        stream
            .set_read_timeout(Some(Duration::from_secs(20)))
            .unwrap();
        stream
    }

    fn send(&self, text: &str) -> String {
        Self::answer(self.connect(), text)
    }

    fn answer(mut stream: TcpStream, text: &str) -> String {
        // the server may hang up in the middle of what is too long
        let _ = stream.write_all(text.as_bytes());
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        String::from_utf8_lossy(&answer).into_owned()
    }

    /// A GET with the right Host and further lines.
    fn get(&self, path: &str, more: &[&str]) -> String {
        let more: String = more.iter().map(|line| format!("{line}\r\n")).collect();
        self.send(&format!(
            "GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n{more}\r\n",
            self.port()
        ))
    }

    fn token(&self) -> String {
        format!("X-Xacro-Token: {}", self.hub.token())
    }

    /// A socket after the handshake, or the answer that refused it.
    fn socket(&self, origin: Option<&str>) -> Result<TcpStream, String> {
        let mut stream = self.connect();
        let origin = origin
            .map(|origin| format!("Origin: {origin}\r\n"))
            .unwrap_or_default();
        let text = format!(
            "GET /socket HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n\
             Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n{origin}\r\n",
            self.port()
        );
        stream.write_all(text.as_bytes()).unwrap();
        let mut head = Vec::new();
        let mut byte = [0];
        while !head.ends_with(b"\r\n\r\n") && stream.read(&mut byte).is_ok_and(|count| count == 1) {
            head.push(byte[0]);
        }
        let head = String::from_utf8(head).unwrap();
        if head.starts_with("HTTP/1.1 101") {
            Ok(stream)
        } else {
            Err(head)
        }
    }

    fn own_socket(&self) -> TcpStream {
        self.socket(Some(&format!("http://127.0.0.1:{}", self.port())))
            .unwrap()
    }

    fn hello(&self, token: &str, id: u32) -> TcpStream {
        let mut stream = self.own_socket();
        write_text(
            &mut stream,
            &format!("{{\"type\":\"hello\",\"token\":\"{token}\",\"id\":{id}}}"),
        );
        stream
    }
}

/// A text frame as a client has to send it: masked, here with zeros.
fn write_text(stream: &mut TcpStream, text: &str) {
    let mut frame = vec![0x81];
    match text.len() {
        short @ 0..=125 => frame.push(0x80 | short as u8),
        middle @ 126..=65535 => {
            frame.push(0x80 | 126);
            frame.extend((middle as u16).to_be_bytes());
        }
        long => {
            frame.push(0x80 | 127);
            frame.extend((long as u64).to_be_bytes());
        }
    }
    frame.extend([0; 4]);
    frame.extend(text.as_bytes());
    let _ = stream.write_all(&frame);
}

/// The kind and content of the next frame; none when the other end hung up.
fn read_frame(stream: &mut TcpStream) -> Option<(u8, Vec<u8>)> {
    let mut head = [0; 2];
    stream.read_exact(&mut head).ok()?;
    let mut length = u64::from(head[1] & 0x7F);
    if length == 126 {
        let mut bytes = [0; 2];
        stream.read_exact(&mut bytes).ok()?;
        length = u64::from(u16::from_be_bytes(bytes));
    }
    let mut content = vec![0; length as usize];
    stream.read_exact(&mut content).ok()?;
    Some((head[0] & 0x0F, content))
}

/// The code a socket was closed with; pings in front of it do not count.
fn close_code(stream: &mut TcpStream) -> Option<u16> {
    loop {
        match read_frame(stream)? {
            (8, content) => return Some(u16::from_be_bytes([content[0], content[1]])),
            (9, _) => {}
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn the_page_says_what_it_may_do() {
    let rig = rig();
    let page = rig.get("/", &[]);
    assert!(page.starts_with("HTTP/1.1 200"), "{page}");
    let lower = page.to_lowercase();
    for line in [
        "x-content-type-options: nosniff",
        "cross-origin-resource-policy: same-origin",
        "referrer-policy: no-referrer",
        "content-security-policy: default-src 'none'; script-src 'self'",
        "cache-control: no-store",
    ] {
        assert!(lower.contains(line), "{line} in {page}");
    }
    assert!(!lower.contains("access-control-") && !page.contains(rig.hub.token()));
    let wanted = if viewer::SCRIPT.is_some() {
        "/viewer.js"
    } else {
        "npm run build"
    };
    assert!(page.contains(wanted), "{page}");
}

#[test]
fn other_names_of_this_machine_are_ours() {
    let rig = rig();
    for host in ["localhost", "[::1]"] {
        let answer = rig.send(&format!(
            "GET / HTTP/1.1\r\nHost: {host}:{}\r\n\r\n",
            rig.port()
        ));
        assert!(answer.starts_with("HTTP/1.1 200"), "{host}: {answer}");
    }
}

#[test]
fn both_addresses_of_this_machine_answer() {
    let rig = rig();
    let text = format!("GET / HTTP/1.1\r\nHost: localhost:{}\r\n\r\n", rig.port());
    assert!(rig.send(&text).starts_with("HTTP/1.1 200"));
    match TcpStream::connect(("::1", rig.port())) {
        Ok(stream) => assert!(Rig::answer(stream, &text).starts_with("HTTP/1.1 200")),
        // without IPv6 there is nothing that could answer
        Err(error) => assert!(TcpListener::bind(("::1", 0)).is_err(), "{error}"),
    }
}

#[test]
fn a_host_that_was_rebound_gets_nothing() {
    let rig = rig();
    let port = rig.port();
    let hosts = [
        format!("Host: evil.example:{port}"),
        "Host: 127.0.0.1".to_owned(),
        format!("Host: 127.0.0.1:{}", port.wrapping_add(1)),
        format!("Host: 127.0.0.1:{port}\r\nHost: evil.example"),
        format!("Host: 127.0.0.1.evil.example:{port}"),
        "X-Nothing: 1".to_owned(),
    ];
    for host in hosts {
        let answer = rig.send(&format!("GET / HTTP/1.1\r\n{host}\r\n\r\n"));
        assert!(answer.starts_with("HTTP/1.1 4"), "{host}: {answer}");
    }
    let absolute = format!("GET http://evil.example/ HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n");
    assert!(rig.send(&absolute).starts_with("HTTP/1.1 4"));
}

#[test]
fn requests_of_other_pages_get_nothing() {
    let rig = rig();
    let id = rig.files.id(&rig.tree.path("mesh.stl"), 1);
    let path = format!("/mesh/{id}");
    let foreign = format!("Origin: http://127.0.0.1:{}", rig.port().wrapping_add(1));
    let secure = format!("Origin: https://127.0.0.1:{}", rig.port());
    for line in [
        "Origin: https://evil.example",
        "Origin: null",
        &foreign,
        &secure,
        "Sec-Fetch-Site: cross-site",
    ] {
        let answer = rig.get(&path, &[&rig.token(), line]);
        assert!(answer.starts_with("HTTP/1.1 403"), "{line}: {answer}");
    }
    for origin in [None, Some("https://evil.example"), Some("null"), Some("")] {
        let refused = rig.socket(origin).unwrap_err();
        assert!(refused.starts_with("HTTP/1.1 403"), "{origin:?}: {refused}");
    }
}

#[test]
fn only_get_is_answered() {
    let rig = rig();
    for method in ["POST", "PUT", "DELETE", "OPTIONS", "HEAD", "PATCH", "TRACE"] {
        let text = format!(
            "{method} / HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n",
            rig.port()
        );
        let answer = rig.send(&text);
        assert!(answer.starts_with("HTTP/1.1 405"), "{method}: {answer}");
        assert!(
            !answer.to_lowercase().contains("access-control-"),
            "{answer}"
        );
    }
}

#[test]
fn files_need_the_token_and_an_id_of_a_model() {
    let rig = rig();
    let id = rig.files.id(&rig.tree.path("mesh.stl"), 1);
    let path = format!("/mesh/{id}");
    let good = rig.get(&path, &[&rig.token()]);
    assert!(
        good.starts_with("HTTP/1.1 200") && good.ends_with("endsolid x\n"),
        "{good}"
    );
    let token = rig.hub.token().to_owned();
    let short = format!("X-Xacro-Token: {}", &token[1..]);
    let wrong = format!("X-Xacro-Token: {}", "0".repeat(32));
    for line in ["X-Nothing: 1", "X-Xacro-Token:", &short, &wrong] {
        let answer = rig.get(&path, &[line]);
        assert!(answer.starts_with("HTTP/1.1 403"), "{line}: {answer}");
    }
    let in_query = rig.get(&format!("{path}?token={token}"), &[]);
    assert!(in_query.starts_with("HTTP/1.1 403"), "{in_query}");
    let secret = rig.tree.path("secret.txt").display().to_string();
    for path in [
        "/mesh/../secret.txt",
        "/mesh/..%2fsecret.txt",
        "/mesh/%2e%2e%2f%2e%2e%2fetc%2fpasswd",
        "/mesh/f999",
        "/mesh/",
        "/mesh/f1%00",
        &format!("/mesh/{}", secret.replace('/', "%2f")),
        &format!("/mesh{secret}"),
        "/secret.txt",
    ] {
        let answer = rig.get(path, &[&rig.token()]);
        assert!(
            answer.starts_with("HTTP/1.1 4") && !answer.ends_with("secret"),
            "{path}: {answer}"
        );
    }
    rig.files.keep(&base::FastSet::default());
    assert!(
        rig.get(&path, &[&rig.token()]).starts_with("HTTP/1.1 404"),
        "no model names it any more"
    );
}

#[test]
fn what_is_too_large_is_refused() {
    let rig = rig();
    let long = rig.get(&format!("/{}", "a".repeat(1 << 20)), &[]);
    assert!(
        long.is_empty() || long.starts_with("HTTP/1.1 4"),
        "{}",
        long.len()
    );
    let head = rig.get("/", &[&format!("X-Long: {}", "a".repeat(1 << 20))]);
    assert!(
        head.is_empty() || head.starts_with("HTTP/1.1 4"),
        "{}",
        head.len()
    );
    let body = rig.get("/", &["Content-Length: 1000000000"]);
    assert!(body.starts_with("HTTP/1.1 413"), "{body}");
    let chunked = rig.get("/", &["Transfer-Encoding: chunked"]);
    assert!(chunked.starts_with("HTTP/1.1 413"), "{chunked}");
    let mut socket = rig.own_socket();
    write_text(&mut socket, &"a".repeat(1 << 20));
    assert!(close_code(&mut socket).is_none_or(|code| code == 4001 || code == 1009));
    assert!(rig.get("/", &[]).starts_with("HTTP/1.1 200"));
}

#[test]
fn a_socket_has_to_name_the_token_first() {
    let rig = rig();
    let token = rig.hub.token().to_owned();
    assert_eq!(close_code(&mut rig.hello(&"0".repeat(32), 1)), Some(4001));
    assert_eq!(close_code(&mut rig.hello("", 1)), Some(4001));
    assert_eq!(close_code(&mut rig.hello(&token, 9)), Some(4004));
    let mut other = rig.own_socket();
    write_text(&mut other, "{\"type\":\"ready\"}");
    assert_eq!(close_code(&mut other), Some(4001));
    assert!(
        rig.said.try_recv().is_err(),
        "nobody without the token was listened to"
    );
}

#[test]
fn a_page_is_told_and_listened_to() {
    let rig = rig();
    let mut socket = rig.hello(rig.hub.token(), 1);
    let ready = rig.said.recv_timeout(Duration::from_secs(20)).unwrap();
    assert!(matches!(
        ready,
        Received {
            id: 1,
            message: FromViewer::Ready
        }
    ));
    rig.hub.select(&Selection {
        id: 1,
        links: vec!["arm".to_owned()],
        ..Selection::default()
    });
    let text = loop {
        if let (1, content) = read_frame(&mut socket).unwrap() {
            break String::from_utf8(content).unwrap();
        }
    };
    assert_eq!(
        text,
        r#"{"type":"select","id":1,"links":["arm"],"joints":[]}"#
    );
    write_text(&mut socket, "nonsense");
    write_text(&mut socket, "{\"type\":\"select\",\"link\":\"arm\"}");
    let said = rig.said.recv_timeout(Duration::from_secs(20)).unwrap();
    assert!(matches!(said.message, FromViewer::Select { link: Some(link), .. } if link == "arm"));
    rig.hub.close(1);
    assert_eq!(close_code(&mut socket), Some(4004));
}

#[test]
fn a_thousand_idle_connections_keep_nobody_out() {
    let rig = rig();
    let mut idle = Vec::new();
    while idle.len() < 1000 {
        // a system may allow fewer files than that
        let Ok(stream) = TcpStream::connect(("127.0.0.1", rig.port())) else {
            break;
        };
        idle.push(stream);
    }
    // room for our own
    idle.truncate(idle.len().saturating_sub(20).max(1));
    assert!(idle.len() > 300, "{}", idle.len());
    let begin = Instant::now();
    assert!(rig.get("/", &[]).starts_with("HTTP/1.1 200"));
    let mut socket = rig.hello(rig.hub.token(), 1);
    assert!(rig.said.recv_timeout(Duration::from_secs(20)).is_ok());
    assert!(
        begin.elapsed() < Duration::from_secs(10),
        "{:?}",
        begin.elapsed()
    );
    assert!(rig.hub.connections.len() <= 128);
    rig.hub.close(1);
    assert_eq!(close_code(&mut socket), Some(4004));
}

#[test]
fn sockets_that_say_nothing_keep_nobody_out() {
    let rig = rig();
    let silent: Vec<TcpStream> = (0..60).map(|_| rig.own_socket()).collect();
    let _page = rig.hello(rig.hub.token(), 1);
    assert!(rig.said.recv_timeout(Duration::from_secs(20)).is_ok());
    assert!(rig.hub.unauthenticated.len() <= 32);
    drop(silent);
}

#[test]
fn connections_that_say_nothing_end_no_download() {
    const SIZE: u64 = 50_000_000;
    let rig = rig();
    let mesh = rig.tree.path("mesh.stl");
    std::fs::File::options()
        .write(true)
        .open(&mesh)
        .unwrap()
        .set_len(SIZE)
        .unwrap();
    let id = rig.files.id(&mesh, 1);
    let mut download = rig.connect();
    let host = format!("Host: 127.0.0.1:{}", rig.port());
    write!(
        download,
        "GET /mesh/{id} HTTP/1.1\r\n{host}\r\n{}\r\n\r\n",
        rig.token()
    )
    .unwrap();
    let mut first = [0; 4096];
    download.read_exact(&mut first).unwrap();
    // a thousand of them; the server has let go of those that are dropped here
    let mut silent = std::collections::VecDeque::new();
    for _ in 0..1000 {
        silent.push_back(rig.connect());
        if silent.len() > 300 {
            silent.pop_front();
        }
    }
    assert!(rig.get("/", &[]).starts_with("HTTP/1.1 200"));
    let mut rest = Vec::new();
    download.read_to_end(&mut rest).unwrap();
    let head = first
        .windows(4)
        .position(|bytes| bytes == b"\r\n\r\n")
        .unwrap()
        + 4;
    assert_eq!((first.len() - head + rest.len()) as u64, SIZE);
}

#[tokio::test]
async fn who_waits_longest_makes_room() {
    let limiter = ConnectionLimiter::new(2);
    let (first, second) = (limiter.enter(), limiter.enter());
    let _third = limiter.enter();
    first.lost().await;
    assert!(
        tokio::time::timeout(Duration::from_millis(20), second.lost())
            .await
            .is_err()
    );
    drop(first);
    assert_eq!(limiter.len(), 2);
}

#[test]
fn tokens_differ_and_have_128_bits() {
    let (a, b) = (rig(), rig());
    assert_ne!(a.hub.token(), b.hub.token());
    assert_eq!(a.hub.token().len(), 32);
    assert!(
        a.hub
            .url(3)
            .ends_with(&format!("/#token={}&id=3", a.hub.token()))
    );
    assert_eq!(
        a.tree.path("x").parent().map(PathBuf::from),
        Some(a.tree.root().to_path_buf())
    );
}
