//! Errors in scene files: each is reported with its line and what was expected.

use super::{assert_objections, objections};
use shading_lab::scene::{Light, LightKind, Scene};

#[test]
fn text_that_is_no_toml_is_named_with_its_line() {
    assert_objections(
        "version = 1\n[camera\neye = 1\n",
        &["s.toml:2: unclosed table, expected `]`"],
    );
    assert_objections(
        "\n\nmode = phong\n",
        &["s.toml:3: string values must be quoted, expected literal string"],
    );
    assert_objections("[camera]\n[camera]\n", &["s.toml:2: duplicate key"]);
}

#[test]
fn unknown_keys_are_all_named_with_their_choices() {
    assert_objections(
        "[camera]\nfov = 3\n\n[shadow]\non = true\n[[light]]\n[[light]]\npositoin = [0, 0, 0]\n",
        &[
            "s.toml:2: unknown key `camera.fov`, expected one of eye, target, up, roll, projection, fov_y, height, framing, viewer \
             (did you mean fov_y?)",
            "s.toml:4: unknown key `shadow`, expected one of version, about, camera, image, display, object, material, \
             reflection, ambient, pattern, transparency, shading, ground, backdrop, depth_cueing, compare, light",
            "s.toml:8: unknown key `light.1.positoin`, expected one of name, kind, mute, solo, position, direction, \
             color, cone, exponent, softness, shape, extent, radius, samples, attenuation, k, c1, c2, c3 (did you mean position?)",
        ],
    );
    assert_objections(
        "lights = []\n",
        &[
            "s.toml:1: unknown key `lights`, expected one of version, about, camera, image, display, object, material, \
           reflection, ambient, pattern, transparency, shading, ground, backdrop, depth_cueing, compare, light (did you mean light?)",
        ],
    );
}

#[test]
fn unknown_words_are_named_with_their_choices() {
    assert_objections(
        "[shading]\nmode = \"Gourad\"\n",
        &[
            "s.toml:2: `shading.mode` is \"Gourad\", expected one of flat, interpolated, gouraud, phong, exact \
           (did you mean gouraud?)",
        ],
    );
    assert_objections(
        "[[light]]\nattenuation = \"squared\"\n",
        &[
            "s.toml:2: `light.0.attenuation` is \"squared\", expected one of none, viewer, light, inverse-square, \
           quadratic",
        ],
    );
    assert_objections(
        "[object]\nkind = 3\n",
        &[
            "s.toml:2: `object.kind` is 3, expected one of sphere, torus, cylinder, cone, cube, plane, teapot, corrugated, balls, \
           polygons, obj",
        ],
    );
}

#[test]
fn wrong_types_are_named_with_what_was_expected() {
    for (text, expected) in [
        (
            "[material]\nn = \"abc\"\n",
            "s.toml:2: `material.n` is \"abc\", expected a number",
        ),
        (
            "[material]\nka = true\n",
            "s.toml:2: `material.ka` is true, expected a number or [red, green, blue]",
        ),
        (
            "[material]\nka = [1, 2]\n",
            "s.toml:2: `material.ka` is a list of 2, expected a number or [red, green, blue]",
        ),
        (
            "[camera]\neye = [1,\n2,\n'x']\n",
            "s.toml:4: `camera.eye.2` is \"x\", expected a number",
        ),
        (
            "[camera]\neye = [1, 2]\n",
            "s.toml:2: `camera.eye` is a list of 2, expected a list of three numbers",
        ),
        (
            "[camera]\neye = [1, 2, 3, 4]\n",
            "s.toml:2: `camera.eye` is a list of 4, expected a list of three numbers",
        ),
        (
            "[camera]\neye = 1979-05-27\n",
            "s.toml:2: `camera.eye` is a date, expected a list of three numbers",
        ),
        (
            "[camera]\nfov_y = {}\n",
            "s.toml:2: `camera.fov_y` is a table of keys, expected a number",
        ),
        (
            "[object]\nsegments = 2.5\n",
            "s.toml:2: `object.segments` is 2.5, expected a whole number, 0 or more",
        ),
        (
            "[object]\nsegments = -4\n",
            "s.toml:2: `object.segments` is -4, expected a whole number, 0 or more",
        ),
        (
            "[object]\npath = 4\n",
            "s.toml:2: `object.path` is 4, expected a path in quotation marks",
        ),
        (
            "[object]\nfit = 1\n",
            "s.toml:2: `object.fit` is 1, expected true or false",
        ),
        (
            "[image]\nsize = [1]\n",
            "s.toml:2: `image.size` is a list of 1, expected a list of two whole numbers",
        ),
        (
            "camera = 7\n",
            "s.toml:1: `camera` is 7, expected a table of keys",
        ),
        (
            "[light]\nk = 1\n",
            "s.toml:1: `light` is a table of keys, expected a list of tables",
        ),
        (
            "light = [1]\n",
            "s.toml:1: `light.0` is 1, expected a table of keys",
        ),
        (
            "[material]\nn = 1e999\n",
            "s.toml:2: `material.n` is 1e999, expected a number below 1.8e308 (or inf)",
        ),
        (
            "version = 'x'\n",
            "s.toml:1: `version` is \"x\", expected a whole number, 0 or more",
        ),
    ] {
        assert_objections(text, &[expected]);
    }
}

