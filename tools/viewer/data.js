// The page's data, from text to numbers. Positions become relative to the middle of the box, so
// that 32-bit floats hold them well wherever the world's origin is.

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/// Ranges [first, end) of points: how many to pass over, how many to take, and so on (LEB128).
function rangesOf(base64) {
  const numbers = [];
  let number = 0;
  let shift = 0;
  for (const byte of bytesOf(base64)) {
    number |= (byte & 0x7f) << shift;
    shift += 7;
    if (byte & 0x80) continue;
    numbers.push(number);
    [number, shift] = [0, 0];
  }
  const ranges = [];
  let at = 0;
  for (let i = 0; i < numbers.length; i += 2) {
    const first = at + numbers[i];
    at = first + numbers[i + 1];
    ranges.push([first, at]);
  }
  return ranges;
}

export function readData() {
  const data = JSON.parse(document.getElementById('data').textContent);
  const { lower, upper } = data.box;
  const middle = lower.map((x, a) => (x + upper[a]) / 2);
  const points = (base64) => {
    const shares = new Uint16Array(bytesOf(base64).buffer);
    const result = new Float32Array(shares.length);
    for (let i = 0; i < shares.length; ++i) {
      const a = i % 3;
      result[i] = lower[a] - middle[a] + ((upper[a] - lower[a]) * shares[i]) / 65535;
    }
    return result;
  };
  data.middle = middle;
  data.extent = Math.hypot(...upper.map((x, a) => x - lower[a])) || 1;
  data.mesh.points = points(data.mesh.positions);
  data.mesh.index = new Uint32Array(bytesOf(data.mesh.corners).buffer);
  data.mesh.pieces = data.mesh.pieces.map(([component, triangles, area]) => (
    { component, triangles, area }));
  const areas = new Map(data.mesh.pieces.map((piece) => [piece.component, piece.area]));
  data.volume.bytes = bytesOf(data.volume.values);
  for (const part of [data.mesh, data.volume]) {
    delete part.positions;
    delete part.corners;
    delete part.values;
  }
  data.loops.forEach((loop, number) => {
    loop.number = number;
    loop.pieceArea = areas.get(loop.component) ?? 0; // of one that is not drawn: less than all
    loop.size = loop.size === null ? Infinity : loop.size;
    loop.curves = loop.curves.map(points);
    if (loop.feature) loop.feature.points = rangesOf(loop.feature.points);
  });
  return data;
}

/// From voxel indices to the scene.
export function sceneOf(data, index) {
  return data.origin.map(
    (o, row) =>
      o - data.middle[row] +
      index.reduce((sum, i, axis) => sum + i * data.spacing[axis] * data.direction[axis][row], 0),
  );
}

/// The box of a loop in the scene: its middle and half its diagonal; and the axis of the volume
/// that is closest to upright on it.
export function frameOf(data, loop) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  const area = [0, 0, 0];
  for (const p of loop.curves) {
    for (let i = 0; i < p.length; i += 3) {
      const n = (i + 3) % p.length;
      for (let a = 0; a < 3; ++a) {
        low[a] = Math.min(low[a], p[i + a]);
        high[a] = Math.max(high[a], p[i + a]);
        const [b, c] = [(a + 1) % 3, (a + 2) % 3];
        area[a] += p[i + b] * p[n + c] - p[i + c] * p[n + b];
      }
    }
  }
  const across = data.direction.map((d) => Math.abs(d[0] * area[0] + d[1] * area[1] + d[2] * area[2]));
  return {
    middle: low.map((x, a) => (x + high[a]) / 2),
    radius: Math.hypot(...high.map((x, a) => x - low[a])) / 2,
    normal: area,
    axis: across.indexOf(Math.max(...across)),
  };
}
