// Joins the class and follows its step.
"use strict";

async function join() {
  const joined = await fetch("join", { method: "POST", body: "{}" });
  if (!joined.ok) throw new Error((await joined.json()).error);
  const events = new EventSource("events");
  let step = 0;
  events.addEventListener("pace", async (event) => {
    const pace = JSON.parse(event.data);
    document.getElementById("pace").textContent = `${pace.step}/${pace.steps}`;
    if (pace.step === step) return;
    const part = await fetch(`steps/${pace.step}`);
    if (part.ok) {
      step = pace.step;
      document.querySelector("main").innerHTML = await part.text();
    }
  });
}

join();
