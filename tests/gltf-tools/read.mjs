#!/usr/bin/env node
// read.mjs DIR: reads all GLB files of a folder with glTF-Transform and prints what is in each as one line of JSON.
// Sums run over the elements in order, in double precision, so that another program can find exactly the same numbers:
//   sum    Σ vᵢ of each component
//   woven  Σ (i mod 251 + 1)·vᵢ of each component, which sees elements that changed places
import { NodeIO } from '@gltf-transform/core';
import { glbFiles } from './files.mjs';

const TRIANGLES = 4;

for (const { name, bytes } of glbFiles()) {
  const warnings = [];
  const listen = (text) => warnings.push(text);
  const io = new NodeIO().setLogger({ debug() {}, info() {}, warn: listen, error: listen });
  const root = (await io.readBinary(bytes)).getRoot();
  console.log(JSON.stringify({ file: name, warnings, ...describe(root) }));
}

function describe(root) {
  const scene = root.getDefaultScene();
  const skinned = root.listNodes().filter((node) => node.getMesh() && node.getSkin());
  if (skinned.length !== 1) throw new Error(`${skinned.length} skinned nodes; expected 1`);
  const mesh = skinned[0].getMesh();
  const skin = skinned[0].getSkin();
  const joints = skin.listJoints();
  const shared = mesh.listPrimitives()[0];
  const attribute = (semantic) => digest(shared.getAttribute(semantic));
  const { seed, algorithmVersion, options, blueprint } = root.getAsset().extras.creaturegen;
  return {
    seed,
    algorithmVersion,
    options: options ?? null,
    blueprintVersion: blueprint.version ?? null,
    roots: scene.listChildren().map((node) => node.getName()),
    skeleton: skin.getSkeleton()?.getName() ?? null,
    joints: joints.map((joint) => ({
      name: joint.getName(),
      parent: joint.getParentNode()?.getName() ?? null,
      translation: joint.getTranslation(),
      rotation: joint.getRotation(),
      scale: joint.getScale(),
      colliders: joint.getExtras().colliders?.length ?? 0,
    })),
    sockets: root.listNodes().filter((node) => node.getExtras().socket).map((node) => ({
      name: node.getName(),
      parent: node.getParentNode().getName(),
      children: node.listChildren().length,
      translation: node.getWorldTranslation(),
      width: node.getExtras().socket.width,
    })),
    limbs: joints[0].getExtras().limbs.map(({ kind, joints: names }) => ({ kind, joints: names })),
    mass: joints[0].getExtras().massProperties.mass,
    bindError: bindError(joints, skin.getInverseBindMatrices()),
    vertices: shared.getAttribute('POSITION').getCount(),
    min: shared.getAttribute('POSITION').getMin([]),
    max: shared.getAttribute('POSITION').getMax([]),
    attributes: shared.listSemantics().sort(),
    position: attribute('POSITION'),
    normal: attribute('NORMAL'),
    texcoord: attribute('TEXCOORD_0'),
    colour: attribute('COLOR_0'),
    joint: attribute('JOINTS_0'),
    weight: attribute('WEIGHTS_0'),
    parts: mesh.listPrimitives().map((part) => {
      if (part.getMode() !== TRIANGLES) throw new Error(`primitive of mode ${part.getMode()}; expected triangles`);
      if (part.getAttribute('POSITION') !== shared.getAttribute('POSITION')) throw new Error('the parts do not share their vertices');
      const material = part.getMaterial();
      return {
        material: material.getName(),
        doubleSided: material.getDoubleSided(),
        alphaMode: material.getAlphaMode(),
        baseColour: material.getBaseColorFactor(),
        metallic: material.getMetallicFactor(),
        index: digest(part.getIndices()),
      };
    }),
    materials: root.listMaterials().map((material) => material.getName()),
  };
}

/** Count, kind and sums of an accessor's stored numbers. */
function digest(accessor) {
  const array = accessor.getArray();
  const width = accessor.getElementSize();
  const sum = new Array(width).fill(0);
  const woven = new Array(width).fill(0);
  for (let i = 0; i < accessor.getCount(); i++) {
    for (let k = 0; k < width; k++) {
      sum[k] += array[i * width + k];
      woven[k] += ((i % 251) + 1) * array[i * width + k];
    }
  }
  return { count: accessor.getCount(), stored: array.constructor.name, normalized: accessor.getNormalized(), sum, woven };
}

/** The largest difference from identity of an entry of joint world matrix × inverse bind matrix. */
function bindError(joints, inverseBinds) {
  let worst = 0;
  joints.forEach((joint, j) => {
    const world = joint.getWorldMatrix();
    const inverse = inverseBinds.getElement(j, []);
    for (let column = 0; column < 4; column++) {
      for (let row = 0; row < 4; row++) {
        let entry = 0;
        for (let k = 0; k < 4; k++) entry += world[4 * k + row] * inverse[4 * column + k];
        worst = Math.max(worst, Math.abs(entry - (row === column ? 1 : 0)));
      }
    }
  });
  return worst;
}
