// Everything that is heard is made here, of oscillators and noise, from what the library tells of each moment. Nothing sounds until somebody asks for it, as browsers want it.

const loudest = 0.5;
const attackSeconds = 0.004;
const silence = 0.0001;
const longestCall = 1.8;
const hushSeconds = 0.05;
const limiter = { threshold: -9, knee: 6, ratio: 20, attack: 0.002, release: 0.12 };
const level = 0.7;
const evenHertz = 700;

// More than this at once is noise: what comes then is not heard.
const mostVoices = 24;

/** Sounds of creatures: steps, wings, calls, bites and falls; deeper the heavier they are. */
export class Sound {
  #context = null;
  #out = null;
  #noise = null;
  #voices = new Map();
  #sounding = 0;
  on = false;

  /** @param makeContext gives what sounds are made in, when somebody first wants to hear them. */
  constructor(makeContext = () => new AudioContext()) {
    this.makeContext = makeContext;
  }

  turn(on) {
    this.on = on;
    if (on && !this.#context) {
      this.#begin(this.makeContext());
    }
    this.#context?.[on ? 'resume' : 'suspend']()?.catch?.(() => {});
  }

  /** Lets a moment be heard: its kind, how hard, how far from the ear in units of the world, and by whom. */
  play(kind, strength, distance, facts, slot) {
    if (!this.on || !this.#context) {
      return;
    }
    if (kind === 'callEnd') {
      this.#hush(slot);
      return;
    }
    if (this.#sounding >= mostVoices) {
      return;
    }
    const near = 1 / (1 + 0.35 * distance * distance);
    const deep = Math.min(2.2, Math.max(0.4, Math.pow(60 / facts.mass, 0.2)));
    switch (kind) {
      case 'footfall': {
        // The weight, and the ground that gives: the second is what small loudspeakers let hear.
        const loud = Math.min(loudest, 0.12 + 0.3 * strength) * near;
        this.#thump(loud, 60 + 100 * deep, 0.12);
        this.#rush(2 * loud, 700 * deep, 0.07);
        break;
      }
      case 'fell':
        this.#thump(0.5 * near, 45 + 60 * deep, 0.34);
        this.#rush(1.2 * near, 380 * deep, 0.22);
        break;
      case 'wingBeat':
        this.#rush(0.5 * near, 420 * deep, 0.16, 0.05);
        break;
      case 'contact':
        this.#rush(1.8 * near, 1700 * deep, 0.07);
        break;
      case 'call':
        this.#call(slot, 0.55 * near, deep);
        break;
    }
  }

  /** Many at once stay below full level: a limiter comes before the loudspeaker. */
  #begin(context) {
    this.#context = context;
    this.#out = context.createDynamicsCompressor();
    for (const [name, value] of Object.entries(limiter)) {
      this.#out[name].value = value;
    }
    const whole = context.createGain();
    whole.gain.value = level;
    this.#out.connect(whole).connect(context.destination);
    this.#noise = context.createBuffer(1, context.sampleRate, context.sampleRate);
    const samples = this.#noise.getChannelData(0);
    for (let i = 0, held = 0; i < samples.length; i++) {
      held += 0.35 * (Math.random() * 2 - 1 - held);
      samples[i] = held;
    }
  }

  /** A level that rises at once, without a click, and dies away. */
  #swell(loud, seconds, attack = attackSeconds) {
    const { currentTime } = this.#context;
    const gain = this.#gain();
    gain.gain.setValueAtTime(silence, currentTime);
    gain.gain.exponentialRampToValueAtTime(Math.max(loud, 2 * silence), currentTime + attack);
    gain.gain.exponentialRampToValueAtTime(silence, currentTime + seconds);
    return gain;
  }

  #gain() {
    const gain = this.#context.createGain();
    gain.connect(this.#out);
    return gain;
  }

  #thump(loud, hertz, seconds) {
    const now = this.#context.currentTime;
    const tone = this.#context.createOscillator();
    tone.frequency.setValueAtTime(hertz, now);
    tone.frequency.exponentialRampToValueAtTime(0.3 * hertz, now + 0.9 * seconds);
    tone.connect(this.#swell(loud, seconds));
    this.#sound(tone, now, now + seconds);
  }

  #rush(loud, hertz, seconds, attack = attackSeconds) {
    const now = this.#context.currentTime;
    const source = this.#context.createBufferSource();
    source.buffer = this.#noise;
    const band = this.#context.createBiquadFilter();
    band.type = 'bandpass';
    band.frequency.value = hertz;
    // A band holds the less of the noise the lower it is.
    source.connect(band).connect(this.#swell(loud * Math.sqrt(Math.max(1, evenHertz / hertz)), seconds, attack));
    source.loop = true;
    this.#sound(source, now, now + seconds, 0.7 * Math.random());
  }

  /** A voice: a buzz through two formants that open and close, with a voice of its own for every slot. */
  #call(slot, loud, deep) {
    this.#hush(slot);
    const now = this.#context.currentTime;
    const pitch = 190 * deep * (0.85 + 0.09 * ((slot * 7) % 5));
    const buzz = this.#context.createOscillator();
    buzz.type = 'sawtooth';
    buzz.frequency.setValueAtTime(0.8 * pitch, now);
    buzz.frequency.linearRampToValueAtTime(1.25 * pitch, now + 0.16);
    buzz.frequency.linearRampToValueAtTime(0.7 * pitch, now + 0.9);
    const tremor = this.#context.createOscillator();
    tremor.frequency.value = 7 + 3 * deep;
    const depth = this.#context.createGain();
    depth.gain.value = 0.05 * pitch;
    tremor.connect(depth).connect(buzz.frequency);
    const gain = this.#gain();
    gain.gain.setValueAtTime(silence, now);
    gain.gain.exponentialRampToValueAtTime(Math.max(loud, 2 * silence), now + 0.06);
    // Another level for the end, so that it begins wherever the first one is.
    const end = this.#context.createGain();
    end.gain.setTargetAtTime(0, now + longestCall - 6 * hushSeconds, hushSeconds);
    end.connect(gain);
    for (const [hertz, width] of [[620 * deep, 4], [1250 * deep, 6]]) {
      const formant = this.#context.createBiquadFilter();
      formant.type = 'bandpass';
      formant.Q.value = width;
      formant.frequency.setValueAtTime(0.6 * hertz, now);
      formant.frequency.linearRampToValueAtTime(hertz, now + 0.14);
      formant.frequency.linearRampToValueAtTime(0.55 * hertz, now + 0.9);
      buzz.connect(formant).connect(end);
    }
    this.#sound(buzz, now, now + longestCall);
    this.#sound(tremor, now, now + longestCall);
    this.#voices.set(slot, { buzz, tremor, end });
  }

  #hush(slot) {
    const voice = this.#voices.get(slot);
    if (voice) {
      const now = this.#context.currentTime;
      voice.end.gain.setTargetAtTime(0, now, hushSeconds);
      voice.buzz.stop(now + 8 * hushSeconds);
      voice.tremor.stop(now + 8 * hushSeconds);
      this.#voices.delete(slot);
    }
  }

  /** Sounds from then till then, and is counted meanwhile. */
  #sound(source, from, till, ...offset) {
    this.#sounding++;
    source.onended = () => { this.#sounding--; };
    source.start(from, ...offset);
    source.stop(till);
  }
}
