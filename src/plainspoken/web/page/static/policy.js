// A policy as a graph. Past, present and future differ in shape and line as well as in colour.
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const still = matchMedia("(prefers-reduced-motion: reduce)");

function style() {
  const ink = colour("--ink"), card = colour("--card"), soft = colour("--soft");
  const accent = colour("--accent"), line = colour("--line"), track = colour("--track");
  return [
    { selector: "node", style: {
        label: "data(label)", color: ink, "font-size": 13, "text-wrap": "wrap", "text-max-width": 132,
        "text-valign": "center", width: 150, height: 52, "background-color": card,
        "border-width": 2, "border-color": soft, shape: "ellipse" } },
    { selector: "node.past", style: { shape: "round-rectangle", "background-color": line, "border-color": soft } },
    { selector: "node.present", style: {
        shape: "hexagon", width: 176, height: 66, "background-color": accent, color: colour("--on-accent"),
        "font-weight": "bold", "border-color": ink, "border-width": 3 } },
    { selector: "node.future", style: { "border-color": accent } },
    { selector: "node.missed", style: { shape: "rectangle", "border-style": "dotted", color: soft } },
    { selector: "node.stop", style: { "border-style": "double", "border-width": 6 } },
    { selector: "node.fold", style: { shape: "round-tag", "border-style": "dashed", "background-color": card } },
    { selector: "edge", style: {
        width: 2, "line-color": track, "target-arrow-color": track, "target-arrow-shape": "triangle",
        "curve-style": "bezier", label: "data(label)", color: soft, "font-size": 10, "text-wrap": "wrap",
        "text-max-width": 110, "text-background-color": card, "text-background-opacity": 0.85, "text-background-padding": 2 } },
    { selector: "edge.past", style: { width: 5, "line-color": soft, "target-arrow-color": soft } },
    { selector: "edge.future", style: { "line-color": accent, "target-arrow-color": accent, "line-style": "dashed" } },
    { selector: "edge.missed", style: { "line-style": "dotted", "target-arrow-shape": "vee" } },
    { selector: ".found, .lit", style: { "underlay-color": colour("--lit"), "underlay-opacity": 0.8, "underlay-padding": 8 } },
  ];
}

export default {
  template: `<div class="policy" role="img" aria-label="the plan as a graph; it is told in words below"></div>`,
  props: { graph: Object, library: String },
  emits: ["pick"],
  mounted() {
    this.onPanel = () => this.$nextTick(() => this.draw());
    this.onLight = (event) => this.light(event.detail);
    this.onScheme = () => this.cy?.style(style());
    addEventListener("panel", this.onPanel);
    addEventListener("light", this.onLight);
    this.scheme = matchMedia("(prefers-color-scheme: dark)");
    this.scheme.addEventListener("change", this.onScheme);
    this.sizes = new ResizeObserver(() => this.draw());
    this.sizes.observe(this.$el);
    this.draw();
  },
  unmounted() {
    removeEventListener("panel", this.onPanel);
    removeEventListener("light", this.onLight);
    this.scheme.removeEventListener("change", this.onScheme);
    this.sizes.disconnect();
    this.cy?.destroy();
  },
  watch: {
    graph() {
      this.draw();
    },
  },
  methods: {
    async draw() {
      if (!this.$el.offsetWidth) return; // nobody sees it: neither load nor draw
      if (!this.cy) {
        if (this.loading) return;
        this.loading = true;
        // Not before somebody looks at a plan: it is the largest file of the page.
        const { default: cytoscape } = await import(this.library);
        this.cy = cytoscape({
          container: this.$el, style: style(), autoungrabify: true, boxSelectionEnabled: false,
          minZoom: 0.08, maxZoom: 2,
        });
        this.cy.on("dragpan scrollzoom pinchzoom", () => (this.free = true)); // looked at elsewhere
        this.cy.on("tap", "node", (event) => this.$emit("pick", event.target.id()));
        this.$el.cy = this.cy;
      }
      const ids = this.graph.nodes.map((node) => node.id).join();
      const first = !this.drawn;
      const moved = this.drawn !== ids;
      this.cy.batch(() => {
        if (moved) {
          this.cy.elements().remove();
          this.cy.add(this.graph.nodes.map((node) => ({
            group: "nodes", data: { id: node.id, label: node.label }, position: { x: node.x, y: node.y } })));
        }
        for (const node of this.graph.nodes)
          this.cy.getElementById(node.id).classes(
            `${node.kind}${node.stop ? " stop" : ""}${node.id.startsWith("fold") ? " fold" : ""}`);
        this.cy.edges().remove();
        this.cy.add(this.graph.edges.map((edge, i) => ({
          group: "edges", data: { id: `edge ${i}`, source: edge.source, target: edge.target, label: edge.label },
          classes: edge.kind })));
      });
      this.drawn = ids;
      const present = this.graph.nodes.find((node) => node.kind === "present")?.id;
      this.cy.resize();
      if (first || (!this.free && (moved || present !== this.present))) this.here();
      this.present = present;
      if (moved && this.words) this.find(this.words); // what was folded away may be there now
    },
    go(what) {
      if (still.matches) this.cy.center(what);
      else this.cy.animate({ center: { eles: what } }, { duration: 300 });
    },
    here() {
      if (!this.cy) return;
      this.free = false;
      const present = this.cy.nodes(".present");
      if (this.cy.nodes().length < 7 || !present.length) {
        this.fit();
        this.free = false;
        return;
      }
      this.cy.zoom(0.8);
      this.go(present);
    },
    fit() {
      this.free = true;
      this.cy?.fit(undefined, 24);
      if (this.cy && this.cy.zoom() > 1) { this.cy.zoom(1); this.cy.center(); }
    },
    find(words) {
      this.words = words;
      if (!this.cy) return;
      this.cy.nodes().removeClass("found");
      const asked = words.trim().toLowerCase();
      if (!asked) return;
      const found = this.cy.nodes().filter((node) => node.data("label").toLowerCase().includes(asked));
      found.addClass("found");
      if (found.length) this.cy.fit(found, 80);
      if (this.cy.zoom() > 1) { this.cy.zoom(1); this.cy.center(found); }
    },
    light(ids) {
      this.cy?.nodes().removeClass("lit");
      for (const id of ids) this.cy?.getElementById(id).addClass("lit");
    },
  },
};
