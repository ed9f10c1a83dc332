/** Footfalls as short falling thumps. Made when somebody asks for sound, as browsers want it. */
export class Sound {
  #context = null;
  on = false;

  turn(on) {
    this.on = on;
    this.#context ??= on ? new AudioContext() : null;
    this.#context?.[on ? 'resume' : 'suspend']();
  }

  /** A foot comes down. */
  step(strength, distance, mass) {
    if (!this.on || !this.#context) {
      return;
    }
    const now = this.#context.currentTime;
    const tone = this.#context.createOscillator();
    const loud = this.#context.createGain();
    const deep = Math.min(2, Math.max(0.45, Math.pow(60 / mass, 0.2)));
    tone.frequency.setValueAtTime(150 * deep, now);
    tone.frequency.exponentialRampToValueAtTime(45 * deep, now + 0.11);
    loud.gain.setValueAtTime(Math.min(0.5, 0.12 + 0.3 * strength) / (1 + distance * distance), now);
    loud.gain.exponentialRampToValueAtTime(0.001, now + 0.12);
    tone.connect(loud).connect(this.#context.destination);
    tone.start(now);
    tone.stop(now + 0.13);
  }
}
