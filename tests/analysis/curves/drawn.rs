//! The curves as figures: their texts, their sheets, and the lobe over the picture.

use super::{lobe_of, near, preset, probed};
use glam::{DVec2, DVec3};
use shading_lab::analysis::curves::Curves;
use shading_lab::analysis::overlay::{OverlayLayer, OverlayOptions};
use shading_lab::analysis::probe::{Probe, draw_overlay};
use shading_lab::figure::palette::contrast;
use shading_lab::figure::{Drawing, Ink, Paper, Plot, PlotKind, PlotStyle, lay_out, lay_out_sheet};
use shading_lab::scene::{Reflectance, Rgb, Scene, ShadingMode, View};
use tiny_skia::Pixmap;

/// Returns all plots of a scene that has every kind.
fn all_plots() -> Vec<Plot> {
    let mut scene = preset("attenuation");
    scene.material.reflectance = Reflectance::Gold;
    let (renderer, probe) = probed(&scene);
    let curves = Curves::new(&renderer, &scene, &probe, 0);
    PlotKind::ALL
        .into_iter()
        .filter_map(|kind| curves.plot(kind, &scene))
        .collect()
}

fn figure(size: [u32; 2], paper: Paper) -> Drawing {
    let plots = all_plots();
    lay_out_sheet(
        &plots,
        DVec2::from_array(size.map(f64::from)),
        &PlotStyle::of(size, plots.len(), paper),
    )
}

/// Returns whether every tag that opens is closed, in order.
fn well_formed(svg: &str) -> bool {
    let mut open: Vec<&str> = Vec::new();
    for piece in svg.split('<').skip(1) {
        let Some((tag, text)) = piece.split_once('>') else {
            return false;
        };
        if text.contains('&')
            && !["&amp;", "&lt;", "&gt;", "&quot;"]
                .iter()
                .any(|entity| text.contains(entity))
        {
            return false;
        }
        let name = tag
            .split([' ', '/'])
            .find(|word| !word.is_empty())
            .unwrap_or_default();
        match (tag.starts_with('/'), tag.ends_with('/')) {
            (true, _) if open.pop() != Some(name) => return false,
            (false, false) => open.push(name),
            _ => {}
        }
        if tag.matches('"').count() % 2 == 1 {
            return false;
        }
    }
    open.is_empty()
}

#[test]
fn an_svg_is_text_with_its_labels_in_it() {
    let svg = figure([1200, 800], Paper::LIGHT).to_svg("a < b & \"c\"");
    assert!(svg.starts_with("<svg ") && well_formed(&svg), "{svg}");
    assert!(svg.contains("<title>a &lt; b &amp; &quot;c&quot;</title>"));
    for label in [
        "n = 20, now",
        english!("point-legend-half-width"),
        "W(80°)",
        english!("point-both-terms"),
        "farthest: f(",
        "distance from the light",
    ] {
        assert!(svg.contains(label), "{label}");
    }
    assert!(
        !svg.contains("NaN") && !svg.contains("inf"),
        "all places are numbers"
    );
}

#[test]
fn a_figure_is_drawn_on_either_paper_and_at_any_size() {
    for paper in [Paper::LIGHT, Paper::DARK] {
        let drawing = figure([900, 600], paper);
        let mut pixmap = Pixmap::new(900, 600).expect("not empty");
        drawing.draw(&mut pixmap.as_mut());
        let ground = pixmap.pixels()[0];
        assert_eq!(
            [ground.red(), ground.green(), ground.blue(), ground.alpha()],
            [paper.ground[0], paper.ground[1], paper.ground[2], 255]
        );
        let inked = pixmap
            .pixels()
            .iter()
            .filter(|pixel| **pixel != ground)
            .count();
        assert!(
            (20_000..300_000).contains(&inked),
            "{inked} pixels of 540000 are inked"
        );
    }
    for size in [[1, 1], [40, 900], [900, 40], [160, 120], [3000, 2000]] {
        let drawing = figure(size, Paper::LIGHT);
        let mut pixmap = Pixmap::new(size[0], size[1]).expect("not empty");
        drawing.draw(&mut pixmap.as_mut());
        assert!(
            drawing.texts.iter().all(|text| text.at.is_finite()),
            "{size:?}"
        );
    }
}

