// Checks the page in a real browser and prints one line of JSON for each claim: {"claim", "holds", "detail"}.
// node check.mjs EXPECTED FOLDER: EXPECTED is a JSON file with the hashes of native files, [{"seed", "kind", "sha256"}]; FOLDER is where the page was exported to.
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import pixelmatch from 'pixelmatch';
import { PNG } from 'pngjs';
import { openBrowser, serveFolder, serveLab } from './browser.mjs';

const [expectedFile, exported, mode] = process.argv.slice(2);
const expected = JSON.parse(readFileSync(expectedFile, 'utf8'));
const pictures = fileURLToPath(new URL('../../../../docs/', import.meta.url));
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const longest = 120_000;

// How far a picture may be from the committed one: other machines round otherwise, and clouds move.
const pixelTolerance = 0.2;
const shareTolerance = 0.08;

const lab = await serveLab();
const browser = await openBrowser();
const troubles = [];

async function visit(address, size = { width: 900, height: 640 }) {
  const page = await browser.newPage({ viewport: size });
  page.setDefaultTimeout(longest);
  page.on('pageerror', error => troubles.push(String(error)));
  page.on('console', message => {
    // Reading pixels back for a picture makes the driver of software drawing grumble.
    if (['error', 'warning'].includes(message.type()) && !/GPU stall/.test(message.text())) {
      troubles.push(message.text());
    }
  });
  await page.goto(address);
  await page.evaluate(() => creatureLab.ready.then(() => true));
  return page;
}

async function claim(name, check) {
  const begin = Date.now();
  let detail = '';
  try {
    detail = (await check()) ?? '';
  } catch (problem) {
    process.stdout.write(`${JSON.stringify({ claim: name, holds: false, detail: String(problem?.message ?? problem).slice(0, 2000) })}\n`);
    return;
  }
  process.stdout.write(`${JSON.stringify({ claim: name, holds: true, detail: `${detail} ${Date.now() - begin} ms`.trim() })}\n`);
}

function require(condition, message) {
  if (!condition) {
    throw new Error(message);
  }
}

const still = `${lab.address}?still&draw=least`;
const page = await visit(still);

await claim('files equal native ones', async () => {
  for (const { seed, kind, sha256 } of expected) {
    const found = await page.evaluate(async ([seed, kind]) => {
      const digest = await crypto.subtle.digest('SHA-256', await creatureLab.glb(seed, kind));
      return [...new Uint8Array(digest)].map(byte => byte.toString(16).padStart(2, '0')).join('');
    }, [seed, kind]);
    require(found === sha256, `seed ${seed}, ${kind}: ${found}; expected ${sha256}`);
  }
  return `${expected.length} files`;
});

await claim('it walks where it is sent', async () => {
  const way = await page.evaluate(async () => {
    const frame = creatureLab.lab;
    const unit = frame.world.scale;
    await frame.library.call('Go', 0, 0.4 * unit, 4 * unit);
    const member = frame.herd.members.get(0);
    const places = [];
    let loads = 0;
    for (let i = 0; i < 360; i++) {
      await frame.advance(1 / 30);
      places.push([member.body.group.position.x / unit, member.body.group.position.z / unit]);
      loads += member.feet.filter(foot => foot[3] > 0).length;
    }
    return { end: places.at(-1), loads, feet: member.feet.length, sound: member.body.skeleton.boneMatrices.every(Number.isFinite), cost: creatureLab.frameCost() };
  });
  require(way.sound, 'a matrix is not finite');
  require(way.end[1] > 2, `it came to ${way.end}; expected near 0.4, 4`);
  require(way.loads > 360 * way.feet * 0.3, 'feet hardly touch the ground');
  require(way.cost > 0 && way.cost < 1000, `frameCost is ${way.cost}`);
});

await claim('neighbours come, and are counted', async () => {
  await page.waitForFunction(() => creatureLab.count() >= 8);
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
        await library.call('Grow', 60, String(100 + turn), kind, 0, `${slider.name}${Math.round(value * 100) / 100}`);
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
  require(await page.evaluate(() => creatureLab.lab.lab.facts.mass) === before, `undo did not take ${address} back`);
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
    return { disabled, neck: traits.neck ?? 1, others: Object.keys(traits).length };
  });
  require(kept.disabled && kept.neck === 1 && kept.others > 5, JSON.stringify(kept));
});

await claim('two creatures have a litter of nine, and a child grows up', async () => {
  const result = await page.evaluate(async () => {
    const frame = creatureLab.lab;
    await frame.lab.meet({ seed: '3', kind: 'walking', strangeness: 0, traits: {}, text: null });
    await frame.lab.breed({ seed: '22', kind: 'walking', strangeness: 0, traits: {}, text: null }, 0.25, () => {});
    const count = frame.lab.litter.length;
    const baby = frame.lab.litter[4].facts.mass;
    const design = await frame.lab.raise(frame.lab.litter[4]);
    frame.history.push(design);
    return { count, baby, grown: frame.lab.facts.mass, generation: frame.lab.facts.generation, left: frame.lab.litter.length };
  });
  require(result.count === 9 && result.left === 0 && result.generation === 1 && result.grown > 2 * result.baby, JSON.stringify(result));
});

