//! Concave polygons of one shade: OpenGL takes the shade of a triangle from one of its vertices, and not all
//! triangles that cover such a polygon contain its first one.

use crate::export::text::filled;
use crate::geometry::VertexMesh;
use crate::render::FaceMaterials;

/// A face drawn through the stencil buffer, as a fan about its first vertex, which comes last.
struct Fan {
    face: usize,
    /// Triangles with the polygon's orientation, and those with the opposite one.
    triangles: [Vec<[u32; 3]>; 2],
}

/// The faces that their fans do not cover, and their materials where there are several.
#[derive(Default)]
pub struct Concave<'a>(Vec<Fan>, Option<&'a FaceMaterials>);

impl<'a> Concave<'a> {
    /// Finds the faces of `mesh` that their fans do not cover; `face_materials` has their materials if there are several.
    pub fn of(mesh: &VertexMesh, face_materials: Option<&'a FaceMaterials>) -> Self {
        let runs = mesh.cut.chunk_by(|a, b| a.0 == b.0);
        let fan = |run: &[(u32, [u32; 3])]| {
            let face = run[0].0 as usize;
            let (vertices, normal) = (mesh.face(face), mesh.face_normal(face));
            let turns_along = |triangle: &[u32; 3]| {
                let [a, b, c] = triangle.map(|v| mesh.positions[v as usize].as_dvec3());
                (b - a).cross(c - a).dot(normal) > 0.0
            };
            let triangles = vertices[1..]
                .windows(2)
                .map(|pair| [pair[0], pair[1], vertices[0]]);
            Fan {
                face,
                triangles: triangles.partition(turns_along).into(),
            }
        };
        Self(runs.map(fan).collect(), face_materials)
    }

    /// Returns whether face `f` is among them.
    pub fn has(&self, f: usize) -> bool {
        self.0.binary_search_by_key(&f, |fan| fan.face).is_ok()
    }

    /// Returns the part of the program that draws them; empty where there are none.
    pub fn text(&self) -> String {
        if self.0.is_empty() {
            return String::new();
        }
        let row = |[a, b, c]: &[u32; 3]| format!("    {{{a}, {b}, {c}}},\n");
        let count = |Fan {
                         face,
                         triangles: [along, against],
                     }: &Fan| {
            let (all, along) = (along.len() + against.len(), along.len());
            match self.1 {
                None => format!("    {{{all}, {along}}},\n"),
                Some(face_materials) => format!(
                    "    {{{all}, {along}, {}}},\n",
                    face_materials.of_face(*face as u32)
                ),
            }
        };
        let (numbers, use_material) = match self.1 {
            None => ("2", ""),
            Some(_) => ("3", "        use_material(concave[i][2]);"),
        };
        let triangles = self.0.iter().flat_map(|fan| fan.triangles.iter().flatten());
        let text = filled(
            include_str!("concave.c"),
            &[
                ("fans", &triangles.map(row).collect::<String>()),
                ("numbers", numbers),
                ("use_material", use_material),
                ("counts", &self.0.iter().map(count).collect::<String>()),
            ],
        );
        text + "\n"
    }

    /// Returns the call of that part.
    pub fn draw(&self) -> &'static str {
        if self.0.is_empty() {
            ""
        } else {
            "    draw_concave();"
        }
    }

    /// Returns the stencil buffer that the picture needs for it.
    pub fn stencil(&self) -> &'static str {
        if self.0.is_empty() {
            ""
        } else {
            "EGL_STENCIL_SIZE, 8, "
        }
    }
}
