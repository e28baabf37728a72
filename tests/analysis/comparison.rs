//! Comparison panes of one scene: their pictures, the measured differences, and the sentences about them.

use shading_lab::analysis::comparison::{
    Captions, DrawnPane, ErrorFigures, ErrorRegion, LinearPicture, PaneArea, brightest,
    comparison_sheet, difference_picture, difference_scale, draw_panes, error_figures, pane_areas,
    pane_figures, panes_on_sheet, region_errors,
};
use shading_lab::analysis::perception::luminance;
use shading_lab::analysis::probe::probe;
use shading_lab::analysis::unwatched;
use shading_lab::figure::palette;
use shading_lab::render::{Frame, Renderer};
use shading_lab::scene::{
    Choice, Compare, CompareView, DifferenceKind, Pane, Rgb, Scene, ShadingMode, presets,
};
use std::convert::Infallible;

fn drawn(scene: &Scene) -> Vec<DrawnPane> {
    let nothing = |_: &mut _, _: &mut _, _: &_| Ok::<(), Infallible>(());
    draw_panes(
        &mut Renderer::default(),
        scene,
        &panes_on_sheet(scene),
        1,
        &mut |_| true,
        nothing,
    )
    .unwrap_or_default()
}

/// Returns a coarse sphere beside the true one.
fn scene(view: CompareView) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [96, 64];
    scene.object.segments = 9;
    scene.object.rings = 5;
    scene.shading.mode = ShadingMode::Gouraud;
    scene.compare = Compare {
        view,
        panes: vec![Pane::of(&["shading.mode=exact"])],
        ..Compare::default()
    };
    scene
}

#[test]
fn a_pane_is_the_scene_with_its_own_settings() {
    let scene = scene(CompareView::Wipe);
    for (pane, mode) in drawn(&scene)
        .iter()
        .zip([ShadingMode::Gouraud, ShadingMode::Exact])
    {
        let mut alone = Scene {
            compare: Compare::default(),
            ..scene.clone()
        };
        alone.shading.mode = mode;
        assert_eq!(
            Renderer::default().render(&alone).pixels,
            pane.frame.pixels,
            "{mode:?}"
        );
    }
}

/// Checks that the probe ignores panes: it reads the scene's own picture, at the size of the whole sheet.
#[test]
fn what_the_probe_calls_stored_is_the_scenes_own_picture() {
    let with = scene(CompareView::Panes);
    let without = Scene {
        compare: Compare::default(),
        ..with.clone()
    };
    let stored = |scene: &Scene| {
        probe(&mut Renderer::default(), scene, 40, 30)
            .hit
            .map(|hit| hit.stored)
    };
    assert!(stored(&with).is_some() && stored(&with) == stored(&without));
    let frame = Renderer::default().render(&without).clone();
    assert_eq!(frame.pixel(40, 30), stored(&with));
}

#[test]
fn keeping_the_picture_before_the_display_does_not_change_what_is_stored() {
    for preset in presets::ALL {
        let mut scene = Scene {
            compare: Compare::default(),
            ..preset.scene()
        };
        scene.image.size = [48, 48];
        let stored = Renderer::default().render(&scene).pixels.clone();
        let mut renderer = Renderer::default();
        renderer.keep_linear(true);
        assert_eq!(renderer.render(&scene).pixels, stored, "{}", preset.name);
        assert_eq!(renderer.linear().len(), stored.len());
        renderer.keep_linear(false);
        assert_eq!(renderer.render(&scene).pixels, stored, "{}", preset.name);
    }
}

/// Returns the RMS and the maximum error, computed from the stored pixels alone.
fn of_stored(a: &DrawnPane, b: &DrawnPane) -> (f64, f64) {
    let (mut sum, mut greatest, mut count) = (0.0, 0.0f64, 0u32);
    for (index, (p, q)) in a.frame.pixels.iter().zip(&b.frame.pixels).enumerate() {
        if a.linear[index][3] > 0.0 || b.linear[index][3] > 0.0 {
            for channel in 0..3 {
                let difference = (f64::from(p[channel]) - f64::from(q[channel])).abs() / 255.0;
                sum += difference * difference;
                greatest = greatest.max(difference);
                count += 1;
            }
        }
    }
    ((sum / f64::from(count)).sqrt(), greatest)
}

