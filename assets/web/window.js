// What the page does for the window that the program draws: frames only when something changes, fingers, wheel and focus.
const page = document.documentElement;
const canvas = document.querySelector("canvas");
if (["", "1", "true"].includes(new URLSearchParams(location.search).get("embed"))) page.dataset.embed = "";
const again = ["reload", "back_forward"].includes(performance.getEntriesByType("navigation")[0]?.type);
try {
  // Where this tab was loaded again, it goes on with its own unsaved work.
  if (again && localStorage.getItem(sessionStorage.getItem("shading-lab-own"))) page.dataset.again = "";
} catch {
  // A browser that stores nothing.
}

/** How long nothing has to change until the window is at rest, milliseconds. */
const REST = 250;

// The window's toolkit asks for the next frame after each one, and then looks whether there is anything to do. Here its request
// waits until there is: an input, or a time that the program has named.
const draw = window.requestAnimationFrame.bind(window);
let waiting;
let asked;
let left = 3;
let due = Infinity;
let timer;
let resting;
let onRest = () => {};

function ask() {
  if (waiting && !asked) asked = draw(frame);
}

function frame(time) {
  const callback = waiting;
  [waiting, asked, due] = [undefined, undefined, Infinity];
  left -= 1;
  // Upon this event the toolkit draws what has changed.
  dispatchEvent(new Event("pageshow"));
  callback?.(time);
}

window.requestAnimationFrame = (callback) => {
  waiting = callback;
  if (left > 0 || due <= performance.now()) ask();
  return 1;
};
window.cancelAnimationFrame = () => { waiting = undefined; };

/** Has a frame drawn after so many seconds. What is at rest afterwards is told unless it is `quiet`. */
export function wake(seconds = 0, quiet = false) {
  if (!quiet) {
    clearTimeout(resting);
    resting = setTimeout(() => onRest(), REST + 1000 * Math.min(seconds, 1));
  }
  const at = performance.now() + 1000 * seconds;
  if (at >= due) return;
  due = at;
  clearTimeout(timer);
  if (seconds > 0) timer = setTimeout(ask, Math.min(1000 * seconds, 2 ** 31 - 1));
  else ask();
}

/** Calls a function whenever the window has come to rest. */
export function atRest(todo) {
  onRest = todo;
  wake();
}

// An input is drawn in the first frame and answered in the second.
const INPUTS = ["pointerdown", "pointerup", "pointercancel", "mousemove", "mouseleave", "touchstart", "touchmove", "touchend", "touchcancel",
  "wheel", "keydown", "keyup", "input", "compositionstart", "compositionend", "copy", "cut", "paste", "focus", "blur", "dragover", "dragleave",
  "drop", "resize", "visibilitychange", "gesturechange"];
for (const input of INPUTS) addEventListener(input, () => { left = 2; wake(); }, { capture: true, passive: true });
for (const query of ["(prefers-color-scheme: dark)", `(resolution: ${devicePixelRatio}dppx)`]) {
  matchMedia(query).addEventListener("change", () => { left = 2; wake(); });
}

// Fingers are told by their touches alone, which give the window the focus as a mouse does.
for (const name of ["pointerdown", "pointerup"]) {
  addEventListener(name, (event) => {
    if (event.pointerType !== "touch") return;
    event.stopPropagation();
    if (name === "pointerup" && !("embed" in page.dataset)) take();
  }, true);
}

function take() {
  if (document.activeElement !== agent()) canvas.focus({ preventScroll: true });
}

// A figure among the text of another page leaves the wheel and swipes to that page until it is clicked or tapped.
if ("embed" in page.dataset) {
  const use = (on) => page.toggleAttribute("data-used", on);
  let down;
  addEventListener("pointerdown", (event) => {
    if (event.pointerType === "mouse") use(true);
    else down = event;
  }, true);
  addEventListener("pointerup", ({ pointerType, clientX, clientY }) => {
    if (pointerType === "mouse" || !down || Math.hypot(clientX - down.clientX, clientY - down.clientY) >= 8) return;
    use(true);
    take();
  }, true);
  addEventListener("blur", () => use(false));
}

/** The field in which the toolkit has text typed. */
const agent = () => document.querySelector("canvas + input");

/** Lets Tab leave the window after its last control and before its first one, and enter it at the first or the last. */
export function passTab(program) {
  agent().tabIndex = -1;
  let pressed = false;
  addEventListener("keydown", (event) => {
    if (event.key !== "Tab" || event.ctrlKey || event.altKey || event.metaKey || ![canvas, agent()].includes(event.target)) return;
    pressed = true;
    if (!program.leaves(event.shiftKey)) return;
    event.stopPropagation();
    // The browser goes on from what has the focus.
    const others = [canvas, agent()].filter((one) => one !== document.activeElement);
    if ("embed" in page.dataset) others.push(document.getElementById("mirror"));
    for (const one of others) one.inert = true;
    setTimeout(() => { for (const one of others) one.inert = false; });
  }, true);
  // A key that is released here only was pressed on what had the focus before.
  canvas.addEventListener("keyup", (event) => {
    if (event.key !== "Tab") return;
    if (!pressed) program.enter(event.shiftKey);
    pressed = false;
  });
}