#[test]
fn another_version_is_all_that_is_reported() {
    let text = "\nversion = 2\n[camera]\nlens = 'fish'\n";
    let expected = format!(
        "s.toml:2: `version` is 2, expected 1: shading-lab {} reads version 1; a later version needs a later shading-lab",
        env!("CARGO_PKG_VERSION")
    );
    assert_objections(text, &[&expected]);
}

#[test]
fn every_value_out_of_range_is_named_in_the_order_of_the_lines() {
    assert_objections(
        "[camera]
fov_y = 400
height = 0
[image]
size = [0, 10]
background = [-1, 0, 0]
[object]
segments = 2
rings = 5000
[material]
ks = [0.1, 0.2, -0.3]
n = -1
[[light]]
color = [1e31, 0, 0]
k = nan
[[light]]
kind = 'directional'
direction = [0, 0, 0]
position = [0, -1e31, 0]
[[light]]
attenuation = 'quadratic'
c1 = 0
c2 = 0
c3 = 0
",
        &[
            "s.toml:2: `camera.fov_y` is 400, expected 0.001 to 179 degrees",
            "s.toml:3: `camera.height` is 0, expected 1e-30 to 1e30",
            "s.toml:5: `image.size` is [0, 10], expected sides of 1 to 16384 pixels",
            "s.toml:6: `image.background` is [-1, 0, 0], expected 0 to 1e30 in each channel",
            "s.toml:8: `object.segments` is 2, expected 3 to 4096",
            "s.toml:9: `object.rings` is 5000, expected 2 to 4096",
            "s.toml:11: `material.ks` is [0.1, 0.2, -0.3], expected 0 to 1000000 in each channel",
            "s.toml:12: `material.n` is -1, expected 0 to inf",
            "s.toml:14: `light.0.color` is [1e31, 0, 0], expected 0 to 1e30 in each channel",
            "s.toml:15: `light.0.k` is nan, expected 0 to 1e30",
            "s.toml:18: `light.1.direction` is [0, 0, 0], expected a direction, of length 1e-30 or more",
            "s.toml:19: `light.1.position` is [0, -1e31, 0], expected coordinates up to 1e30",
            "s.toml:22: `light.2.c1` is 0 like `c2` and `c3`, expected one of c1, c2, c3 above 0",
        ],
    );
}

