//! Memory that a large model takes: `cargo test --test engine obj_memory -- --ignored --test-threads 1`, Linux only.

use shading_lab::geometry::read_obj;
use std::io::{BufReader, Read};

const SIZE: usize = 100_000_000;

/// A file that is made while it is read.
struct Generated<F> {
    line: F,
    text: Vec<u8>,
    taken: usize,
}

impl<F: FnMut(&mut Vec<u8>)> Read for Generated<F> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        if self.taken == self.text.len() {
            self.text.clear();
            self.taken = 0;
            (self.line)(&mut self.text);
        }
        let amount = buffer.len().min(self.text.len() - self.taken);
        buffer[..amount].copy_from_slice(&self.text[self.taken..self.taken + amount]);
        self.taken += amount;
        Ok(amount)
    }
}

/// The most memory that this process has held, in bytes.
fn peak() -> usize {
    let status = std::fs::read_to_string("/proc/self/status").expect("Linux");
    let line = status
        .lines()
        .find(|line| line.starts_with("VmHWM:"))
        .expect("Linux");
    let kilobytes: usize = line
        .split_whitespace()
        .nth(1)
        .expect("a number")
        .parse()
        .expect("a number");
    kilobytes * 1024
}

/// Reads a model of about [`SIZE`] bytes, made of what `line(k)` gives for k = 0, 1, … .
fn check(name: &str, line: impl Fn(usize) -> String) {
    // The mark only rises, so it is set back to what is held now.
    std::fs::write("/proc/self/clear_refs", "5").expect("Linux");
    let before = peak();
    let (mut k, mut size) = (0, 0);
    let generated = Generated {
        line: |text: &mut Vec<u8>| {
            if size < SIZE {
                text.extend_from_slice(line(k).as_bytes());
                k += 1;
                size += text.len();
            }
        },
        text: Vec::new(),
        taken: 0,
    };
    let start = std::time::Instant::now();
    let mesh = read_obj(BufReader::new(generated), &mut |_| {}).expect("the model is sound");
    let ratio = (peak() - before) as f64 / SIZE as f64;
    println!(
        "{name}: {} triangles, {ratio:.2} times the file, {:.1?}",
        mesh.triangle_count(),
        start.elapsed()
    );
    assert!(ratio < 6.0, "{name}: {ratio}");
}

/// Row by row of a grid 1000 wide: the vertex, and where there is one the face that it completes.
fn grid(k: usize, corner: impl Fn(usize) -> String, triangles: bool) -> String {
    let (i, j) = (k % 1000, k / 1000);
    if i == 0 || j == 0 {
        return String::new();
    }
    let [a, b, c, d] = [k - 1001, k - 1000, k, k - 1].map(|k| corner(k + 1));
    if triangles {
        format!("f {a} {b} {c}\nf {a} {c} {d}\n")
    } else {
        format!("f {a} {b} {c} {d}\n")
    }
}

#[test]
#[ignore = "reads 400 MB and needs the process to itself"]
fn a_large_model_takes_less_than_six_times_its_file() {
    let vertex = |k: usize| {
        format!(
            "v {:.6} {:.6} {:.6}\n",
            k % 1000,
            k / 1000,
            (k as f64 * 0.37).sin()
        )
    };
    check("triangles", |k| {
        vertex(k) + &grid(k, |c| c.to_string(), true)
    });
    check("quads with normals", |k| {
        let normal = format!("vn {:.4} {:.4} 0.5\n", (k as f64).sin(), (k as f64).cos());
        vertex(k) + "vt 0.5 0.5\n" + &normal + &grid(k, |c| format!("{c}/{c}/{c}"), false)
    });
    check("many faces of few vertices", |k| {
        if k < 9 {
            vertex(k * k)
        } else {
            format!("f {} {} 9\n", k % 4 + 1, k % 3 + 5)
        }
    });
    check("scattered faces", |k| {
        if k < 1_000_000 {
            return vertex(k);
        }
        let scattered = |step: usize| k.wrapping_mul(step) % 1_000_000 + 1;
        format!(
            "f {} {} {}\n",
            scattered(7_919),
            scattered(104_729),
            scattered(1_299_709)
        )
    });
}
