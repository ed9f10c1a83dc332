// What one does with a creature.

export async function checkPlay({ claim, require, page }) {
  await claim('it walks where it is sent', async () => {
    const way = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      await frame.lab.meet({ seed: '12', kind: 'walking', strangeness: 0, traits: {}, text: null });
      const unit = frame.world.scale;
      await frame.library.call('Go', 0, 0.4 * unit, 4 * unit);
      const member = frame.herd.members.get(0);
      const places = [];
      let loads = 0;
      for (let i = 0; i < 360; i++) {
        await frame.theatre.advance(1 / 30);
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

  await claim('feet stay where they stand', async () => {
    // A vertex of the sole is followed in the world while its foot stands.
    const slips = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      await frame.lab.meet({ seed: '12', kind: 'walking', strangeness: 0, traits: {}, text: null });
      const unit = frame.world.scale;
      await frame.library.call('Go', 0, 0, 6 * unit);
      const member = frame.herd.members.get(0);
      const { body } = member;
      const { positions, skinJoints, skinWeights } = body.mesh;
      const place = vertex => {
        const [x, y, z] = [0, 0, 0];
        const sum = body.group.position.clone().set(x, y, z);
        const part = sum.clone();
        for (let k = 0; k < 4; k++) {
          const weight = skinWeights[4 * vertex + k] / 255;
          if (weight > 0) {
            sum.addScaledVector(body.carry(skinJoints[4 * vertex + k], part.fromArray(positions, 3 * vertex)), weight);
          }
        }
        body.group.updateMatrixWorld();
        return sum.applyMatrix4(body.group.matrixWorld);
      };
      const lowest = foot => {
        let best = 0;
        let nearest = Infinity;
        const at = body.group.position.clone();
        for (let v = 0; v < positions.length / 3; v += 1) {
          const far = place(v).distanceToSquared(at.fromArray(foot));
          if (far < nearest) {
            nearest = far;
            best = v;
          }
        }
        return best;
      };
      const held = new Map();
      const found = [];
      for (let i = 0; i < 420; i++) {
        await frame.theatre.advance(1 / 60);
        member.feet.forEach((foot, n) => {
          const grip = held.get(n);
          if (!(foot[3] > 0)) {
            if (grip && grip.frames > 8) {
              found.push(grip.slip / member.facts.height);
            }
            held.delete(n);
          } else if (!grip) {
            // Two frames after touchdown, when it carries.
            held.set(n, { wait: 2, frames: 0, slip: 0 });
          } else if (grip.wait > 0) {
            grip.wait--;
            if (grip.wait === 0) {
              grip.vertex = grip.vertexOf ?? lowest(foot);
              grip.from = place(grip.vertex);
            }
          } else if (foot[3] > 0.2) {
            grip.frames++;
            grip.slip = Math.max(grip.slip, place(grip.vertex).sub(grip.from).setY(0).length());
          }
        });
      }
      return found.sort((a, b) => a - b);
    });
    require(slips.length >= 8, `${slips.length} steps`);
    const median = slips[slips.length >> 1];
    require(median < 0.03, `half of the feet slip by more than ${(100 * median).toFixed(2)} % of the height; expected at most 3`);
    return `${slips.length} steps, median ${(100 * median).toFixed(2)} %, worst ${(100 * slips.at(-1)).toFixed(2)} % of the height`;
  });

  await claim('it staggers when it is pushed, falls when it is pushed hard, and gets up', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      await frame.lab.meet({ seed: '12', kind: 'walking', strangeness: 0, traits: {}, text: null });
      const run = async count => {
        const states = new Set();
        for (let i = 0; i < count; i++) {
          await frame.theatre.advance(1 / 30);
          states.add(frame.herd.members.get(0).state);
        }
        return [...states];
      };
      await run(20);
      await frame.play.push(1, 0.2, -1, 0.25);
      const soft = await run(40);
      await frame.play.push(1, 0.2, -1, 1.1);
      return { soft, hard: await run(360), end: frame.herd.members.get(0).state };
    });
    require(!seen.soft.includes('limp') && seen.hard.includes('limp') && seen.hard.includes('rising') && seen.end === 'supported', JSON.stringify(seen));
  });

  await claim('while an act is tried others live on', async () => {
    const { longest, whole, slices } = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      const lives = { seed: '25', kind: 'walking', strangeness: 0.6, traits: {}, text: null };
      await frame.lab.meet(lives);
      const begin = performance.now();
      let goesOn = true;
      const tried = frame.play.rehearse('Eat').then(() => frame.play.rehearse('Lie')).then(() => { goesOn = false; });
      let longest = 0;
      let slices = 0;
      while (goesOn) {
        const asked = performance.now();
        await frame.library.call('UsualStrangeness');
        longest = Math.max(longest, performance.now() - asked);
        slices++;
      }
      await tried;
      return { longest, whole: performance.now() - begin, slices };
    });
    require(slices > 10 && longest < 0.4 * whole, `the library answered after ${longest.toFixed()} of ${whole.toFixed()} ms, ${slices} times`);
    return `${longest.toFixed()} of ${whole.toFixed()} ms at most, ${slices} answers`;
  });

  await claim('it is petted, dances, and comes for its fruit', async () => {
    const seen = await page.evaluate(async () => {
      const frame = creatureLab.lab;
      await frame.play.pet();
      const petted = frame.notices.status.textContent;
      const danced = await frame.play.act('Dance');
      for (let i = 0; i < 60; i++) {
        await frame.theatre.advance(1 / 30);
      }
      await frame.library.call('Habit', 0, 'stay', 0, 0, 1);
      await frame.play.feed();
      let bitten = false;
      let i = 0;
      for (; i < 900 && frame.treats.fruit; i++) {
        await frame.theatre.advance(1 / 30);
        bitten ||= !!frame.treats.fruit?.bitten;
      }
      return { petted, danced, bitten, left: !!frame.treats.fruit, frames: i };
    });
    require(seen.petted !== '' && seen.danced && seen.bitten && !seen.left, JSON.stringify(seen));
  });
}
