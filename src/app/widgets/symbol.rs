//! The symbol of the equation under the pointer, linked to its control: pointing at either highlights the other.
//!
//! The state lives in egui's context, as the keyboard focus does, so that a letter of a formula needs nothing else.

pub use crate::scene::Symbol;
use eframe::egui::{Context, Id};

/// The symbol under the pointer. What the pointer is over in this frame is highlighted in the next, so that the order
/// of painting does not matter.
#[derive(Clone, Copy, Debug, Default)]
struct HoveredSymbol {
    /// The symbol highlighted in this frame.
    now: Option<Symbol>,
    /// The symbol under the pointer so far in this frame.
    next: Option<Symbol>,
    /// The symbol whose control is to be scrolled into view and focused.
    sought: Option<Symbol>,
    /// True if the panel of controls is to open for the sought symbol.
    opens: bool,
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

/// Scrolls the control of `symbol` into view and opens the panel of controls.
pub fn seek(ctx: &Context, symbol: Symbol) {
    with(ctx, |hovered| {
        (hovered.sought, hovered.opens) = (Some(symbol), true);
    });
}

/// Returns the symbol whose control is to be scrolled into view.
pub fn sought(ctx: &Context) -> Option<Symbol> {
    with(ctx, |hovered| hovered.sought)
}

/// Ends the search for the control of `symbol`; returns whether that symbol was sought.
pub fn is_found(ctx: &Context, symbol: Symbol) -> bool {
    with(ctx, |hovered| {
        let found = hovered.sought.take_if(|sought| *sought == symbol).is_some();
        hovered.next = if found { Some(symbol) } else { hovered.next };
        found
    })
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
        changed
    })
}
