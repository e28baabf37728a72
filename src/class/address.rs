//! The port of the class, and the address at which phones in the room reach it.

use crate::text::text;
use std::io;
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr, TcpListener, UdpSocket};

/// The port that is tried first.
pub const PORT: u16 = 8080;
/// The number of ports that are tried after it.
const NEXT: u16 = 50;

/// Opens a port: the given one, or the first that is free.
///
/// # Errors
/// No port could be opened; a sentence says what to do.
pub fn listen(bind: IpAddr, port: Option<u16>) -> Result<TcpListener, String> {
    let open = |port: u16| TcpListener::bind(SocketAddr::new(bind, port));
    if let Some(port) = port {
        return open(port).map_err(|error| refused(bind, port, &error));
    }
    let mut ports = PORT..=PORT + NEXT;
    let taken = |error: &io::Error| {
        // Windows forbids the ports that another service keeps for itself.
        matches!(
            error.kind(),
            io::ErrorKind::AddrInUse | io::ErrorKind::PermissionDenied
        )
    };
    let found = ports.find_map(|port| match open(port) {
        Err(error) if taken(&error) => None,
        opened => Some(opened.map_err(|error| refused(bind, port, &error))),
    });
    let none = || Err(text!("live-no-port", from = PORT, to = PORT + NEXT));
    found.unwrap_or_else(none)
}

fn refused(bind: IpAddr, port: u16, error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::AddrInUse => text!("live-port-taken", port = port.to_string()),
        io::ErrorKind::AddrNotAvailable => text!("live-no-address", address = bind.to_string()),
        _ => {
            let error = error.to_string();
            text!("live-port-refused", port = port.to_string(), error = error)
        }
    }
}

/// Finds the address of this machine in the room's network; none where it is in no network. Nothing is sent: only the system's table of
/// routes is asked.
pub fn own_address() -> Option<IpAddr> {
    // Documentation addresses lie behind the default route, the others in the networks of rooms and homes.
    let v4 = [
        [192, 0, 2, 1],
        [10, 255, 255, 254],
        [192, 168, 255, 254],
        [172, 31, 255, 254],
    ];
    let v4 = v4.map(|bytes| (IpAddr::from(Ipv4Addr::UNSPECIFIED), IpAddr::from(bytes)));
    let v6 = Ipv6Addr::new(0x2001, 0xdb8, 0, 0, 0, 0, 0, 1);
    let v6 = (IpAddr::from(Ipv6Addr::UNSPECIFIED), IpAddr::from(v6));
    v4.into_iter().chain([v6]).find_map(|(any, there)| {
        let socket = UdpSocket::bind((any, 0)).ok()?;
        socket.connect((there, 9)).ok()?;
        let own = socket.local_addr().ok()?.ip();
        (!own.is_loopback() && !own.is_unspecified()).then_some(own)
    })
}

/// Returns the address of a class as it is typed; `base` is what stands before the code, where a proxy is in between.
pub fn class_address(base: Option<&str>, (ip, port): (IpAddr, u16), code: &str) -> String {
    match base {
        Some(base) => format!("{}/{code}/", base.trim_end_matches('/')),
        None => format!("http://{}/{code}/", SocketAddr::new(ip, port)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_port_that_is_taken_is_passed_over_or_named() {
        let local = IpAddr::from(Ipv4Addr::LOCALHOST);
        let first = listen(local, None).expect("a port");
        let second = listen(local, None).expect("another port");
        let port = |listener: &TcpListener| listener.local_addr().expect("an address").port();
        assert_ne!(port(&first), port(&second));
        let again = listen(local, Some(port(&first))).expect_err("it is taken");
        assert_eq!(
            again,
            text!("live-port-taken", port = port(&first).to_string())
        );
        let elsewhere = IpAddr::from([192, 0, 2, 1]);
        let elsewhere = listen(elsewhere, None).expect_err("another machine's address");
        assert_eq!(elsewhere, text!("live-no-address", address = "192.0.2.1"));
    }

    #[test]
    fn addresses_end_in_the_code() {
        let local = (IpAddr::from([10, 0, 0, 7]), 8080);
        assert_eq!(
            class_address(None, local, "k3x9ab"),
            "http://10.0.0.7:8080/k3x9ab/"
        );
        let six = (IpAddr::from(Ipv6Addr::LOCALHOST), 80);
        assert_eq!(
            class_address(None, six, "k3x9ab"),
            "http://[::1]:80/k3x9ab/"
        );
        let base = Some("https://example.org/shading/");
        assert_eq!(
            class_address(base, local, "k3x9ab"),
            "https://example.org/shading/k3x9ab/"
        );
    }
}
