//! A probe as text, in columns.

use glam::DVec3;
use shading_lab::analysis::{LightTerms, Probe, ProbeHit};
use shading_lab::scene::{
    Attenuation, Backfacing, Encoding, LightKind, Overflow, ReflectionModel, Rgb, Scene, ShadingMode,
};
use std::fmt::Write;

/// Characters of a number's column.
const WIDTH: usize = 10;

/// The equation at the pixel, term by term, down to the stored value.
pub fn describe(probe: &Probe, scene: &Scene) -> String {
    let [x, y] = probe.pixel;
    let Some(hit) = &probe.hit else { return format!("pixel ({x}, {y}) shows the background\n") };
    let face = hit.face.map(|face| format!(", face {face}")).unwrap_or_default();
    let mut text = format!("pixel ({x}, {y}){face}, depth {}\n\n", number(hit.depth).trim_start());
    vectors(&mut text, &[("P  position", hit.position), ("N  normal", hit.normal), ("V  to the viewer", hit.view)]);
    let lobe = if scene.reflection.model == ReflectionModel::Blinn { "(N·H)^n" } else { "(R·V)^n" };
    let _ = writeln!(text, "\nI = ka·Od·Ia + Σ f·Ip·(kd·Od·(N·L) + ks·S), S = {lobe}");
    text += evaluated_where(scene.shading.mode);
    text += "\n";
    let m = &scene.material;
    let ia = scene.ambient.color;
    text += "ambient          ka ·        Od ·        Ia\n";
    for (c, name) in CHANNELS.iter().enumerate() {
        row(
            &mut text,
            name,
            &format!("{} · {} · {}", number(m.ka[c]), number(m.color[c]), number(ia[c])),
            hit.ambient[c],
        );
    }
    for (i, light) in hit.lights.iter().enumerate() {
        describe_light(&mut text, scene, i, light);
    }
    sum(&mut text, scene, hit);
    text
}

const CHANNELS: [&str; 3] = ["red", "green", "blue"];

fn evaluated_where(mode: ShadingMode) -> &'static str {
    match mode {
        ShadingMode::Flat => "    evaluated once for the polygon; the vectors are those at the pixel\n",
        ShadingMode::Interpolated | ShadingMode::Gouraud => {
            "    evaluated at the polygon's vertices and interpolated; the vectors are those at the pixel\n"
        }
        ShadingMode::Phong | ShadingMode::Exact => "",
    }
}

fn describe_light(text: &mut String, scene: &Scene, index: usize, light: &LightTerms) {
    let Some(source) = scene.lights.get(index) else { return };
    let blinn = scene.reflection.model == ReflectionModel::Blinn;
    let kind = match light.kind {
        LightKind::Point => "point",
        LightKind::Directional => "directional",
        LightKind::Spot => "spot",
        LightKind::Area => "area",
    };
    let f = match source.attenuation {
        Attenuation::None => "1",
        Attenuation::Viewer => "1/(r + k), r to the viewer",
        Attenuation::Light => "1/(r + k), r to the light",
        Attenuation::InverseSquare => "1/d²",
        Attenuation::Quadratic => "min(1, 1/(c1 + c2·d + c3·d²))",
    };
    let _ = writeln!(text, "\nlight {index}, {kind}, f = {f}");
    vectors(text, &[("L  to the light", light.l), ("R  L mirrored", light.r), ("H  half-way", light.h)]);
    let (theta, phi) = (light.theta.to_degrees(), light.phi.to_degrees());
    let between = if blinn { "N and H" } else { "R and V" };
    let _ = writeln!(text, "  θ, N and L      {theta:WIDTH$.2}°   N·L = {}", number(light.n_dot_l).trim_start());
    let _ = writeln!(text, "  φ, {between}      {phi:WIDTH$.2}°   n   = {}", number(scene.material.n).trim_start());
    if matches!(scene.shading.mode, ShadingMode::Phong | ShadingMode::Exact) {
        products(text, scene, source.color, light);
    } else {
        text.push_str("                diffuse     specular\n");
        for (c, name) in CHANNELS.iter().enumerate() {
            let terms = format!("{} + {}", number(light.diffuse[c]), number(light.specular[c]));
            row(text, name, &terms, light.diffuse[c] + light.specular[c]);
        }
    }
}

/// The factors of both terms where they are evaluated at the pixel itself.
fn products(text: &mut String, scene: &Scene, color: Rgb, light: &LightTerms) {
    let m = &scene.material;
    let facing = match scene.reflection.backfacing {
        Backfacing::Clamp => light.n_dot_l.max(0.0),
        Backfacing::Flip => light.n_dot_l.abs(),
    };
    let power = ratio(light.specular, color * m.ks * light.attenuation);
    text.push_str("diffuse           f ·         Ip ·         kd ·         Od ·        N·L\n");
    for (c, name) in CHANNELS.iter().enumerate() {
        let factors = [light.attenuation, color[c], m.kd[c], m.color[c], facing].map(number).join(" · ");
        row(text, name, &factors, light.diffuse[c]);
    }
    text.push_str("specular          f ·         Ip ·         ks ·          S\n");
    for (c, name) in CHANNELS.iter().enumerate() {
        let factors = [light.attenuation, color[c], m.ks[c], power].map(number).join(" · ");
        row(text, name, &factors, light.specular[c]);
    }
}

/// What all channels of `product` have besides `factors`; 0 where no channel tells.
fn ratio(product: Rgb, factors: Rgb) -> f64 {
    (0..3).find(|&c| factors[c] > 0.0).map_or(0.0, |c| product[c] / factors[c])
}

fn sum(text: &mut String, scene: &Scene, hit: &ProbeHit) {
    let overflow = match scene.display.overflow {
        Overflow::Clamp => "clamped to 1",
        Overflow::Scale => "scaled to the picture's greatest",
        Overflow::Mark => "marked above 1",
    };
    let encoding = match scene.display.encoding {
        Encoding::Raw => "times 255",
        Encoding::Srgb => "encoded as sRGB",
    };
    let _ = writeln!(text, "\nsum, and stored: {overflow}, {encoding}, rounded");
    for (c, name) in CHANNELS.iter().enumerate() {
        let _ = writeln!(text, "  {name:6}{}  -> {:3}", number(hit.sum[c]), hit.stored[c]);
    }
}

fn row(text: &mut String, name: &str, factors: &str, result: f64) {
    let _ = writeln!(text, "  {name:6}{factors} = {}", number(result));
}

fn vectors(text: &mut String, rows: &[(&str, DVec3)]) {
    for (name, vector) in rows {
        let [x, y, z] = vector.to_array().map(number);
        let _ = writeln!(text, "  {name:16}{x} {y} {z}");
    }
}

/// Four decimals, or the scientific form where those say too little, in the width of a column.
fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || (1e-3..1e5).contains(&size) || !size.is_finite() {
        format!("{value:WIDTH$.4}")
    } else {
        format!("{value:WIDTH$.2e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_take_a_column() {
        for value in [0.0, -0.5, 1.0, 99_999.0, 1e-9, -1.5e20, f64::INFINITY] {
            assert_eq!(number(value).chars().count(), WIDTH, "{value}");
        }
    }

    #[test]
    fn a_common_factor_is_found_in_the_channel_that_has_it() {
        assert_eq!(ratio(Rgb::new(0.0, 0.5, 0.0), Rgb::new(0.0, 2.0, 0.0)), 0.25);
        assert_eq!(ratio(Rgb::ZERO, Rgb::ZERO), 0.0);
    }
}
