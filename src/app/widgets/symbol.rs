//! The symbol of the equation that the pointer is on, with the control that it belongs to: pointing at either lights up the other.
//!
//! It is kept by the toolkit's context, as the keyboard's focus is, so that a letter of a formula needs nothing else.

pub use crate::scene::Symbol;
use eframe::egui::{Context, Id};

/// The symbol that is pointed at. What the pointer is over this frame is shown the next, so that the order of painting does not
/// matter.
#[derive(Clone, Copy, Debug, Default)]
struct HoveredSymbol {
    /// The symbol lit in this frame.
    now: Option<Symbol>,
    /// The symbol pointed at so far in this frame.
    next: Option<Symbol>,
    /// The symbol whose control is to come into view and take the keyboard.
    sought: Option<Symbol>,
    /// Whether the panel of controls is to open for it.
    opens: bool,
}

fn with<T>(ctx: &Context, change: impl FnOnce(&mut HoveredSymbol) -> T) -> T {
    ctx.data_mut(|data| change(data.get_temp_mut_or_default(Id::unique("hovered-symbol"))))
}

/// Returns whether `symbol` is lit in this frame.
pub fn is_lit(ctx: &Context, symbol: Symbol) -> bool {
    with(ctx, |hovered| hovered.now == Some(symbol))
}

/// Lights up `symbol` in the next frame.
pub fn light_up(ctx: &Context, symbol: Symbol) {
    with(ctx, |hovered| hovered.next = Some(symbol));
}

/// Lights up `symbol` in the next frame, unless another one is pointed at.
pub fn light_up_otherwise(ctx: &Context, symbol: Symbol) {
    with(ctx, |hovered| _ = hovered.next.get_or_insert(symbol));
}

/// Brings the control of `symbol` into view.
pub fn seek(ctx: &Context, symbol: Symbol) {
    with(ctx, |hovered| {
        (hovered.sought, hovered.opens) = (Some(symbol), true);
    });
}

/// Returns the symbol whose control is to come into view.
pub fn sought(ctx: &Context) -> Option<Symbol> {
    with(ctx, |hovered| hovered.sought)
}

/// Ends the search for the control of `symbol`, if it is the one that is sought; returns whether it is.
pub fn is_found(ctx: &Context, symbol: Symbol) -> bool {
    with(ctx, |hovered| {
        let found = hovered.sought.take_if(|sought| *sought == symbol).is_some();
        hovered.next = if found { Some(symbol) } else { hovered.next };
        found
    })
}

/// Returns, once, whether the panel of controls is to open for the symbol that is sought.
pub fn opens_controls(ctx: &Context) -> bool {
    with(ctx, |hovered| std::mem::take(&mut hovered.opens))
}

/// Ends a frame; returns whether what is lit has changed and another frame must show it.
pub fn turn(ctx: &Context) -> bool {
    with(ctx, |hovered| {
        let changed = hovered.now != hovered.next;
        hovered.now = hovered.next.take();
        changed
    })
}
