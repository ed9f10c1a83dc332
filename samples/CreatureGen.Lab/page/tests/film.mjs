// Films the page for the README: ten seconds of a creature's life, with what one does on the page, as an animated WebP. node film.mjs FILE [HASH [MATE]]: HASH tells the creature as an address does, MATE is a seed.
import { writeFileSync } from 'node:fs';
import { openBrowser, serveLab } from './browser.mjs';

const [file, hash = '#22.walking', mate = '25'] = process.argv.slice(2);
const viewport = { width: 880, height: 560 };
const [width, height] = [616, 392];
const rate = 7;
const seconds = 10;
const quality = 0.5;

// Software drawing takes most of its time for shadows.
const shadowSize = 1024;

// What happens, at which second: `f` is the page, `u` the unit of its world, `t` goes from 0 to 1 between the first second and the second.
const script = [
  [0, 0, 'f.library.call("Go", 0, 1.3 * u, 2.2 * u)'],
  [1.4, 1.4, 'f.play.pet()'],
  [2.3, 3.5, 'slide("neck", 1 + 1.1 * t)'],
  [3.5, 4.4, 'slide("colour", 1.9 * t)'],
  [4.5, 4.5, 'settle()'],
  [4.9, 4.9, 'document.getElementById("tab-breed").click(), court()'],
  [5.8, 7.3, 'born(Math.ceil(9 * t))'],
  [8.3, 8.3, 'f.lab.raise(f.lab.litter[4])'],
  [8.7, 8.7, 'f.play.act("Dance")'],
];

const lab = await serveLab();
const browser = await openBrowser();
const page = await browser.newPage({ viewport });
page.setDefaultTimeout(300_000);
await page.goto(`${lab.address}?still&draw=best${hash}`);
await page.evaluate(() => creatureLab.ready.then(() => true));
await page.waitForFunction(() => creatureLab.count() >= 13 && creatureLab.lab.herd.members.get(0).body.textures);
await page.evaluate(([mate, shadowSize]) => {
  const f = creatureLab.lab;
  f.drawing.renderer.setPixelRatio(1);
  f.world.sun.shadow.mapSize.set(shadowSize, shadowSize);
  const until = async test => { while (!test()) { await new Promise(resolve => setTimeout(resolve, 20)); } };
  const act = window.filmed = {
    f,
    async slide(name, value) {
      const range = document.getElementById(`trait-${name}`);
      range.value = value;
      range.dispatchEvent(new Event('input'));
      await f.lab.idle();
    },
    settle: () => f.making.settle(),
    async court() {
      const seed = document.getElementById('partner-seed');
      document.getElementById('partner').value = 'seed';
      seed.value = mate;
      seed.dispatchEvent(new Event('change'));
      await until(() => f.courtship.mate?.design.seed === mate && f.courtship.mate.moved !== undefined);
    },
    async born(count) {
      act.brood ??= f.nursery.litter(mate, 0.3);
      await until(() => f.lab.litter.length >= count);
    },
  };
  return f.library.call('Rehearse', 0, 'Dance');
}, [mate, shadowSize]);
for (let n = 0; n < 2 * rate; n++) {
  await page.evaluate(dt => creatureLab.lab.theatre.advance(dt), 1 / rate);
}
const pictures = [];
for (let n = 0; n < rate * seconds; n++) {
  const now = n / rate;
  for (const [from, till, act] of script) {
    if (from === till ? now >= from && now - 1 / rate < from : now >= from && now <= till) {
      await page.evaluate(`(async ({ f, slide, settle, court, born }, u, t) => { await (${act}); })(filmed, creatureLab.lab.world.scale, ${from === till ? 1 : (now - from) / (till - from)})`);
    }
  }
  await page.evaluate(async dt => {
    const { theatre } = creatureLab.lab;
    for (let i = 0; i < 3; i++) {
      await theatre.advance(dt / 3);
    }
    for (let i = 0; i < 4; i++) {
      theatre.portraits.draw();
    }
    theatre.render();
  }, 1 / rate);
  const seen = await page.screenshot({ type: 'jpeg', quality: 92, timeout: 300_000 });
  pictures.push(Buffer.from(await page.evaluate(async ([text, width, height, quality]) => {
    const image = new Image();
    image.src = `data:image/jpeg;base64,${text}`;
    await image.decode();
    const flat = new OffscreenCanvas(width, height);
    const pen = flat.getContext('2d', { alpha: false });
    pen.imageSmoothingQuality = 'high';
    pen.drawImage(image, 0, 0, width, height);
    const bytes = new Uint8Array(await (await flat.convertToBlob({ type: 'image/webp', quality })).arrayBuffer());
    return btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join(''));
  }, [seen.toString('base64'), width, height, quality]), 'base64'));
}
writeFileSync(file, animatedWebp(pictures, width, height, Math.round(1000 / rate)));
await browser.close();
lab.close();
process.exit(0);

/** Frames of one picture each, in one file that plays without end (the WebP container's ANIM and ANMF). */
function animatedWebp(pictures, width, height, milliseconds) {
  const chunk = (name, data) => {
    const head = Buffer.alloc(8);
    head.write(name, 0, 'latin1');
    head.writeUInt32LE(data.length, 4);
    return Buffer.concat([head, data, Buffer.alloc(data.length % 2)]);
  };
  const short = value => Buffer.from([value & 255, (value >> 8) & 255, (value >> 16) & 255]);
  const body = [
    chunk('VP8X', Buffer.concat([Buffer.from([2, 0, 0, 0]), short(width - 1), short(height - 1)])),
    chunk('ANIM', Buffer.from([255, 255, 255, 255, 0, 0])),
    ...pictures.map(picture => {
      const at = picture.indexOf('VP8 ', 12, 'latin1');
      const data = picture.subarray(at, at + 8 + picture.readUInt32LE(at + 4) + (picture.readUInt32LE(at + 4) % 2));
      return chunk('ANMF', Buffer.concat([short(0), short(0), short(width - 1), short(height - 1), short(milliseconds), Buffer.from([2]), data]));
    }),
  ];
  const all = Buffer.concat([Buffer.from('WEBP', 'latin1'), ...body]);
  const head = Buffer.alloc(8);
  head.write('RIFF', 0, 'latin1');
  head.writeUInt32LE(all.length, 4);
  return Buffer.concat([head, all]);
}
