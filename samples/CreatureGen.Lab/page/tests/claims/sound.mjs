// What is heard.

export async function checkSound({ claim, require, page }) {
  await claim('nothing is heard until somebody asks for it', async () => {
    const seen = await page.evaluate(() => {
      const { sound, lab } = creatureLab.lab;
      const button = document.querySelector('.deeds [aria-label=Sound]');
      const contexts = [];
      const { makeContext } = sound;
      sound.makeContext = () => { const context = makeContext(); contexts.push(context); return context; };
      const state = () => ({ on: sound.on, pressed: button.getAttribute('aria-pressed'), contexts: contexts.length });
      const step = () => sound.play('footfall', 1, 0, lab.facts, 0);
      step();
      const before = state();
      button.click();
      step();
      const asked = state();
      button.click();
      const after = state();
      sound.makeContext = makeContext;
      return { before, asked, after };
    });
    require(!seen.before.on && seen.before.pressed === 'false' && seen.before.contexts === 0, `at the beginning: ${JSON.stringify(seen.before)}`);
    require(seen.asked.on && seen.asked.pressed === 'true' && seen.asked.contexts === 1 && !seen.after.on && seen.after.pressed === 'false', JSON.stringify(seen));
  });

  await claim('sounds begin and end without a click, do not clip, and are deeper the heavier who makes them', async () => {
    const seen = await page.evaluate(async () => {
      const Sound = creatureLab.lab.sound.constructor;
      const rate = 44100;
      const seconds = 2.4;
      const render = async play => {
        const context = new OfflineAudioContext(1, seconds * rate, rate);
        const sound = new Sound(() => context);
        sound.turn(true);
        play(sound, context);
        return (await context.startRendering()).getChannelData(0);
      };

      // The middle of the spectrum by its power, over the loudest stretch.
      const middle = samples => {
        const size = 4096;
        const from = Math.min(Math.max(0, samples.findIndex(v => Math.abs(v) > 1e-3)), samples.length - size);
        let [power, sum] = [0, 0];
        for (let k = 2; k < 600; k++) {
          let [re, im] = [0, 0];
          for (let i = 0; i < size; i++) {
            const window = 0.5 - 0.5 * Math.cos((2 * Math.PI * i) / size);
            const v = samples[from + i] * window;
            re += v * Math.cos((2 * Math.PI * k * i) / size);
            im += v * Math.sin((2 * Math.PI * k * i) / size);
          }
          power += re * re + im * im;
          sum += k * (re * re + im * im);
        }
        return (rate / size) * (sum / power);
      };
      const most = (samples, from, till) => {
        let found = 0;
        for (let i = Math.max(0, Math.floor(from)); i < Math.min(samples.length, till); i++) {
          found = Math.max(found, Math.abs(samples[i]));
        }
        return found;
      };
      const told = {};
      for (const kind of ['footfall', 'fell', 'wingBeat', 'contact', 'call']) {
        for (const mass of [1, 60, 4000]) {
          const samples = await render(sound => sound.play(kind, 1, 0, { mass }, 0));
          const peak = most(samples, 0, samples.length);
          const begin = samples.findIndex(v => Math.abs(v) > 1e-4 * peak);
          const end = samples.findLastIndex(v => Math.abs(v) > 1e-3 * peak);
          let step = 0;
          for (let i = Math.max(begin, 1); i <= begin + rate / 1000; i++) {
            step = Math.max(step, Math.abs(samples[i] - samples[i - 1]));
          }
          told[`${kind} ${mass}`] = { peak, hertz: middle(samples), seconds: (end - begin) / rate, begins: step / peak, ends: most(samples, end - rate / 500, end) / peak };
        }
      }
      const cut = await render((sound, context) => {
        sound.play('call', 1, 0, { mass: 60 }, 0);
        context.suspend(0.4).then(() => { sound.play('callEnd', 1, 0, { mass: 60 }, 0); context.resume(); });
      });
      const steps = (from, till) => { let found = 0; for (let i = from * rate; i < till * rate; i++) { found = Math.max(found, Math.abs(cut[Math.round(i)] - cut[Math.round(i) - 1])); } return found; };
      const crowd = await render(sound => { for (let n = 0; n < 20; n++) { sound.play(['footfall', 'fell', 'call', 'contact'][n % 4], 1, 0, { mass: 60 + n }, n); } });
      return { told, hush: { jump: steps(0.39, 0.44) / steps(0.25, 0.38), after: most(cut, 0.9 * rate, cut.length) / most(cut, 0, cut.length) }, crowd: most(crowd, 0, crowd.length) };
    });
    for (const [name, { peak, begins, ends, hertz }] of Object.entries(seen.told)) {
      require(peak > 0.03 && peak < 0.9, `${name} has a peak of ${peak}`);
      require(begins < 0.35 && ends < 0.02, `${name} clicks: ${begins} of its peak in one sample at its beginning, ${ends} in its last two milliseconds`);
      require(hertz > 60 && hertz < 4000, `${name} is at ${hertz} Hz`);
    }
    for (const kind of ['footfall', 'fell', 'wingBeat', 'contact', 'call']) {
      const [light, middling, heavy] = [1, 60, 4000].map(mass => seen.told[`${kind} ${mass}`].hertz);
      require(light > middling && middling > heavy, `${kind}: ${light}, ${middling}, ${heavy} Hz`);
    }
    require(seen.hush.jump < 1.5 && seen.hush.after < 0.01, `a call that is cut short: ${JSON.stringify(seen.hush)}`);
    require(seen.crowd < 1, `twenty at once have a peak of ${seen.crowd}`);
    return Object.entries(seen.told).map(([name, { peak, hertz, seconds }]) => `${name} kg: peak ${peak.toFixed(2)}, ${hertz.toFixed(0)} Hz, ${seconds.toFixed(2)} s`).join('; ') + `; twenty at once ${seen.crowd.toFixed(2)}; cut ${seen.hush.jump.toFixed(2)}`;
  });
}
