// HTML that is brought up to date in place. Elements are told apart by data-key, else by their
// place: so what moves is seen moving, and what has the focus keeps it.
import DOMPurify from "dompurify";

const KEPT = new Set(["open"]); // set by the person who looks, not by us

function keyOf(node) {
  return node.nodeType === Node.ELEMENT_NODE ? node.getAttribute("data-key") : null;
}

function alike(a, b) {
  return a.nodeType === b.nodeType && a.nodeName === b.nodeName && keyOf(a) === keyOf(b);
}

function attributes(from, to) {
  for (const { name } of [...to.attributes])
    if (!from.hasAttribute(name) && !KEPT.has(name)) to.removeAttribute(name);
  for (const { name, value } of from.attributes)
    if (to.getAttribute(name) !== value && !KEPT.has(name)) to.setAttribute(name, value);
}

export function morph(to, from) {
  const keyed = new Map();
  for (const child of to.childNodes) if (keyOf(child)) keyed.set(keyOf(child), child);
  let here = to.firstChild;
  for (const wanted of [...from.childNodes]) {
    const known = keyOf(wanted) && keyed.get(keyOf(wanted));
    let found = known && alike(known, wanted) ? known : null;
    if (!found && here && alike(here, wanted)) found = here;
    if (found && found !== here) to.insertBefore(found, here);
    if (found) {
      if (found.nodeType === Node.ELEMENT_NODE) {
        attributes(wanted, found);
        morph(found, wanted);
      } else if (found.nodeValue !== wanted.nodeValue) found.nodeValue = wanted.nodeValue;
      here = found.nextSibling;
    } else to.insertBefore(wanted, here);
  }
  while (here) {
    const next = here.nextSibling;
    here.remove();
    here = next;
  }
}

export default {
  template: `<component :is="tag" @click="picked"></component>`,
  props: { content: String, tag: String },
  emits: ["pick"],
  mounted() {
    this.low = true;
    this.onPanel = () => this.$nextTick(() => this.sink());
    this.$el.addEventListener("scroll", () => {
      const el = this.$el;
      this.low = el.scrollHeight - el.scrollTop - el.clientHeight < 48;
    });
    addEventListener("panel", this.onPanel);
    this.draw();
  },
  unmounted() {
    removeEventListener("panel", this.onPanel);
  },
  watch: {
    content() {
      this.draw();
    },
  },
  methods: {
    draw() {
      const el = this.$el;
      const fresh = document.createElement("div");
      fresh.append(
        DOMPurify.sanitize(this.content, { RETURN_DOM_FRAGMENT: true, ADD_ATTR: ["data-key"] }),
      );
      morph(el, fresh);
      this.sink();
    },
    sink() {
      // The latest is at the foot, and stays in sight of whoever has not scrolled away from it.
      if (this.low && this.$el.classList.contains("keeps-low")) this.$el.scrollTop = this.$el.scrollHeight;
    },
    picked(event) {
      const found = event.target.closest("[data-pick]");
      if (found) this.$emit("pick", found.getAttribute("data-pick"));
    },
  },
};
