// Pictures of the page, against those of the documents.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import pixelmatch from 'pixelmatch';
import { PNG } from 'pngjs';

const pictures = fileURLToPath(new URL('../../../../../docs/', import.meta.url));

// How far a picture may be from the committed one: other machines round otherwise.
const pixelTolerance = 0.2;
const shareTolerance = 0.05;

export async function checkLooks({ claim, require, visit, lab, longest, mode }) {
  for (const [file, size, address] of [['lab.png', { width: 1280, height: 800 }, ''], ['lab-phone.png', { width: 360, height: 740 }, '#22.walking']]) {
    await claim(`${file} is what is seen`, async () => {
      const other = await visit(`${lab.address}?still&draw=best${address}`, size);
      await other.waitForFunction(count => creatureLab.count() >= count && creatureLab.lab.herd.members.get(0).body.textures, size.width < 700 ? 7 : 13);
      await other.evaluate(() => creatureLab.lab.theatre.portrait(8));
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
}
