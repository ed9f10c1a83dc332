// Films the stage for the README: ten seconds of a creature's life as an animated WebP. node film.mjs FILE [HASH]
import { writeFileSync } from 'node:fs';
import { openBrowser, serveLab } from './browser.mjs';

const [file, hash = ''] = process.argv.slice(2);
const [width, height] = [640, 400];
const rate = 8;
const seconds = 10;
const quality = 0.62;

// What happens, at which second.
const script = [
  [0.2, 'f.library.call("Go", 0, -0.9 * u, 1.3 * u)'],
  [2.4, 'f.play.feed()'],
  [6.6, 'f.play.act("Dance")'],
];

const lab = await serveLab();
const browser = await openBrowser();
const page = await browser.newPage({ viewport: { width, height } });
page.setDefaultTimeout(300_000);
await page.goto(`${lab.address}?still&draw=best${hash}`);
await page.evaluate(() => creatureLab.ready.then(() => true));
await page.waitForFunction(() => creatureLab.count() >= 8 && creatureLab.lab.herd.members.get(0).body.textures);
await page.evaluate(() => {
  const f = creatureLab.lab;
  f.drawing.renderer.setPixelRatio(1);
  f.orbit.fit(innerWidth, innerHeight, { right: 0, bottom: 0 });
  f.orbit.camera.fov = 30;
  return f.library.call('Rehearse', 0, 'Dance');
});
const frames = [];
for (let n = 0; n < rate * seconds; n++) {
  const begun = script.filter(([at]) => at >= n / rate && at < (n + 1) / rate).map(([, act]) => act);
  for (const act of begun) {
    await page.evaluate(`((f, u) => ${act})(creatureLab.lab, creatureLab.lab.world.scale)`);
  }
  frames.push(Buffer.from(await page.evaluate(async ([dt, quality]) => {
    const f = creatureLab.lab;
    for (let i = 0; i < 3; i++) {
      await f.advance(dt / 3);
    }
    const { canvas } = f;
    f.drawing.renderer.render(f.world.scene, f.orbit.camera);
    const flat = document.createElement('canvas');
    [flat.width, flat.height] = [640, 400];
    flat.getContext('2d', { alpha: false }).drawImage(canvas, 0, 0, 640, 400);
    const blob = await new Promise(resolve => flat.toBlob(resolve, 'image/webp', quality));
    const bytes = new Uint8Array(await blob.arrayBuffer());
    let text = '';
    for (const byte of bytes) {
      text += String.fromCharCode(byte);
    }
    return btoa(text);
  }, [1 / rate, quality]), 'base64'));
}
writeFileSync(file, animatedWebp(frames, width, height, Math.round(1000 / rate)));
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
