// What is taken home.
import { readFileSync } from 'node:fs';

export async function checkKeeping({ claim, require, page }) {
  await claim('files are downloaded whole: blueprint, plain GLB, GLB with textures and clips', async () => {
    await page.evaluate(() => creatureLab.lab.lab.meet({ seed: '7', kind: 'walking', strangeness: 0, traits: {}, text: null }));
    await page.click('#tab-keep');
    const taken = async name => {
      const [download] = await Promise.all([page.waitForEvent('download'), page.click(`#panel-keep button:text-is("${name}")`)]);
      return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
    };
    const json = await taken('Blueprint');
    const text = await page.evaluate(() => creatureLab.lab.lab.text());
    require(json.name.endsWith('.json') && json.bytes.toString('utf8') === text, `${json.name} is not the blueprint`);
    const told = [];
    for (const [button, clips, images] of [['GLB', 0, 0], ['GLB, textured and animated', 2, 1]]) {
      const { name, bytes } = await taken(button);
      const gltf = JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)));
      require(name.endsWith('.glb') && bytes.toString('latin1', 0, 4) === 'glTF' && bytes.readUInt32LE(8) === bytes.length, `${name} is no GLB`);
      require((gltf.animations?.length ?? 0) >= clips && (gltf.images?.length ?? 0) >= images && gltf.skins.length === 1, `${button}: ${gltf.animations?.length} clips, ${gltf.images?.length} images`);
      told.push(`${button}: ${Math.round(bytes.length / 1000)} kB, ${gltf.animations?.length ?? 0} clips`);
    }
    return told.join('; ');
  });
}
