//! A probe as text, in columns.

use glam::DVec3;
use shading_lab::analysis::{LightTerms, Probe, ProbeHit, REFERENCE_SAMPLES, SamplingError};
use shading_lab::scene::{
    Attenuation, Backfacing, CuedBy, Encoding, Light, LightKind, Overflow, PatternKind, Reflectance, ReflectionModel,
    Rgb, Scene, ShadingMode,
};
use std::fmt::Write;

/// Characters of a number's column.
const WIDTH: usize = 10;

/// The equation at the pixel, term by term, down to the stored value.
pub fn describe(probe: &Probe, scene: &Scene, sampling: &[Option<SamplingError>]) -> String {
    let [x, y] = probe.pixel;
    let Some(hit) = &probe.hit else { return format!("pixel ({x}, {y}) shows the background\n") };
    let face = hit.face.map(|face| format!(", face {face}")).unwrap_or_default();
    let mut text = format!("pixel ({x}, {y}){face}, depth {}\n\n", number(hit.depth).trim_start());
    vectors(&mut text, &[("P  position", hit.position), ("N  normal", hit.normal), ("V  to the viewer", hit.view)]);
    formula(&mut text, scene);
    text += evaluated_where(scene.shading.mode);
    text += "\n";
    ambient(&mut text, scene, hit);
    for (i, light) in hit.lights.iter().enumerate() {
        describe_light(&mut text, scene, i, light);
        if let Some(SamplingError { rms, greatest }) = sampling.get(i).copied().flatten() {
            let [rms, greatest] = [rms, greatest].map(|error| number(error).trim_start().to_owned());
            let _ = writeln!(
                text,
                "  over the picture {rms} (rms), {greatest} (greatest) from {REFERENCE_SAMPLES} samples"
            );
        }
    }
    transmission(&mut text, scene, hit);
    depth_cue(&mut text, scene, hit);
    sum(&mut text, scene, hit);
    if let Some(fit) = probe.ambient_fit {
        let [r, g, b] = fit.to_array().map(number);
        let _ = writeln!(text, "\nthe constant Ia that stands best for the bounce in this picture: {r} {g} {b}");
    }
    text
}

const CHANNELS: [&str; 3] = ["red", "green", "blue"];

/// The equation in letters, with the factors that this scene has.
fn formula(text: &mut String, scene: &Scene) {
    let lobe = match scene.reflection.model {
        ReflectionModel::Phong => "(R·V)^n",
        ReflectionModel::Blinn => "(N·H)^n",
        ReflectionModel::CookTorrance => "π·D·G/(4·(N·V))",
    };
    let w = if scene.material.reflectance == Reflectance::Constant { "" } else { "W·" };
    let _ = writeln!(text, "\nI = ka·Od·Ia + Σ f·Ip·(kd·Od·(N·L) + ks·Os·{w}S), S = {lobe}");
    if scene.transparency.kt > 0.0 {
        text.push_str("I = (1 − kt)·Irefl + kt·Itrans, Irefl as above\n");
    }
    if scene.depth_cueing.by != CuedBy::Off {
        text.push_str("shown is s0·I + (1 − s0)·Idc\n");
    }
}

fn ambient(text: &mut String, scene: &Scene, hit: &ProbeHit) {
    if hit.bounced {
        text.push_str("ambient, from other surfaces, scattered once\n");
        for (c, name) in CHANNELS.iter().enumerate() {
            row(text, name, &" ".repeat(3 * WIDTH + 6), hit.ambient[c]);
        }
        return;
    }
    let (m, ia) = (&scene.material, scene.ambient.color);
    text.push_str("ambient          ka ·        Od ·        Ia\n");
    for (c, name) in CHANNELS.iter().enumerate() {
        let color = surface_color(scene, c, hit.ambient[c], m.ka[c] * ia[c]);
        row(text, name, &format!("{} · {} · {}", number(m.ka[c]), number(color), number(ia[c])), hit.ambient[c]);
    }
}

