//! The materials that a model's file uses, and the libraries (`.mtl`) beside it that define them.
//!
//! A statement that cannot be read is left out with a remark, and the model is drawn all the same.

use super::lines::{malformed, quoted};
use crate::geometry::mesh::Mesh;
use crate::geometry::mtl::{ModelMaterial, NO_MATERIAL, Remark};
use crate::scene::{Material, MaterialOverride, Rgb};
use crate::text::text;

/// A function that returns the bytes of a library by its name in the model's file, or a sentence that says why there are none.
pub type OpenLibrary<'a> = &'a mut dyn FnMut(&str) -> Result<Vec<u8>, String>;

/// The longest name of a material, in characters: that of its changes in a scene.
const LONGEST_NAME: usize = MaterialOverride::MAX_NAME;
/// The most libraries of a model.
const MOST_LIBRARIES: usize = 64;
/// The most remarks that are kept.
const MOST_REMARKS: usize = 16;

/// The materials of a model whose lines are being read.
#[derive(Default)]
pub struct Uses {
    /// The libraries, each with the line of its `mtllib`.
    libraries: Vec<(String, u64)>,
    /// The materials that faces have, each with the line that first names it. Its place here is its number.
    names: Vec<(String, u64)>,
    /// The numbers in the order of the names.
    sorted: Vec<u16>,
    /// The name and the line of the latest `usemtl`, and its number once a face has it.
    current: Option<(String, u64, Option<u16>)>,
    /// The number of each face's material; empty while no face has one.
    faces: Vec<u16>,
    remarks: Vec<Remark>,
}

impl Uses {
    /// Keeps a remark, of several that are alike the first.
    pub fn remark(&mut self, library: Option<&str>, line: u64, words: String) {
        let alike = |known: &Remark| known.words == words && known.library.as_deref() == library;
        if self.remarks.len() < MOST_REMARKS && !self.remarks.iter().any(alike) {
            self.remarks.push(Remark {
                library: library.map(str::to_owned),
                line,
                words,
            });
        }
    }

    /// Returns the place of a name in `sorted`: where it is, or where it would be.
    fn find(&self, name: &str) -> Result<usize, usize> {
        let of = |number: &u16| self.names[usize::from(*number)].0.as_str();
        self.sorted.binary_search_by(|number| of(number).cmp(name))
    }

    /// Notes the libraries of an `mtllib` line. Their names may have blanks (the format's 1995 description allows several
    /// names in a line, exporters write blanks in one), so a name ends behind `.mtl`. Blender's importer takes quotation
    /// marks off, too.
    pub fn library(&mut self, rest: &[u8], line: u64) {
        let rest = String::from_utf8_lossy(rest);
        let (mut name, words) = (String::new(), rest.split_ascii_whitespace());
        let count = words.clone().count();
        for (k, word) in words.enumerate() {
            if !name.is_empty() {
                name.push(' ');
            }
            name += word;
            let bare = name.trim_matches('"');
            if k + 1 < count && !bare.to_ascii_lowercase().ends_with(".mtl") {
                continue;
            }
            let new = self.libraries.iter().all(|(known, _)| known != bare);
            if new && self.libraries.len() < MOST_LIBRARIES {
                self.libraries.push((bare.to_owned(), line));
            }
            name.clear();
        }
    }

    /// Notes the material of the faces to come. Blender writes an empty name before faces that have none.
    pub fn material(&mut self, rest: &[u8], line: u64) {
        self.current = None;
        let name = String::from_utf8_lossy(rest);
        if name.chars().count() > LONGEST_NAME {
            let words = text!("mtl-name-too-long", longest = LONGEST_NAME);
            self.remark(None, line, words);
        } else if !name.is_empty() {
            self.current = Some((name.into_owned(), line, None));
        }
    }

