//! What a request is answered with: a file of the table, or why not. Nothing of a request but its method, its host, its path and what it
//! can unpack is looked at.

use super::File;
use hyper::header::{
    ACCEPT_ENCODING, ALLOW, AUTHORIZATION, CACHE_CONTROL, CONTENT_ENCODING, CONTENT_SECURITY_POLICY, CONTENT_TYPE,
    HOST, HeaderMap, HeaderName, HeaderValue, REFERRER_POLICY, VARY, X_CONTENT_TYPE_OPTIONS,
};
use hyper::{Method, Request, Response, StatusCode};

/// What the page may do: nothing from elsewhere, no script and no style in its own text.
const POLICY: &str = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob: data:; \
                      font-src 'self'; connect-src 'self' blob:; worker-src 'self'; manifest-src 'self'; media-src blob:; \
                      frame-src 'self' blob:; frame-ancestors 'none'; base-uri 'none'; form-action 'none'";

/// The frame in which a report is shown: no script at all, and only the page itself may hold it.
const POLICY_OF_REPORT: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data: blob:; frame-ancestors 'self'; base-uri 'none'; form-action 'none'";

/// Headers of every answer: what is here is for pages of the same origin alone, which may have threads.
const ALWAYS: [(HeaderName, &str); 5] = [
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-embedder-policy"), "require-corp"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    (X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (REFERRER_POLICY, "no-referrer"),
];

/// The answer to a request at a server on this port.
pub(crate) fn answer<B>(request: &Request<B>, port: u16, files: &'static [File]) -> Response<&'static [u8]> {
    if !is_ours(request, port) {
        return refusal(StatusCode::MISDIRECTED_REQUEST, b"this server answers for 127.0.0.1 and localhost alone\n");
    }
    if request.method() != Method::GET && request.method() != Method::HEAD {
        let mut response = refusal(StatusCode::METHOD_NOT_ALLOWED, b"this server only gives files\n");
        response.headers_mut().insert(ALLOW, HeaderValue::from_static("GET, HEAD"));
        return response;
    }
    let name = request.uri().path().strip_prefix('/').unwrap_or("");
    let name = if name.is_empty() { "index.html" } else { name };
    // A name is one of the table or none: nothing is decoded, joined or looked up elsewhere.
    match files.iter().find(|file| file.name == name) {
        Some(file) => given(file, request.headers()),
        None => refusal(StatusCode::NOT_FOUND, b"there is no such file\n"),
    }
}

/// Whether a request is meant for this server: pages of other names that lead here are not let in.
fn is_ours<B>(request: &Request<B>, port: u16) -> bool {
    let mut hosts = request.headers().get_all(HOST).iter();
    let (Some(host), None) = (hosts.next(), hosts.next()) else { return false };
    let ours = |host: &str| {
        let (name, given) = match host.rsplit_once(':') {
            Some((name, digits)) if !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit()) => {
                (name, digits.parse::<u16>().ok())
            }
            _ => (host, Some(80)),
        };
        ["127.0.0.1", "localhost"].iter().any(|known| known.eq_ignore_ascii_case(name)) && given == Some(port)
    };
    let whole = request.uri().authority().is_none_or(|authority| ours(authority.as_str()));
    // Nobody logs in here: a request that tries is meant for something else.
    whole && host.to_str().is_ok_and(ours) && !request.headers().contains_key(AUTHORIZATION)
}