/// Od in a channel: the material's, or where a pattern varies it what `product` has besides the other factors.
fn surface_color(scene: &Scene, channel: usize, product: f64, others: f64) -> f64 {
    let plain = scene.pattern.kind == PatternKind::None || others == 0.0;
    if plain { scene.material.color[channel] } else { product / others }
}

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
    let name = if source.name.is_empty() { String::new() } else { format!(" “{}”", source.name) };
    let _ = writeln!(text, "\nlight {index}{name}, {kind}, f = {f}");
    if source.shines(scene.soloing()) {
        vectors(text, &[("L  to the light", light.l), ("R  L mirrored", light.r), ("H  half-way", light.h)]);
        angles(text, scene, light);
    }
    if let Some(why) = light.why_nothing() {
        let _ = writeln!(text, "  adds nothing: {why}");
        return;
    }
    // The sum over an area light's samples is no product of mean factors.
    let at_pixel = matches!(scene.shading.mode, ShadingMode::Phong | ShadingMode::Exact);
    if at_pixel && source.kind != LightKind::Area {
        products(text, scene, source, light);
        return;
    }
    if source.kind == LightKind::Area {
        let _ = writeln!(text, "  summed over {} samples", source.samples);
    }
    text.push_str("                diffuse     specular\n");
    for (c, name) in CHANNELS.iter().enumerate() {
        let terms = format!("{} + {}", number(light.diffuse[c]), number(light.specular[c]));
        row(text, name, &terms, light.diffuse[c] + light.specular[c]);
    }
    for (term, why) in [("diffuse", light.why_no_diffuse()), ("specular", light.why_no_specular())] {
        if let Some(why) = why {
            let _ = writeln!(text, "  the {term} term is 0: {why}");
        }
    }
}

fn angles(text: &mut String, scene: &Scene, light: &LightTerms) {
    let model = scene.reflection.model;
    let (theta, phi) = (light.theta.to_degrees(), light.phi.to_degrees());
    let between = if model == ReflectionModel::Phong { "R and V" } else { "N and H" };
    let sharpness = match model {
        ReflectionModel::CookTorrance => format!("m   = {}", number(scene.material.roughness).trim_start()),
        _ => format!("n   = {}", number(scene.material.n).trim_start()),
    };
    let _ = writeln!(text, "  θ, N and L      {theta:WIDTH$.2}°   N·L = {}", number(light.n_dot_l).trim_start());
    let _ = writeln!(text, "  φ, {between}      {phi:WIDTH$.2}°   {sharpness}");
    if scene.material.reflectance != Reflectance::Constant {
        let angle = light.incidence.to_degrees();
        let [r, g, b] = light.reflectance.to_array().map(number);
        let _ = writeln!(text, "  angle of W      {angle:WIDTH$.2}°   W = {r} {g} {b}");
    }
    if light.kind == LightKind::Spot {
        let _ = writeln!(text, "  the spot's part {}", number(light.spot));
    }
    if light.reached < 1.0 {
        let _ = writeln!(text, "  not in shadow   {}", number(light.reached));
    }
}

/// The factors of both terms where they are evaluated at the pixel itself.
fn products(text: &mut String, scene: &Scene, source: &Light, light: &LightTerms) {
    let (m, color) = (&scene.material, source.color);
    let facing = match scene.reflection.backfacing {
        Backfacing::Clamp => light.n_dot_l.max(0.0),
        Backfacing::Flip => light.n_dot_l.abs(),
    };
    let arriving = Arriving::of(light);
    let f = arriving.product();
    let reflected = color * m.ks * m.specular_color * light.reflectance;
    let power = ratio(light.specular, reflected * f);
    let [head, factors] = arriving.columns();
    let mut term = |name: &str, columns: &str, why: Option<String>, row_of: &dyn Fn(usize) -> ([f64; 4], f64)| {
        if let Some(why) = why {
            let _ = writeln!(text, "{name} adds nothing: {why}");
            return;
        }
        let _ = writeln!(text, "{name:8}{head} ·{columns}");
        for (c, channel) in CHANNELS.iter().enumerate() {
            let (others, result) = row_of(c);
            row(text, channel, &format!("{factors} · {}", others.map(number).join(" · ")), result);
        }
    };
    term("diffuse", "         Ip ·         kd ·         Od ·        N·L", light.why_no_diffuse(), &|c| {
        let od = surface_color(scene, c, light.diffuse[c], f * color[c] * m.kd[c] * facing);
        ([color[c], m.kd[c], od, facing], light.diffuse[c])
    });
    term("specular", "         Ip ·      ks·Os ·          W ·          S", light.why_no_specular(), &|c| {
        ([color[c], m.ks[c] * m.specular_color[c], light.reflectance[c], power], light.specular[c])
    });
}

