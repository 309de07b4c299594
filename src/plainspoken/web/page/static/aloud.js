// Answers read aloud by the browser's own voice, for whoever switches that on.
"use strict";
(() => {
  const KEPT = "plainspoken.aloud";
  let last = null;

  const on = () => localStorage.getItem(KEPT) === "yes";
  const newest = () => [...document.querySelectorAll(".turns > li.robot")].at(-1);
  const named = (turn) => turn && `${turn.dataset.key} ${turn.querySelector("p")?.textContent}`;

  function show(button) {
    const can = "speechSynthesis" in window;
    const pressed = String(can && on());
    if (button.getAttribute("aria-pressed") !== pressed) button.setAttribute("aria-pressed", pressed);
    button.hidden = !can;
  }

  new MutationObserver(() => {
    const button = document.querySelector("[data-aloud]");
    if (!button) return;
    show(button);
    const turn = newest(), name = named(turn) ?? "";
    // What was said before the page was opened is not said again.
    if (last !== null && name && name !== last && on()) {
      speechSynthesis.cancel();
      const words = new SpeechSynthesisUtterance(turn.querySelector("p").textContent);
      words.lang = "en";
      speechSynthesis.speak(words);
    }
    last = name;
  }).observe(document, { childList: true, subtree: true, characterData: true });

  document.addEventListener("click", (event) => {
    const button = event.target.closest?.("[data-aloud]");
    if (!button) return;
    localStorage.setItem(KEPT, on() ? "no" : "yes");
    if (!on()) speechSynthesis.cancel();
    show(button);
  });
})();
