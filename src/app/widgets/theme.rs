//! The look of the window: fonts, spacing, and two calm themes.

use crate::text::{FONTS, chinese_font};
use eframe::egui::style::{HandleShape, Selection, TextCursorStyle, WidgetVisuals, Widgets};
use eframe::egui::{
    Align2, Color32, Context, CornerRadius, FontData, FontDefinitions, FontFamily, Margin, Shadow,
    Stroke, Style, TextBuffer, TextEdit, TextStyle, Theme, Ui, Visuals, vec2,
};
use serde::{Deserialize, Serialize};

/// Size of ordinary text, points.
pub const TEXT: f32 = 14.0;
/// Height of the window in lines of ordinary text at projector size: 28 lines on the screen are readable from the back
/// of a room.
pub const PROJECTOR_LINES: f32 = 28.0;
/// The scales of the interface; 1 is the size for which the fonts were chosen.
pub const SCALES: [f32; 9] = [0.8, 0.9, 1.0, 1.1, 1.25, 1.5, 1.75, 2.0, 2.5];

/// Width below which a screen counts as hand-held, points.
pub const NARROW: f32 = 600.0;

/// Height of a control for a pointer and for a finger, points.
const CONTROL: [f32; 2] = [24.0, 44.0];
/// Maximum height of a drop-down list, in heights of a control; all shading modes are visible at once.
const LIST: f32 = 8.5;
/// Radius of corners, points.
const RADIUS: u8 = 6;

/// The choice of a theme.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ThemeChoice {
    /// Follows the system.
    #[default]
    System,
    Dark,
    Light,
}

/// Installs the fonts and the two themes of the window.
pub fn install(ctx: &Context) {
    install_fonts(ctx);
    ctx.set_style_of(Theme::Dark, style(dark_visuals()));
    ctx.set_style_of(Theme::Light, style(light_visuals()));
    // The window has its own zoom commands, which store the size.
    ctx.options_mut(|options| options.zoom_with_keyboard = false);
}

/// Installs the available fonts.
pub fn install_fonts(ctx: &Context) {
    ctx.set_fonts(fonts());
}

/// Clears the font atlas when the pixels per point change; `known` is the value of the letters in it. egui keeps every
/// size that was ever shown, in memory and on the graphics card, until they fill 16 384 pixels squared.
pub fn forget_letters(ctx: &Context, known: &mut Option<f32>) {
    let now = ctx.pixels_per_point();
    if known
        .replace(now)
        .is_some_and(|before| before.to_bits() != now.to_bits())
    {
        // Other fonts have another atlas: these have a family more, which nothing uses. The desktop's own fonts, which have
        // what ours lack, such as the names of a model's materials, stay.
        let mut fonts = fonts();
        let unused = FontFamily::Name(now.to_string().into());
        fonts.families.insert(unused, vec![FONTS[0].0.to_owned()]);
        ctx.set_fonts(fonts);
    }
}

/// Makes controls high enough for a finger, or for a pointer.
pub fn touch(ctx: &Context, on: bool) {
    let height = CONTROL[usize::from(on)];
    if ctx.global_style().spacing.interact_size.y.to_bits() != height.to_bits() {
        ctx.all_styles_mut(|style| {
            style.spacing.interact_size.y = height;
            style.spacing.combo_height = LIST * height;
        });
    }
}

/// Returns whether controls are high enough for a finger.
pub fn is_touch(ui: &Ui) -> bool {
    ui.spacing().interact_size.y >= CONTROL[1]
}

/// Returns the fonts. The proportional font falls back to the monospaced one, which has the arrows and squares, and the
/// other way round; both fall back to the Chinese characters of the catalogue.
fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::empty();
    let chinese = Some(("Chinese", chinese_font())).filter(|(_, file)| !file.is_empty());
    let files: Vec<_> = FONTS.into_iter().chain(chinese).collect();
    for (family, first) in [(FontFamily::Proportional, 0), (FontFamily::Monospace, 1)] {
        let mut names: Vec<_> = files.iter().map(|(name, _)| (*name).to_owned()).collect();
        names[..2].rotate_left(first);
        fonts.families.insert(family, names);
    }
    for (name, file) in files {
        let data = FontData::from_static(file);
        fonts.font_data.insert(name.to_owned(), data.into());
    }
    fonts
}

/// Creates a single-line text field with its text vertically centred: a field for a finger is higher than its text.
pub fn text_field(text: &mut dyn TextBuffer) -> TextEdit<'_> {
    TextEdit::singleline(text).align(Align2::LEFT_CENTER)
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
    style.spacing.item_spacing = vec2(8.0, 4.0);
    style.spacing.button_padding = vec2(8.0, 4.0);
    style.spacing.interact_size = vec2(40.0, CONTROL[0]);
    style.spacing.menu_margin = Margin::same(8);
    style.spacing.window_margin = Margin::same(16);
    style.spacing.icon_width = 16.0;
    style.spacing.icon_width_inner = 8.0;
    style.spacing.icon_spacing = 8.0;
    style.spacing.combo_width = 40.0;
    style.spacing.combo_height = LIST * CONTROL[0];
    style.spacing.slider_rail_height = 4.0;
    style.spacing.tooltip_width = 320.0;
    style.spacing.scroll.floating_allocated_width = 8.0;
    style.interaction.tooltip_delay = 0.4;
    style.interaction.selectable_labels = false;
    style
}

