//! The symbol of the equation under the pointer, linked to its control: pointing at either highlights the other.
//!
//! The state lives in egui's context, as the keyboard focus does, so that a letter of a formula needs nothing else.

pub use crate::scene::Symbol;
use crate::scene::parameter::Parameter;
use eframe::egui::{Context, Id, Rect};

/// The number of frames in which a sought control may appear: its section unfolds first.
const FRAMES: u8 = 4;

/// A control that is to be scrolled into view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sought {
    /// The control of a symbol of the equation.
    Symbol(Symbol),
    /// The row of the parameter with this key.
    Parameter(&'static str),
}

/// The symbol under the pointer. What the pointer is over in this frame is highlighted in the next, so that the order
/// of painting does not matter.
#[derive(Clone, Copy, Debug, Default)]
struct HoveredSymbol {
    /// The symbol highlighted in this frame.
    now: Option<Symbol>,
    /// The symbol under the pointer so far in this frame.
    next: Option<Symbol>,
    /// The control to scroll into view, and for how many more frames it is looked for.
    sought: Option<(Sought, u8)>,
    /// The letter that is being dragged, and by how many points in this frame.
    pulled: Option<(Symbol, f32)>,
    /// True if the panel of controls is to open for the sought symbol.
    opens: bool,
    /// The letter that was clicked, and its place.
    clicked: Option<(Symbol, Rect)>,
}

fn with<T>(ctx: &Context, change: impl FnOnce(&mut HoveredSymbol) -> T) -> T {
    ctx.data_mut(|data| change(data.get_temp_mut_or_default(Id::unique("hovered-symbol"))))
}

/// Returns whether `symbol` is highlighted in this frame.
pub fn is_lit(ctx: &Context, symbol: Symbol) -> bool {
    with(ctx, |hovered| hovered.now == Some(symbol))
}

/// Highlights `symbol` in the next frame.
pub fn light_up(ctx: &Context, symbol: Symbol) {
    with(ctx, |hovered| hovered.next = Some(symbol));
}

/// Highlights `symbol` in the next frame, unless the pointer is on another one.
pub fn light_up_otherwise(ctx: &Context, symbol: Symbol) {
    with(ctx, |hovered| _ = hovered.next.get_or_insert(symbol));
}

/// Scrolls a control into view and opens the panel of controls.
pub fn seek(ctx: &Context, sought: Sought) {
    with(ctx, |hovered| {
        (hovered.sought, hovered.opens) = (Some((sought, FRAMES)), true);
    });
    ctx.request_repaint();
}

/// Returns the control that is to be scrolled into view.
pub fn sought(ctx: &Context) -> Option<Sought> {
    with(ctx, |hovered| hovered.sought.map(|(sought, _)| sought))
}

/// Ends the search for the row of a parameter or of its symbol; returns whether either was sought.
pub fn is_found(ctx: &Context, parameter: Option<&Parameter>, symbol: Option<Symbol>) -> bool {
    with(ctx, |hovered| {
        let is_here = |sought: &mut (Sought, u8)| match sought.0 {
            Sought::Symbol(wanted) => symbol == Some(wanted),
            Sought::Parameter(key) => parameter.is_some_and(|parameter| parameter.key == key),
        };
        let found = hovered.sought.take_if(is_here).is_some();
        hovered.next = symbol.filter(|_| found).or(hovered.next);
        found
    })
}

/// Records that the letter of `symbol` in `rect` was clicked.
pub fn click(ctx: &Context, symbol: Symbol, rect: Rect) {
    with(ctx, |hovered| hovered.clicked = Some((symbol, rect)));
    ctx.request_repaint();
}

/// Returns whether a letter was clicked whose click waits for its answer.
pub fn is_clicked(ctx: &Context) -> bool {
    with(ctx, |hovered| hovered.clicked.is_some())
}

/// Returns, once, the letter that was clicked, and its place.
pub fn take_clicked(ctx: &Context) -> Option<(Symbol, Rect)> {
    with(ctx, |hovered| hovered.clicked.take())
}

/// Records that the letter of `symbol` is dragged sideways by `points` in this frame.
pub fn pull(ctx: &Context, symbol: Symbol, points: f32) {
    with(ctx, |hovered| hovered.pulled = Some((symbol, points)));
}

/// Returns, once, the letter that is dragged, and by how many points.
pub fn pulled(ctx: &Context) -> Option<(Symbol, f32)> {
    with(ctx, |hovered| hovered.pulled.take())
}

/// Returns, once, whether the panel of controls is to open for the sought symbol.
pub fn opens_controls(ctx: &Context) -> bool {
    with(ctx, |hovered| std::mem::take(&mut hovered.opens))
}

/// Ends a frame; returns whether the highlighted symbol has changed, so that another frame must show it.
pub fn turn(ctx: &Context) -> bool {
    with(ctx, |hovered| {
        let changed = hovered.now != hovered.next;
        hovered.now = hovered.next.take();
        hovered.sought = hovered
            .sought
            .and_then(|(sought, frames)| Some((sought, frames.checked_sub(1)?)));
        changed || hovered.sought.is_some()
    })
}
