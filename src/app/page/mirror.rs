//! The window as a screen reader meets it: egui's accessibility tree, which the page's script (`mirror.js`) shows as hidden elements.
//!
//! The tree of a single frame is taken whenever the window has come to rest, so that nothing is spent while it moves or while nothing
//! happens. What is done to an element comes back as a request of the accessibility tree. `shadingLab.widgets()` gives the same list to
//! scripts, with the places of the window's controls.

use super::function;
use crate::app::widgets::focus;
use eframe::egui::accesskit::{
    Action, ActionData, ActionRequest, Node, NodeId, Role, Toggled, TreeId,
};
use eframe::egui::{Context, Event, FullOutput, Plugin, RawInput};
use js_sys::{Function, JSON, Promise, Reflect};
use serde_json::{Value, json};
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use wasm_bindgen::JsValue;
use wasm_bindgen::closure::Closure;

/// The function of the page's object that has a frame drawn after a time, and the one that shows the tree.
const WAKE: &str = "wake";
const MIRROR: &str = "mirror";

thread_local! {
    /// The callbacks of pending requests for the list.
    static ASKED: RefCell<Vec<Function>> = const { RefCell::new(Vec::new()) };
    /// The requests made by the mirror's elements.
    static ACTIONS: RefCell<Vec<ActionRequest>> = const { RefCell::new(Vec::new()) };
    static WAKES: RefCell<Option<Function>> = const { RefCell::new(None) };
    /// True while the frame is drawn in which the window is at rest.
    static RESTING: Cell<bool> = const { Cell::new(false) };
}

/// Gives its functions to scripts, as properties of `own`, and has frames drawn by the page's `wake` from now on.
pub fn offer(own: &JsValue, ctx: &Context) {
    ctx.add_plugin(Mirror);
    WAKES.set(function(WAKE));
    ctx.set_request_repaint_callback(|info| wake(info.delay.as_secs_f64()));
    let set = |name: &str, function: JsValue| _ = Reflect::set(own, &name.into(), &function);
    let window = ctx.clone();
    let widgets = Closure::<dyn Fn() -> Promise>::new(move || {
        window.enable_accesskit();
        window.request_repaint();
        Promise::new(&mut |give, _| ASKED.with_borrow_mut(|asked| asked.push(give)))
    });
    set("widgets", widgets.into_js_value());
    let window = ctx.clone();
    let rest = Closure::<dyn Fn()>::new(move || {
        RESTING.set(true);
        window.enable_accesskit();
        window.request_repaint();
    });
    set("rest", rest.into_js_value());
    let window = ctx.clone();
    let act = Closure::<dyn Fn(String, String, JsValue)>::new(
        move |node: String, action: String, data| {
            if let Some(request) = request(&node, &action, &data) {
                ACTIONS.with_borrow_mut(|actions| actions.push(request));
                window.request_repaint();
            }
        },
    );
    set("act", act.into_js_value());
    let window = ctx.clone();
    let leaves = Closure::<dyn Fn(bool) -> bool>::new(move |back| focus::leaves(&window, back));
    set("leaves", leaves.into_js_value());
    let window = ctx.clone();
    let enter = Closure::<dyn Fn(bool)>::new(move |back| focus::enter(&window, back));
    set("enter", enter.into_js_value());
}

/// Has a frame drawn after some seconds. The frame at rest does not count as a change.
fn wake(seconds: f64) {
    let quiet = RESTING.get();
    WAKES.with_borrow(|wake| {
        if let Some(wake) = wake {
            let _ = wake.call2(&JsValue::NULL, &seconds.into(), &quiet.into());
        }
    });
}

/// Returns whether this frame is drawn because the window has come to rest.
pub fn is_at_rest() -> bool {
    RESTING.get()
}

