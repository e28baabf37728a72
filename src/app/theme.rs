//! How the window looks: type, spacing and two calm themes.

use crate::text::CHINESE_FONT;
use eframe::egui::style::{HandleShape, Selection, TextCursorStyle, WidgetVisuals, Widgets};
use eframe::egui::{
    Color32, Context, CornerRadius, FontData, FontDefinitions, FontFamily, Margin, Shadow, Stroke,
    Style, TextStyle, Theme, Visuals, vec2,
};
use serde::{Deserialize, Serialize};

/// Size of ordinary text, in points.
pub const TEXT: f32 = 14.0;
/// Size of text for a room, in points.
pub const PROJECTOR_TEXT: f32 = 20.0;
/// The steps by which the interface grows and shrinks; their middle is the size that the type was chosen for.
pub const SCALES: [f32; 9] = [
    0.8,
    0.9,
    1.0,
    1.1,
    1.25,
    PROJECTOR_TEXT / TEXT,
    1.75,
    2.0,
    2.5,
];

/// Which theme is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ThemeChoice {
    /// Follows the system.
    #[default]
    System,
    Dark,
    Light,
}

/// Gives `ctx` the window's two themes.
pub fn install(ctx: &Context) {
    ctx.set_fonts(fonts());
    ctx.set_style_of(Theme::Dark, style(dark_visuals()));
    ctx.set_style_of(Theme::Light, style(light_visuals()));
    // The window has its own commands for this, which remember the size.
    ctx.options_mut(|options| options.zoom_with_keyboard = false);
}

/// The usual fonts, with the monospaced one behind the proportional one: it has the arrows and the squares. Behind both, the
/// Chinese characters of the catalogue.
fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::default();
    let behind = fonts
        .families
        .get(&FontFamily::Monospace)
        .cloned()
        .unwrap_or_default();
    fonts
        .families
        .entry(FontFamily::Proportional)
        .or_default()
        .extend(behind);
    let chinese = FontData::from_static(CHINESE_FONT);
    fonts.font_data.insert("Chinese".to_owned(), chinese.into());
    for family in fonts.families.values_mut() {
        family.push("Chinese".to_owned());
    }
    fonts
}

fn style(visuals: Visuals) -> Style {
    let mut style = Style {
        visuals,
        animation_time: 0.08,
        ..Style::default()
    };
    for (name, font) in &mut style.text_styles {
        font.size = if *name == TextStyle::Heading {
            TEXT + 2.0
        } else {
            TEXT
        };
    }
    style.drag_value_text_style = TextStyle::Monospace;
    style.spacing.item_spacing = vec2(8.0, 5.0);
    style.spacing.button_padding = vec2(9.0, 4.0);
    style.spacing.interact_size = vec2(40.0, 24.0);
    style.spacing.menu_margin = Margin::same(8);
    style.spacing.window_margin = Margin::same(16);
    style.spacing.icon_width = 18.0;
    style.spacing.icon_width_inner = 10.0;
    style.spacing.combo_width = 40.0;
    style.spacing.slider_rail_height = 4.0;
    style.spacing.tooltip_width = 340.0;
    style.spacing.scroll.floating_allocated_width = 6.0;
    style.interaction.tooltip_delay = 0.4;
    style.interaction.selectable_labels = false;
    style
}

/// Light text on dark panels, for a dark room.
pub fn dark_visuals() -> Visuals {
    let layers = [0x10_11_14, 0x1a_1c_20, 0x20_22_27, 0x30_33_3a];
    let controls = [0x2b_2e_35, 0x37_3b_44, 0x44_49_54];
    let texts = [0x98_9f_aa, 0xd8_dc_e2, 0xf6_f7_f9];
    visuals(
        Visuals::dark(),
        layers,
        controls,
        texts,
        [0x4a_60_84, 0xf6_f8_fc],
        110,
    )
}

/// Dark text on light panels, for a bright room.
pub fn light_visuals() -> Visuals {
    let layers = [0xff_ff_ff, 0xf6_f7_f9, 0xfc_fd_fe, 0xd4_d8_df];
    let controls = [0xe4_e7_ec, 0xd8_dd_e5, 0xc9_d0_db];
    let texts = [0x5c_64_70, 0x24_28_2f, 0x0a_0c_10];
    visuals(
        Visuals::light(),
        layers,
        controls,
        texts,
        [0x42_5c_8a, 0xff_ff_ff],
        40,
    )
}

/// The look of widgets in colours given as 0xRR_GG_BB: wells, panels, windows and lines; controls at rest, hovered and pressed;
/// weak, ordinary and strong text; the accent and text on it. `shadow` is the alpha of shadows.
fn visuals(
    base: Visuals,
    layers: [u32; 4],
    controls: [u32; 3],
    texts: [u32; 3],
    accents: [u32; 2],
    shadow: u8,
) -> Visuals {
    let rgb = |colour: u32| {
        let [_, r, g, b] = colour.to_be_bytes();
        Color32::from_rgb(r, g, b)
    };
    let [well, panel, window, line] = layers.map(rgb);
    let [control, hovered, pressed] = controls.map(rgb);
    let [weak, text, strong] = texts.map(rgb);
    let [accent, on_accent] = accents.map(rgb);
    let widget = |fill: Color32, text: Color32, stroke: Stroke| WidgetVisuals {
        bg_fill: fill,
        weak_bg_fill: fill,
        bg_stroke: stroke,
        fg_stroke: Stroke::new(1.0, text),
        corner_radius: CornerRadius::same(5),
        expansion: 0.0,
    };
    let shadow = Shadow {
        offset: [0, 4],
        blur: 16,
        spread: 0,
        color: Color32::from_black_alpha(shadow),
    };
    Visuals {
        widgets: Widgets {
            noninteractive: widget(panel, text, Stroke::new(1.0, line)),
            inactive: widget(control, text, Stroke::NONE),
            hovered: widget(hovered, strong, Stroke::NONE),
            active: widget(pressed, strong, Stroke::new(1.0, accent)),
            open: widget(hovered, strong, Stroke::NONE),
        },
        selection: Selection {
            bg_fill: accent,
            stroke: Stroke::new(1.0, on_accent),
        },
        weak_text_color: Some(weak),
        hyperlink_color: accent,
        faint_bg_color: control,
        extreme_bg_color: well,
        code_bg_color: control,
        window_fill: window,
        panel_fill: panel,
        window_stroke: Stroke::new(1.0, line),
        window_corner_radius: CornerRadius::same(8),
        menu_corner_radius: CornerRadius::same(8),
        window_shadow: shadow,
        popup_shadow: shadow,
        slider_trailing_fill: true,
        handle_shape: HandleShape::Circle,
        indent_has_left_vline: false,
        // A blinking cursor repaints the window for as long as a field has the focus.
        text_cursor: TextCursorStyle {
            blink: false,
            stroke: Stroke::new(2.0, strong),
            ..TextCursorStyle::default()
        },
        ..base
    }
}
