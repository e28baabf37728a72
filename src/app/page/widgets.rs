//! The positions of the window's controls, for scripts: `shadingLab.widgets()` returns a promise of a list of them,
//! each with its `role`, `name`, `value` and position in the page, as reported to screen readers.

use eframe::egui::{Context, FullOutput, Plugin};
use js_sys::{Function, JSON, Promise, Reflect};
use serde_json::{Value, json};
use std::cell::RefCell;
use wasm_bindgen::JsValue;
use wasm_bindgen::closure::Closure;

thread_local! {
    /// The callbacks of pending requests.
    static ASKED: RefCell<Vec<Function>> = const { RefCell::new(Vec::new()) };
}

/// Gives the function to scripts, as a property of `own`.
pub fn offer(own: &JsValue, ctx: &Context) {
    ctx.add_plugin(Widgets);
    let ctx = ctx.clone();
    let widgets = Closure::<dyn Fn() -> Promise>::new(move || {
        ctx.enable_accesskit();
        ctx.request_repaint();
        Promise::new(&mut |give, _| ASKED.with_borrow_mut(|asked| asked.push(give)))
    });
    let _ = Reflect::set(own, &"widgets".into(), &widgets.into_js_value());
}

/// The plugin that answers requests with the accessibility tree of the next frame. No tree is built while there are no
/// requests.
struct Widgets;

impl Plugin for Widgets {
    fn debug_name(&self) -> &'static str {
        "widgets"
    }

    fn output_hook(&mut self, ctx: &Context, output: &mut FullOutput) {
        let Some(told) = output.platform_output.accesskit_update.take() else {
            return;
        };
        ctx.disable_accesskit();
        let scale = f64::from(ctx.zoom_factor());
        let widgets: Value = (told.nodes.iter())
            .filter_map(|(_, node)| {
                let place = node.bounds()?;
                Some(json!({
                    "role": format!("{:?}", node.role()),
                    "name": node.label().unwrap_or_default(),
                    "value": node.value().map(str::to_owned),
                    "disabled": node.is_disabled(),
                    "x": place.x0 * scale,
                    "y": place.y0 * scale,
                    "width": place.width() * scale,
                    "height": place.height() * scale,
                }))
            })
            .collect();
        let widgets = JSON::parse(&widgets.to_string()).unwrap_or(JsValue::NULL);
        for give in ASKED.take() {
            let _ = give.call1(&JsValue::NULL, &widgets);
        }
    }
}
