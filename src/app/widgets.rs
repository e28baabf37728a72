//! Shared widgets: letters, colours, signs, cards, formulas, drawings, tables, and the keyboard's focus.

pub mod background;
pub mod card;
pub mod code;
pub mod dialog;
pub mod drawing;
pub mod fingers;
pub mod focus;
pub mod formula;
pub mod formula_field;
pub mod heading;
pub mod letter;
pub mod lines;
pub mod mark;
pub mod meter;
pub mod palette;
pub mod sign;
pub mod strip;
pub mod swatch;
pub mod symbol;
pub mod table;
pub mod theme;
pub mod tile;
pub mod typeset;