#[test]
fn the_figures_are_those_of_the_stored_pixels_to_their_rounding() {
    let panes = drawn(&scene(CompareView::Difference));
    let figures = pane_figures(&panes);
    let ErrorFigures {
        rms, greatest, at, ..
    } = figures[0].error.expect("against the last");
    let (expected, most) = of_stored(&panes[0], &panes[1]);
    assert!((rms - expected).abs() < 0.6 / 255.0, "{rms} {expected}");
    assert!((greatest - most).abs() <= 1.0 / 255.0, "{greatest} {most}");
    let [x, y] = at.expect("they differ").map(|v| v as usize);
    let pixel = |pane: &DrawnPane| pane.linear[y * 96 + x];
    let there = (0..3)
        .map(|c| (pixel(&panes[0])[c] - pixel(&panes[1])[c]).abs())
        .fold(0.0, f32::max);
    assert!((f64::from(there) - greatest).abs() < 1e-12);
    assert_eq!(figures[1].error, None);
    let brightest = panes[1]
        .linear
        .iter()
        .map(|p| luminance(Rgb::new(p[0].into(), p[1].into(), p[2].into())));
    assert_eq!(
        figures[1].brightest.map(|b| b.value),
        Some(brightest.fold(0.0, f64::max))
    );
}

#[test]
fn a_wipe_has_the_one_picture_left_of_its_line_and_the_other_right_of_it() {
    let mut scene = scene(CompareView::Wipe);
    let panes = drawn(&scene);
    for wipe in [0.0, 0.25, 1.0] {
        scene.compare.wipe = wipe;
        let sheet = comparison_sheet(&scene, &panes, Captions::None);
        let line = (96.0 * wipe) as u32;
        for (x, y) in (0..96u32).flat_map(|x| (0..64).map(move |y| (x, y))) {
            // The line itself is drawn over both.
            if x.abs_diff(line) > 2 {
                let expected = &panes[usize::from(x >= line)].frame;
                assert_eq!(sheet.pixel(x, y), expected.pixel(x, y), "{wipe} {x} {y}");
            }
        }
    }
}

#[test]
fn panes_stand_side_by_side_as_they_were_drawn() {
    let scene = scene(CompareView::Panes);
    let panes = drawn(&scene);
    let sheet = comparison_sheet(&scene, &panes, Captions::None);
    assert_eq!([sheet.width, sheet.height], scene.image.size);
    let [width, height] = [panes[0].frame.width, panes[0].frame.height];
    assert!(width < 96 || height < 64);
    let last = |x: u32, y: u32| sheet.pixel(96 - width + x, 64 - height + y);
    for (x, y) in [(0, 0), (width / 2, height / 2), (width - 1, height - 1)] {
        assert_eq!(sheet.pixel(x, y), panes[0].frame.pixel(x, y));
        assert_eq!(last(x, y), panes[1].frame.pixel(x, y));
    }
}

#[test]
fn names_stay_where_figures_are_hidden() {
    let scene = scene(CompareView::Panes);
    let panes = drawn(&scene);
    let sheet = |captions| comparison_sheet(&scene, &panes, captions);
    let [none, names, figures] = [Captions::None, Captions::Names, Captions::Figures].map(sheet);
    let height = panes[0].frame.height;
    let changed = |sheet: &Frame, rows: std::ops::Range<u32>| {
        let mut places = rows.flat_map(|y| (0..sheet.width).map(move |x| (x, y)));
        places.any(|(x, y)| sheet.pixel(x, y) != none.pixel(x, y))
    };
    // Names are at the top of a pane, figures at its bottom.
    let bottom = height - height / 3..height;
    assert!(changed(&names, 0..height / 2));
    assert!(!changed(&names, bottom.clone()) && changed(&figures, bottom));
}

