//! Who may watch: the names under which a server answers, and the pages that may read from it.
//!
//! A browser lets every page open a WebSocket to this machine, and says in `Origin` which page it is. A page can also
//! let its own name lead to this machine (DNS rebinding); then `Host` has that name. Programs send no `Origin` and any
//! `Host` they like: this keeps out pages, not people.

use std::net::{IpAddr, Ipv6Addr};
use std::str::FromStr;
use tungstenite::handshake::server::Request;
use tungstenite::http::header::{HOST, ORIGIN};

/// Origins of viewers that are no pages of this machine: the Foxglove app on the web, and desktop programs, whose
/// windows are files.
const VIEWERS: [&str; 2] = ["https://app.foxglove.dev", "file://"];

/// A host name or an origin that may watch a run besides those of this machine.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LiveName(String);

impl FromStr for LiveName {
    type Err = String;

    /// A host name such as `lab.example`, or an origin such as `https://lab.example:8080`.
    ///
    /// # Errors
    /// A text that says what is allowed.
    fn from_str(text: &str) -> Result<Self, String> {
        let name = text.trim_end_matches('/').to_ascii_lowercase();
        // The slashes of an origin without a host are gone with those at the end.
        let host =
            name.split_once("://").map_or(name.strip_suffix(':').map_or(name.as_str(), |_| ""), |(_, host)| host);
        let plain = |c: char| c.is_ascii_graphic() && !"/\\?#@*,\"'".contains(c);
        if !host.is_empty() && host.chars().all(plain) {
            return Ok(Self(name));
        }
        Err("allowed is a host name such as lab.example, or an origin such as https://lab.example:8080".to_owned())
    }
}

/// Names that a server lets in: hosts and origins.
#[derive(Debug, Clone, Default)]
pub(super) struct Access {
    /// The host of the address that it was told to listen on.
    pub(super) listens: String,
    pub(super) names: Vec<LiveName>,
}

impl Access {
    /// Why a handshake is refused; none where it is not.
    pub(super) fn refusal(&self, request: &Request) -> Option<String> {
        let text = |name| request.headers().get(name).map(|value| value.to_str().unwrap_or("?").to_ascii_lowercase());
        let Some(host) = text(HOST) else {
            return Some("the header Host is missing".to_owned());
        };
        if !self.answers_to(&host) {
            return Some(format!(
                "this server does not answer to the name {host}; --live-allow {} lets it",
                name(&host)
            ));
        }
        let origin = text(ORIGIN)?;
        (!self.lets_read(&origin, &host))
            .then(|| format!("pages of {origin} may not read this run; --live-allow {origin} lets them"))
    }

    fn knows(&self, name: &str) -> bool {
        self.names.iter().any(|known| known.0 == name)
    }

    /// Numbers cannot be made to lead elsewhere; names can.
    fn answers_to(&self, host: &str) -> bool {
        let name = name(host);
        address(name).is_some() || is_this_machine(name) || name == self.listens || self.knows(name)
    }

    fn lets_read(&self, origin: &str, host: &str) -> bool {
        let of = origin.split_once("://").map(|(_, authority)| authority);
        let of_page = of.is_some_and(|page| {
            !page.is_empty() && (page == host || is_this_machine(name(page)) || self.knows(name(page)))
        });
        of_page || VIEWERS.contains(&origin) || self.knows(origin)
    }
}

/// A host without its port and brackets.
fn name(host: &str) -> &str {
    if let Some(rest) = host.strip_prefix('[') {
        return rest.split_once(']').map_or(rest, |(address, _)| address);
    }
    match host.rsplit_once(':') {
        Some((name, port)) if port.bytes().all(|byte| byte.is_ascii_digit()) && !name.contains(':') => name,
        _ => host,
    }
}

fn address(name: &str) -> Option<IpAddr> {
    name.parse().ok().or_else(|| name.parse::<Ipv6Addr>().ok().map(IpAddr::V6))
}

/// Names and addresses that lead to the machine itself, RFC 6761, section 6.3.
fn is_this_machine(name: &str) -> bool {
    name == "localhost" || name.ends_with(".localhost") || address(name).is_some_and(|address| address.is_loopback())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refusal(access: &Access, host: &str, origin: Option<&str>) -> Option<String> {
        let request = Request::builder().uri("/").header(HOST, host);
        let request =
            origin.map_or_else(|| Request::builder().uri("/").header(HOST, host), |o| request.header(ORIGIN, o));
        access.refusal(&request.body(()).unwrap())
    }

    #[test]
    fn limit_pages_of_other_machines_are_kept_out() {
        let none = Access::default();
        let here = "127.0.0.1:8765";
        for (host, origin) in [
            (here, None),
            ("localhost", None),
            ("[::1]:8765", None),
            ("192.168.1.7:8765", None),
            (here, Some("http://localhost:8080")),
            (here, Some("http://[::1]:8080")),
            (here, Some("file://")),
            (here, Some("https://app.foxglove.dev")),
            ("192.168.1.7:8765", Some("http://192.168.1.7:8765")),
        ] {
            assert_eq!(refusal(&none, host, origin), None, "{host} {origin:?}");
        }
        for (host, origin, part) in [
            ("evil.example:8765", None, "--live-allow evil.example lets"),
            ("localhost.evil.example", None, "does not answer"),
            ("127.0.0.1.evil.example", None, "does not answer"),
            (here, Some("https://evil.example"), "--live-allow https://evil.example lets"),
            (here, Some("https://app.foxglove.dev.evil.example"), "may not read"),
            (here, Some("http://evil.example/http://localhost"), "may not read"),
            (here, Some("null"), "may not read"),
            (here, Some(""), "may not read"),
            (here, Some("http://192.168.1.7:8080"), "may not read"),
        ] {
            let said = refusal(&none, host, origin).unwrap_or_else(|| panic!("{host} {origin:?} is let in"));
            assert!(said.contains(part), "{said}");
        }
    }

    #[test]
    fn limit_what_was_allowed_is_let_in_and_nothing_else() {
        let names = ["Lab.example", "https://viewer.example:8080/"].map(|name| name.parse().unwrap());
        let access = Access { listens: "bench.lan".to_owned(), names: names.to_vec() };
        for (host, origin) in [
            ("lab.example:8765", Some("https://lab.example")),
            ("bench.lan:8765", None),
            ("127.0.0.1", Some("https://viewer.example:8080")),
        ] {
            assert_eq!(refusal(&access, host, origin), None, "{host} {origin:?}");
        }
        for (host, origin) in [
            ("viewer.example", None),
            ("127.0.0.1", Some("https://viewer.example")),
            ("127.0.0.1", Some("https://bench.lan.example")),
        ] {
            assert!(refusal(&access, host, origin).is_some(), "{host} {origin:?}");
        }
        for bad in ["", "https://", "a b", "*", "lab.example/path", "https://user@lab.example"] {
            assert!(bad.parse::<LiveName>().unwrap_err().contains("lab.example"), "{bad}");
        }
    }
}
