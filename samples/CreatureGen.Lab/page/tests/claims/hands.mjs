// What one does with hands: keys, pulling, and that the page answers meanwhile.

export async function checkHands({ claim, require, page }) {
  await claim('everything is done by keys alone', async () => {
    // Undo leads back to whom one visited before.
    await page.evaluate(() => creatureLab.lab.visits.meet({ seed: '12', kind: 'walking', strangeness: 0, traits: {}, text: null }));
    await page.evaluate(() => { creatureLab.lab.show('make'); document.getElementById('tab-make').focus(); });
    const at = () => page.evaluate(() => document.activeElement.id || document.activeElement.getAttribute('aria-label') || document.activeElement.textContent);

    // Arrow keys go from tab to tab, and turn the eye; plus and minus zoom.
    for (const tab of ['meet', 'breed', 'keep', 'make']) {
      await page.keyboard.press('ArrowRight');
      require(await at() === `tab-${tab}`, `an arrow key went to ${await at()}; expected tab-${tab}`);
    }
    const view = () => page.evaluate(() => { const { azimuth, elevation, wantedDistance } = creatureLab.lab.orbit; return { azimuth, elevation, wantedDistance }; });
    const before = await view();
    await page.focus('#stage');
    for (const key of ['ArrowLeft', 'ArrowUp', '+']) {
      await page.keyboard.press(key);
    }
    const after = await view();
    require(after.azimuth !== before.azimuth && after.elevation !== before.elevation && after.wantedDistance < before.wantedDistance, `${JSON.stringify(before)}; ${JSON.stringify(after)}`);

    // A slider, undo, and a deed.
    await page.focus('#trait-girth');
    const girth = await page.evaluate(() => creatureLab.lab.lab.design.traits.girth ?? 1);
    await page.keyboard.press('ArrowRight');
    await page.waitForFunction(girth => (creatureLab.lab.visits.history.now.traits.girth ?? 1) > girth && !document.body.classList.contains('working'), girth);
    await page.focus('[aria-label=Undo]');
    await page.keyboard.press('Enter');
    await page.waitForFunction(girth => (creatureLab.lab.lab.design.traits.girth ?? 1) === girth && !document.body.classList.contains('working'), girth);
    await page.evaluate(() => { creatureLab.lab.notices.say(''); document.querySelector('[data-deed=pet]').focus(); });
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => creatureLab.lab.notices.status.textContent !== '');

    // All that can be pressed can be reached: from the first element by Tab alone, until it begins anew.
    const reached = new Set();
    await page.focus('#seed');
    for (let i = 0; i < 200; i++) {
      await page.keyboard.press('Tab');
      const name = await at();
      if (reached.has(name) && name === 'seed') {
        break;
      }
      reached.add(name);
    }
    for (const name of ['stage', 'trait-neck', 'tab-make', 'Surprise me', 'Horns', 'Pet it', 'Sound', 'Creature of the day', 'Many at once']) {
      require(reached.has(name), `Tab does not reach “${name}”; it reaches ${[...reached].join(', ')}`);
    }
  });

  await claim('trunk, neck, tail and legs are pulled by the part that is under the pointer', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      frame.show('make');
      frame.canvas.setPointerCapture = () => {};
      const parts = ['trunk', 'neck', 'tail', 'leg'];
      const point = (type, x, y) => frame.canvas.dispatchEvent(new PointerEvent(type, { pointerId: 8, clientX: x, clientY: y, pointerType: 'mouse', bubbles: true }));

      // Where each part is on the screen, at a moment in which nothing moves and the body is the one that is felt.
      let part = null;
      const listen = ({ detail }) => { part = detail?.part; };
      frame.pointer.addEventListener('hover', listen);
      const places = async () => {
        await frame.lab.idle();
        while (document.body.classList.contains('working')) {
          await new Promise(resolve => setTimeout(resolve, 20));
        }
        await frame.theatre.portrait(1);
        await frame.touch.learn();
        const found = Object.fromEntries(parts.map(name => [name, []]));
        for (let y = 20; y < innerHeight - 20; y += 12) {
          for (let x = 10; x < innerWidth - 10; x += 12) {
            point('pointermove', x, y);
            found[part]?.push([x, y]);
          }
        }
        return found;
      };

      // A creature that shows them all.
      for (let seed = 3, shown = {}; seed < 20 && !parts.every(name => shown[name]?.length > 0); seed++) {
        await frame.lab.meet({ seed: String(seed), kind: 'walking', strangeness: 0, traits: {}, text: null });
        shown = await places();
      }
      const told = {};
      for (const name of parts) {
        const found = (await places())[name];
        const [x, y] = found[found.length >> 1] ?? [0, 0];
        point('pointerdown', x, y);
        point('pointermove', x, y + 12);
        point('pointermove', x, y + 40);
        told[name] = frame.ghost.hidden ? 'nothing' : frame.ghost.textContent.split(' ')[0];
        dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape' }));
        point('pointerup', x, y + 40);
      }
      frame.pointer.removeEventListener('hover', listen);
      return told;
    });
    const answers = { trunk: ['Girth', 'Size'], neck: ['Neck'], tail: ['Tail'], leg: ['Legs', 'Stoutness'] };
    for (const [part, names] of Object.entries(answers)) {
      require(names.includes(seen[part]), `${part}: ${seen[part]}`);
    }
    return Object.entries(seen).map(([part, name]) => `${part}: ${name}`).join(', ');
  });

  await claim('the page answers while the library grows creatures', async () => {
    // Turns of the page between a wish and the library's answer: were there one for each, nobody could do anything meanwhile. Fast machines have few.
    const seen = await page.evaluate(async () => {
      const { library } = creatureLab.lab;
      const gaps = [];
      let turns = 0;
      for (let n = 0; n < 6; n++) {
        let grown = false;
        const answer = library.call('Grow', 62, String(500 + n), ['walking', 'flying', 'swimming'][n % 3], 0.6, '', '').then(() => { grown = true; });
        for (let before = performance.now(); !grown; turns++) {
          await new Promise(resolve => setTimeout(resolve, 4));
          gaps.push(performance.now() - before);
          before = performance.now();
        }
        await answer;
      }
      await library.call('Remove', 62);
      gaps.sort((a, b) => a - b);
      return { turns, median: gaps[gaps.length >> 1], longest: gaps.at(-1) };
    });
    require(seen.turns >= 24, JSON.stringify(seen));
    return `${seen.turns} turns of the page during six creatures, one each ${seen.median.toFixed(1)} ms, longest ${seen.longest.toFixed(0)} ms`;
  });

  await claim('a creature is seen in each of its looks, with its feet and its gait', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      await frame.lab.meet({ seed: '12', kind: 'walking', strangeness: 0, traits: {}, text: null });
      await frame.library.call('Habit', 0, 'march', 0, 0, 1);
      const found = {};
      for (const look of ['flat', 'wire', 'bones', 'capsules', 'feet', 'skin']) {
        document.querySelector(`.looks [data-value=${look}]`).click();
        for (let i = 0; i < 45; i++) {
          await frame.theatre.advance(1 / 30);
        }
        const { body } = frame.herd.members.get(0);
        const [material] = body.skin.material;
        const pen = frame.gaitsCanvas.getContext('2d');
        const { width, height } = frame.gaitsCanvas;
        const drawn = look === 'feet' ? new Set(new Uint32Array(pen.getImageData(0, 0, width, height).data.buffer)).size : 0;
        found[look] = { flat: material.flatShading, wire: material.wireframe, skin: body.skin.visible, faint: material.opacity < 1, gait: drawn, shown: !frame.gaitsCanvas.hidden, marks: frame.looks.marks };
      }
      await frame.library.call('Habit', 0, 'stay', 0, 0, 1);
      return { found, counts: document.querySelector('#panel-make .fine').textContent };
    });
    const { flat, wire, bones, capsules, feet, skin } = seen.found;
    const right = flat.flat && wire.wire && bones.faint && bones.marks === 2 && !capsules.skin && capsules.marks > 10 && feet.shown && feet.gait > 2 && feet.marks >= 2 && skin.skin && skin.marks === 0 && !skin.shown;
    require(right && /[0-9] triangles.*[0-9] joints/.test(seen.counts), JSON.stringify(seen));
  });

  await claim('the pointer pets, sends, calls, pushes, turns and zooms', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      const { library, herd, canvas, orbit, notices } = frame;
      await frame.lab.meet({ seed: '12', kind: 'walking', strangeness: 0, traits: {}, text: null });
      frame.show('meet');
      canvas.setPointerCapture = () => {};
      const unit = frame.world.scale;
      await library.call('Grow', 30, '3', 'walking', 0, '', '');
      await library.call('Place', 30, -1.6 * unit, 0, -0.8 * unit, 0);
      const other = await herd.settle(30, JSON.parse(await library.call('Grow', 30, '3', 'walking', 0, '', '')));
      other.name = 'Somebody';

      // The eye is where the claim before left it; from some places no ground that is far enough is clicked before the other one is, a second time.
      Object.assign(frame.orbit, { azimuth: 0.62, elevation: 0.3 });
      await frame.theatre.portrait(4);
      const live = async count => { for (let i = 0; i < count; i++) { await frame.theatre.advance(1 / 30); } };
      const onScreen = place => { const at = place.clone().project(orbit.camera); return [((at.x + 1) / 2) * innerWidth, ((1 - at.y) / 2) * innerHeight]; };
      // Strokes and double clicks are told by their times: a clock of its own, that a machine with much to do does not hold up.
      let clock = performance.now();
      const point = (type, x, y, id = 9) => {
        const event = new PointerEvent(type, { pointerId: id, clientX: x, clientY: y, pointerType: 'mouse', bubbles: true });
        clock += 8;
        Object.defineProperty(event, 'timeStamp', { value: clock });
        canvas.dispatchEvent(event);
      };
      const click = (x, y) => { point('pointerdown', x, y); point('pointerup', x, y); };
      const heard = [];
      for (const name of ['pet', 'send', 'pick', 'push']) {
        frame.pointer.addEventListener(name, () => heard.push(name));
      }

      // Where the chosen creature is under the pointer, at a moment in which nothing moves.
      const onBody = async () => {
        await frame.theatre.portrait(1);
        await frame.touch.learn();
        let felt = false;
        const listen = ({ detail }) => { felt = detail !== null; };
        frame.pointer.addEventListener('hover', listen);
        const middle = onScreen(frame.lab.focus());
        const found = [0, 20, -20, 45, -45, 70, -70].flatMap(aside => [0, 20, -20, 45].map(up => [middle[0] + aside, middle[1] - up])).find(place => {
          point('pointermove', ...place);
          return felt;
        });
        frame.pointer.removeEventListener('hover', listen);
        return found ?? middle;
      };
      click(...await onBody());

      // The other one, beside what of the chosen one is before it.
      for (const up of [0.45, 0.2, 0.7, 0.95]) {
        if (!heard.includes('pick')) {
          click(...onScreen(other.body.group.position.clone().setY(other.body.group.position.y + up * other.facts.height)));
        }
      }
      const called = notices.status.textContent;
      const before = other.body.group.position.clone();
      const start = herd.members.get(0).body.group.position.clone();

      // Twice on ground that is far enough to walk to.
      let sent = null;
      frame.pointer.addEventListener('send', ({ detail }) => { sent = detail; });
      let empty = [0, 0];
      for (let up = 0.9; up > 0.45 && !(sent && Math.hypot(sent.x - start.x, sent.z - start.z) > 2 * frame.lab.facts.length); up -= 0.06) {
        empty = [0.92 * innerWidth, up * innerHeight];
        click(...empty);
        click(...empty);
      }
      await live(150);
      const came = other.body.group.position.distanceTo(before) / unit;
      const went = herd.members.get(0).body.group.position.distanceTo(start) / unit;

      // Drawing over the ground turns, two fingers zoom.
      const { azimuth, wantedDistance } = orbit;
      point('pointerdown', ...empty);
      point('pointermove', empty[0] + 60, empty[1]);
      point('pointerup', empty[0] + 60, empty[1]);
      const turned = orbit.azimuth - azimuth;
      point('pointerdown', 60, 60, 1);
      point('pointerdown', 160, 60, 2);
      point('pointermove', 260, 60, 2);
      point('pointerup', 260, 60, 2);
      point('pointerup', 60, 60, 1);
      const zoomed = orbit.wantedDistance / wantedDistance;

      // A stroke over the body pushes it.
      const [bodyX, bodyY] = await onBody();
      point('pointerdown', bodyX, bodyY);
      point('pointermove', bodyX + 120, bodyY);
      point('pointerup', bodyX + 120, bodyY);
      await herd.remove(30);
      return { heard, called, came, went, turned, zoomed };
    });
    require(['pet', 'pick', 'send', 'push'].every(name => seen.heard.includes(name)), `heard: ${seen.heard}`);
    require(seen.called.startsWith('Somebody') && seen.came > 0.3 && seen.went > 0.3 && seen.turned !== 0 && seen.zoomed < 0.6, JSON.stringify(seen));
  });

  await claim('a finger turns the eye and pulls on the body, two zoom', async () => {
    const finger = await page.context().newCDPSession(page);
    const touch = (type, ...points) => finger.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    const view = () => page.evaluate(() => { const { azimuth, wantedDistance } = creatureLab.lab.orbit; return { azimuth, wantedDistance }; });
    await finger.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 2 });
    try {
      const trunk = await page.evaluate(async () => {
        const frame = creatureLab.lab;
        await frame.lab.meet({ seed: '3', kind: 'walking', strangeness: 0, traits: {}, text: null });
        frame.show('make');
        delete frame.canvas.setPointerCapture;
        // The eye follows whoever came to where the one before had gone.
        Object.assign(frame.orbit, { azimuth: 0.62, elevation: 0.12 });
        await frame.theatre.portrait(3);
        await frame.touch.learn();
        const focus = frame.lab.focus().project(frame.orbit.camera);
        let part = null;
        const listen = ({ detail }) => { part = detail?.part; };
        frame.pointer.addEventListener('hover', listen);
        let [x, y] = [0, 0];
        for (const [aside, up] of [0, 30, -30, 60, -60, 90, -90].flatMap(aside => [0, 25, 50, -25].map(up => [aside, up]))) {
          [x, y] = [((focus.x + 1) / 2) * innerWidth + aside, ((1 - focus.y) / 2) * innerHeight - up];
          frame.canvas.dispatchEvent(new PointerEvent('pointermove', { pointerId: 7, clientX: x, clientY: y, pointerType: 'mouse', bubbles: true }));
          if (part === 'trunk' && document.elementFromPoint(x, y) === frame.canvas) {
            break;
          }
        }
        frame.pointer.removeEventListener('hover', listen);
        return [x, y];
      });
      const before = await view();
      await touch('touchStart', [40, 300]);
      await touch('touchMove', [70, 300]);
      await touch('touchMove', [120, 300]);
      await touch('touchEnd');
      const turned = await view();
      await touch('touchStart', [40, 300]);
      await touch('touchStart', [40, 300], [140, 300]);
      await touch('touchMove', [40, 300], [240, 300]);
      await touch('touchEnd');
      const zoomed = await view();
      const [x, y] = trunk;
      await touch('touchStart', [x, y]);
      await touch('touchMove', [x, y - 20]);
      await touch('touchMove', [x, y - 60]);
      const label = await page.evaluate(() => (creatureLab.lab.ghost.hidden ? '' : creatureLab.lab.ghost.textContent));
      await touch('touchEnd');
      await page.waitForFunction(() => !document.body.classList.contains('working'));
      const girth = await page.evaluate(() => creatureLab.lab.lab.design.traits.girth);
      require(turned.azimuth < before.azimuth - 0.3 && turned.wantedDistance === before.wantedDistance, `a finger: ${JSON.stringify([before, turned])}`);
      require(zoomed.wantedDistance < 0.7 * turned.wantedDistance, `two fingers: ${JSON.stringify([turned, zoomed])}`);
      require(label.startsWith('Girth') && girth > 1.2, `on the trunk: “${label}”, girth ${girth}`);
    } finally {
      await finger.send('Emulation.setTouchEmulationEnabled', { enabled: false });
      await finger.detach();
    }
  });

  await claim('the creature of the day is that of the date', async () => {
    await page.click('.today');
    const date = await page.evaluate(() => { const now = new Date(); return String(now.getUTCFullYear() * 10000 + (now.getUTCMonth() + 1) * 100 + now.getUTCDate()); });
    await page.waitForFunction(date => creatureLab.lab.lab.facts.seed === date && location.hash.startsWith(`#${date}.`), date);
  });
}
