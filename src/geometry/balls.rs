//! Three balls with a material each: a model that comes with the program, read as any other.

use super::mesh::Mesh;
use super::obj::read_model;
use crate::scene::ObjectKind;
use std::sync::{Arc, LazyLock};

const OBJ: &str = include_str!("../../assets/balls/balls.obj");
const MTL: &str = include_str!("../../assets/balls/balls.mtl");

static BALLS: LazyLock<Arc<Mesh>> = LazyLock::new(|| {
    let mesh = read_model(OBJ.as_bytes(), &mut |_| {}, &mut |_| Ok(MTL.into()));
    Arc::new(mesh.unwrap_or_else(|error| unreachable!("the tests read it: {error}")))
});

/// Returns the built-in model of a kind that is one.
pub fn built_in(kind: ObjectKind) -> Option<&'static Arc<Mesh>> {
    (kind == ObjectKind::Balls).then(|| &*BALLS)
}
