//! The server of a class: a thread that takes connections until it is dropped.

use super::address::listen;
use super::files::read_page;
use super::patient::Patient;
use super::room::Room;
use super::routes::{Shared, router};
use crate::text::{in_language, text};
use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::net::{IpAddr, SocketAddr};
use std::path::PathBuf;
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::Duration;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{Semaphore, oneshot};
use tokio::time::sleep;

/// The longest time in which the head of a request arrives, and for which a connection stays open without one.
const HEAD_TIME: Duration = Duration::from_secs(10);
/// The most bytes of a request's head.
const HEAD: usize = 16 << 10;
/// The most connections: four of each student.
const CONNECTIONS: usize = 4000;
/// The number of files that the program needs besides connections.
const FILES: usize = 100;
/// The pause after a connection could not be taken.
const PAUSE: Duration = Duration::from_millis(100);

/// The time in which the last events are sent.
const LAST: Duration = Duration::from_millis(200);

/// The settings of a server.
#[derive(Clone, Debug)]
pub struct ServerOptions {
    /// The address of this machine that it listens at.
    pub bind: IpAddr,
    /// The port; `None` for the first that is free.
    pub port: Option<u16>,
    /// The folder with the files of the program's own page.
    pub page: Option<PathBuf>,
}

/// A server of a class. It ends when it is dropped.
#[derive(Debug)]
pub struct Server {
    address: SocketAddr,
    has_lab: bool,
    stop: Option<oneshot::Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Server {
    /// Starts to serve a class.
    ///
    /// # Errors
    /// The port cannot be opened, in a sentence.
    pub fn start(room: &Arc<Room>, options: &ServerOptions) -> Result<Self, String> {
        let failed = |error: std::io::Error| text!("live-no-server", error = error.to_string());
        let listener = listen(options.bind, options.port)?;
        listener.set_nonblocking(true).map_err(failed)?;
        let address = listener.local_addr().map_err(failed)?;
        let most = connections();
        let lab = options.page.as_deref().and_then(read_page);
        let has_lab = lab.is_some();
        let router = router(Shared::new(Arc::clone(room), lab));
        let mut builder = tokio::runtime::Builder::new_current_thread();
        let runtime = builder.enable_all().build().map_err(failed)?;
        let (stop, stopped) = oneshot::channel();
        let language = room.head().language;
        let serve = async move {
            let Ok(listener) = TcpListener::from_std(listener) else {
                return;
            };
            tokio::select! {
                () = take_connections(&listener, &router, most) => {}
                _ = stopped => {}
            }
            // The phones are told that the class is over.
            sleep(LAST).await;
        };
        let thread = std::thread::spawn(move || in_language(language, || runtime.block_on(serve)));
        Ok(Self {
            address,
            has_lab,
            stop: Some(stop),
            thread: Some(thread),
        })
    }

    /// Returns the address that it listens at.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Returns whether the files of the program's own page were found.
    pub fn has_lab(&self) -> bool {
        self.has_lab
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // The runtime drops what it serves when the thread ends.
        drop(self.stop.take());
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// Takes connections, as many at a time as there may be.
async fn take_connections(listener: &TcpListener, router: &Router, most: usize) {
    let seats = Arc::new(Semaphore::new(most));
    loop {
        let Ok(seat) = Arc::clone(&seats).acquire_owned().await else {
            return;
        };
        match listener.accept().await {
            Ok((stream, _)) => {
                let router = router.clone();
                tokio::spawn(async move {
                    serve(stream, router).await;
                    drop(seat);
                });
            }
            // Too many files are open, or the other end is gone already.
            Err(_) => sleep(PAUSE).await,
        }
    }
}

/// Answers the requests of a connection until it is closed, or takes too long.
async fn serve(stream: TcpStream, router: Router) {
    let _ = stream.set_nodelay(true);
    let mut connection = http1::Builder::new();
    connection
        .timer(TokioTimer::new())
        .header_read_timeout(HEAD_TIME)
        .max_buf_size(HEAD);
    let service = TowerToHyperService::new(router);
    let io = TokioIo::new(Patient::new(stream));
    // Whatever is wrong with a connection ends that one.
    let _ = connection.serve_connection(io, service).await;
}

/// Returns how many connections the system allows, after asking for more: most systems start programs with 256 or 1024 files.
#[cfg(unix)]
fn connections() -> usize {
    use nix::sys::resource::{Resource, getrlimit, setrlimit};
    let wanted = (CONNECTIONS + FILES) as u64;
    let Ok((soft, hard)) = getrlimit(Resource::RLIMIT_NOFILE) else {
        return FILES;
    };
    let most = soft.max(wanted.min(hard));
    let raised = most > soft && setrlimit(Resource::RLIMIT_NOFILE, most, hard).is_ok();
    let files = if raised { most } else { soft };
    let files = usize::try_from(files).unwrap_or(usize::MAX);
    files.saturating_sub(FILES).clamp(1, CONNECTIONS)
}

#[cfg(not(unix))]
fn connections() -> usize {
    CONNECTIONS
}
