// What is changed of a creature.
import { readFileSync } from 'node:fs';

export async function checkMaking({ claim, require, page }) {
  await claim('it begins as strange as the library’s own default', async () => {
    const [page_, library] = await page.evaluate(async () => [creatureLab.lab.lab.design.strangeness, await creatureLab.lab.library.call('UsualStrangeness')]);
    require(page_ === library, `${page_}; expected ${library}`);
  });

  await claim('a slider changes the creature and its address, and undo takes it back', async () => {
    const before = await page.evaluate(() => creatureLab.lab.lab.facts.mass);
    const address = page.url();
    await page.evaluate(() => {
      const range = document.getElementById('trait-girth');
      range.value = '1.5';
      range.dispatchEvent(new Event('input'));
      range.dispatchEvent(new Event('change'));
    });
    await page.waitForFunction(() => location.hash.includes('~girth1.5'));
    const after = await page.evaluate(() => creatureLab.lab.lab.facts.mass);
    require(after > 1.2 * before, `the mass went from ${before} to ${after}`);
    require(new URL(page.url()).hash.length <= 80, `the address is ${page.url()}`);
    await page.click('[aria-label=Undo]');
    await page.waitForFunction(() => !location.hash.includes('girth'));
    const back = await page.evaluate(() => creatureLab.lab.lab.facts.mass);
    require(back === before, `undo did not take ${address} back: ${back} kg; expected ${before}`);
  });

  await claim('the sliders and parts that the page shows before the library runs are the library\'s own', async () => {
    const asked = await page.evaluate(async () => {
      const { library } = creatureLab.lab;
      return { sliders: JSON.parse(await library.call('Sliders')).map(({ name, least, most, own }) => ({ name, least, most, own })), parts: JSON.parse(await library.call('Palette')) };
    });
    const shown = JSON.parse(readFileSync(new URL('../../src/offered.json', import.meta.url), 'utf8'));
    require(JSON.stringify(shown) === JSON.stringify(asked), `src/offered.json has to be ${JSON.stringify(asked)}`);
    return `${shown.sliders.length} sliders, ${shown.parts.length} parts`;
  });

  await claim('surprises and nudges are sound, and undo and redo go back and forth between them', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      const { lab, library } = frame;
      lab.dressing = false;
      await frame.visits.meet({ seed: '12', kind: 'walking', strangeness: 0, individual: '', traits: {}, text: null });
      frame.show('make');
      const sliders = JSON.parse(await library.call('Sliders'));
      const buttons = [...document.querySelectorAll('#panel-make .row button')];
      const [surprise, nudge] = ['Surprise', 'Nudge'].map(words => buttons.find(button => button.textContent.startsWith(words)));
      const [undo, redo] = ['Undo', 'Redo'].map(words => document.querySelector(`[aria-label=${words}]`));
      const press = async button => {
        button.click();
        do {
          await new Promise(done => setTimeout(done, 20));
        } while (document.body.classList.contains('working'));
        await lab.idle();
        return { traits: lab.design.traits, hash: location.hash, mass: lab.facts.mass, violations: lab.facts.violations, undo: !undo.disabled, redo: !redo.disabled };
      };
      const { random } = Math;
      let n = 0;
      Math.random = () => (n = (n + 0.618034) % 1);
      const [first, second] = [await press(surprise), await press(nudge)];
      Math.random = random;
      const [back, forth] = [await press(undo), await press(redo)];
      const far = Object.entries(second.traits).map(([name, value]) => { const { least, most } = sliders.find(slider => slider.name === name); return Math.abs(value - first.traits[name]) / (most - least); });
      await press(undo);
      const anew = await press(nudge);
      lab.dressing = true;
      return { first, second, back, forth, anew, far };
    });
    const { first, second, back, forth, anew, far } = seen;
    require([first, second, back, forth].every(one => one.violations.length === 0), JSON.stringify(seen));
    require(far.length > 5 && Math.max(...far) > 0 && Math.max(...far) <= 0.1201 && first.mass !== second.mass, `a nudge moves sliders by ${far}`);
    require(back.hash === first.hash && back.mass === first.mass && back.redo && forth.hash === second.hash && forth.mass === second.mass && !forth.redo, JSON.stringify(seen));
    require(!anew.redo && anew.undo, 'what was undone can be done again after something else was done');
    return `${far.length} traits`;
  });

  await claim('pulling on the body changes it, and Escape takes it back', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      await frame.lab.meet({ seed: '3', kind: 'walking', strangeness: 0, traits: {}, text: null });
      frame.show('make');
      frame.canvas.setPointerCapture = () => {};
      let [x, y] = [0, 0];
      const point = (type, dy) => frame.canvas.dispatchEvent(new PointerEvent(type, { pointerId: 7, clientX: x, clientY: y + dy, pointerType: 'mouse', bubbles: true }));
      const settled = async () => { for (let i = 0; i < 200 && frame.notices.status.textContent !== ''; i++) { await new Promise(resolve => setTimeout(resolve, 50)); } };
      const girth = () => frame.lab.design.traits.girth ?? 1;

      // Where the trunk is in front of head and legs, as near the middle of the body as it is.
      const aim = async () => {
        await frame.touch.learn();
        await frame.theatre.portrait(1);
        const focus = frame.lab.focus().project(frame.orbit.camera);
        let part = null;
        const listen = ({ detail }) => { part = detail?.part; };
        frame.pointer.addEventListener('hover', listen);
        for (const [aside, up] of [0, 30, -30, 60, -60, 90, -90, 120, -120].flatMap(aside => [0, 25, 50, -25].map(up => [aside, up]))) {
          [x, y] = [((focus.x + 1) / 2) * innerWidth + aside, ((1 - focus.y) / 2) * innerHeight - up];
          point('pointermove', 0);
          if (part === 'trunk') {
            break;
          }
        }
        frame.pointer.removeEventListener('hover', listen);
        return part;
      };

      const first = await aim();
      point('pointerdown', 0);
      point('pointermove', -20);
      point('pointermove', -60);
      const label = frame.ghost.textContent;
      point('pointerup', -60);
      await settled();
      const pulled = girth();
      const { mass } = frame.lab.facts;
      const second = await aim();
      point('pointerdown', 0);
      point('pointermove', 20);
      point('pointermove', 60);
      const between = girth();
      dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape' }));
      await settled();
      point('pointerup', 60);
      return { first, second, label, pulled, between, back: girth(), mass, same: frame.lab.facts.mass };
    });
    require(seen.label.startsWith('Girth') && seen.pulled > 1.2 && seen.between < seen.pulled && seen.back === seen.pulled && seen.same === seen.mass, JSON.stringify(seen));
  });

  await claim('parts are put on and taken off', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      await frame.lab.meet({ seed: '12', kind: 'walking', strangeness: 0, traits: {}, text: null });
      const text = await frame.lab.text();
      const wrong = [];
      const kept = [];
      for (const part of JSON.parse(await frame.library.call('Palette'))) {
        const { blueprint, parts } = JSON.parse(await frame.library.call('GivePart', text, part, '5'));
        const facts = JSON.parse(await frame.library.call('GrowText', 60, blueprint, ''));
        kept.push(...(parts.includes(part) ? [part] : []));
        if (facts.violations.length) {
          wrong.push(`${part}: ${facts.violations[0]}`);
        }
        const bare = JSON.parse(await frame.library.call('TakePart', blueprint, part));
        if (!['eyes', 'coat'].includes(part) && bare.parts.includes(part)) {
          wrong.push(`${part} cannot be taken off`);
        }
      }
      await frame.library.call('Remove', 60);
      return { wrong, kept };
    });
    require(seen.wrong.length === 0, seen.wrong.join('\n'));
    require(seen.kept.length >= 14, `only ${seen.kept.join(', ')} stay on`);
    return `${seen.kept.length} of 20 stay on`;
  });

  await claim('sliders make valid creatures at both ends', async () => {
    const wrong = await page.evaluate(async () => {
      const { library, lab } = creatureLab.lab;
      const sliders = JSON.parse(await library.call('Sliders'));
      const found = [];
      let turn = 0;
      for (const slider of sliders) {
        for (const value of [slider.least, slider.most]) {
          const kind = ['walking', 'flying', 'swimming'][turn++ % 3];
          await library.call('Grow', 60, String(100 + turn), kind, 0, '', `${slider.name}${Math.round(value * 100) / 100}`);
          const facts = JSON.parse(await library.call('Mend', 60));
          if (facts.violations.length) {
            found.push(`${slider.name} ${value} of ${100 + turn} ${kind}: ${facts.violations[0]}`);
          }
        }
      }
      await library.call('Remove', 60);
      return found;
    });
    require(wrong.length === 0, wrong.join('\n'));
  });

  await claim('arms have a slider of their own, at both ends sound', async () => {
    const seen = await page.evaluate(async () => {
      const { library } = creatureLab.lab;
      const grow = async (seed, traits) => {
        await library.call('Grow', 60, String(seed), 'walking', 0, '', traits);
        return JSON.parse(await library.call('Mend', 60));
      };
      const lengths = async () => JSON.parse(await library.call('Blueprint', 60)).legs.map(({ archetype, length }) => ({ arm: ['arm', 'raptorial'].includes(archetype), length }));
      const tried = [];
      for (let seed = 1; tried.length < 4 && seed < 100; seed++) {
        if (!(await grow(seed, '')).traits.includes('arms')) {
          continue;
        }
        const own = await lengths();
        const felt = (await library.call('Parts', 60)).includes('"arm"');
        for (const share of [0.55, 1.8]) {
          const { violations } = await grow(seed, `arms${share}`);
          const changed = await lengths();
          tried.push({ seed, felt, violations, arms: changed.every((leg, n) => !leg.arm || Math.abs(leg.length / own[n].length / share - 1) < 0.01), legs: changed.every((leg, n) => leg.arm || leg.length === own[n].length) });
        }
      }
      await library.call('Remove', 60);
      return tried;
    });
    require(seen.length >= 4 && seen.every(({ felt, violations, arms, legs }) => felt && violations.length === 0 && arms && legs), JSON.stringify(seen));
    return `seeds ${seen.map(({ seed }) => seed).join(', ')}`;
  });

  await claim('repair is told with its reason', async () => {
    const [reasons, told] = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      for (let seed = 100; seed < 140; seed++) {
        await frame.lab.meet({ seed: String(seed), kind: 'walking', strangeness: 0, traits: {}, text: null });
        const facts = await frame.lab.mend({ ...frame.lab.design, traits: { head: 1.6, neck: 2.4, legs: 0.55, tail: 2.4, girth: 1.7 } });
        frame.make.tell(facts.reasons);
        if (facts.reasons.length) {
          return [facts.reasons, document.querySelector('.reasons').textContent];
        }
      }
      return [[], ''];
    });
    require(reasons.length > 0 && told.includes(reasons[0]), `nothing was changed, or “${told}” does not tell it`);
    return reasons[0];
  });

  await claim('a lock keeps a trait', async () => {
    const kept = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      await frame.lab.meet({ seed: '20', kind: 'walking', strangeness: 0, traits: {}, text: null });
      const lock = document.querySelector('[aria-label^="Keep neck"]');
      lock.click();
      document.querySelector('#panel-make .loud').click();
      const disabled = document.getElementById('trait-neck').disabled;
      const traits = frame.lab.design.traits;
      lock.click();
      while (document.body.classList.contains('working')) {
        await new Promise(resolve => setTimeout(resolve, 20));
      }
      return { disabled, neck: traits.neck ?? 1, others: Object.keys(traits).length };
    });
    require(kept.disabled && kept.neck === 1 && kept.others > 5, JSON.stringify(kept));
  });
}
