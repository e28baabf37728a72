// The page of a class on a phone. It follows the lecturer's step, keeps what is entered until it is saved, and sends it.
"use strict";
(() => {
  const texts = JSON.parse(document.body.dataset.texts);
  const [connection, news, main] = ["connection", "news", "step"].map((id) => document.getElementById(id));
  const SVG = "http://www.w3.org/2000/svg";
  /** Milliseconds: the first pause after a failure and the longest one, and how long an answer is waited for. */
  const [PAUSE, LONGEST, PATIENCE] = [500, 20000, 10000];
  /** Without a beat from the class for so long, the connection is taken for dead. */
  const SILENCE = 45000;

  const say = (place, words) => {
    if (place && place.textContent !== words) place.textContent = words;
  };
  const filled = (words, values) => words.replace(/\{(\w+)\}/g, (whole, name) => values[name] ?? whole);
  const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
  /** A number as people type it: with a comma, or with a minus that is none. */
  const number = (words) => {
    const plain = words.trim().replace(/[−–]/g, "-").replace(",", ".");
    return plain === "" ? NaN : Number(plain);
  };
  const short = (value) => String(Number(value.toPrecision(4)));
  const svg = (name, attributes) => {
    const made = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    return made;
  };

  // What was entered, in the browser's storage: another page of the same browser has it too. Some browsers refuse to store anything.
  const place = (key) => `class ${location.pathname} ${key}`;
  const storage = {
    get(key) {
      try {
        return JSON.parse(localStorage.getItem(place(key)));
      } catch {
        return null;
      }
    },
    set(key, value) {
      try {
        localStorage.setItem(place(key), JSON.stringify(value));
      } catch {
        // Then it is kept for as long as the page is open.
      }
    },
  };

  // The kinds of questions: each reads and shows what is entered, and makes an answer of it, or says what is missing.

  const choice = (form, changed) => {
    const buttons = [...form.querySelectorAll("input[type=radio]")];
    form.addEventListener("change", changed);
    return {
      state: () => buttons.findIndex((button) => button.checked),
      show: (state) => buttons.forEach((button, index) => (button.checked = index === state)),
      answer: (state) => (state >= 0 ? state : new Problem(form.dataset.problem, buttons[0])),
      entered: (answer) => answer,
    };
  };

  /** A field, or several, for numbers; `whole`: the answer is a list of them. */
  const numbers = (whole) => (form, changed) => {
    const fields = [...form.querySelectorAll(".number input")];
    form.addEventListener("input", changed);
    return {
      state: () => fields.map((field) => field.value),
      show: (state) => fields.forEach((field, index) => (field.value = state[index] ?? "")),
      answer(state) {
        for (const [index, field] of fields.entries()) {
          const value = number(state[index] ?? "");
          const { from, to, problem } = field.dataset;
          if (!(value >= Number(from) && value <= Number(to))) return new Problem(problem, field);
        }
        const values = state.map(number);
        return whole ? values : values[0];
      },
      entered: (answer) => (whole ? answer : [answer]).map(String),
    };
  };

  const formula = (form, changed) => {
    const field = form.querySelector(".formula textarea");
    form.addEventListener("input", changed);
    for (const key of form.querySelectorAll(".keys button")) {
      key.addEventListener("click", () => {
        field.setRangeText(key.textContent, field.selectionStart, field.selectionEnd, "end");
        field.focus();
        changed();
      });
    }
    return {
      state: () => field.value,
      show: (state) => (field.value = state ?? ""),
      answer: (state) => state.trim() || new Problem(form.dataset.problem, field),
      entered: (answer) => answer,
    };
  };

  const point = (form, changed) => {
    const picture = form.querySelector(".place svg");
    const told = form.querySelector("#place");
    const [, , width, height] = picture.getAttribute("viewBox").split(" ").map(Number);
    const side = Math.min(width, height);
    const cross = crossed(picture, "own");
    let at = null;
    const put = ([x, y]) => {
      const [most, highest] = [width / side / 2, height / side / 2];
      at = [clamp(x, -most, most), clamp(y, -highest, highest)];
      show();
      changed();
    };
    // Without the sign that a rounded zero may have.
    const rounded = (value) => (Math.round(100 * value) / 100 || 0).toFixed(2);
    const show = () => {
      cross.put(at);
      say(told, at ? filled(told.dataset.place, { x: rounded(at[0]), y: rounded(at[1]) }) : "");
    };
    const read = (event) => {
      const box = picture.getBoundingClientRect();
      const scale = width / box.width;
      return [((event.clientX - box.left) * scale - width / 2) / side, ((event.clientY - box.top) * scale - height / 2) / side];
    };
    const open = () => !form.querySelector("fieldset").disabled;
    picture.addEventListener("click", (event) => open() && event.detail > 0 && put(read(event)));
    // A finger scrolls over the picture; what it drags is the cross.
    cross.group.addEventListener("pointerdown", (event) => open() && cross.group.setPointerCapture(event.pointerId));
    cross.group.addEventListener("pointermove", (event) => cross.group.hasPointerCapture(event.pointerId) && open() && put(read(event)));
    const WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    picture.addEventListener("keydown", (event) => {
      const way = WAYS[event.key];
      if (!way || !open()) return;
      event.preventDefault();
      const by = event.shiftKey ? 0.1 : 0.02;
      const [x, y] = at ?? [0, 0];
      put(at ? [x + way[0] * by, y + way[1] * by] : [0, 0]);
    });
    return {
      state: () => at,
      show: (state) => {
        at = state;
        show();
      },
      answer: (state) => state ?? new Problem(form.dataset.problem, picture),
      entered: (answer) => answer,
    };
  };

  /** A cross in a picture, in units of its shorter side from the middle. */
  const crossed = (picture, name) => {
    const [, , width, height] = picture.getAttribute("viewBox").split(" ").map(Number);
    const side = Math.min(width, height);
    const group = svg("g", { class: `cross ${name}`, visibility: "hidden" });
    const arms = `M${-0.06 * side} 0H${0.06 * side}M0 ${-0.06 * side}V${0.06 * side}`;
    group.append(svg("circle", { r: 0.08 * side, fill: "transparent" }));
    for (const under of ["under", "over"]) group.append(svg("path", { d: arms, class: under, "stroke-width": side * (under === "under" ? 0.016 : 0.007) }));
    picture.append(group);
    const put = (at) => {
      group.setAttribute("visibility", at ? "visible" : "hidden");
      if (at) group.setAttribute("transform", `translate(${width / 2 + at[0] * side} ${height / 2 + at[1] * side})`);
    };
    return { group, put };
  };

  /** The axes of a curve: where its points are, and the line through them. */
  const axes = (plot, name) => {
    const [left, bottom, right, top] = plot.dataset.area.split(" ").map(Number);
    const [low, high] = plot.dataset.y.split(" ").map(Number);
    const count = Number(plot.dataset.points);
    const drawing = plot.querySelector("svg");
    const line = svg("path", { class: `curve ${name}`, fill: "none" });
    drawing.append(line);
    return {
      count,
      low,
      high,
      drawing,
      draw(values) {
        let d = "";
        let down = false;
        values.forEach((value, index) => {
          if (value === null) return (down = false);
          const x = left + ((right - left) * index) / (count - 1);
          const y = bottom + ((top - bottom) * (clamp(value, low, high) - low)) / (high - low);
          d += `${down ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`;
          down = true;
        });
        line.setAttribute("d", d);
      },
      /** The nearest point, and the value there. */
      read(event) {
        const box = drawing.getBoundingClientRect();
        const scale = drawing.viewBox.baseVal.width / box.width;
        const [x, y] = [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
        const index = Math.round(clamp((x - left) / (right - left), 0, 1) * (count - 1));
        return [index, low + (high - low) * clamp((y - bottom) / (top - bottom), 0, 1)];
      },
    };
  };

  const curve = (form, changed) => {
    const field = axes(form.querySelector(".plot"), "own");
    const inputs = [...form.querySelectorAll(".values input")];
    const none = () => Array(field.count).fill(null);
    let values = none();
    let last = null;
    const show = (but) => {
      field.draw(values);
      for (const input of inputs) {
        const value = values[Number(input.dataset.at)];
        if (input !== but) input.value = value === null ? "" : short(value);
      }
    };
    const between = ([from, before], [to, after]) => {
      const steps = Math.max(Math.abs(to - from), 1);
      for (let step = 0; step <= steps; step++) {
        values[Math.round(from + ((to - from) * step) / steps)] = before + ((after - before) * step) / steps;
      }
    };
    const stroke = (event) => {
      const next = field.read(event);
      between(last ?? next, next);
      last = next;
      show();
      changed();
    };
    const open = () => !form.querySelector("fieldset").disabled;
    field.drawing.addEventListener("pointerdown", (event) => {
      if (!open() || !event.isPrimary) return;
      field.drawing.setPointerCapture(event.pointerId);
      last = null;
      stroke(event);
    });
    field.drawing.addEventListener("pointermove", (event) => {
      if (!field.drawing.hasPointerCapture(event.pointerId) || !open()) return;
      // A finger moves further between two frames than a pixel.
      const moves = event.getCoalescedEvents?.() ?? [];
      for (const one of moves.length > 0 ? moves : [event]) stroke(one);
    });
    form.querySelector(".clear").addEventListener("click", () => {
      values = none();
      show();
      changed();
    });
    // Straight lines lead to the values beside it.
    form.querySelector(".values").addEventListener("input", ({ target }) => {
      const value = number(target.value);
      if (Number.isNaN(value)) return;
      const at = Number(target.dataset.at);
      const place = inputs.indexOf(target);
      const here = clamp(value, field.low, field.high);
      values[at] = here;
      for (const input of [inputs[place - 1], inputs[place + 1]]) {
        const there = input && values[Number(input.dataset.at)];
        if (typeof there === "number") between([at, here], [Number(input.dataset.at), there]);
      }
      show(target);
      changed();
    });
    return {
      state: () => values.slice(),
      show: (state) => {
        values = state.slice();
        show();
      },
      answer(state) {
        const drawn = state.filter((value) => value !== null).length;
        if (10 * drawn < 9 * field.count) return new Problem(form.dataset.problem, form.querySelector("summary"));
        return state;
      },
      entered: (answer) => answer,
    };
  };

  const order = (form, changed) => {
    const list = form.querySelector(".order");
    const items = () => [...list.children];
    const mark = () =>
      items().forEach((item, index, all) => {
        item.querySelector(".up").disabled = index === 0;
        item.querySelector(".down").disabled = index === all.length - 1;
      });
    const move = (item, to) => {
      const others = items().filter((other) => other !== item);
      list.insertBefore(item, others[to] ?? null);
      mark();
      say(news, filled(item.dataset.moved, { place: to + 1 }));
      changed();
    };
    list.addEventListener("click", ({ target }) => {
      const button = target.closest("button");
      if (!button) return;
      const item = button.closest("li");
      move(item, items().indexOf(item) + (button.className === "up" ? -1 : 1));
      // The button at the end is not there any more for the keyboard.
      (button.disabled ? item.querySelector("button:enabled") : button).focus();
    });
    let held = null;
    list.addEventListener("pointerdown", (event) => {
      const grip = event.target.closest(".grip");
      if (!grip || form.querySelector("fieldset").disabled) return;
      held = grip.closest("li");
      held.classList.add("held");
      list.setPointerCapture(event.pointerId);
    });
    list.addEventListener("pointermove", (event) => {
      if (!held) return;
      const others = items().filter((item) => item !== held);
      const after = others.findIndex((item) => {
        const box = item.getBoundingClientRect();
        return event.clientY < box.top + box.height / 2;
      });
      const to = after < 0 ? others.length : after;
      if (items().indexOf(held) !== to) move(held, to);
    });
    const drop = () => {
      held?.classList.remove("held");
      held = null;
    };
    list.addEventListener("pointerup", drop);
    list.addEventListener("pointercancel", drop);
    mark();
    return {
      state: () => items().map((item) => Number(item.dataset.item)),
      show: (state) => {
        state.forEach((index) => list.append(list.querySelector(`[data-item="${index}"]`)));
        mark();
      },
      answer: (state) => state,
      entered: (answer) => answer,
    };
  };

  /** What is missing in an answer, and where. */
  class Problem {
    constructor(words, at) {
      Object.assign(this, { words, at });
    }
  }

  const KINDS = { choice, formula, point, curve, order, value: numbers(false), settings: numbers(false), match: numbers(true) };

  // The step that is shown.

  let pace = null;
  let shown = null;
  /** Of the question: its form, what reads it, and what was entered: `{state, round, sent, waits, at}`. */
  let form = null;
  let widget = null;
  let draft = null;
  let explained = null;

  const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

  /** Says why there is no lab, in place of the links to it. */
  const withoutLab = (inside) => {
    if (!texts.noLab) return;
    for (const link of inside.querySelectorAll("a.lab")) {
      const words = document.createElement("span");
      words.className = "quiet";
      words.textContent = texts.noLab;
      link.replaceWith(words);
    }
  };

  /** Asks the class for something, and gives up after a while. */
  const ask = async (path, options = {}) => {
    const control = new AbortController();
    const timer = setTimeout(() => control.abort(), PATIENCE);
    try {
      return await fetch(path, { ...options, cache: "no-cache", signal: control.signal });
    } finally {
      clearTimeout(timer);
    }
  };

  /** Tells the class something. */
  const post = (path, body) => ask(path, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) });

  const text = async (asked) => {
    const response = await asked;
    if (!response.ok) throw new Error(String(response.status));
    return response.text();
  };

  const load = async (step) => {
    const first = shown === null;
    const inside = main.contains(document.activeElement);
    // The page comes with the step that the class was at.
    if (!first || main.querySelector("article")?.dataset.step !== String(step)) {
      const html = await text(ask(`steps/${step}`));
      if (pace.step !== step) return;
      main.innerHTML = html;
    }
    withoutLab(main);
    [shown, explained] = [step, null];
    form = main.querySelector("form");
    widget = draft = null;
    const heading = main.querySelector("h2");
    if (!first) {
      window.scrollTo(0, 0);
      say(news, heading?.textContent ?? "");
      if (inside) heading?.focus();
    }
    if (!form) return;
    widget = KINDS[form.dataset.kind](form, changed);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      submit();
    });
    draft = storage.get(step);
    if (draft) widget.show(draft.state);
  };

  /** Brings the page to where the class is. */
  const update = () => {
    if (!pace || pace.step !== shown) return;
    const open = pace.phase === "ask";
    if (form) {
      take(pace.answered?.[form.dataset.kind]);
      form.querySelector("fieldset").disabled = !open;
      form.querySelector(".send").hidden = !open;
      say(form.querySelector(".sent"), open ? standing() : texts[pace.phase] ?? "");
      if (!open) say(form.querySelector(".problem"), "");
    }
    explain().catch(() => later());
  };

  // Other steps, where students go at their own pace.

  const pager = document.getElementById("pager");
  /** The step that one has turned to, where it is not the lecturer's. */
  let turned = null;

  const turn = async (step) => {
    turned = step;
    try {
      const response = await post("turn", { step });
      // It may not be allowed any more.
      if (response.status === 403) turned = null;
      else if (!response.ok) throw new Error(String(response.status));
    } catch {
      later();
    }
  };

  for (const [id, by] of [["pager-back", -1], ["pager-next", 1]]) {
    document.getElementById(id).addEventListener("click", () => turn(clamp(pace.step + by, 1, pace.steps)));
  }

  /** Shows where one is, and where the lecturer is. */
  const showPager = () => {
    const { step, steps, lecturer } = pace;
    turned = lecturer === undefined || lecturer === step ? null : step;
    pager.hidden = lecturer === undefined || pace.phase === "closed";
    pager.querySelector("span").textContent = filled(turned === null ? texts.ownStep : texts.lecturerStep, pace);
    document.getElementById("pager-back").disabled = step <= 1;
    document.getElementById("pager-next").disabled = step >= steps;
  };

  /** Shows the answer that the class has, unless another one was entered since. */
  const take = (answer) => {
    const mine = draft?.round === pace.round && (draft.waits || !draft.sent);
    if (answer === undefined || answer === null) {
      if (draft && draft.sent) draft = { ...draft, sent: false };
      return;
    }
    if (mine && pace.phase === "ask") return;
    draft = { state: widget.entered(answer), round: pace.round, sent: true, waits: false };
    widget.show(draft.state);
    storage.set(shown, draft);
  };

  /** What is said about the answer. */
  const standing = () => {
    const again = pace.round > 1 ? texts.again : "";
    if (!draft) return again;
    if (draft.waits) return sending ? texts.sending : texts.waiting;
    if (draft.sent) return texts.saved;
    return draft.round === pace.round ? texts.changed : again;
  };

  const changed = () => {
    draft = { state: widget.state(), round: pace?.round ?? 1, sent: false, waits: false };
    storage.set(shown, draft);
    say(form.querySelector(".problem"), "");
    say(form.querySelector(".sent"), standing());
  };

  const submit = () => {
    const state = widget.state();
    const answer = widget.answer(state);
    const problem = answer instanceof Problem;
    say(form.querySelector(".problem"), problem ? answer.words : "");
    if (problem) {
      answer.at?.focus();
      return;
    }
    draft = { state, round: pace.round, sent: false, waits: true, at: Date.now() };
    storage.set(shown, draft);
    send();
  };

  let sending = false;

  /** Sends the answer that waits. It is tried again, later and later, until the class has said that it is saved, or why not. */
  const send = async () => {
    if (!draft?.waits || sending || pace?.phase !== "ask" || draft.round !== pace.round) return;
    const [step, round, state] = [shown, draft.round, draft.state];
    const answer = { [form.dataset.kind]: widget.answer(state) };
    const body = { step, round, answer, sent: draft.at };
    const at = form;
    sending = true;
    say(at.querySelector(".sent"), texts.sending);
    let refused = "";
    let saved = false;
    try {
      const response = await post("answers", body);
      saved = response.ok;
      if ([400, 409, 413].includes(response.status)) refused = (await response.json()).error;
    } catch {
      // No connection.
    }
    sending = false;
    if (shown !== step || !draft) return;
    if (same(draft.state, state) && draft.round === round && (saved || refused)) {
      draft = { ...draft, sent: saved, waits: false };
      storage.set(step, draft);
    }
    say(at.querySelector(".problem"), refused);
    say(at.querySelector(".sent"), standing());
    if (!saved && !refused) later();
    else if (draft.waits) send();
  };

  /** Shows the explanation once the lecturer has it shown, with one's own answer in it. */
  const explain = async () => {
    const there = main.querySelector(".explanation");
    if (!form) return;
    if (pace.phase !== "explain") {
      there?.remove();
      explained = null;
      return;
    }
    const step = shown;
    if (explained === step) return;
    explained = step;
    let html;
    try {
      html = await text(ask(`steps/${step}/explanation`));
    } catch (error) {
      explained = null;
      throw error;
    }
    if (shown !== step || pace.phase !== "explain" || html === "") return;
    const section = document.createElement("section");
    section.className = "explanation";
    section.innerHTML = html;
    withoutLab(section);
    main.querySelector(".explanation")?.remove();
    main.append(section);
    const own = draft?.state;
    if (!own) section.querySelector(".legend .own")?.remove();
    const plot = section.querySelector(".plot");
    if (plot && own) axes(plot, "own").draw(own);
    const points = section.querySelector(".points svg");
    if (points && own) crossed(points, "own").put(own);
    say(news, section.querySelector("h3")?.textContent ?? "");
    section.scrollIntoView({ block: "nearest" });
  };

  // The connection to the class.

  let events = null;
  let pause = PAUSE;
  let timer = null;
  let heard = 0;
  let beats = false;

  const alive = () => {
    heard = Date.now();
    pause = PAUSE;
    say(connection, "");
  };

  const join = (name = storage.get("name") ?? undefined) => text(post("join", { name }));

  /** Joins the class, as the student who one was before, and follows the lecturer's step. */
  const connect = async () => {
    clearTimeout(timer);
    timer = null;
    events?.close();
    events = null;
    try {
      await join();
      if (turned !== null) await turn(turned);
    } catch (error) {
      return later(/^\d+$/.test(error.message) ? texts.refused : texts.lost);
    }
    const source = new EventSource("events");
    if (events) events.close();
    events = source;
    heard = Date.now();
    source.addEventListener("pace", (event) => {
      alive();
      follow(JSON.parse(event.data));
    });
    source.addEventListener("alive", () => {
      beats = true;
      alive();
    });
    source.addEventListener("error", () => {
      if (events !== source) return;
      source.close();
      later();
    });
  };

  /** Says that something failed, and tries again after a pause that grows. */
  const later = (words = texts.lost) => {
    say(connection, pace?.phase === "closed" ? texts.closed : words);
    if (form && pace?.phase === "ask") say(form.querySelector(".sent"), standing());
    if (timer !== null) return;
    timer = setTimeout(connect, pause * (0.75 + Math.random() / 2));
    pause = Math.min(2 * pause, LONGEST);
  };

  const follow = async (next) => {
    pace = next;
    showPager();
    if (pace.phase === "closed") say(connection, texts.closed);
    if (pace.step !== shown) {
      try {
        await load(pace.step);
      } catch {
        return later(texts.missing);
      }
    }
    update();
    send();
  };

  // A phone that has slept, or was without a network, is not told that its connection is gone.
  const wake = () => {
    if (document.visibilityState !== "visible") return;
    if (!events || events.readyState !== EventSource.OPEN || Date.now() - heard > PATIENCE) {
      pause = PAUSE;
      connect();
    }
  };
  document.addEventListener("visibilitychange", wake);
  window.addEventListener("online", wake);
  window.addEventListener("pageshow", (event) => event.persisted && wake());
  window.addEventListener("offline", () => {
    events?.close();
    events = null;
    later();
  });
  setInterval(() => {
    if (events && beats && document.visibilityState === "visible" && Date.now() - heard > SILENCE) connect();
  }, 5000);

  // Another page of the same browser is the same student.
  window.addEventListener("storage", (event) => {
    if (shown === null || !form || event.key !== place(shown)) return;
    const stored = storage.get(shown);
    if (!stored || same(stored, draft)) return;
    draft = { ...stored, waits: false };
    widget.show(draft.state);
    say(form.querySelector(".sent"), pace.phase === "ask" ? standing() : texts[pace.phase]);
  });

  document.getElementById("name").addEventListener("submit", async (event) => {
    event.preventDefault();
    const told = event.target.querySelector("[role=status]");
    const name = document.getElementById("nickname").value;
    try {
      await join(name);
      storage.set("name", name);
      say(told, texts.named);
    } catch {
      say(told, texts.lost);
    }
  });

  document.getElementById("nickname").value = storage.get("name") ?? "";
  connect();
})();
