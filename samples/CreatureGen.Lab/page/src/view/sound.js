// Everything that is heard is made here, of oscillators and noise, from what the library tells of each moment. Nothing sounds until somebody asks for it, as browsers want it.

const loudest = 0.5;

/** Sounds of creatures: steps, wings, calls, bites and falls; deeper the heavier they are. */
export class Sound {
  #context = null;
  #noise = null;
  #voices = new Map();
  on = false;

  turn(on) {
    this.on = on;
    if (on && !this.#context) {
      this.#context = new AudioContext();
      this.#noise = this.#context.createBuffer(1, this.#context.sampleRate, this.#context.sampleRate);
      const samples = this.#noise.getChannelData(0);
      for (let i = 0, held = 0; i < samples.length; i++) {
        held += 0.35 * (Math.random() * 2 - 1 - held);
        samples[i] = held;
      }
    }
    this.#context?.[on ? 'resume' : 'suspend']();
  }

  /** Lets a moment be heard: its kind, how hard, how far from the ear in units of the world, and by whom. */
  play(kind, strength, distance, facts, slot) {
    if (!this.on || !this.#context) {
      return;
    }
    const near = 1 / (1 + 0.35 * distance * distance);
    const deep = Math.min(2.2, Math.max(0.4, Math.pow(60 / facts.mass, 0.2)));
    const make = { footfall: () => this.#thump(Math.min(loudest, 0.1 + 0.28 * strength) * near, 150 * deep, 0.12), fell: () => this.#thump(0.5 * near, 90 * deep, 0.34), wingBeat: () => this.#rush(0.14 * near, 420 * deep, 0.16), contact: () => this.#rush(0.3 * near, 1700 * deep, 0.07), call: () => this.#call(slot, 0.3 * near, deep), callEnd: () => this.#hush(slot) }[kind];
    make?.();
  }

  #gain(loud, seconds) {
    const { currentTime } = this.#context;
    const gain = this.#context.createGain();
    gain.gain.setValueAtTime(Math.max(loud, 0.0002), currentTime);
    gain.gain.exponentialRampToValueAtTime(0.0001, currentTime + seconds);
    gain.connect(this.#context.destination);
    return gain;
  }

  #thump(loud, hertz, seconds) {
    const now = this.#context.currentTime;
    const tone = this.#context.createOscillator();
    tone.frequency.setValueAtTime(hertz, now);
    tone.frequency.exponentialRampToValueAtTime(0.3 * hertz, now + 0.9 * seconds);
    tone.connect(this.#gain(loud, seconds));
    tone.start(now);
    tone.stop(now + seconds);
  }

  #rush(loud, hertz, seconds) {
    const now = this.#context.currentTime;
    const source = this.#context.createBufferSource();
    source.buffer = this.#noise;
    const band = this.#context.createBiquadFilter();
    band.type = 'bandpass';
    band.frequency.value = hertz;
    source.connect(band).connect(this.#gain(loud, seconds));
    source.start(now, Math.random() * 0.7);
    source.stop(now + seconds);
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
    const gain = this.#context.createGain();
    gain.gain.setValueAtTime(0.0001, now);
    gain.gain.exponentialRampToValueAtTime(Math.max(loud, 0.0002), now + 0.06);
    gain.connect(this.#context.destination);
    for (const [hertz, width] of [[620 * deep, 4], [1250 * deep, 6]]) {
      const formant = this.#context.createBiquadFilter();
      formant.type = 'bandpass';
      formant.Q.value = width;
      formant.frequency.setValueAtTime(0.6 * hertz, now);
      formant.frequency.linearRampToValueAtTime(hertz, now + 0.14);
      formant.frequency.linearRampToValueAtTime(0.55 * hertz, now + 0.9);
      buzz.connect(formant).connect(gain);
    }
    buzz.start(now);
    tremor.start(now);
    this.#voices.set(slot, { buzz, tremor, gain });
    const voice = this.#voices.get(slot);
    setTimeout(() => this.#voices.get(slot) === voice && this.#hush(slot), 1800);
  }

  #hush(slot) {
    const voice = this.#voices.get(slot);
    if (voice) {
      const now = this.#context.currentTime;
      voice.gain.gain.cancelScheduledValues(now);
      voice.gain.gain.setTargetAtTime(0.0001, now, 0.05);
      voice.buzz.stop(now + 0.3);
      voice.tremor.stop(now + 0.3);
      this.#voices.delete(slot);
    }
  }
}