fn given(file: &'static File, asked: &HeaderMap) -> Response<&'static [u8]> {
    let mut response = plain(StatusCode::OK, file.bytes, kind(file.name));
    let headers = response.headers_mut();
    let policy = if file.name == "report.html" { POLICY_OF_REPORT } else { POLICY };
    headers.insert(CONTENT_SECURITY_POLICY, HeaderValue::from_static(policy));
    // The names of built files have a hash of what they contain.
    let lasts = file.name.starts_with("assets/");
    let kept = if lasts { "public, max-age=31536000, immutable" } else { "no-cache" };
    headers.insert(CACHE_CONTROL, HeaderValue::from_static(kept));
    if let Some(compressed) = file.compressed {
        headers.insert(VARY, HeaderValue::from_static("accept-encoding"));
        if unpacks(asked) {
            headers.insert(CONTENT_ENCODING, HeaderValue::from_static("br"));
            *response.body_mut() = compressed;
        }
    }
    response
}

/// Whether Brotli is among what the other side can unpack.
fn unpacks(asked: &HeaderMap) -> bool {
    let all = asked.get_all(ACCEPT_ENCODING).iter().filter_map(|value| value.to_str().ok());
    let mut each = all.flat_map(|value| value.split(','));
    each.any(|one| {
        let (name, weight) = one.split_once(';').unwrap_or((one, ""));
        let weight = weight.trim().strip_prefix("q=").map_or(1.0, |weight| weight.trim().parse::<f64>().unwrap_or(0.0));
        name.trim().eq_ignore_ascii_case("br") && weight > 0.0
    })
}

fn refusal(status: StatusCode, words: &'static [u8]) -> Response<&'static [u8]> {
    let mut response = plain(status, words, "text/plain; charset=utf-8");
    response.headers_mut().insert(CONTENT_SECURITY_POLICY, HeaderValue::from_static("default-src 'none'"));
    response.headers_mut().insert(CACHE_CONTROL, HeaderValue::from_static("no-store"));
    response
}

fn plain(status: StatusCode, body: &'static [u8], kind: &'static str) -> Response<&'static [u8]> {
    let mut response = Response::new(body);
    *response.status_mut() = status;
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    for (name, value) in ALWAYS {
        response.headers_mut().insert(name, HeaderValue::from_static(value));
    }
    response
}

/// The kind of a file by its ending.
fn kind(name: &str) -> &'static str {
    match name.rsplit_once('.').map_or("", |(_, ending)| ending) {
        "html" => "text/html; charset=utf-8",
        "js" | "mjs" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "json" => "application/json",
        "webmanifest" => "application/manifest+json",
        "wasm" => "application/wasm",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "ico" => "image/x-icon",
        "woff2" => "font/woff2",
        "woff" => "font/woff",
        "txt" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILES: &[File] = &[
        File { name: "index.html", bytes: b"<p>page</p>", compressed: None },
        File { name: "report.html", bytes: b"", compressed: None },
        File { name: "assets/a-1.wasm", bytes: b"wasm", compressed: Some(b"br") },
    ];

    fn asked(method: &str, target: &str, headers: &[(&str, &str)]) -> Response<&'static [u8]> {
        let mut request = Request::builder().method(method).uri(target);
        for (name, value) in headers {
            request = request.header(*name, *value);
        }
        answer(&request.body(()).unwrap(), 8000, FILES)
    }

    #[test]
    fn files_come_with_their_kind_and_the_policy() {
        let response = asked("GET", "/", &[("host", "127.0.0.1:8000")]);
        assert_eq!((response.status(), *response.body()), (StatusCode::OK, &b"<p>page</p>"[..]));
        assert_eq!(response.headers()[CONTENT_TYPE], "text/html; charset=utf-8");
        let policy = response.headers()[CONTENT_SECURITY_POLICY].to_str().unwrap();
        assert!(
            policy.contains("script-src 'self' 'wasm-unsafe-eval';") && !policy.contains("unsafe-inline"),
            "{policy}"
        );
        assert_eq!(response.headers()["cross-origin-opener-policy"], "same-origin");
        assert_eq!(response.headers()["cross-origin-embedder-policy"], "require-corp");
        let report = asked("GET", "/report.html?x", &[("host", "localhost:8000")]);
        assert!(!report.headers()[CONTENT_SECURITY_POLICY].to_str().unwrap().contains("script"));
    }

    #[test]
    fn what_is_compressed_is_given_so_to_who_can_unpack_it() {
        let host = ("host", "LOCALHOST:8000");
        let with = |value: &'static str| asked("GET", "/assets/a-1.wasm", &[host, ("accept-encoding", value)]);
        assert_eq!(*with("gzip, br").body(), b"br");
        assert_eq!(with("gzip, br").headers()[CONTENT_TYPE], "application/wasm");
        assert_eq!(*with("gzip, br;q=0").body(), b"wasm");
        assert_eq!(*with("gzip").body(), b"wasm");
    }

    #[test]
    fn foreign_hosts_other_methods_and_other_paths_are_refused() {
        let ours = ("host", "127.0.0.1:8000");
        let foreign = [
            "evil.example:8000",
            "127.0.0.1",
            "127.0.0.1:8001",
            "localhost.evil:8000",
            "",
            "127.0.0.1:8000, a",
            "[::1]:8000",
        ];
        for host in foreign {
            assert_eq!(asked("GET", "/", &[("host", host)]).status(), StatusCode::MISDIRECTED_REQUEST, "{host}");
        }
        assert_eq!(asked("GET", "/", &[]).status(), StatusCode::MISDIRECTED_REQUEST);
        assert_eq!(asked("GET", "/", &[ours, ours]).status(), StatusCode::MISDIRECTED_REQUEST);
        assert_eq!(asked("GET", "http://evil.example/", &[ours]).status(), StatusCode::MISDIRECTED_REQUEST);
        for method in ["POST", "PUT", "DELETE", "OPTIONS", "TRACE", "PATCH"] {
            assert_eq!(asked(method, "/", &[ours]).status(), StatusCode::METHOD_NOT_ALLOWED, "{method}");
        }
        let outside = [
            "/../Cargo.toml",
            "/assets/../index.html",
            "/%2e%2e/index.html",
            "//index.html",
            "/assets/",
            "/index.html/",
            "/etc/passwd",
        ];
        for path in outside {
            assert_eq!(asked("GET", path, &[ours]).status(), StatusCode::NOT_FOUND, "{path}");
        }
    }
}