/// The colours of a theme, as 0xRR_GG_BB.
struct Colours {
    /// Plots, panels, windows, every other row of a table, and lines.
    layers: [u32; 5],
    /// Fields for text.
    field: u32,
    /// Controls: inactive, hovered and pressed.
    controls: [u32; 3],
    /// Weak, ordinary and strong text.
    texts: [u32; 3],
    /// The selection, text on it, and the accent as text: links and the focus ring.
    accents: [u32; 3],
    warning: u32,
    error: u32,
    /// Opacity of disabled controls.
    disabled: f32,
    /// Alpha of shadows.
    shadow: u8,
}

/// Returns the dark theme: light text on dark panels, for a dark room.
pub fn dark_visuals() -> Visuals {
    let colours = Colours {
        layers: [0x13_15_19, 0x1b_1d_22, 0x22_25_2b, 0x22_25_2a, 0x34_38_41],
        field: 0x13_15_19,
        controls: [0x2c_30_38, 0x37_3c_46, 0x43_49_55],
        texts: [0xad_b4_c0, 0xdd_e1_e7, 0xf7_f8_fa],
        accents: [0x4f_6a_9e, 0xfb_fc_ff, 0x9f_bc_f0],
        warning: 0xf0_b8_60,
        error: 0xff_9a_90,
        disabled: 0.66,
        shadow: 110,
    };
    visuals(Visuals::dark(), &colours)
}

/// Returns the light theme: dark text on light panels, for a bright room.
pub fn light_visuals() -> Visuals {
    let colours = Colours {
        layers: [0xff_ff_ff, 0xf5_f6_f8, 0xfc_fc_fd, 0xec_ee_f2, 0xd3_d8_e0],
        field: 0xe9_ec_f1,
        controls: [0xe3_e6_eb, 0xd9_dd_e5, 0xcb_d1_dc],
        texts: [0x52_5a_66, 0x23_27_2e, 0x0a_0c_10],
        accents: [0x3d_5c_96, 0xff_ff_ff, 0x28_4f_9e],
        warning: 0x70_44_00,
        error: 0x00a3_1d16,
        disabled: 0.72,
        shadow: 40,
    };
    visuals(Visuals::light(), &colours)
}

/// Returns the look of widgets in the colours of a theme.
fn visuals(base: Visuals, colours: &Colours) -> Visuals {
    let rgb = |colour: u32| {
        let [_, r, g, b] = colour.to_be_bytes();
        Color32::from_rgb(r, g, b)
    };
    let [well, panel, window, faint, line] = colours.layers.map(rgb);
    let [control, hovered, pressed] = colours.controls.map(rgb);
    let [weak, text, strong] = colours.texts.map(rgb);
    let [chosen, on_chosen, accent] = colours.accents.map(rgb);
    let widget = |fill: Color32, text: Color32, stroke: Stroke| WidgetVisuals {
        bg_fill: fill,
        weak_bg_fill: fill,
        bg_stroke: stroke,
        fg_stroke: Stroke::new(1.0, text),
        corner_radius: CornerRadius::same(RADIUS),
        expansion: 0.0,
    };
    let shadow = Shadow {
        offset: [0, 4],
        blur: 16,
        spread: 0,
        color: Color32::from_black_alpha(colours.shadow),
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
            bg_fill: chosen,
            stroke: Stroke::new(1.0, on_chosen),
        },
        weak_text_color: Some(weak),
        warn_fg_color: rgb(colours.warning),
        error_fg_color: rgb(colours.error),
        disabled_alpha: colours.disabled,
        hyperlink_color: accent,
        faint_bg_color: faint,
        extreme_bg_color: well,
        text_edit_bg_color: Some(rgb(colours.field)),
        code_bg_color: control,
        window_fill: window,
        panel_fill: panel,
        window_stroke: Stroke::new(1.0, line),
        window_corner_radius: CornerRadius::same(RADIUS),
        menu_corner_radius: CornerRadius::same(RADIUS),
        window_shadow: shadow,
        popup_shadow: shadow,
        slider_trailing_fill: true,
        handle_shape: HandleShape::Circle,
        indent_has_left_vline: false,
        // A blinking cursor would repaint the window as long as a field has the focus.
        text_cursor: TextCursorStyle {
            blink: false,
            stroke: Stroke::new(2.0, strong),
            ..TextCursorStyle::default()
        },
        ..base
    }
}
