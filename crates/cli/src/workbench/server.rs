//! A server on the loopback address. It holds few connections at a time, none for long, and reads no more of a request than its head;
//! who says nothing gives way to who comes.

use super::File;
use super::answer::answer;
use super::guests::Guests;
use http_body_util::Full;
use hyper::body::Bytes;
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use std::convert::Infallible;
use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::time::Duration;
use tokio::time::timeout;

/// Connections at a time: a browser opens six, and several pages may be open.
const MOST_CONNECTIONS: usize = 128;
/// How long the head of a request may take, and a connection wait for its next one.
const HEAD: Duration = Duration::from_secs(10);
/// How long a connection may last.
const LONGEST: Duration = Duration::from_secs(120);
/// Bytes of the head of a request.
const LARGEST_HEAD: usize = 16 << 10;
/// How often the server looks whether it is to end.
const TICK: Duration = Duration::from_millis(100);

/// A server that listens.
pub(crate) struct Server {
    listener: TcpListener,
    port: u16,
    files: &'static [File],
}

impl Server {
    /// Listens on the loopback address, at this port or, for 0, at a free one.
    ///
    /// # Errors
    /// A port that is taken, or not allowed.
    pub(crate) fn bind(port: u16, files: &'static [File]) -> io::Result<Server> {
        let listener = TcpListener::bind(SocketAddr::from((Ipv4Addr::LOCALHOST, port)))?;
        listener.set_nonblocking(true)?;
        let port = listener.local_addr()?.port();
        Ok(Server { listener, port, files })
    }

    /// Where the page is.
    pub(crate) fn address(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }

    /// Answers until `ends` says so.
    ///
    /// # Errors
    /// A system that gives no runtime; requests make none.
    pub(crate) fn run(self, ends: impl Fn() -> bool) -> io::Result<()> {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_io().enable_time().build()?;
        runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(self.listener)?;
            let mut guests = Guests::default();
            while !ends() {
                // Nobody came, or the system has no more connections to give just now.
                let Ok(Ok((stream, _))) = timeout(TICK, listener.accept()).await else { continue };
                guests.make_room(MOST_CONNECTIONS);
                let (port, files, use_of) = (self.port, self.files, guests.announced());
                let told = use_of.clone();
                let connection = tokio::spawn(async move {
                    let service = service_fn(move |request| {
                        told.asked();
                        let response = answer(&request, port, files).map(|body| Full::new(Bytes::from_static(body)));
                        async move { Ok::<_, Infallible>(response) }
                    });
                    let mut http = http1::Builder::new();
                    http.timer(TokioTimer::new()).header_read_timeout(HEAD).max_buf_size(LARGEST_HEAD).half_close(true);
                    // A connection that breaks off is its own affair.
                    let _ = timeout(LONGEST, http.serve_connection(TokioIo::new(stream), service)).await;
                });
                guests.seat(use_of, connection.abort_handle());
            }
            Ok(())
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Read, Write};
    use std::net::TcpStream;
    use std::sync::atomic::{AtomicBool, Ordering};

    const FILES: &[File] = &[File { name: "index.html", bytes: b"<p>page</p>", compressed: None }];

    /// A server, and how to end it.
    fn running(stop: &'static AtomicBool) -> (SocketAddr, std::thread::JoinHandle<io::Result<()>>) {
        let server = Server::bind(0, FILES).unwrap();
        let address = SocketAddr::from((Ipv4Addr::LOCALHOST, server.port));
        (address, std::thread::spawn(move || server.run(|| stop.load(Ordering::Relaxed))))
    }

    /// What a server says to these bytes; nothing where it hangs up.
    fn said(address: SocketAddr, bytes: &[u8]) -> String {
        let Ok(mut stream) = TcpStream::connect(address) else { return String::new() };
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        // A server that has heard enough may hang up before all is said.
        let _ = stream.write_all(bytes);
        let _ = stream.shutdown(std::net::Shutdown::Write);
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        String::from_utf8_lossy(&answer).into_owned()
    }

    fn good(address: SocketAddr) -> String {
        said(address, format!("GET / HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n").as_bytes())
    }