    /// Gives the face with the number `face`, the latest, the present material.
    pub fn face(&mut self, face: usize) {
        let number = self.number();
        if number != NO_MATERIAL || !self.faces.is_empty() {
            self.faces.resize(face, NO_MATERIAL);
            self.faces.push(number);
        }
    }

    /// Returns the number of the present material, which a face has.
    fn number(&mut self) -> u16 {
        let Some((name, line, number)) = self.current.take() else {
            return NO_MATERIAL;
        };
        let known = number.unwrap_or_else(|| self.number_of(&name, line));
        self.current = Some((name, line, Some(known)));
        known
    }

    fn number_of(&mut self, name: &str, line: u64) -> u16 {
        let place = match self.find(name) {
            Ok(known) => return self.sorted[known],
            Err(place) => place,
        };
        if self.names.len() == ModelMaterial::MAX {
            let words = text!("mtl-too-many", most = ModelMaterial::MAX);
            self.remark(None, line, words);
            return NO_MATERIAL;
        }
        let new = self.names.len() as u16;
        self.names.push((name.to_owned(), line));
        self.sorted.insert(place, new);
        new
    }

    /// Gives the mesh its materials, as the libraries define them. Without a face that has one no library is opened:
    /// MeshLab names one then that it does not write.
    pub fn resolve(mut self, mesh: &mut Mesh, open: OpenLibrary<'_>) {
        let mut found: Vec<Option<ModelMaterial>> = vec![None; self.names.len()];
        let mut all_read = true;
        for (library, line) in std::mem::take(&mut self.libraries) {
            if found.is_empty() {
                break;
            }
            match open(&library) {
                Ok(bytes) => self.read(&library, &bytes, &mut found),
                Err(words) => {
                    all_read = false;
                    let words = format!("{}: {words}", quoted(library.as_bytes()));
                    self.remark(None, line, words);
                }
            }
        }
        let mut numbers = vec![NO_MATERIAL; found.len()];
        for (k, (name, line)) in std::mem::take(&mut self.names).into_iter().enumerate() {
            if let Some(material) = found[k].take() {
                numbers[k] = mesh.materials.len() as u16;
                mesh.materials.push(material);
            } else if all_read {
                // A library that is missing is one remark, not one for each of its materials.
                let words = text!("mtl-not-found", name = quoted(name.as_bytes()));
                self.remark(None, line, words);
            }
        }
        if !mesh.materials.is_empty() {
            self.faces.resize(mesh.face_count(), NO_MATERIAL);
            self.faces.shrink_to_fit();
            for number in &mut self.faces {
                let new = numbers.get(usize::from(*number));
                *number = new.copied().unwrap_or(NO_MATERIAL);
            }
            mesh.face_materials = self.faces;
        }
        mesh.remarks = self.remarks;
    }

    /// Reads the materials of a library that are used and not found yet. The first definition counts: so the format
    /// has it of several libraries, and Blender's importer within one (tobj takes the last, Assimp continues the first).
    fn read(&mut self, library: &str, bytes: &[u8], found: &mut [Option<ModelMaterial>]) {
        let text = String::from_utf8_lossy(bytes);
        // MeshLab's `Tr` is the part that is not transparent (vcglib, wrap/io_trimesh/io_material.h).
        const MESHLAB: &[u8] = b"Meshlab";
        let opaque_tr = bytes.windows(MESHLAB.len()).any(|part| part == MESHLAB);
        let mut current: Option<&mut ModelMaterial> = None;
        // `d` counts before `Tr`, whatever their order.
        let mut has_d = false;
        for (line, text) in (1..).zip(text.trim_start_matches('\u{feff}').lines()) {
            let (key, rest) = split(text);
            if key.eq_ignore_ascii_case("newmtl") {
                has_d = false;
                let number = self.find(rest).map(|place| usize::from(self.sorted[place]));
                current = number.ok().filter(|k| found[*k].is_none()).map(|k| {
                    found[k].insert(ModelMaterial {
                        name: rest.to_owned(),
                        ..ModelMaterial::default()
                    })
                });
            } else if let Some(material) = &mut current
                && let Err(words) = statement(material, key, rest, (opaque_tr, &mut has_d))
            {
                self.remark(Some(library), line, words);
            }
        }
    }
}

