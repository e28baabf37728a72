// The window as hidden elements, which a screen reader reads and operates: buttons, ranges, fields, headings, and the texts of lessons.
// The program tells its accessibility tree whenever it is at rest; what is done to an element goes back to it.
const canvas = document.querySelector("canvas");
const mirror = document.getElementById("mirror");
const status = document.getElementById("status");
const known = new Map();
let live;
let act = () => {};
let hasFocus;

const BUTTONS = { CheckBox: "checkbox", RadioButton: "radio", Tab: "tab", ComboBox: "combobox", Link: "link", ListItem: "button" };

/** Shows what the program tells of itself. */
export function showMirror(program) {
  act = program.act;
  program.mirror = show;
}

/** What a node is shown as: the name of an element, and its role if that is not the element's own; nothing for what only groups others. */
function shape({ role, name, value, html, part, clickable }) {
  // A lesson's text is shown whole.
  if (part) return undefined;
  if (html) return ["article"];
  if (role === "Slider") return ["input", "range"];
  if (role === "SpinButton" || role === "TextInput") return ["input", "text"];
  if (role === "MultilineTextInput") return ["textarea"];
  if (role === "Heading") return ["h2"];
  if (role === "Image") return ["div", "img"];
  if (role === "ProgressIndicator") return ["div", "progressbar"];
  if (role === "Label" || (role === "ListItem" && !clickable)) return value || name ? ["p"] : undefined;
  if (role === "Button" || role === "ColorWell") return ["button"];
  if (role in BUTTONS) return name || value ? ["button", BUTTONS[role]] : undefined;
  return clickable && name ? ["button"] : undefined;
}

function make(node, [tag, role]) {
  const element = document.createElement(tag);
  element.id = `node-${node.id}`;
  const tell = (...what) => act(node.id, ...what);
  if (tag === "input") {
    element.type = role;
    if (role === "range") element.step = "any";
  } else if (role && role !== "button") {
    element.setAttribute("role", role);
  }
  if (tag === "button") element.addEventListener("click", () => tell("click"));
  if (role === "range") {
    element.addEventListener("input", () => tell("set", element.valueAsNumber));
    element.addEventListener("keydown", (event) => {
      const way = { ArrowUp: "more", ArrowRight: "more", ArrowDown: "less", ArrowLeft: "less" }[event.key];
      if (!way) return;
      event.preventDefault();
      tell(way);
    });
  } else if (tag === "input" || tag === "textarea") {
    element.addEventListener("change", () => {
      if (node.role !== "SpinButton") tell("set", element.value);
      else if (Number.isFinite(Number(element.value))) tell("set", Number(element.value));
    });
  }
  if (role === "img") {
    element.tabIndex = 0;
    element.addEventListener("keydown", (event) => {
      if (!event.key.startsWith("Arrow")) return;
      event.preventDefault();
      tell("focus");
      pass(event);
    });
  }
  element.addEventListener("focus", () => {
    // A field that has the window's focus would be typed in there.
    tell(["input", "textarea"].includes(tag) && role !== "range" ? "show" : "focus");
  });
  return element;
}

/** Passes a key on to the window, and takes the focus back. */
function pass(event) {
  const from = document.activeElement;
  canvas.focus({ preventScroll: true });
  for (const type of ["keydown", "keyup"]) canvas.dispatchEvent(new KeyboardEvent(type, { key: event.key, code: event.code, shiftKey: event.shiftKey, bubbles: true }));
  hasFocus = from;
}

const set = (element, name, value) => {
  if (value === undefined || value === null || value === "") element.removeAttribute(name);
  else if (element.getAttribute(name) !== String(value)) element.setAttribute(name, value);
};

function update(element, node, [tag, role]) {
  const { name, value, number, on, about, html, disabled } = node;
  const words = tag === "p" || tag === "h2" ? value || name : name || value;
  if (html) {
    if (element.shown !== html) element.innerHTML = element.shown = html;
  } else if (tag === "p" || tag === "h2" || tag === "button") {
    if (element.textContent !== words) element.textContent = words;
  } else {
    set(element, "aria-label", words);
  }
  if (role === "range") {
    set(element, "min", node.least);
    set(element, "max", node.most);
    if (document.activeElement !== element || element.valueAsNumber !== number) element.value = number ?? 0;
    set(element, "aria-valuetext", Number(number?.toPrecision(4)));
  } else if (tag === "input" || tag === "textarea") {
    const text = String(number ?? value ?? "");
    if (element.told !== text) element.value = element.told = text;
  } else if (role === "combobox") {
    set(element, "aria-label", name);
    element.textContent = value ?? name;
    set(element, "aria-expanded", "false");
  } else if (role === "progressbar") {
    set(element, "aria-valuenow", number);
  }
  if (tag === "button" || role === "img") {
    const state = { checkbox: "aria-checked", radio: "aria-checked", tab: "aria-selected" }[role] ?? "aria-pressed";
    set(element, state, on ?? undefined);
  }
  set(element, "aria-description", role === "img" ? [about, value].filter(Boolean).join(" ") : about);
  if ("disabled" in element) element.disabled = Boolean(disabled);
  const place = { left: node.x, top: node.y, width: Math.max(node.width, 1), height: Math.max(node.height, 1) };
  for (const [side, points] of Object.entries(place)) {
    const size = `${Math.round(points)}px`;
    if (element.style[side] !== size) element.style[side] = size;
  }
}

function show(nodes, focus) {
  const inMirror = mirror.contains(document.activeElement) || hasFocus;
  const before = hasFocus ?? document.activeElement;
  hasFocus = undefined;
  const seen = new Set();
  let next = mirror.firstElementChild;
  const said = new Map();
  for (const node of nodes) {
    const kind = shape(node);
    if (!kind) continue;
    seen.add(node.id);
    let one = known.get(node.id);
    if (one?.kind !== kind.join()) {
      one?.element.remove();
      if (one && next === one.element) next = next.nextElementSibling;
      known.set(node.id, one = { element: make(node, kind), kind: kind.join() });
    }
    update(one.element, node, kind);
    if (node.live) said.set(node.id, node.html ? one.element.textContent : node.value || node.name);
    if (next === one.element) next = next.nextElementSibling;
    else mirror.insertBefore(one.element, next);
  }
  for (const [id, { element }] of known) {
    if (seen.has(id)) continue;
    element.remove();
    known.delete(id);
  }
  // What is there at first is no news.
  const news = [...said].filter(([id, words]) => live && live.get(id) !== words).map(([, words]) => words);
  if (news.length > 0) status.textContent = news.join("\n");
  live = said;
  // The focus follows that of the window where somebody works with the mirror; else the window itself says what has it.
  const focused = known.get(focus)?.element;
  if (!inMirror) {
    const words = focused && (focused.getAttribute("aria-label") || focused.textContent);
    for (const one of document.querySelectorAll("canvas, canvas + input")) set(one, "aria-label", words ? `shading-lab: ${words}` : "shading-lab");
  } else if (!mirror.contains(document.activeElement)) {
    (mirror.contains(before) ? before : focused ?? mirror.querySelector("h2, button"))?.focus({ preventScroll: true });
  }
}
