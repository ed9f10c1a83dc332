// Neighbours, hosts, networks and browsers.
import { serveFolder } from '../browser.mjs';

export async function checkAnywhere({ claim, require, visit, browser, lab, exported, longest }) {
  await claim('neighbours come, and are counted', async () => {
    const other = await visit(`${lab.address}?still&draw=least`);
    await other.waitForFunction(() => creatureLab.count() >= 13);
    const seen = await other.evaluate(async () => {
      const frame = creatureLab.lab;
      for (let i = 0; i < 120; i++) {
        await frame.theatre.advance(1 / 30);
      }
      const moved = [...frame.herd.members.values()].filter(member => member.moved).length;
      return { moved, media: [...new Set(frame.lab.neighbours.map(member => member.facts.kind))].sort().join(' '), afloat: frame.lab.neighbours.filter(member => member.facts.medium === 'water').every(member => member.body.group.position.y < frame.world.waterLevel) };
    });
    await other.close();
    require(seen.moved === 13 && seen.media === 'flying swimming walking' && seen.afloat, JSON.stringify(seen));
  });

  await claim('an exported page works below a path of a plain host', async () => {
    const host = await serveFolder(exported, '/games/lab/');
    try {
      const other = await visit(`${host.address}?still&draw=least&alone#7.swimming`);
      const length = await other.evaluate(async () => (await creatureLab.glb(7, 'swimming')).length);
      await other.close();
      require(length > 100_000, `the file has ${length} bytes`);
    } finally {
      host.close();
    }
  });

  await claim('the page works without a network after the first visit', async () => {
    const host = await serveFolder(exported, '/');
    const context = await browser.newContext();
    try {
      const other = await context.newPage();
      await other.goto(`${host.address}?still&draw=least&alone`);
      await other.evaluate(() => creatureLab.ready.then(() => creatureLab.keep()).then(() => navigator.serviceWorker.ready).then(() => true));
      host.close();
      await context.setOffline(true);
      await other.goto(`${host.address}?still&draw=least&alone#31.walking`, { timeout: longest });
      await other.reload({ timeout: longest });
      await other.evaluate(() => creatureLab.ready.then(() => true));
      require(await other.evaluate(() => creatureLab.lab.lab.facts.seed) === '31', 'another creature came');
    } finally {
      await context.close();
      host.close();
    }
  });

  await claim('a browser that cannot run it gets pictures', async () => {
    for (const [without, words] of [['wasm', 'WebAssembly'], ['webgl', 'WebGL 2']]) {
      const other = await browser.newPage();
      other.setDefaultTimeout(longest);
      await other.goto(`${lab.address}?without=${without}`);
      await other.waitForFunction(() => [...document.querySelectorAll('.stills img')].filter(image => image.complete && image.naturalWidth === 360).length >= 12);
      const told = await other.evaluate(() => document.querySelector('[role=alert]').textContent);
      await other.close();
      require(told.includes(words), told);
    }
  });
}
