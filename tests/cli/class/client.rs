//! A phone as the server sees it: HTTP over a connection that is kept.

use serde_json::{Value, json};
use std::collections::HashMap;
use std::io::{self, BufRead, BufReader, ErrorKind, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::time::Duration;

/// The longest time that an answer may take.
const PATIENCE: Duration = Duration::from_secs(30);

/// What the server answers.
#[derive(Debug)]
pub struct Reply {
    pub status: u16,
    pub headers: HashMap<String, String>,
    pub body: Vec<u8>,
}

impl Reply {
    pub fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap_or_else(|error| panic!("{error}: {self:?}"))
    }

    pub fn text(&self) -> String {
        String::from_utf8_lossy(&self.body).into_owned()
    }
}

/// A phone with the cookie that it was given.
pub struct Phone {
    pub address: SocketAddr,
    /// The path of the class, without a slash at its end.
    pub base: String,
    pub token: Option<String>,
    connection: Option<BufReader<TcpStream>>,
}

impl Phone {
    pub fn new(address: SocketAddr, code: &str) -> Self {
        Self {
            address,
            base: format!("/{code}"),
            token: None,
            connection: None,
        }
    }

    /// Returns another tab of the same phone.
    pub fn tab(&self) -> Self {
        let mut tab = Self::new(self.address, &self.base[1..]);
        tab.token.clone_from(&self.token);
        tab
    }

    /// Joins and keeps the cookie.
    #[track_caller]
    pub fn join(&mut self, name: Option<&str>) {
        let reply = self.post("join", &json!({ "name": name }));
        assert_eq!(reply.status, 200, "{}", reply.text());
        self.keep_cookie(&reply);
    }

    pub fn keep_cookie(&mut self, reply: &Reply) {
        let cookie = reply.headers.get("set-cookie").map_or("", String::as_str);
        let token = cookie
            .strip_prefix("token=")
            .and_then(|rest| rest.split(';').next());
        self.token = token.map(str::to_owned);
    }

    pub fn get(&mut self, path: &str) -> Reply {
        self.request("GET", path, &[], b"").expect("an answer")
    }

    pub fn post(&mut self, path: &str, body: &Value) -> Reply {
        self.try_post(path, body).expect("an answer")
    }

    pub fn try_post(&mut self, path: &str, body: &Value) -> io::Result<Reply> {
        self.request("POST", path, &[], body.to_string().as_bytes())
    }

    pub fn answer(&mut self, step: usize, round: u32, answer: &Value) -> Reply {
        let body = json!({ "step": step, "round": round, "answer": answer });
        self.post("answers", &body)
    }

    /// Sends a request below the class's path, again on a new connection if the server has closed the one that was kept.
    pub fn request(
        &mut self,
        method: &str,
        path: &str,
        headers: &[(&str, &str)],
        body: &[u8],
    ) -> io::Result<Reply> {
        let target = format!("{}/{path}", self.base);
        let was_kept = self.connection.is_some();
        let result = self.send(method, &target, headers, body);
        match result {
            Err(_) if was_kept && method == "GET" => {
                self.connection = None;
                self.send(method, &target, headers, body)
            }
            result => result,
        }
    }

    /// Sends a request with any target.
    pub fn send(
        &mut self,
        method: &str,
        target: &str,
        headers: &[(&str, &str)],
        body: &[u8],
    ) -> io::Result<Reply> {
        let sent = self.exchange(method, target, headers, body);
        if sent.is_err() {
            self.connection = None;
        }
        let reply = sent?;
        if reply
            .headers
            .get("connection")
            .is_some_and(|value| value == "close")
        {
            self.connection = None;
        }
        Ok(reply)
    }

    fn exchange(
        &mut self,
        method: &str,
        target: &str,
        headers: &[(&str, &str)],
        body: &[u8],
    ) -> io::Result<Reply> {
        let head = self.head(method, target, headers, Some(body.len()));
        let connection = self.connected()?;
        connection
            .get_mut()
            .write_all(&[head.as_bytes(), body].concat())?;
        let (status, headers) = read_head(connection)?;
        let length = headers
            .get("content-length")
            .and_then(|length| length.parse().ok());
        let mut body = vec![0; length.unwrap_or(0)];
        connection.read_exact(&mut body)?;
        Ok(Reply {
            status,
            headers,
            body,
        })
    }

    fn head(
        &self,
        method: &str,
        target: &str,
        headers: &[(&str, &str)],
        length: Option<usize>,
    ) -> String {
        let mut head = format!("{method} {target} HTTP/1.1\r\nHost: class\r\n");
        if let Some(token) = &self.token {
            head += &format!("Cookie: theme=dark; token={token}\r\n");
        }
        for (name, value) in headers {
            head += &format!("{name}: {value}\r\n");
        }
        if let Some(length) = length.filter(|_| method != "GET") {
            head += &format!("Content-Length: {length}\r\n");
        }
        head + "\r\n"
    }

    fn connected(&mut self) -> io::Result<&mut BufReader<TcpStream>> {
        if self.connection.is_none() {
            self.connection = Some(connect(self.address)?);
        }
        Ok(self.connection.as_mut().expect("a connection"))
    }

    /// Opens the stream of events.
    pub fn events(&self) -> io::Result<Events> {
        let mut connection = connect(self.address)?;
        let head = self.head("GET", &format!("{}/events", self.base), &[], None);
        connection.get_mut().write_all(head.as_bytes())?;
        let (status, headers) = read_head(&mut connection)?;
        if status != 200 {
            return Err(io::Error::other(format!("{status}")));
        }
        assert_eq!(headers["content-type"], "text/event-stream");
        Ok(Events(connection))
    }
}

pub fn connect(address: SocketAddr) -> io::Result<BufReader<TcpStream>> {
    let stream = TcpStream::connect_timeout(&address, PATIENCE)?;
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_nodelay(true)?;
    Ok(BufReader::new(stream))
}

fn read_head(connection: &mut impl BufRead) -> io::Result<(u16, HashMap<String, String>)> {
    let mut line = String::new();
    connection.read_line(&mut line)?;
    let status = line
        .split(' ')
        .nth(1)
        .and_then(|status| status.parse().ok());
    let status = status.ok_or_else(|| io::Error::new(ErrorKind::UnexpectedEof, line.clone()))?;
    let mut headers = HashMap::new();
    loop {
        line.clear();
        connection.read_line(&mut line)?;
        let Some((name, value)) = line.trim_end().split_once(": ") else {
            return Ok((status, headers));
        };
        headers.insert(name.to_lowercase(), value.to_owned());
    }
}

/// A stream of events.
pub struct Events(BufReader<TcpStream>);

impl Events {
    /// Waits for the next pace.
    pub fn pace(&mut self) -> io::Result<Value> {
        loop {
            let mut line = String::new();
            if self.0.read_line(&mut line)? == 0 {
                return Err(ErrorKind::UnexpectedEof.into());
            }
            if let Some(data) = line.strip_prefix("data: ")
                && let Ok(pace) = serde_json::from_str::<Value>(data)
                && pace.is_object()
            {
                return Ok(pace);
            }
        }
    }
}