#[test]
fn a_difference_of_nothing_is_even_and_gain_makes_it_stronger() {
    let mut scene = scene(CompareView::Difference);
    scene.compare.difference = DifferenceKind::Absolute;
    let panes = drawn(&scene);
    let sum = |gain: f64| {
        let mut scene = scene.clone();
        scene.compare.gain = gain;
        let sheet = comparison_sheet(&scene, &panes, Captions::None);
        let object = sheet
            .pixels
            .iter()
            .zip(&panes[0].linear)
            .filter(|(_, linear)| linear[3] > 0.0);
        object
            .map(|(pixel, _)| pixel[..3].iter().map(|&v| u64::from(v)).sum::<u64>())
            .sum::<u64>()
    };
    assert!(sum(1.0) > 0 && sum(4.0) > 3 * sum(1.0));
    scene.compare.panes = vec![Pane::default()];
    let same = drawn(&scene);
    assert_eq!(
        pane_figures(&same)[0].error.map(|e| (e.greatest, e.at)),
        Some((0.0, None))
    );
}

#[test]
fn the_highlight_is_lost_by_gouraud_shading_and_kept_by_phong_shading() {
    let mut scene = presets::find("highlight")
        .map(|preset| preset.scene())
        .expect("built in");
    scene.image.size = [400, 300];
    let figures = pane_figures(&drawn(&scene));
    let names: Vec<&str> = figures.iter().map(|pane| pane.name.as_str()).collect();
    use ShadingMode::{Exact, Flat, Gouraud, Phong};
    assert_eq!(names, [Flat, Gouraud, Phong, Exact].map(ShadingMode::label));
    let brightest: Vec<f64> = figures
        .iter()
        .filter_map(|pane| Some(pane.brightest?.value))
        .collect();
    assert!(brightest[1] < 0.4 * brightest[3], "{brightest:?}");
    assert!((brightest[2] - brightest[3]).abs() < 1e-4, "{brightest:?}");
}

#[test]
fn panes_of_one_mode_are_called_by_what_tells_them_apart() {
    let mut scene = scene(CompareView::Panes);
    let mut names = |panes: &[&[&str]]| {
        scene.compare.panes = panes.iter().map(|pane| Pane::of(pane)).collect();
        (0..scene.pane_count())
            .map(|pane| scene.pane_name(pane))
            .collect::<Vec<_>>()
    };
    let n = names(&[&["material.n=7.5"], &["material.n=1005"]]);
    assert_eq!(n[1..], ["n = 7.5", "n = 1005"]);
    assert!(n[0].starts_with("n = "), "{n:?}");
    let models = names(&[&["reflection.model=blinn", "object.segments=20"]]);
    assert!(
        models[0].starts_with(ShadingMode::Phong.label()) && models[0].contains("9"),
        "{models:?}"
    );
    assert!(
        models[1].starts_with("Blinn") && models[1].contains("20"),
        "{models:?}"
    );
    let modes = [ShadingMode::Gouraud, ShadingMode::Flat].map(ShadingMode::label);
    assert_eq!(names(&[&["shading.mode=flat"]]), modes);
}

#[test]
fn what_is_drawn_over_panes_does_not_change_their_figures() {
    let scene = scene(CompareView::Panes);
    let over = |frame: &mut Frame, renderer: &mut Renderer, scene: &Scene| {
        shading_lab::analysis::defects::defects(renderer, scene, [3, 3], &unwatched);
        frame.pixels.fill([0, 0, 0, 255]);
        Ok::<(), Infallible>(())
    };
    let panes = draw_panes(
        &mut Renderer::default(),
        &scene,
        &panes_on_sheet(&scene),
        1,
        &mut |_| true,
        over,
    );
    assert_eq!(
        pane_figures(&panes.unwrap_or_default()),
        pane_figures(&drawn(&scene))
    );
}

