// What is brought along, and told where it is none.

export async function checkBringing({ claim, require, page }) {
  await claim('its gait comes as an animated picture that holds its blueprint', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      const bytes = await frame.keeping.loop();
      const text = new TextDecoder('latin1').decode(bytes);
      const image = new Image();
      image.src = URL.createObjectURL(new Blob([bytes], { type: 'image/png' }));
      await image.decode();
      return { frames: text.split('fcTL').length - 1, animated: text.includes('acTL'), width: image.naturalWidth, size: bytes.length, same: (await frame.library.call('Open', bytes)) === (await frame.lab.text()) };
    });
    require(seen.animated && seen.frames >= 8 && seen.width === 360 && seen.same && seen.size < 3e6, JSON.stringify(seen));
    return `${seen.frames} frames, ${Math.round(seen.size / 1000)} kB`;
  });

  await claim('a picture gives its creature back', async () => {
    const same = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      const before = await frame.library.call('Blueprint', 0);
      const picture = await frame.keeping.picture();
      const file = new File([picture], 'me.png', { type: 'image/png' });
      await frame.lab.meet({ seed: '8', kind: 'flying', strangeness: 0, traits: {}, text: null });
      const transfer = new DataTransfer();
      transfer.items.add(file);
      window.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, cancelable: true }));
      for (let i = 0; i < 300 && (await frame.library.call('Blueprint', 0)) !== before; i++) {
        await new Promise(resolve => setTimeout(resolve, 100));
      }
      return (await frame.library.call('Blueprint', 0)) === before;
    });
    require(same, 'another creature came out of the picture');
  });

  await claim('bad files, seeds and addresses are told, and the page lives on', async () => {
    const message = async make => {
      await page.evaluate(() => { document.querySelector('.alert').hidden = true; });
      await make();
      await page.waitForFunction(() => !document.querySelector('.alert').hidden);
      return page.evaluate(() => document.querySelector('.alert').textContent);
    };
    const drop = (name, bytes) => message(() => page.evaluate(([name, bytes]) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([typeof bytes === 'number' ? new Uint8Array(bytes) : bytes], name));
      window.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, cancelable: true }));
    }, [name, bytes]));
    for (const [name, bytes, words] of [
      ['broken.json', '{"version": 9}', 'broken.json'],
      ['broken.glb', 'glTF and no more', 'broken.glb'],
      ['picture.png', '\u0089PNG', 'picture.png'],
      ['<b>bold</b>.txt', 'hello', '<b>bold</b>.txt'],
      ['huge.glb', 32_000_001, '32 MB'],
    ]) {
      const told = await drop(name, bytes);
      require(told.includes(words), `${name}: “${told}”`);
    }
    const seed = await message(async () => {
      await page.fill('#seed', '99999999999999999999');
      await page.click('.search .loud');
    });
    require(seed.includes('18446744073709551615'), seed);
    for (const hash of ['#nobody', '#3.walking~girth9', '#b=AAAA', '#3.walking~<img>']) {
      const told = await message(() => page.evaluate(hash => { location.hash = hash; }, hash));
      require(told.includes('address'), `${hash}: “${told}”`);
    }
    await page.fill('#seed', '5');
    await page.click('.search .loud');
    await page.waitForFunction(() => location.hash.startsWith('#5.'));
  });

  await claim('addresses have two thousand letters at most, read and written', async () => {
    const told = () => page.evaluate(() => { const alert = document.querySelector('.alert'); const text = alert.hidden ? '' : alert.textContent; alert.hidden = true; return text; });
    const meets = async hash => {
      await told();
      await page.evaluate(hash => { location.hash = hash; }, hash);
      await page.waitForFunction(() => !document.querySelector('.alert').hidden);
      return told();
    };
    const [long, longer] = [await meets(`#b=${'A'.repeat(1997)}`), await meets(`#b=${'A'.repeat(1998)}`)];
    require(long.includes('mistyped') && longer.includes('2,001 letters; expected at most 2,000'), `${long}; ${longer}`);
    const bar = letters => page.evaluate(async letters => {
      const { visits, library, lab, taking, notices } = creatureLab.lab;
      const { call } = Object.getPrototypeOf(library);
      const { design } = lab;
      lab.design = { ...design, text: '{}' };
      library.call = (name, ...values) => (name === 'Address' ? Promise.resolve('A'.repeat(letters - 3)) : call.call(library, name, ...values));
      await visits.remember();
      const { hash } = location;
      await taking.share();
      const { textContent } = notices.status;
      delete library.call;
      lab.design = design;
      await visits.remember();
      notices.say('');
      return { letters: hash.length, status: textContent };
    }, letters);
    const [held, none] = [await bar(2000), await bar(2001)];
    const complaint = await told();
    require(held.letters === 2000 && none.letters === 0 && none.status.includes('no address') && complaint.includes('takes 2,001'), JSON.stringify({ held, none, complaint }));
  });

  await claim('names bring no markup', async () => {
    const found = await page.evaluate(() => {
      const frame = creatureLab.lab;
      const name = document.getElementById('name');
      name.value = '<img src=x><b>x</b>';
      name.dispatchEvent(new Event('change'));
      [...document.querySelectorAll('#panel-keep .loud')][0].click();
      return { images: document.querySelectorAll('main img[src=x], main b b').length, told: document.querySelector('.kept .person').textContent, kept: frame.keeping.collection.length };
    });
    require(found.images === 0 && found.told === '<img src=x><b>x</b>' && found.kept === 1, JSON.stringify(found));
  });

  await claim('a collection is taken along, and what is none is refused', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      const { length } = frame.keeping.collection;
      const text = JSON.stringify(frame.keeping.collection);
      await frame.taking.importAll(new File([text], 'mine.json'));
      const grown = frame.keeping.collection.length;
      await frame.taking.importAll(new File(['[{"name": 3}, {"name": "x", "design": {"seed": "<b>"}}]'], 'theirs.json'));
      return { length, grown, after: frame.keeping.collection.length, told: document.querySelector('.alert').textContent };
    });
    require(seen.grown === 2 * seen.length && seen.after === seen.grown && seen.told.includes('theirs.json'), JSON.stringify(seen));
  });
}
