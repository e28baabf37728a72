//! The program: a window, or one command; a page on the web.

#[cfg(not(target_arch = "wasm32"))]
mod cli;

/// An allocator that returns freed memory: with the system's own a window on Linux grew to twice the memory it needed.
#[cfg(all(feature = "app", not(target_arch = "wasm32")))]
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    cli::run()
}

#[cfg(target_arch = "wasm32")]
fn main() {
    shading_lab::app::run();
}
