//! Names of files, and the restrictions on paths found in a file. The rules are the same on every system and open
//! nothing.

use std::path::Path;

/// Windows' names of devices, in any folder and with any ending.
const DEVICES: [&str; 6] = ["con", "prn", "aux", "nul", "conin", "conout"];
/// Windows' names of ports, each followed by a digit.
const PORTS: [&str; 2] = ["com", "lpt"];

const SEPARATORS: [char; 2] = ['/', '\\'];

/// Returns the ending of a file's name, in lower case; none where the name does not end with it. `x.toml/.`, which systems open as
/// `x.toml`, has none.
///
/// ```
/// use shading_lab::document::ending;
/// use std::path::Path;
///
/// assert_eq!(ending(Path::new("a/Scene.TOML")).as_deref(), Some("toml"));
/// assert_eq!(ending(Path::new("a/scene.toml/.")), None);
/// ```
pub fn ending(path: &Path) -> Option<String> {
    let text = path.as_os_str().to_string_lossy();
    let (stem, ending) = last_part(&text).rsplit_once('.')?;
    (!stem.is_empty()).then(|| ending.to_ascii_lowercase())
}

fn last_part(path: &str) -> &str {
    path.rsplit(SEPARATORS).next().unwrap_or(path)
}

/// Returns whether a path found in a file leads to a file of this machine: not to another machine (`\\host\share`),
/// to which opening it would log in, and not to a device.
pub(crate) fn stays_here(path: &str) -> bool {
    let mut start = path.chars();
    let separator = |c: Option<char>| c.is_some_and(|c| SEPARATORS.contains(&c));
    // `\\` begins a share or a device, `\??\` the Windows kernel's name of one.
    let elsewhere = separator(start.next()) && {
        let second = start.next();
        separator(second) || second == Some('?')
    };
    let name = last_part(path).to_lowercase();
    let stem = name.split(['.', ':', ' ', '$']).next().unwrap_or_default();
    let port = |port: &&str| {
        let number = stem.strip_prefix(port).map(str::chars);
        number.is_some_and(|mut rest| {
            rest.next().is_some_and(char::is_numeric) && rest.next().is_none()
        })
    };
    !elsewhere && !DEVICES.contains(&stem) && !PORTS.iter().any(port)
}

/// Returns the name of a file that lies beside the one in which `path` was found; none where the path leads anywhere else.
/// MeshLab writes `./` before it.
pub(super) fn beside(path: &str) -> Option<&str> {
    let name = path.strip_prefix("./").or_else(|| path.strip_prefix(".\\"));
    let name = name.unwrap_or(path);
    let elsewhere = |c: char| SEPARATORS.contains(&c) || c == ':' || c.is_control();
    let sound = !name.is_empty() && !name.contains(elsewhere) && !matches!(name, "." | "..");
    (sound && stays_here(name)).then_some(name)
}