/// Reads a request of an element: the node's number, the action's name, and its number or text.
fn request(node: &str, action: &str, data: &JsValue) -> Option<ActionRequest> {
    let value = || {
        let number = data.as_f64().map(ActionData::NumericValue);
        number.or_else(|| data.as_string().map(|text| ActionData::Value(text.into())))
    };
    let (action, data) = match action {
        "click" => (Action::Click, None),
        "focus" => (Action::Focus, None),
        "show" => (Action::ScrollIntoView, None),
        "more" => (Action::Increment, None),
        "less" => (Action::Decrement, None),
        "set" => (Action::SetValue, Some(value()?)),
        _ => return None,
    };
    Some(ActionRequest {
        action,
        target_tree: TreeId::ROOT,
        target_node: NodeId(node.parse().ok()?),
        data,
    })
}

/// The plugin that takes the tree. No tree is built unless one is wanted.
struct Mirror;

impl Plugin for Mirror {
    fn debug_name(&self) -> &'static str {
        "mirror"
    }

    fn input_hook(&mut self, _: &Context, input: &mut RawInput) {
        let requests = ACTIONS.take().into_iter();
        input
            .events
            .extend(requests.map(Event::AccessKitActionRequest));
    }

    fn output_hook(&mut self, ctx: &Context, output: &mut FullOutput) {
        let Some(told) = output.platform_output.accesskit_update.take() else {
            return;
        };
        ctx.disable_accesskit();
        let nodes: HashMap<NodeId, &Node> =
            told.nodes.iter().map(|(id, node)| (*id, node)).collect();
        let mut listed = Vec::new();
        if let Some(tree) = &told.tree {
            let scale = ctx.zoom_factor().into();
            list(&nodes, tree.root, scale, false, &mut listed);
        }
        let listed = Value::Array(listed).to_string();
        let parsed = || JSON::parse(&listed).unwrap_or(JsValue::NULL);
        for give in ASKED.take() {
            let _ = give.call1(&JsValue::NULL, &parsed());
        }
        if RESTING.take()
            && let Some(show) = function(MIRROR)
        {
            let _ = show.call2(&JsValue::NULL, &parsed(), &told.focus.0.to_string().into());
        }
    }
}

/// Appends a node and those below it, in the order in which they were drawn. Those of a lesson's text are marked as its parts.
fn list(
    nodes: &HashMap<NodeId, &Node>,
    id: NodeId,
    scale: f64,
    part: bool,
    listed: &mut Vec<Value>,
) {
    let Some(node) = nodes.get(&id) else {
        return;
    };
    if let Some(place) = node.bounds() {
        listed.push(json!({
            "id": id.0.to_string(),
            "role": format!("{:?}", node.role()),
            "name": node.label().map_or_else(|| labels(nodes, node), str::to_owned),
            "value": node.value(),
            "number": node.numeric_value().filter(|number| number.is_finite()),
            "least": node.min_numeric_value().filter(|number| number.is_finite()),
            "most": node.max_numeric_value().filter(|number| number.is_finite()),
            "on": node.toggled().map(|toggled| toggled == Toggled::True),
            "about": node.description(),
            "html": node.inner_html(),
            "part": part,
            "live": node.live().is_some(),
            "disabled": node.is_disabled(),
            "clickable": node.supports_action(Action::Click),
            "x": place.x0 * scale,
            "y": place.y0 * scale,
            "width": place.width() * scale,
            "height": place.height() * scale,
        }));
    }
    if node.role() != Role::TextInput && node.role() != Role::MultilineTextInput {
        let part = part || node.role() == Role::Article;
        for child in node.children() {
            list(nodes, *child, scale, part, listed);
        }
    }
}

/// Returns the texts of the nodes that label a node.
fn labels(nodes: &HashMap<NodeId, &Node>, node: &Node) -> String {
    let labels = node
        .labelled_by()
        .iter()
        .filter_map(|id| nodes.get(id)?.value());
    labels.collect::<Vec<_>>().join(" ")
}
