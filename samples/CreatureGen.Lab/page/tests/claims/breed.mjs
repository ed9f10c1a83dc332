// Parents, children and their families.

export async function checkBreeding({ claim, require, page, visit, still }) {
  await claim('two parents stand side by side where one breeds, and part where one does not', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      await frame.lab.meet({ seed: '3', kind: 'walking', strangeness: 0, traits: {}, text: null });
      document.getElementById('tab-breed').click();
      const other = document.getElementById('partner-seed');
      document.getElementById('partner').value = 'seed';
      other.value = '22';
      other.dispatchEvent(new Event('change'));
      for (let i = 0; i < 400 && !(frame.courtship.mate?.design.seed === '22' && frame.courtship.mate.moved); i++) {
        await frame.theatre.advance(1 / 30);
        await new Promise(resolve => setTimeout(resolve, 20));
      }
      for (let i = 0; i < 60; i++) {
        await frame.theatre.advance(1 / 30);
      }
      const { mate } = frame.courtship;
      const onScreen = [frame.herd.members.get(0), mate].map(member => member.body.group.position.clone().project(frame.orbit.camera).x);
      frame.theatre.render();
      await new Promise(resolve => setTimeout(resolve, 100));
      const shown = [...document.querySelectorAll('.pair figcaption')].map(name => name.textContent);
      document.getElementById('tab-make').click();
      for (let i = 0; i < 200 && frame.herd.members.has(mate.slot); i++) {
        await new Promise(resolve => setTimeout(resolve, 20));
      }
      return { onScreen, shown, name: mate.name, left: frame.herd.members.has(mate.slot) };
    });
    require(seen.onScreen.every(x => x > -1 && x < 0.9) && seen.onScreen[1] - seen.onScreen[0] > 0.15 && seen.shown[1] === seen.name && !seen.left, JSON.stringify(seen));
  });

  await claim('two creatures have a litter of nine, and a child grows up', async () => {
    const result = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      await frame.lab.meet({ seed: '3', kind: 'walking', strangeness: 0, traits: {}, text: null });
      await frame.lab.breed({ seed: '22', kind: 'walking', strangeness: 0, traits: {}, text: null }, 0.25, () => {});
      const count = frame.lab.litter.length;
      const baby = frame.lab.litter[4].facts.mass;
      const design = await frame.lab.raise(frame.lab.litter[4]);
      frame.visits.history.push(design);
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

  await claim('all changed sliders of the longest seed fit into eighty letters', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      const sliders = JSON.parse(await frame.library.call('Sliders'));
      const traits = Object.fromEntries(sliders.map((slider, n) => [slider.name, Math.round(100 * (n % 2 ? slider.least : slider.most)) / 100]));
      const design = { seed: '18446744073709551615', kind: 'swimming', strangeness: 0.35, individual: '', traits, text: null };
      const address = frame.visits.addressOf(design);
      const read = frame.visits.designOf(address);
      return { length: address.length, same: JSON.stringify(Object.entries(read.traits).sort()) === JSON.stringify(Object.entries(traits).sort()) && read.seed === design.seed && read.strangeness === design.strangeness };
    });
    require(seen.length <= 80 && seen.same, JSON.stringify(seen));
    return `${seen.length} letters`;
  });

  await claim('a family can be walked back, and branches', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      const { family } = frame.lab;
      const child = family.now;
      const parent = child.parents[0];
      await frame.lab.meet(parent.design);
      const back = family.now === parent;
      await frame.lab.breed({ seed: '9', kind: 'walking', strangeness: 0, traits: {}, text: null }, 0.2, () => {});
      await frame.lab.raise(frame.lab.litter[0]);
      return { back, members: family.members.length, children: family.members.filter(member => member.parents.includes(parent)).length, drawn: document.querySelectorAll('.relative').length };
    });
    require(seen.back && seen.members === 5 && seen.children === 2 && seen.drawn === 5, JSON.stringify(seen));
  });

  await claim('a population is bred on towards a goal while one looks on', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      await frame.lab.meet({ seed: '3', kind: 'walking', strangeness: 0, traits: {}, text: null });
      document.getElementById('goal').value = 'tall';
      const button = [...document.querySelectorAll('#panel-breed .loud')].at(-1);
      button.click();
      const told = () => document.querySelector('#panel-breed .chart').previousElementSibling.textContent;
      for (let i = 0; i < 1200 && !/Generation 2/.test(told()); i++) {
        await new Promise(resolve => setTimeout(resolve, 100));
      }
      const last = told();
      button.click();
      for (let i = 0; i < 600 && frame.nursery.evolving; i++) {
        await new Promise(resolve => setTimeout(resolve, 100));
      }
      return { last, over: !frame.nursery.evolving, generation: frame.lab.facts.generation, paths: document.querySelectorAll('.chart path').length };
    });
    require(/Generation 2/.test(seen.last) && seen.over && seen.paths === 2, JSON.stringify(seen));
    return seen.last;
  });
}