await claim('a child’s address brings it back', async () => {
  const [hash, text] = await page.evaluate(async () => {
    const frame = creatureLab.lab;
    return [`#b=${await frame.library.call('Address', 0)}`, await frame.library.call('Blueprint', 0)];
  });
  const other = await visit(still + hash);
  const found = await other.evaluate(() => creatureLab.lab.library.call('Blueprint', 0));
  await other.close();
  require(found === text, 'another creature came');
  require(hash.length <= 2000, `the address has ${hash.length} letters`);
  return `${hash.length} letters`;
});

await claim('a picture gives its creature back', async () => {
  const same = await page.evaluate(async () => {
    const frame = creatureLab.lab;
    const before = await frame.library.call('Blueprint', 0);
    const picture = await frame.picture();
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

await claim('names bring no markup', async () => {
  const found = await page.evaluate(() => {
    const frame = creatureLab.lab;
    const name = document.getElementById('name');
    name.value = '<img src=x><b>x</b>';
    name.dispatchEvent(new Event('change'));
    [...document.querySelectorAll('#panel-keep .loud')][0].click();
    return { images: document.querySelectorAll('main img, main b b').length, told: document.querySelector('.kept .person').textContent, kept: frame.collection.length };
  });
  require(found.images === 0 && found.told === '<img src=x><b>x</b>' && found.kept === 1, JSON.stringify(found));
});

await claim('sixty creatures leave the memory as it was', async () => {
  const memory = await page.evaluate(async () => {
    const { library } = creatureLab.lab;
    const at = [];
    for (let n = 0; n < 60; n++) {
      await library.call('Grow', 61, String(n), ['walking', 'flying', 'swimming'][n % 3], 0, '');
      await library.call('Mesh', 61);
      if (n % 20 === 19) {
        at.push(Number(await library.call('Memory')));
      }
    }
    await library.call('Remove', 61);
    return at;
  });
  require(memory.at(-1) < memory[0] + 6e6, memory.join(', '));
  return memory.join(', ');
});

await claim('the grid shows creatures that live, by kind', async () => {
  await page.evaluate(() => document.querySelector('.alert:not([hidden]) button')?.click());
  await page.click('[aria-label="Many at once"]');
  await page.waitForFunction(() => creatureLab.lab.grid?.herd?.members.size >= 4);
  await page.click('.many [data-value=swimming]');
  await page.waitForFunction(() => [...(creatureLab.lab.grid?.herd?.members.values() ?? [])].filter(member => member.moved && member.facts.kind === 'swimming').length >= 4);
  await page.evaluate(() => document.querySelector('.many').close());
});

await claim('axe finds no serious issue on any tab', async () => {
  await page.evaluate(axe);
  const found = [];
  for (const tab of ['make', 'meet', 'breed', 'keep']) {
    await page.click(`#tab-${tab}`);
    const { violations } = await page.evaluate(() => axe.run(document, { resultTypes: ['violations'] }));
    found.push(...violations.filter(v => ['serious', 'critical'].includes(v.impact)).map(v => `${tab}: ${v.id}: ${v.nodes.map(node => node.html.slice(0, 120)).slice(0, 3).join(' | ')}`));
  }
  require(found.length === 0, found.join('\n'));
});
await page.close();

await claim('an exported page works below a path of a plain host', async () => {
  const host = await serveFolder(exported, '/games/lab/');
  try {
    const other = await visit(`${host.address}?still&draw=least#7.swimming`);
    const length = await other.evaluate(async () => (await creatureLab.glb(7, 'swimming')).length);
    await other.close();
    require(length > 100_000, `the file has ${length} bytes`);
  } finally {
    host.close();
  }
});

for (const [file, size, address] of [['lab.png', { width: 1280, height: 800 }, ''], ['lab-phone.png', { width: 360, height: 740 }, '#22.walking']]) {
  await claim(`${file} is what is seen`, async () => {
    const other = await visit(`${lab.address}?still&draw=best${address}`, size);
    await other.waitForFunction(count => creatureLab.count() >= count && creatureLab.lab.herd.members.get(0).body.textures, size.width < 700 ? 5 : 8);
    await other.evaluate(() => creatureLab.lab.portrait(8));
    const seen = PNG.sync.read(await other.screenshot({ timeout: longest }));
    const narrow = await other.evaluate(() => document.documentElement.scrollWidth > innerWidth);
    await other.close();
    require(!narrow, 'the page is wider than the window');
    if (mode === 'renew') {
      writeFileSync(join(pictures, file), PNG.sync.write(seen, { colorType: 2 }));
      return 'written';
    }
    const before = PNG.sync.read(readFileSync(join(pictures, file)));
    require(before.width === seen.width && before.height === seen.height, `${seen.width} × ${seen.height} pixels`);
    const apart = pixelmatch(before.data, seen.data, null, seen.width, seen.height, { threshold: pixelTolerance }) / (seen.width * seen.height);
    require(apart <= shareTolerance, `${(100 * apart).toFixed(2)} % of the pixels differ; expected at most ${100 * shareTolerance} %`);
    return `${(100 * apart).toFixed(2)} %`;
  });
}

await claim('the console stays silent', () => require(troubles.length === 0, troubles.join('\n')));
await browser.close();
lab.close();
process.exit(0);
