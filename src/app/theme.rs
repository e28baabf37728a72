//! How the window looks: type, spacing and two calm themes.

use eframe::egui::style::{HandleShape, Selection, TextCursorStyle, WidgetVisuals, Widgets};
use eframe::egui::{
    Color32, Context, CornerRadius, FontFamily, FontId, Margin, Shadow, Stroke, Style, TextStyle, Theme, Visuals, vec2,
};
use serde::{Deserialize, Serialize};

/// Size of ordinary text, in points.
pub const TEXT: f32 = 14.0;
/// Size of text for a room, in points.
pub const PROJECTOR_TEXT: f32 = 20.0;
/// The steps by which the interface grows and shrinks; their middle is the size that the type was chosen for.
pub const SCALES: [f32; 9] = [0.8, 0.9, 1.0, 1.1, 1.25, PROJECTOR_TEXT / TEXT, 1.75, 2.0, 2.5];

/// Which theme is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ThemeChoice {
    /// As the desktop has it.
    #[default]
    System,
    Dark,
    Light,
}

impl From<ThemeChoice> for eframe::egui::ThemePreference {
    fn from(choice: ThemeChoice) -> Self {
        match choice {
            ThemeChoice::System => Self::System,
            ThemeChoice::Dark => Self::Dark,
            ThemeChoice::Light => Self::Light,
        }
    }
}

/// Gives `ctx` the window's two themes.
pub fn install(ctx: &Context) {
    ctx.set_style_of(Theme::Dark, style(dark_visuals()));
    ctx.set_style_of(Theme::Light, style(light_visuals()));
    // The window has its own commands for this, which remember the size.
    ctx.options_mut(|options| options.zoom_with_keyboard = false);
}

fn style(visuals: Visuals) -> Style {
    let mut style = Style { visuals, animation_time: 0.08, ..Style::default() };
    for (name, size, family) in [
        (TextStyle::Small, TEXT, FontFamily::Proportional),
        (TextStyle::Body, TEXT, FontFamily::Proportional),
        (TextStyle::Button, TEXT, FontFamily::Proportional),
        (TextStyle::Heading, TEXT + 2.0, FontFamily::Proportional),
        (TextStyle::Monospace, TEXT, FontFamily::Monospace),
    ] {
        style.text_styles.insert(name, FontId::new(size, family));
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

/// Greys of a theme, from the deepest to the highest layer, and of its text.
struct Greys {
    well: Color32,
    panel: Color32,
    window: Color32,
    line: Color32,
    control: Color32,
    hovered: Color32,
    pressed: Color32,
    weak: Color32,
    text: Color32,
    strong: Color32,
    accent: Color32,
    on_accent: Color32,
}

const fn grey(r: u8, g: u8, b: u8) -> Color32 {
    Color32::from_rgb(r, g, b)
}

/// Light text on dark panels, for a dark room.
pub fn dark_visuals() -> Visuals {
    let greys = Greys {
        well: grey(16, 17, 20),
        panel: grey(26, 28, 32),
        window: grey(32, 34, 39),
        line: grey(48, 51, 58),
        control: grey(43, 46, 53),
        hovered: grey(55, 59, 68),
        pressed: grey(68, 73, 84),
        weak: grey(152, 159, 170),
        text: grey(216, 220, 226),
        strong: grey(246, 247, 249),
        accent: grey(74, 96, 132),
        on_accent: grey(246, 248, 252),
    };
    visuals(Visuals::dark(), &greys, 110)
}

/// Dark text on light panels, for a bright room.
pub fn light_visuals() -> Visuals {
    let greys = Greys {
        well: grey(255, 255, 255),
        panel: grey(246, 247, 249),
        window: grey(252, 253, 254),
        line: grey(212, 216, 223),
        control: grey(228, 231, 236),
        hovered: grey(216, 221, 229),
        pressed: grey(201, 208, 219),
        weak: grey(92, 100, 112),
        text: grey(36, 40, 47),
        strong: grey(10, 12, 16),
        accent: grey(66, 92, 138),
        on_accent: grey(255, 255, 255),
    };
    visuals(Visuals::light(), &greys, 40)
}

fn visuals(base: Visuals, greys: &Greys, shadow: u8) -> Visuals {
    let widget = |fill: Color32, text: Color32, stroke: Stroke| WidgetVisuals {
        bg_fill: fill,
        weak_bg_fill: fill,
        bg_stroke: stroke,
        fg_stroke: Stroke::new(1.0, text),
        corner_radius: CornerRadius::same(5),
        expansion: 0.0,
    };
    let shadow = Shadow { offset: [0, 4], blur: 16, spread: 0, color: Color32::from_black_alpha(shadow) };
    Visuals {
        widgets: Widgets {
            noninteractive: widget(greys.panel, greys.text, Stroke::new(1.0, greys.line)),
            inactive: widget(greys.control, greys.text, Stroke::NONE),
            hovered: widget(greys.hovered, greys.strong, Stroke::NONE),
            active: widget(greys.pressed, greys.strong, Stroke::new(1.0, greys.accent)),
            open: widget(greys.hovered, greys.strong, Stroke::NONE),
        },
        selection: Selection { bg_fill: greys.accent, stroke: Stroke::new(1.0, greys.on_accent) },
        weak_text_color: Some(greys.weak),
        hyperlink_color: greys.accent,
        faint_bg_color: greys.control,
        extreme_bg_color: greys.well,
        code_bg_color: greys.control,
        window_fill: greys.window,
        panel_fill: greys.panel,
        window_stroke: Stroke::new(1.0, greys.line),
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
            stroke: Stroke::new(2.0, greys.strong),
            ..TextCursorStyle::default()
        },
        ..base
    }
}