#[test]
fn values_that_contradict_each_other_are_named() {
    assert_objections(
        "[camera]\neye = [1, 2, 3]\ntarget = [1, 2, 3]\n",
        &[
            "s.toml:2: `camera.eye` is the same point as `camera.target`, expected two different points",
        ],
    );
    assert_objections(
        "[camera]\ntarget = [0, 0, 4]\n",
        &[
            "s.toml:1: `camera.eye` is the same point as `camera.target`, expected two different points",
        ],
    );
    assert_objections(
        "[camera]\neye = [0, 3, 0]\n",
        &[
            "s.toml:1: `camera.up` is parallel to the viewing direction, expected a direction across it",
        ],
    );
    // The direction is checked even if the light's kind ignores it: a point light can become a directional one.
    for kind in ["point", "spot", "directional", "area"] {
        assert_objections(
            &format!("[[light]]\nkind = '{kind}'\ndirection = [0, 0, 0]\n"),
            &[
                "s.toml:3: `light.0.direction` is [0, 0, 0], expected a direction, of length 1e-30 or more",
            ],
        );
    }
    assert_objections(
        "[camera]\nup = [0, 0, 0]\n",
        &["s.toml:2: `camera.up` is [0, 0, 0], expected a direction, of length 1e-30 or more"],
    );
    assert_objections(
        "[depth_cueing]\nfront = 4\nback = 4\n",
        &[
            "s.toml:3: `depth_cueing.back` is not beyond `depth_cueing.front`, expected a greater depth",
        ],
    );
    assert_objections(
        "[object]\nkind = 'obj'\n",
        &[
            "s.toml:1: `object.path` is missing, expected the path of a model since `object.kind` is \"obj\"",
        ],
    );
    assert_objections(
        "[object]\npath = ''\n",
        &["s.toml:2: `object.path` is empty, expected the path of a model"],
    );
    assert_objections(
        "[image]\nsize = [16384, 16384]\n",
        &["s.toml:2: `image.size` is [16384, 16384], expected at most 134217728 pixels in total"],
    );
}

#[test]
fn a_pane_at_fault_is_named_with_its_setting() {
    assert_objections(
        "[[compare.pane]]\nname = 'a'\nset = [\n'shading.mode=exact',\n'material.n=-1',\n]\n",
        &["s.toml:5: `compare.pane.0.set.1`: `material.n` is -1, expected 0 to inf"],
    );
    assert_objections(
        "[compare]\nview = 'wipe'\n",
        &["s.toml:2: `compare.view` has nothing to compare with, expected a [[compare.pane]]"],
    );
    assert_objections(
        "[[compare.pane]]\nset = ['camera.fov_y=30']\n",
        &[
            "s.toml:2: `compare.pane.0.set.0` is \"camera.fov_y=30\", expected a key that panes may differ in (they share \
           camera, image and model)",
        ],
    );
    assert_objections(
        "[[compare.pane]]\nset = 3\n",
        &[
            "s.toml:2: `compare.pane.0.set` is 3, expected a list of settings in quotation marks, as in \
           [\"shading.mode=exact\"]",
        ],
    );
    assert_objections(
        "compare.pane = [{}, {}, {}, {}, {}, {}]\n",
        &["s.toml:1: `compare.pane` is a list of 6, expected at most 5 beside the scene itself"],
    );
}

