// How the page begins.

export async function checkStart({ claim, require, browser, visit, lab, longest }) {
  await claim('a baked creature moves while the library starts, then the live one comes', async () => {
    // The library is kept from starting: what moves is baked.
    const waiting = await browser.newPage({ viewport: { width: 900, height: 640 } });
    waiting.setDefaultTimeout(longest);
    let release;
    const held = new Promise(resolve => { release = resolve; });
    await waiting.route('**/dotnet.native.wasm', async route => { await held; await route.abort().catch(() => {}); });
    await waiting.goto(`${lab.address}?still&alone`);
    await waiting.waitForFunction(() => performance.getEntriesByName('creature:baked').length > 0);
    const seen = async () => (await waiting.locator('#cover img').screenshot({ timeout: longest })).toString('base64');
    const first = await seen();
    const begin = Date.now();
    let moved = false;
    while (!moved && Date.now() - begin < longest) {
      moved = await seen() !== first;
    }
    const crowded = await waiting.locator('.panel').isVisible();
    release();
    await waiting.close();
    require(moved, 'the picture of the first creature stands still');
    require(!crowded, 'panels are painted before the first creature lives');

    const other = await visit(lab.address, { width: 900, height: 640 }, () => {
      window.asked = [];
      window.Worker = class extends Worker {
        constructor(...values) {
          super(...values);
          window.asked.push({ name: 'worker', at: performance.now() });
        }

        postMessage(call, ...more) {
          window.asked.push({ name: call.name, at: performance.now() });
          super.postMessage(call, ...more);
        }
      };
    });
    await other.waitForFunction(() => creatureLab.count() > 1);
    const marks = await other.evaluate(() => Object.fromEntries(performance.getEntriesByType('mark').map(mark => [mark.name, mark.startTime])));
    const [baked, live] = ['baked', 'live'].map(name => marks[`creature:${name}`]);
    const early = await other.evaluate(live => window.asked.filter(({ at }) => at < live).map(({ name }) => name), live);
    await other.waitForFunction(() => !document.getElementById('cover'));
    const offered = await other.locator('.panel').isVisible();
    await other.close();
    require(offered, 'there is no panel beside the live creature');
    require(baked < live, JSON.stringify(marks));
    require(['worker', 'Grow'].every(name => early.filter(one => one === name).length === 1), `asked for before the first picture: ${early}`);
    return `${Math.round(baked)}, ${Math.round(live)} ms`;
  });

  await claim('where less motion is asked for, only creatures move', async () => {
    const context = await browser.newContext({ reducedMotion: 'reduce', viewport: { width: 900, height: 640 } });
    const page = await context.newPage();
    page.setDefaultTimeout(longest);
    const pictures = [];
    page.on('request', request => { if (/first/.test(request.url())) { pictures.push(request.url().split('/').at(-1)); } });
    await page.goto(`${lab.address}?still&draw=least&alone`);
    await page.evaluate(() => creatureLab.ready.then(() => true));
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      const before = frame.world.time;
      for (let i = 0; i < 10; i++) {
        await frame.theatre.advance(1 / 30);
      }
      const styled = [...document.querySelectorAll('*')].filter(element => { const style = getComputedStyle(element); return style.transitionDuration.split(',').some(time => parseFloat(time) > 0) || style.animationName !== 'none'; });
      return { passed: frame.world.time - before, lives: frame.herd.members.get(0).moved, styled: styled.map(element => element.outerHTML.slice(0, 80)) };
    });
    await context.close();
    require(seen.passed === 0 && seen.lives && seen.styled.length === 0 && pictures.join() === 'first.png', `${JSON.stringify(seen)}, pictures ${pictures}`);
  });
}