/// Checks that the figures of a picture of many samples are those of one at each pixel's centre, which the window shows: the
/// mean of samples is one of clamped values.
#[test]
fn figures_do_not_depend_on_the_number_of_samples() {
    let mut scene = scene(CompareView::Panes);
    scene.lights[0].color = Rgb::splat(9.0);
    let nothing = |_: &mut _, _: &mut _, _: &_| Ok::<(), Infallible>(());
    let which = panes_on_sheet(&scene);
    let figures = [1, 4].map(|samples| {
        let mut renderer = Renderer::default();
        let panes = draw_panes(
            &mut renderer,
            &scene,
            &which,
            samples,
            &mut |_| true,
            nothing,
        );
        pane_figures(&panes.unwrap_or_default())
    });
    assert_eq!(figures[0], figures[1]);
    let brightest = figures[1][0].brightest.expect("the sphere").value;
    assert!(brightest > 1.2, "{brightest}");
}

#[test]
fn panes_stand_where_they_are_seen_largest() {
    let sizes = |count, size| {
        pane_areas(count, size)
            .iter()
            .map(|area| area.size)
            .collect::<Vec<_>>()
    };
    assert_eq!(sizes(1, [640, 480]), [[640, 480]]);
    assert_eq!(sizes(2, [802, 400]), [[400, 400]; 2]);
    assert_eq!(sizes(2, [400, 802]), [[400, 400]; 2]);
    assert_eq!(sizes(2, [602, 602]), [[602, 300]; 2]);
    assert_eq!(sizes(4, [802, 602]), [[400, 300]; 4]);
    assert_eq!(sizes(3, [1204, 400]), [[400, 400]; 3]);
    let four = pane_areas(4, [802, 602]);
    assert_eq!(four[3].min, [402, 302]);
    // Prefers one row to an empty quarter.
    assert_eq!(sizes(3, [802, 602]), [[266, 602]; 3]);
    let five = pane_areas(5, [614, 740]);
    assert_eq!(five[1].min, [308, 0]);
    assert_eq!(five[4].min, [154, 494], "the last one stands in the middle");
}

#[test]
fn panes_stay_inside_and_apart_at_any_size() {
    for count in 1..=6 {
        for size in [[7, 5], [100, 33], [33, 100], [1280, 720]] {
            let areas = pane_areas(count, size);
            assert_eq!(areas.len(), count);
            for (index, area) in areas.iter().enumerate() {
                for axis in 0..2 {
                    assert!(
                        area.min[axis] + area.size[axis] <= size[axis],
                        "{count} {size:?} {area:?}"
                    );
                }
                let apart = |other: &PaneArea| {
                    (0..2).any(|a| {
                        other.min[a] >= area.min[a] + area.size[a]
                            || area.min[a] >= other.min[a] + other.size[a]
                    })
                };
                assert!(areas[..index].iter().all(apart), "{count} {size:?}");
            }
        }
    }
}

fn one(pixel: &[[f32; 4]; 1]) -> LinearPicture<'_> {
    LinearPicture {
        width: 1,
        pixels: pixel,
        clamps: true,
    }
}

fn shown(a: [f32; 4], b: [f32; 4], kind: DifferenceKind, gain: f64) -> palette::Rgb8 {
    difference_picture(one(&[a]), one(&[b]), kind, gain)
        .pixel(0, 0)
        .expect("a pixel")
}