#[test]
fn an_override_at_fault_is_named() {
    let scene = Scene::default();
    for (assignments, expected) in [
        (
            &["material.n=abc"][..],
            "--set material.n=abc: `material.n` is \"abc\", expected a number",
        ),
        (
            &["material.n=-1"],
            "--set material.n=-1: `material.n` is -1, expected 0 to inf",
        ),
        (
            &["material.n"],
            "--set material.n: no `=` after a key, expected KEY=VALUE, for example material.n=50",
        ),
        (
            &["=3"],
            "--set =3: no `=` after a key, expected KEY=VALUE, for example material.n=50",
        ),
        (
            &["material.m=3"],
            "--set material.m=3: unknown key `material.m`, expected one of ka, kd, ks, n, color, specular_color, roughness, reflectance, ior, extinction, source",
        ),
        (
            &["shading.mode=gouraux"],
            "--set shading.mode=gouraux: `shading.mode` is \"gouraux\", expected one of flat, interpolated, gouraud, \
             phong, exact (did you mean gouraud?)",
        ),
        (
            &["light.1.k=3"],
            "--set light.1.k=3: `light` has no element 1, expected 0, its only one",
        ),
        (
            &["camera.eye.3=1"],
            "--set camera.eye.3=1: `camera.eye` has no element 3, expected 0 to 2",
        ),
        (
            &["light.x.k=3"],
            "--set light.x.k=3: `light` is a list, expected a number from 0 after it",
        ),
        (
            &["material.n.x=3"],
            "--set material.n.x=3: `material.n` is a single value, expected no `x` after it",
        ),
        (
            &["camera.eye=[1,2"],
            "--set camera.eye=[1,2: `camera.eye` is not a value (unclosed array, expected `]`), expected a value as in a \
             scene file",
        ),
        (
            &["material.n="],
            "--set material.n=: `material.n` is not a value (string values must be quoted, expected literal string), \
             expected a value as in a scene file",
        ),
        (
            &["camera.target=[0,0,4]", "material.n=3"],
            "--set camera.target=[0,0,4]: `camera.eye` is the same point as `camera.target`, expected two different \
             points",
        ),
        (
            &["material.n=3", "object.kind=obj"],
            "--set object.kind=obj: `object.path` is missing, expected the path of a model since `object.kind` is \"obj\"",
        ),
    ] {
        let error = scene.with_overrides(assignments).expect_err("a mistake");
        assert_eq!(error.to_string(), expected);
    }
    let two = scene
        .with_overrides(&["material.n=-1", "camera.fov_y=0"])
        .expect_err("two mistakes")
        .to_string();
    assert_eq!(two.lines().count(), 2);
}

#[test]
fn shadows_of_more_samples_than_memory_holds_are_refused() {
    let settings = [
        "light.0.kind=area",
        "light.0.samples=1024",
        "image.size=[8192,8192]",
    ];
    let scene = Scene::default()
        .with_overrides(&settings)
        .expect("without shadows it is only slow");
    let error = scene
        .with_override("shading.shadows=true")
        .expect_err("8 GiB of bits")
        .to_string();
    assert!(
        error.contains("`image.size` has too many pixels for so many shadows"),
        "{error}"
    );
    assert!(
        scene
            .with_overrides(&["image.size=[2048,2048]", "shading.shadows=true"])
            .is_ok()
    );
    let mut many = Scene::default();
    let area = Light {
        kind: LightKind::Area,
        samples: 1024,
        ..Light::default()
    };
    many.lights = vec![area; 5];
    let error = many.validate().expect_err("5120 points").to_string();
    assert!(
        error.contains("5120 samples in all, expected at most 4096"),
        "{error}"
    );
}

#[test]
fn sizes_beyond_all_counting_are_refused() {
    let side = u32::MAX;
    let settings = [
        format!("image.size=[{side},{side}]"),
        "light.0.kind=area".into(),
        format!("light.0.samples={side}"),
    ];
    let error = Scene::default()
        .with_overrides(&settings)
        .expect_err("no memory holds that")
        .to_string();
    assert!(
        error.contains(
            "`image.size` is [4294967295, 4294967295], expected sides of 1 to 16384 pixels"
        ),
        "{error}"
    );
    assert!(
        error.contains("`light.0.samples` is 4294967295, expected 1 to 1024"),
        "{error}"
    );
}

