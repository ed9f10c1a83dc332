// Checks the page in a real browser and prints one line of JSON for each claim: {"claim", "holds", "detail"}.
// node check.mjs EXPECTED FOLDER [WORDS]: EXPECTED is a JSON file with the hashes of native files, [{"seed", "kind", "sha256"}]; FOLDER is where the page was exported to; WORDS check only the claims that contain them,
// or, with bars between, any of them. node check.mjs renew writes the pictures anew.
import { readFileSync } from 'node:fs';
import { openBrowser, serveLab } from './browser.mjs';
import { checkAnywhere } from './claims/anywhere.mjs';
import { checkBreeding } from './claims/breed.mjs';
import { checkBringing } from './claims/bring.mjs';
import { checkHands } from './claims/hands.mjs';
import { checkKeeping } from './claims/keeping.mjs';
import { checkLooks } from './claims/looks.mjs';
import { checkMaking } from './claims/make.mjs';
import { checkMany } from './claims/many.mjs';
import { checkPlay } from './claims/play.mjs';
import { checkSound } from './claims/sound.mjs';
import { checkStart } from './claims/start.mjs';

const renews = process.argv[2] === 'renew';
const [expectedFile, exported, mode] = renews ? [null, null, 'renew'] : process.argv.slice(2);
const expected = renews ? [] : JSON.parse(readFileSync(expectedFile, 'utf8'));
const longest = 120_000;

const lab = await serveLab();
const browser = await openBrowser();
const troubles = [];
const strangers = [];

/** Opens the page and waits for its creature; `before` runs in it before anything else. */
async function visit(address, size = { width: 900, height: 640 }, before = () => {}) {
  const page = await browser.newPage({ viewport: size });
  await page.addInitScript(before);
  page.setDefaultTimeout(longest);
  page.on('pageerror', error => troubles.push(String(error)));
  page.on('request', request => {
    const { protocol, hostname } = new URL(request.url());
    if (!['blob:', 'data:'].includes(protocol) && hostname !== 'localhost') {
      strangers.push(request.url());
    }
  });
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
  if (mode && (mode === 'renew' ? !name.includes('.png') : !mode.split('|').some(words => name.includes(words)))) {
    return;
  }
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

// Neighbours would grow at each visit, and keep two workers busy.
const still = `${lab.address}?still&draw=least&alone`;
const page = await visit(still);
const tools = { claim, require, page, visit, still, browser, lab, exported, longest, mode };

await claim('files equal native ones', async () => {
  // Every other one by the page's second worker, so that two cores write.
  const wrong = await page.evaluate(async expected => {
    const studio = await creatureLab.lab.studio();
    const compare = async (glb, files) => {
      const apart = [];
      for (const { seed, kind, sha256 } of files) {
        const digest = await crypto.subtle.digest('SHA-256', await glb(seed, kind));
        const found = [...new Uint8Array(digest)].map(byte => byte.toString(16).padStart(2, '0')).join('');
        if (found !== sha256) {
          apart.push(`seed ${seed}, ${kind}: ${found}; expected ${sha256}`);
        }
      }
      return apart;
    };
    return (await Promise.all([
      compare(creatureLab.glb, expected.filter((_, n) => n % 2 === 0)),
      compare((seed, kind) => studio.call('GlbOfSeed', String(seed), kind), expected.filter((_, n) => n % 2 === 1)),
    ])).flat();
  }, expected);
  require(wrong.length === 0, wrong.join('\n'));
  return `${expected.length} files`;
});

await checkMaking(tools);
await checkPlay(tools);
await checkHands(tools);
await checkSound(tools);
await checkBreeding(tools);
await checkBringing(tools);
await checkKeeping(tools);
await checkMany(tools);
await page.close();
await checkAnywhere(tools);
await checkStart(tools);
await checkLooks(tools);

await claim('nothing leaves the machine', () => require(strangers.length === 0, strangers.join('\n')));
await claim('the console stays silent', () => require(troubles.length === 0, troubles.join('\n')));
await browser.close();
lab.close();
process.exit(0);