#[test]
fn each_kind_shows_what_it_says() {
    let (a, b) = ([0.5, 0.5, 0.5, 1.0], [0.4, 0.5, 0.5, 1.0]);
    assert_eq!(shown(a, b, DifferenceKind::Absolute, 4.0), [102, 0, 0]);
    assert_eq!(
        shown(a, a, DifferenceKind::Signed, 64.0),
        [0xF4, 0xF4, 0xF2]
    );
    assert_eq!(
        shown(a, [0.0, 0.0, 0.0, 1.0], DifferenceKind::Signed, 64.0),
        palette::Vector::L.colour()
    );
    assert_eq!(
        shown([0.0, 0.0, 0.0, 1.0], a, DifferenceKind::Signed, 64.0),
        palette::Vector::N.colour()
    );
    assert_eq!(
        shown(a, b, DifferenceKind::FalseColor, 64.0),
        [0xFF, 0xEA, 0x46]
    );
    assert_eq!(
        shown(a, a, DifferenceKind::FalseColor, 64.0),
        [0x00, 0x20, 0x4D]
    );
    assert_eq!(
        shown(
            [0.5, 0.5, 0.5, 0.0],
            [0.1, 0.0, 0.0, 0.0],
            DifferenceKind::Absolute,
            1.0
        ),
        [0x26, 0x27, 0x2B]
    );
}

fn picture(pixels: &[[f32; 4]]) -> LinearPicture<'_> {
    LinearPicture {
        width: 2,
        pixels,
        clamps: true,
    }
}

#[test]
fn figures_are_of_the_object_alone_and_clamped_as_the_display_does() {
    let a = [
        [0.5, 0.5, 0.5, 1.0],
        [3.0, 1.0, 0.0, 1.0],
        [0.9, 0.9, 0.9, 0.0],
        [0.0, 0.0, 0.0, 0.0],
    ];
    let b = [
        [0.5, 0.25, 0.5, 1.0],
        [1.0, 1.0, 0.0, 1.0],
        [0.1, 0.1, 0.1, 0.0],
        [0.0, 0.0, 0.5, 1.0],
    ];
    let figures = error_figures(picture(&a), picture(&b));
    let expected = ErrorFigures {
        pixels: 3,
        mean: 0.75 / 9.0,
        rms: (0.3125_f64 / 9.0).sqrt(),
        greatest: 0.5,
        at: Some([1, 1]),
        region: Some(ErrorRegion::Outline),
    };
    assert_eq!(figures, expected);
    let open = |pixels| LinearPicture {
        clamps: false,
        ..picture(pixels)
    };
    let unclamped = error_figures(open(&a), open(&b));
    assert_eq!(
        (unclamped.greatest, unclamped.at, unclamped.region),
        (2.0, Some([1, 0]), Some(ErrorRegion::Inside))
    );
    let same = error_figures(picture(&a), picture(&a));
    assert_eq!((same.at, same.region), (None, None));
}

#[test]
fn the_brightest_pixel_is_the_objects_and_not_clamped() {
    let a = [
        [0.5, 0.5, 0.5, 1.0],
        [3.0, 3.0, 3.0, 1.0],
        [9.0, 9.0, 9.0, 0.0],
    ];
    let found = brightest(picture(&a)).expect("an object");
    assert!(
        (found.value - 3.0).abs() < 1e-12 && found.at == [1, 0],
        "{found:?}"
    );
    assert_eq!(brightest(picture(&a[2..])), None);
}

#[test]
fn false_colours_grow_lighter_all_the_way() {
    let light = |step: u8| {
        let value = f32::from(step) / 100.0;
        let colour = shown(
            [value, 0.0, 0.0, 1.0],
            [0.0, 0.0, 0.0, 1.0],
            DifferenceKind::FalseColor,
            1.0,
        );
        palette::contrast(colour, [0; 3])
    };
    for step in 0..100 {
        assert!(light(step + 1) > light(step), "{step}");
    }
}

#[test]
fn the_scale_has_short_numbers() {
    let texts = |kind, gain| {
        let texts = difference_scale([400, 300], kind, gain, 14.0).texts;
        texts.into_iter().map(|text| text.text).collect::<Vec<_>>()
    };
    assert_eq!(
        texts(DifferenceKind::Signed, 8.0),
        ["−0.125", "0", "+0.125"]
    );
    assert_eq!(texts(DifferenceKind::Signed, 1.0), ["−1", "0", "+1"]);
    assert_eq!(
        texts(DifferenceKind::Absolute, 64.0),
        ["0", "0.0078", "0.0156"]
    );
}

