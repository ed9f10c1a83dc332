// Pictures that move: the frames of an animated PNG (the PNG specification, third edition), RGBA, packed by the browser's own deflate.

const signature = [137, 80, 78, 71, 13, 10, 26, 10];

const crcTable = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; k++) {
    n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  }
  return n;
});

function chunk(name, bytes) {
  const whole = new Uint8Array(12 + bytes.length);
  const view = new DataView(whole.buffer);
  view.setUint32(0, bytes.length);
  for (let i = 0; i < 4; i++) {
    whole[4 + i] = name.charCodeAt(i);
  }
  whole.set(bytes, 8);
  let crc = 0xffffffff;
  for (let i = 4; i < 8 + bytes.length; i++) {
    crc = crcTable[(crc ^ whole[i]) & 255] ^ (crc >>> 8);
  }
  view.setUint32(8 + bytes.length, ~crc >>> 0);
  return whole;
}

function numbers(...parts) {
  const bytes = new Uint8Array(parts.reduce((sum, [size]) => sum + size, 0));
  const view = new DataView(bytes.buffer);
  let at = 0;
  for (const [size, value] of parts) {
    ({ 1: () => view.setUint8(at, value), 2: () => view.setUint16(at, value), 4: () => view.setUint32(at, value) })[size]();
    at += size;
  }
  return bytes;
}

/** Each row by what changes from the row above. */
function filtered(pixels, width, height) {
  const row = 4 * width;
  const out = new Uint8Array(height * (row + 1));
  for (let y = 0; y < height; y++) {
    const to = y * (row + 1);
    out[to] = y ? 2 : 0;
    for (let x = 0; x < row; x++) {
      out[to + 1 + x] = y ? pixels[y * row + x] - pixels[(y - 1) * row + x] : pixels[x];
    }
  }
  return out;
}

const deflate = async bytes => new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(new CompressionStream('deflate'))).arrayBuffer());

/** An animated PNG without end of frames of RGBA, each shown for so many milliseconds. */
export async function animatedPng(frames, width, height, milliseconds) {
  const chunks = [
    Uint8Array.from(signature),
    chunk('IHDR', numbers([4, width], [4, height], [1, 8], [1, 6], [1, 0], [1, 0], [1, 0])),
    chunk('acTL', numbers([4, frames.length], [4, 0])),
  ];
  let sequence = 0;
  for (const [n, pixels] of frames.entries()) {
    const data = await deflate(filtered(pixels, width, height));
    chunks.push(chunk('fcTL', numbers([4, sequence++], [4, width], [4, height], [4, 0], [4, 0], [2, Math.round(milliseconds)], [2, 1000], [1, 0], [1, 0])));
    if (n === 0) {
      chunks.push(chunk('IDAT', data));
    } else {
      const numbered = new Uint8Array(4 + data.length);
      new DataView(numbered.buffer).setUint32(0, sequence++);
      numbered.set(data, 4);
      chunks.push(chunk('fdAT', numbered));
    }
  }
  chunks.push(chunk('IEND', new Uint8Array()));
  return new Uint8Array(await new Blob(chunks).arrayBuffer());
}