#[test]
fn polygons_are_refused_with_the_reason() {
    let of = |vertices: &str, faces: &str| {
        objections(&format!(
            "[object]\nvertices = {vertices}\nfaces = [\n{faces}]\n"
        ))
    };
    const SQUARE: &str =
        "[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0, 0], [0.5, 1.5, 0], [0, 0, 0]]";
    for (faces, expected) in [
        (
            "[0, 1, 2],\n[0, 1, 9],\n",
            "s.toml:5: `object.faces.1.2` is 9, expected the number of a vertex, 0 to 6",
        ),
        (
            "[0, 1],\n",
            "s.toml:4: `object.faces.0` is a list of 2, expected 3 to 256 vertices",
        ),
        (
            "[0, 1, 2, 1],\n",
            "s.toml:4: `object.faces.0` is a polygon with the vertex 1 twice, expected each vertex once",
        ),
        (
            "[0, 4, 1],\n",
            "s.toml:4: `object.faces.0` is a polygon whose edges from vertex 0 to 4 and 1 to 0 meet, \
          expected one that neither crosses nor touches itself",
        ),
        (
            "[0, 1, 3, 2],\n",
            "s.toml:4: `object.faces.0` is a polygon whose edges from vertex 1 to 3 and 2 to 0 meet, \
          expected one that neither crosses nor touches itself",
        ),
        (
            "[0, 1, 2, 4, 3],\n",
            "s.toml:4: `object.faces.0` is a polygon whose edges from vertex 0 to 1 and 2 to 4 meet, \
          expected one that neither crosses nor touches itself",
        ),
        (
            "[0, 1, 2, 6],\n",
            "s.toml:4: `object.faces.0` is a polygon whose edges from vertex 0 to 1 and 2 to 6 meet, \
          expected one that neither crosses nor touches itself",
        ),
        (
            "",
            "s.toml:3: `object.faces` is empty, expected at least one polygon since there are `object.vertices`",
        ),
        (
            "[-1, 2, 3],\n",
            "s.toml:4: `object.faces.0.0` is -1, expected a whole number, 0 or more",
        ),
        ("4,\n", "s.toml:4: `object.faces.0` is 4, expected a list"),
    ] {
        assert_eq!(of(SQUARE, faces), expected, "{faces}");
    }
    for faces in [
        "[0, 4, 1, 2, 3],\n",
        "[0, 1, 2, 5, 3],\n",
        "[3, 2, 1],\n[4, 1, 2]\n",
    ] {
        let text = format!("[object]\nvertices = {SQUARE}\nfaces = [\n{faces}]\n");
        assert!(Scene::parse(&text, "s.toml").is_ok(), "{faces}");
    }
    assert_eq!(
        of("[[0, 0, 0], [1e31, 0, 0], [0, 1, 0]]", "[0, 1, 2]\n"),
        "s.toml:2: `object.vertices.1` is [1e31, 0, 0], expected coordinates up to 1e30"
    );
    assert_eq!(
        of("[[0, 0, 0], [1, 0], [0, 1, 0]]", "[0, 1, 2]\n"),
        "s.toml:2: `object.vertices.1` is a list of 2, expected a list of three numbers"
    );
    assert_eq!(
        of("[]", "[0, 1, 2]\n").lines().next(),
        Some(
            "s.toml:4: `object.faces.0.0` is 0, expected no polygon, since `object.vertices` is empty"
        )
    );
    assert_objections(
        "[object]\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\nfaces = [[0, 1, 2]]\nvertex_normals = [[0, 0, 1], [0, 0, 0]]\n",
        &[
            "s.toml:4: `object.vertex_normals` is a list of 2, expected 3, one for each vertex, or none",
            "s.toml:4: `object.vertex_normals.1` is [0, 0, 0], expected a direction, of length 1e-30 or more",
        ],
    );
    let many = format!("[object]\nvertices = [{}]\n", "[0, 0, 0],".repeat(16_385));
    assert_eq!(
        objections(&many),
        "s.toml:2: `object.vertices` is a list of 16385, expected at most 16384"
    );
}

#[test]
fn a_key_that_is_not_written_is_at_fault_in_the_line_of_its_table() {
    let text = "[camera]\neye = [0, 4, 0]\n\n[[light]]\nkind = \"area\"\n[object]\nkind = \"obj\"\n[[light]]\nc1 = -1\n";
    let found = objections(text);
    for line in [
        "s.toml:1: `camera.up` is parallel",
        "s.toml:6: `object.path` is missing",
        "s.toml:9: `light.1.c1` is -1",
    ] {
        assert!(found.contains(line), "{found}");
    }
}
