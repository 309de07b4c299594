// What the page does without asking the server: tabs, and showing what an answer rests on.
"use strict";
(() => {
  const wide = matchMedia("(min-width: 1000px)");

  function choose(name, { focus = false } = {}) {
    const main = document.querySelector("main.mission");
    if (!main) return;
    main.dataset.tab = name;
    for (const tab of document.querySelectorAll("[role=tab]")) {
      const chosen = tab.dataset.tab === name;
      tab.setAttribute("aria-selected", chosen);
      tab.tabIndex = chosen ? 0 : -1;
      if (chosen && focus) tab.focus();
    }
    dispatchEvent(new CustomEvent("panel", { detail: name }));
  }

  function light(turn) {
    for (const old of document.querySelectorAll(".lit")) old.classList.remove("lit");
    const words = (name) => (turn?.getAttribute(name) ?? "").split(" ").filter(Boolean);
    const steps = words("data-steps"), things = words("data-things"), nodes = words("data-nodes");
    for (const el of document.querySelectorAll("[data-step]"))
      if (el.dataset.step.split(" ").some((one) => steps.includes(one))) el.classList.add("lit");
    for (const el of document.querySelectorAll("svg.site [data-thing]"))
      if (things.includes(el.dataset.thing)) el.classList.add("lit");
    dispatchEvent(new CustomEvent("light", { detail: nodes }));
  }

  for (const kind of ["mouseover", "focusin"])
    document.addEventListener(kind, (event) => {
      const turn = event.target.closest?.("li[data-steps]");
      if (turn) light(turn);
    });
  document.addEventListener("mouseout", (event) => {
    const turn = event.target.closest?.("li[data-steps]");
    if (turn && !turn.contains(event.relatedTarget) && !turn.classList.contains("held")) light(null);
  });
  document.addEventListener("click", (event) => {
    const tab = event.target.closest?.("[role=tab]");
    if (tab) choose(tab.dataset.tab);
    if (event.target.closest?.("[data-light]")) {
      const turn = event.target.closest("li[data-steps]");
      light(turn);
      if (!wide.matches) choose("map");
      document.querySelector(".timeline .lit")?.scrollIntoView({ block: "nearest" });
    }
  });
  document.addEventListener("keydown", (event) => {
    const tab = event.target.closest?.("[role=tab]");
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!tab || !step) return;
    const tabs = [...document.querySelectorAll("[role=tab]")].filter((one) => one.offsetParent);
    const next = tabs[(tabs.indexOf(tab) + step + tabs.length) % tabs.length];
    choose(next.dataset.tab, { focus: true });
  });

  // How old things are, counted on by the browser's own clock.
  setInterval(() => {
    for (const time of document.querySelectorAll("time[datetime]")) {
      const seconds = Math.max(0, (Date.now() - Date.parse(time.dateTime)) / 1000);
      const [size, unit] = [[86400, "d"], [3600, "h"], [60, "min"], [1, "s"]].find(([s]) => seconds >= s) ?? [1, "s"];
      time.textContent = `${Math.round(seconds / size)} ${unit}`;
    }
  }, 5000);

  new MutationObserver((_, observer) => {
    const main = document.querySelector("main.mission");
    if (!main || !document.querySelector("[role=tab]")) return;
    observer.disconnect();
    choose(wide.matches ? "events" : "map");
  }).observe(document, { childList: true, subtree: true });
  // Where there is room, map and talk are always there, and no tabs.
  wide.addEventListener("change", () => {
    const shown = document.querySelector("main.mission")?.dataset.tab;
    if (wide.matches && (shown === "map" || shown === "talk")) choose("events");
  });
})();