#[test]
fn texts_stay_on_the_sheet_and_off_each_other() {
    for plot in all_plots() {
        let size = DVec2::new(1280.0, 800.0);
        let style = PlotStyle::of([1280, 800], 1, Paper::LIGHT);
        let drawing = lay_out(&plot, size, &style);
        let boxes: Vec<_> = drawing
            .texts
            .iter()
            .map(|text| {
                let left = text.at.x - text.align * text.width();
                let (min, max) = (
                    DVec2::new(left, text.at.y - 0.6 * text.size),
                    DVec2::new(left + text.width(), text.at.y),
                );
                assert!(
                    min.cmpge(DVec2::ZERO).all() && max.cmple(size).all(),
                    "{text:?} leaves the sheet"
                );
                (min, max, &text.text)
            })
            .collect();
        for (i, a) in boxes.iter().enumerate() {
            for b in &boxes[i + 1..] {
                let apart = a.0.cmpge(b.1).any() || b.0.cmpge(a.1).any();
                assert!(apart, "{:?}: “{}” and “{}” overlap", plot.kind, a.2, b.2);
            }
        }
    }
}

#[test]
fn a_place_in_a_plot_is_read_back() {
    for plot in all_plots() {
        let drawing = lay_out(
            &plot,
            DVec2::new(800.0, 600.0),
            &PlotStyle::of([800, 600], 1, Paper::LIGHT),
        );
        let x = plot.x.low + 0.4 * (plot.x.high - plot.x.low);
        let (at, _) = drawing.place([x, 0.5 * plot.y.high]).expect("room enough");
        near(drawing.x_at(at).expect("inside"), x, 1e-6);
        assert_eq!(drawing.x_at(DVec2::new(-5.0, -5.0)), None);
    }
}

/// An upper bound on the pixels inked by the probe's ring, which is always drawn.
const RING: usize = 100;

/// Counts the pixels that the lobe alone inks over an empty picture, and returns the mean of their positions with the
/// count.
fn inked(scene: &Scene, probe: &Probe, length: f64) -> (usize, DVec2) {
    let options = OverlayOptions {
        layers: vec![OverlayLayer::Lobe],
        length: Some(length),
        ..OverlayOptions::default()
    };
    let mut pixmap = Pixmap::new(400, 400).expect("not empty");
    draw_overlay(&mut pixmap.as_mut(), scene, probe, &options);
    let inked = pixmap
        .pixels()
        .iter()
        .enumerate()
        .filter(|(_, pixel)| pixel.alpha() > 0);
    let places: Vec<DVec2> = inked
        .map(|(i, _)| DVec2::new((i % 400) as f64, (i / 400) as f64))
        .collect();
    (
        places.len(),
        places.iter().sum::<DVec2>() / places.len().max(1) as f64,
    )
}

#[test]
fn the_lobe_over_the_picture_grows_with_the_vectors_and_leans_towards_r() {
    let mut scene = preset("sphere");
    scene.material.kd = Rgb::ZERO;
    let (_, lobe, probe) = lobe_of(&scene);
    let position = probe.hit.as_ref().expect("the sphere").position;
    let view = View::new(&scene.camera, [400, 400]);
    let at = |point| view.project(point).expect("before the eye").0;
    let (small, _) = inked(&scene, &probe, 0.2);
    let (large, middle) = inked(&scene, &probe, 0.8);
    assert!(
        small > RING && large > 3 * small,
        "{small} and {large} pixels"
    );
    let lean = (middle - at(position))
        .normalize()
        .dot((at(position + lobe.r) - at(position)).normalize());
    assert!(lean > 0.8, "{lean}");
}

#[test]
fn a_point_that_is_not_lit_has_no_lobe_over_the_picture() {
    let mut scene = preset("sphere");
    scene.lights[0].position = DVec3::new(0.0, 0.0, -5.0);
    let (_, probe) = probed(&scene);
    assert!(inked(&scene, &probe, 0.5).0 < RING);
    scene.lights.clear();
    let (_, probe) = probed(&scene);
    assert!(inked(&scene, &probe, 0.5).0 < RING);
}

#[test]
fn every_colour_stands_out_from_its_paper() {
    let channels = (0..3).map(Ink::Channel);
    use ShadingMode::{Exact, Flat, Gouraud, Interpolated, Phong};
    let modes = [Flat, Interpolated, Gouraud, Phong, Exact].map(Ink::Shading);
    let others = [
        Ink::N,
        Ink::L,
        Ink::R,
        Ink::V,
        Ink::H,
        Ink::Perceived,
        Ink::Reference,
    ];
    let historic = (0..3).map(Ink::Historic);
    for ink in others
        .into_iter()
        .chain(channels)
        .chain(modes)
        .chain(historic)
    {
        for paper in [Paper::LIGHT, Paper::DARK] {
            assert!(contrast(paper.line(ink), paper.ground) >= 3.0, "{ink:?}");
            assert!(contrast(paper.letters(ink), paper.ground) >= 4.5, "{ink:?}");
            assert!(
                contrast(paper.weak, paper.ground) >= 4.5
                    && contrast(paper.text, paper.ground) > 10.0
            );
        }
    }
}