/// Splits a line into its keyword and what follows, without a comment. A name may have a `#` that no blank precedes.
fn split(line: &str) -> (&str, &str) {
    let line = line.trim();
    let blank = |c: char| c.is_ascii_whitespace();
    let (key, rest) = line.split_once(blank).unwrap_or((line, ""));
    let comment = rest
        .match_indices('#')
        .find(|(k, _)| *k == 0 || rest[..*k].ends_with(blank));
    let rest = comment.map_or(rest, |(k, _)| &rest[..k]);
    (key, rest.trim())
}

/// Takes over a statement of a material; keywords count in any case, as in Assimp.
fn statement(
    material: &mut ModelMaterial,
    key: &str,
    rest: &str,
    (opaque_tr, has_d): (bool, &mut bool),
) -> Result<(), String> {
    let lower = key.to_ascii_lowercase();
    match &*lower {
        "ka" => material.ka = Some(colour(rest)?),
        "kd" => material.kd = Some(colour(rest)?),
        "ks" => material.ks = Some(colour(rest)?),
        "ns" => material.n = Some(number(rest)?),
        "ni" => material.ior = Some(number(rest)?),
        // Some exporters write the number of the model as `0.0`.
        "illum" => material.illum = Some(number(rest)? as u32),
        "d" => {
            let halo = rest.strip_prefix("-halo");
            material.dissolve = Some(number(halo.unwrap_or(rest))?.min(1.0));
            *has_d = true;
            if halo.is_some() {
                return Err(text!("mtl-halo").to_owned());
            }
        }
        "tr" if !*has_d => {
            let tr = number(rest)?.min(1.0);
            material.dissolve = Some(if opaque_tr { tr } else { 1.0 - tr });
        }
        "bump" | "disp" | "decal" | "refl" | "norm" => material.maps.push(texture(rest)),
        map if map.starts_with("map_") => {
            material.masked |= map == "map_d";
            material.maps.push(texture(rest));
        }
        _ => {}
    }
    Ok(())
}

/// Reads a colour: red, green and blue, or one number for a grey.
fn colour(rest: &str) -> Result<Rgb, String> {
    let mut words = rest.split_ascii_whitespace();
    let first = words.next().unwrap_or_default();
    if first == "spectral" || first == "xyz" {
        return Err(text!("mtl-spectral", word = first));
    }
    let r = number(first)?;
    let Some(second) = words.next() else {
        return Ok(Rgb::splat(r));
    };
    let g = number(second)?;
    Ok(Rgb::new(r, g, number(words.next().unwrap_or_default())?))
}

/// Reads the first number of a statement.
fn number(rest: &str) -> Result<f64, String> {
    let word = rest.split_ascii_whitespace().next().unwrap_or_default();
    let number = word.parse().ok();
    number
        .filter(|number: &f64| (0.0..=Material::MAX_COEFFICIENT).contains(number))
        .ok_or_else(|| malformed(word.as_bytes(), "mtl-number"))
}

/// Returns the name of the texture's file, which may have blanks, after its options. The arguments of options are numbers
/// and single words.
fn texture(rest: &str) -> String {
    let mut rest = rest;
    while rest.starts_with('-') {
        let (option, arguments) = split(rest);
        rest = arguments;
        let word = matches!(option, "-type" | "-imfchan" | "-colorspace");
        loop {
            let (argument, after) = split(rest);
            if !word && !matches!(argument, "on" | "off") && argument.parse::<f64>().is_err() {
                break;
            }
            rest = after;
            if word {
                break;
            }
        }
    }
    let name = rest.rsplit(['/', '\\']).next().unwrap_or_default();
    quoted(name.as_bytes())
}
