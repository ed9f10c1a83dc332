import { Box3, BufferAttribute, BufferGeometry, DataTexture, DetachedBindMode, DoubleSide, Bone, FrontSide, Group, LinearFilter, LinearMipmapLinearFilter, Matrix4, MeshStandardMaterial, NoColorSpace, RGBAFormat, Skeleton, SkinnedMesh, Sphere, SRGBColorSpace, Vector3 } from 'three';

/** The parts of a mesh as the library packs it: views of one buffer. */
export function readMesh(buffer, offset = 0) {
  const [vertices, indices, joints, skinIndices, indexBytes, hasTangents] = new Int32Array(buffer, offset, 8);
  let at = offset + 32;
  const take = (Type, count) => {
    const part = new Type(buffer, at, count);
    at += part.byteLength;
    return part;
  };
  return {
    joints,
    indices,
    skinIndices,
    positions: take(Float32Array, 3 * vertices),
    normals: take(Float32Array, 3 * vertices),
    texcoords: take(Float32Array, 2 * vertices),
    tangents: hasTangents ? take(Float32Array, 4 * vertices) : null,
    colours: take(Uint16Array, 4 * vertices),
    skinJoints: take(Uint8Array, 4 * vertices),
    skinWeights: take(Uint8Array, 4 * vertices),
    parents: take(Int32Array, joints),
    restPositions: take(Float32Array, 3 * joints),
    index: take(indexBytes === 2 ? Uint16Array : Uint32Array, indices),
  };
}

function geometryOf(mesh) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(mesh.normals, 3));
  geometry.setAttribute('uv', new BufferAttribute(mesh.texcoords, 2));
  if (mesh.tangents) {
    geometry.setAttribute('tangent', new BufferAttribute(mesh.tangents, 4));
  }
  geometry.setAttribute('tint', new BufferAttribute(mesh.colours, 4, true));
  geometry.setAttribute('skinIndex', new BufferAttribute(mesh.skinJoints, 4));
  geometry.setAttribute('skinWeight', new BufferAttribute(mesh.skinWeights, 4, true));
  geometry.setIndex(new BufferAttribute(mesh.index, 1));
  geometry.addGroup(0, mesh.skinIndices, 0);
  if (mesh.indices > mesh.skinIndices) {
    geometry.addGroup(mesh.skinIndices, mesh.indices - mesh.skinIndices, 1);
  }
  geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
  return geometry;
}

// Colours of vertices where there is no texture, and where a vertex keeps its own under one; a soft rim of skylight on top.
function dress(material, textured) {
  material.userData.flat = { value: 0 };
  material.onBeforeCompile = shader => {
    shader.uniforms.flatly = material.userData.flat;
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nattribute vec4 tint;\nvarying vec4 vTint;')
      .replace('#include <begin_vertex>', '#include <begin_vertex>\nvTint = tint;');
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', '#include <common>\nvarying vec4 vTint;\nuniform float flatly;')
      .replace('#include <map_fragment>', textured ? '#include <map_fragment>\ndiffuseColor.rgb = mix(diffuseColor.rgb, vTint.rgb, max(flatly, step(0.5, vTint.a)));' : 'diffuseColor.rgb = vTint.rgb;')
      .replace(
        '#include <opaque_fragment>',
        `float rim = pow(1.0 - saturate(dot(normalize(vViewPosition), normal)), 3.0);
        outgoingLight += (0.5 * diffuseColor.rgb + 0.06) * rim * (0.35 + 0.65 * saturate(normal.y * 0.5 + 0.5));
        #include <opaque_fragment>`,
      );
  };
  material.customProgramCacheKey = () => (textured ? 'textured' : 'tinted');
  return material;
}

function textureOf(pixels, size, colourSpace) {
  const texture = new DataTexture(pixels, size, size, RGBAFormat);
  texture.colorSpace = colourSpace;
  texture.generateMipmaps = true;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.magFilter = LinearFilter;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  return texture;
}

/** A creature as it is drawn. No bone of it is ever moved: the library's matrices go straight to the texture of bones. */
export class Body {
  #middle = null;

  constructor(mesh) {
    this.group = new Group();
    this.#take(mesh);
  }

  /** The least that is drawn as creatures are: one triangle of skin, without a place. */
  static sample() {
    const vertices = 3;
    const floats = count => new Float32Array(count * vertices);
    const body = new Body({
      joints: 1, indices: vertices, skinIndices: vertices, positions: floats(3), normals: floats(3), texcoords: floats(2), tangents: null, colours: new Uint16Array(4 * vertices),
      skinJoints: new Uint8Array(4 * vertices), skinWeights: new Uint8Array(4 * vertices), index: new Uint16Array([0, 1, 2]),
    });
    // Not all have what is seen from both sides.
    body.skin.material.pop();
    return body;
  }