/// Uses 200 pixels with differences from 1/256 to 200/256, in descending order.
#[test]
fn a_percentile_is_of_nearest_rank() {
    let grey = |value: f32| [value, value, value, 1.0];
    let a: Vec<[f32; 4]> = (1..=200u8)
        .rev()
        .map(|step| grey(f32::from(step) / 256.0))
        .collect();
    let b = vec![grey(0.0); 200];
    let of = |count: usize| {
        region_errors(
            picture(&a[..count]),
            picture(&b[..count]),
            &vec![true; count],
        )
        .percentile_99
    };
    assert_eq!((of(200), of(1), of(0)), (198.0 / 256.0, 200.0 / 256.0, 0.0));
}

#[test]
fn inside_and_outline_are_told_apart() {
    let grey = |value: f32, seen: f32| [value, value, value, seen];
    let a = [
        grey(0.5, 1.0),
        grey(0.5, 1.0),
        grey(0.0, 0.0),
        grey(0.4, 1.0),
    ];
    let b = [
        grey(0.25, 1.0),
        grey(0.0, 1.0),
        grey(0.5, 1.0),
        grey(0.0, 0.0),
    ];
    let errors = region_errors(picture(&a), picture(&b), &[true, false, true, true]);
    assert_eq!(
        (
            errors.interior.pixels,
            errors.interior.rms,
            errors.percentile_99
        ),
        (1, 0.25, 0.25)
    );
    assert_eq!(errors.outline_pixels, 2);
    let expected = ((0.25 + f64::from(0.4_f32).powi(2)) / 2.0).sqrt();
    assert!((errors.outline_rms - expected).abs() < 1e-12);
}

#[test]
fn any_pane_is_the_reference_and_a_pane_that_moves_shows_what_it_showed() {
    let mut scene = scene(CompareView::Panes);
    scene
        .compare
        .panes
        .push(Pane::of(&["material.n=7.5", "object.segments=20"]));
    scene.compare.name = "first".to_owned();
    scene.compare.panes[0].name = "second".to_owned();
    let names = |scene: &Scene| {
        (0..scene.pane_count())
            .map(|pane| scene.pane_name(pane))
            .collect::<Vec<_>>()
    };
    let panes = |scene: &Scene| {
        (0..scene.pane_count())
            .map(|pane| scene.pane(pane).expect("a sound pane"))
            .collect::<Vec<_>>()
    };
    for reference in 0..3 {
        scene.set_reference(reference);
        assert_eq!(scene.reference_pane(), reference);
        let errors: Vec<bool> = pane_figures(&drawn(&scene))
            .iter()
            .map(|figures| figures.error.is_none())
            .collect();
        assert_eq!(errors, [0, 1, 2].map(|pane| pane == reference));
        for (from, to) in [(0, 2), (2, 0), (1, 2), (1, 0)] {
            let mut moved = scene.clone();
            moved.move_pane(from, to).expect("sound panes");
            let mut expected = panes(&scene);
            let pane = expected.remove(from);
            expected.insert(to, pane);
            assert_eq!(panes(&moved), expected, "{from} to {to}");
            // Given names move with their panes; a pane without a name is labelled by its differences.
            let mut given = names(&scene);
            let name = given.remove(from);
            given.insert(to, name);
            for (was, is) in given.iter().zip(names(&moved)) {
                assert!(*was == is || !["first", "second"].contains(&was.as_str()));
            }
            let against = moved.pane(moved.reference_pane());
            assert_eq!(against, scene.pane(reference));
            assert_eq!(moved.validate(), Ok(()));
        }
        let mut without = scene.clone();
        without.remove_pane(0).expect("sound panes");
        assert_eq!(panes(&without), panes(&scene)[1..]);
    }
}