/// How much of a light arrives: f, with a spot's part and what is not in shadow where they are not 1.
struct Arriving(Vec<(&'static str, f64)>);

impl Arriving {
    fn of(light: &LightTerms) -> Self {
        let mut factors = vec![("f", light.attenuation)];
        factors.extend((light.kind == LightKind::Spot).then_some(("s", light.spot)));
        factors.extend((light.reached < 1.0).then_some(("lit", light.reached)));
        Self(factors)
    }

    fn product(&self) -> f64 {
        self.0.iter().map(|(_, value)| value).product()
    }

    /// Their letters, and their numbers below them.
    fn columns(&self) -> [String; 2] {
        let letters: Vec<_> = self.0.iter().map(|(letter, _)| format!("{letter:>WIDTH$}")).collect();
        let numbers: Vec<_> = self.0.iter().map(|(_, value)| number(*value)).collect();
        [letters, numbers].map(|column| column.join(" · "))
    }
}

/// What all channels of `product` have besides `factors`; 0 where no channel tells.
fn ratio(product: Rgb, factors: Rgb) -> f64 {
    (0..3).find(|&c| factors[c] > 0.0).map_or(0.0, |c| product[c] / factors[c])
}

fn transmission(text: &mut String, scene: &Scene, hit: &ProbeHit) {
    let Some(through) = &hit.transmission else { return };
    let _ = writeln!(text, "\ntransmission, η = {}", number(scene.transparency.ior).trim_start());
    match through.t {
        Some(t) => vectors(text, &[("T  transmitted", t)]),
        None => text.push_str("  totally reflected: there is no T\n"),
    }
    let counted = |count: u32, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    let refracted = counted(through.refractions, "refraction");
    let _ = writeln!(text, "  {refracted}, {}", counted(through.total_reflections, "total reflection"));
    text.push_str("          (1 − kt) ·      Irefl +         kt ·     Itrans\n");
    let kt = scene.transparency.kt;
    for (c, name) in CHANNELS.iter().enumerate() {
        let [clear, kt] = [1.0 - kt, kt].map(number);
        let factors = format!("{clear} · {} + {kt} · {}", number(hit.reflected[c]), number(through.seen[c]));
        row(text, name, &factors, hit.intensity[c]);
    }
}

fn depth_cue(text: &mut String, scene: &Scene, hit: &ProbeHit) {
    let Some(cue) = &hit.cue else { return };
    let cueing = &scene.depth_cueing;
    let at_pixel = matches!(scene.shading.mode, ShadingMode::Phong | ShadingMode::Exact);
    let found = match (cueing.by, scene.shading.mode) {
        (CuedBy::Vertex, ShadingMode::Phong) => "interpolated between the vertices",
        (CuedBy::Vertex, _) if !at_pixel => "the mean of those where the equation is evaluated",
        _ => "by the pixel's depth",
    };
    let [front, back] = [cueing.front, cueing.back].map(|depth| number(depth).trim_start().to_owned());
    let s0 = number(cue.scale);
    let _ = writeln!(text, "\ndepth cueing from depth {front} to {back}, s0 = {}, {found}", s0.trim_start());
    text.push_str("              s0 ·          I +   (1 − s0) ·        Idc\n");
    for (c, name) in CHANNELS.iter().enumerate() {
        // Where the equation is evaluated elsewhere, s0·I is a mean of products.
        let mean = cueing.by == CuedBy::Vertex && !at_pixel && hit.intensity[c] > 0.0;
        let share = if mean { cue.kept[c] / hit.intensity[c] } else { cue.scale };
        let [share, intensity, gone, color] = [share, hit.intensity[c], 1.0 - cue.scale, cueing.color[c]].map(number);
        row(text, name, &format!("{share} · {intensity} + {gone} · {color}"), hit.sum[c]);
    }
}

fn sum(text: &mut String, scene: &Scene, hit: &ProbeHit) {
    let overflow = match scene.display.overflow {
        Overflow::Clamp => "clamped to 1",
        Overflow::Scale => &format!("divided by the picture's greatest, {}", number(hit.divisor).trim_start()),
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