  get joints() {
    return this.mesh.joints;
  }

  /** The same creature with the texture of its atlas: a mesh that is cut along the atlas's seams, then base colour and normals. */
  texture(mesh, pixels, size) {
    const bytes = 4 * size * size;
    this.textures = [textureOf(new Uint8Array(pixels.buffer, pixels.byteOffset, bytes), size, SRGBColorSpace), textureOf(new Uint8Array(pixels.buffer, pixels.byteOffset + bytes, bytes), size, NoColorSpace)];
    const pose = this.skeleton.boneMatrices.slice();
    this.#drop();
    this.#take(mesh);
    this.skeleton.boneMatrices.set(pose);
    this.skeleton.boneTexture.needsUpdate = true;
  }

  /** A pose: sixteen numbers for each joint. */
  pose(matrices) {
    this.skeleton.boneMatrices.set(matrices);
    this.skeleton.boneTexture.needsUpdate = true;
  }

  /** A pose between two others. */
  blend(from, to, share) {
    const { boneMatrices, boneTexture } = this.skeleton;
    for (let i = 0; i < to.length; i++) {
      boneMatrices[i] = from[i] + (to[i] - from[i]) * share;
    }
    boneTexture.needsUpdate = true;
  }

  /** Where the middle of the creature is now, as if it were at rest. */
  middle() {
    this.#middle ??= new Box3().setFromArray(this.mesh.positions).getCenter(new Vector3());
    return this.#middle.clone().applyQuaternion(this.group.quaternion).add(this.group.position);
  }

  /** Where a point of the creature at rest is now, in its own space. */
  carry(joint, point) {
    return point.applyMatrix4(scratch.fromArray(this.skeleton.boneMatrices, 16 * joint));
  }

  /** Takes a coarser level: how many of its indices are of the skin, then the indices. */
  coarsen(numbers) {
    const fine = this.skin.geometry;
    const coarse = new BufferGeometry();
    for (const [name, attribute] of Object.entries(fine.attributes)) {
      coarse.setAttribute(name, attribute);
    }
    const indices = numbers.subarray(1);
    coarse.setIndex(new BufferAttribute(fine.attributes.position.count > 65535 ? Uint32Array.from(indices) : Uint16Array.from(indices), 1));
    coarse.addGroup(0, numbers[0], 0);
    coarse.addGroup(numbers[0], indices.length - numbers[0], 1);
    coarse.boundingSphere = fine.boundingSphere;
    this.levels = [fine, coarse];
  }

  /** Shows the coarse level while it is far, if there is one. */
  set far(on) {
    if (this.levels) {
      this.skin.geometry = this.levels[on ? 1 : 0];
    }
  }

  get triangles() {
    return this.skin.geometry.index.count / 3;
  }

  set wireframe(on) {
    for (const material of this.skin.material) {
      material.wireframe = on;
    }
  }

  /** Without its texture, facet by facet, in the colours of its vertices. */
  set flat(on) {
    for (const material of this.skin.material) {
      if (material.flatShading !== on) {
        material.flatShading = on;
        material.needsUpdate = true;
      }
      material.userData.flat.value = on ? 1 : 0;
    }
  }

  dispose() {
    this.#drop();
    this.textures?.forEach(texture => texture.dispose());
    this.group.removeFromParent();
  }

  #take(mesh) {
    this.mesh = mesh;
    const bones = Array.from({ length: mesh.joints }, () => new Bone());
    this.skeleton = new Skeleton(bones);
    this.skeleton.update = () => {};
    this.skeleton.computeBoneTexture();
    const one = new Matrix4();
    for (let i = 0; i < mesh.joints; i++) {
      one.toArray(this.skeleton.boneMatrices, 16 * i);
    }
    const [map, normalMap] = this.textures ?? [];
    const look = { roughness: 0.74, metalness: 0, ...(map && { map, normalMap }) };
    const materials = [dress(new MeshStandardMaterial({ ...look, side: FrontSide }), !!map), dress(new MeshStandardMaterial({ ...look, side: DoubleSide }), !!map)];
    materials[1].shadowSide = DoubleSide;
    this.skin = new SkinnedMesh(geometryOf(mesh), materials);
    this.skin.bindMode = DetachedBindMode;
    this.skin.bind(this.skeleton, one);
    this.skin.frustumCulled = false;
    this.skin.castShadow = true;
    this.skin.receiveShadow = true;
    this.group.add(this.skin);
  }

  #drop() {
    this.group.remove(this.skin);
    this.skin.geometry.dispose();
    this.levels?.forEach(geometry => geometry.dispose());
    this.levels = null;
    this.skin.material.forEach(material => material.dispose());
    this.skeleton.dispose();
  }
}

const scratch = new Matrix4();
