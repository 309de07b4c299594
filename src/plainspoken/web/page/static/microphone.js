// Push to talk: held while speaking, or pressed to begin and again to end (so by keyboard, too).
// What is recorded becomes a WAV file here, and text at the server; nothing is kept of it.
const RATE = 16000; // as the server listens: no byte more is sent than it needs
const MOST = 55, LEAST = 0.3; // seconds
const HELD = 500; // milliseconds: who lets go later than this has held the button

export default {
  template: `
    <div class="microphone" @keydown.esc="discard">
      <button type="button" class="button" :class="{ listening: state === 'listening' }"
        :aria-pressed="String(state === 'listening')" :aria-disabled="String(state === 'busy')"
        @pointerdown="down" @pointerup="up" @click="clicked" @contextmenu.prevent>
        <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
          <rect x="5.5" y="1" width="5" height="8.5" rx="2.5"/>
          <path d="M3 7.5a5 5 0 0 0 10 0M8 12.5v2.5" fill="none" stroke="currentColor" stroke-width="1.5"/>
        </svg>
        {{ state === "listening" ? "End" : "Speak" }}
      </button>
      <template v-if="state === 'listening'">
        <meter min="0" max="1" low="0.25" :value="level" aria-label="how loud you are"></meter>
        <span class="seconds" aria-hidden="true">{{ Math.floor(seconds) }} s</span>
      </template>
      <span class="note" role="status">{{ told }}</span>
    </div>`,
  props: { address: String, recorder: String, missing: String },
  emits: ["heard"],
  data: () => ({ state: "idle", told: "", level: 0, seconds: 0 }),
  unmounted() {
    this.discard();
  },
  methods: {
    down(event) {
      if (event.button || event.pointerType === "") return;
      this.byPointer = true; // the click that follows says nothing new
      event.target.setPointerCapture?.(event.pointerId);
      this.since = event.timeStamp;
      this.toggle();
    },
    up(event) {
      if (this.state === "listening" && event.timeStamp - this.since > HELD) this.end();
    },
    clicked() {
      if (!this.byPointer) this.toggle();
      this.byPointer = false;
    },
    toggle() {
      if (this.state === "listening") this.end();
      else if (this.state === "idle") this.begin();
    },
    async begin() {
      if (this.missing) return this.tell(this.missing);
      if (!navigator.mediaDevices)
        return this.tell("Browsers give their microphone to pages over https, or on the same computer.");
      this.state = "busy";
      this.tell("May I use the microphone?");
      this.pieces = [];
      this.seconds = this.level = 0;
      try {
        this.stream = await navigator.mediaDevices.getUserMedia({ audio: { channelCount: 1 } });
        this.context = new AudioContext();
        await this.context.audioWorklet.addModule(this.recorder);
        const node = new AudioWorkletNode(this.context, "recorder", {
          channelCount: 1, channelCountMode: "explicit", numberOfOutputs: 0,
        });
        node.port.onmessage = ({ data }) => this.take(data);
        this.context.createMediaStreamSource(this.stream).connect(node);
        this.state = "listening";
        this.tell("I am listening.");
      } catch (error) {
        this.close();
        this.state = "idle";
        this.tell(error.name === "NotAllowedError"
          ? "The browser does not allow the microphone: allow it beside the address, or type."
          : `There is no microphone that works (${error.message}): choose another, or type.`);
      }
    },
    take(piece) {
      if (this.state !== "listening") return;
      this.pieces.push(piece);
      this.seconds += piece.length / this.context.sampleRate;
      const power = piece.reduce((sum, one) => sum + one * one, 0) / piece.length;
      const decibels = 10 * Math.log10(power + 1e-9);
      this.level = Math.min(1, Math.max(0, (decibels + 60) / 50));
      if (this.seconds >= MOST) this.end();
    },
    async end() {
      const { pieces, seconds } = this, rate = this.context.sampleRate;
      this.close();
      if (seconds < LEAST) {
        this.state = "idle";
        return this.tell("Hold it while you speak, or press it again at the end.");
      }
      this.state = "busy";
      this.tell("I am thinking about what you said …");
      try {
        const wav = encoded(await resampled(pieces, rate));
        const answer = await fetch(this.address, {
          method: "POST", headers: { "Content-Type": "audio/wav" }, body: wav,
        });
        const said = await answer.json();
        if (answer.ok) {
          this.$emit("heard", said);
          this.tell("Look at what I heard before you go on.");
        } else this.tell(`${said.what}. ${said.hint ?? ""}`);
      } catch {
        this.tell("The server does not answer: try again, or type.");
      }
      this.state = "idle";
    },
    discard() {
      if (this.state !== "listening") return;
      this.close();
      this.state = "idle";
      this.tell("");
    },
    close() {
      for (const track of this.stream?.getTracks() ?? []) track.stop();
      if (this.context?.state !== "closed") this.context?.close();
      this.stream = null;
    },
    tell(text) {
      this.told = text;
    },
  },
};

async function resampled(pieces, rate) {
  const length = pieces.reduce((sum, piece) => sum + piece.length, 0);
  const sound = new AudioBuffer({ length, sampleRate: rate });
  let place = 0;
  for (const piece of pieces) {
    sound.copyToChannel(piece, 0, place);
    place += piece.length;
  }
  const offline = new OfflineAudioContext(1, Math.ceil((length * RATE) / rate), RATE);
  const source = new AudioBufferSourceNode(offline, { buffer: sound });
  source.connect(offline.destination);
  source.start();
  return (await offline.startRendering()).getChannelData(0);
}

function encoded(samples) {
  const bytes = new DataView(new ArrayBuffer(44 + 2 * samples.length));
  const text = (place, word) => [...word].forEach((c, i) => bytes.setUint8(place + i, c.charCodeAt(0)));
  text(0, "RIFF");
  bytes.setUint32(4, 36 + 2 * samples.length, true);
  text(8, "WAVEfmt ");
  bytes.setUint32(16, 16, true);
  bytes.setUint16(20, 1, true); // plain samples
  bytes.setUint16(22, 1, true); // one channel
  bytes.setUint32(24, RATE, true);
  bytes.setUint32(28, 2 * RATE, true);
  bytes.setUint16(32, 2, true);
  bytes.setUint16(34, 16, true);
  text(36, "data");
  bytes.setUint32(40, 2 * samples.length, true);
  samples.forEach((one, i) => bytes.setInt16(44 + 2 * i, Math.max(-1, Math.min(1, one)) * 32767, true));
  return bytes.buffer;
}