    /// A mutilated request: bytes changed, cut, repeated, or none of it.
    fn malformed(number: u64, address: SocketAddr) -> Vec<u8> {
        let mut state = number.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
        let mut draw = |below: u64| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            state % below.max(1)
        };
        let whole = [
            format!("GET /../../etc/passwd HTTP/1.1\r\nHost: {address}\r\n\r\n"),
            format!("GET / HTTP/1.1\r\nHost: {address}\r\nContent-Length: 99999999999999999999\r\n\r\n"),
            format!("POST / HTTP/1.1\r\nHost: {address}\r\nTransfer-Encoding: chunked\r\n\r\nffffffffffffffff\r\n"),
            format!("GET / HTTP/9.9\r\nHost: {address}\r\n\r\n"),
            "GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n".to_owned(),
            format!("\u{0}\u{1}{address}\r\n\r\n"),
            "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n".to_owned(),
            format!("GET / HTTP/1.1\r\nHost: {address}\r\nX: {}\r\n\r\n", "a".repeat(draw(40_000) as usize)),
        ];
        let mut bytes = whole[draw(whole.len() as u64) as usize].clone().into_bytes();
        for _ in 0..draw(6) {
            let at = draw(bytes.len() as u64) as usize;
            match draw(3) {
                0 => bytes[at] = draw(256) as u8,
                1 => bytes.truncate(at + 1),
                _ => bytes.insert(at, draw(256) as u8),
            }
        }
        bytes
    }

    #[test]
    fn ten_thousand_malformed_requests_do_no_harm() {
        static STOP: AtomicBool = AtomicBool::new(false);
        let (address, server) = running(&STOP);
        assert!(good(address).ends_with("<p>page</p>"));
        let mut answered = 0;
        for number in 0..10_000 {
            let answer = said(address, &malformed(number, address));
            assert!(!answer.contains("root:"), "{answer}");
            answered += usize::from(answer.starts_with("HTTP/1."));
        }
        // Not all were let fall: the server has told most what was wrong.
        assert!(answered > 1000, "{answered}");
        assert!(good(address).ends_with("<p>page</p>"));
        STOP.store(true, Ordering::Relaxed);
        server.join().unwrap().unwrap();
    }

    /// How long the page may take where others hold every place: far less than an idle connection lives.
    const PROMPT: Duration = Duration::from_secs(2);

    #[test]
    fn connections_that_say_nothing_or_little_keep_nobody_out() {
        static STOP: AtomicBool = AtomicBool::new(false);
        let (address, server) = running(&STOP);
        let mut held = Vec::new();
        for round in 0..4 {
            // More than there are places: silent ones, heads that never end, and answers that nobody reads.
            for number in 0..MOST_CONNECTIONS + 30 {
                let Ok(mut stream) = TcpStream::connect(address) else { continue };
                let words = match number % 3 {
                    0 => String::new(),
                    1 => "GET / HTTP/1.1\r\nHost: ".to_owned(),
                    _ => format!("GET / HTTP/1.1\r\nHost: {address}\r\n\r\n"),
                };
                let _ = stream.write_all(words.as_bytes());
                held.push(stream);
            }
            let asked = std::time::Instant::now();
            assert!(good(address).contains("200 OK"), "round {round}");
            assert!(asked.elapsed() < PROMPT, "round {round}: {:?}", asked.elapsed());
        }
        drop(held);
        STOP.store(true, Ordering::Relaxed);
        server.join().unwrap().unwrap();
    }

    #[test]
    fn a_connection_that_is_used_outlives_silent_ones() {
        static STOP: AtomicBool = AtomicBool::new(false);
        let (address, server) = running(&STOP);
        let mut used = TcpStream::connect(address).unwrap();
        used.set_read_timeout(Some(PROMPT)).unwrap();
        let mut ask = || {
            used.write_all(format!("GET / HTTP/1.1\r\nHost: {address}\r\n\r\n").as_bytes()).unwrap();
            let mut answer = [0; 4096];
            let count = used.read(&mut answer).unwrap();
            String::from_utf8_lossy(&answer[..count]).into_owned()
        };
        assert!(ask().contains("200 OK"));
        let held: Vec<TcpStream> = (0..2 * MOST_CONNECTIONS).filter_map(|_| TcpStream::connect(address).ok()).collect();
        assert!(good(address).contains("200 OK") && ask().contains("200 OK"));
        drop(held);
        STOP.store(true, Ordering::Relaxed);
        server.join().unwrap().unwrap();
    }

    #[test]
    fn a_port_that_is_taken_is_an_error() {
        let first = Server::bind(0, FILES).unwrap();
        let second = Server::bind(first.port, FILES).err().map(|error| error.kind());
        assert_eq!(second, Some(io::ErrorKind::AddrInUse));
        assert_eq!(first.address(), format!("http://127.0.0.1:{}/", first.port));
    }
}
