// All loops as tubes in one mesh: attributes once, triangles of the visible loops by ranges.
import * as THREE from 'three';

function sidesFor(points) {
  return points < 30000 ? 8 : points < 120000 ? 5 : 3;
}

export function makeTubes(data, radius, colours) {
  let count = 0;
  for (const loop of data.loops) for (const curve of loop.curves) count += curve.length / 3;
  const sides = sidesFor(count);
  const position = new Float32Array(3 * sides * count);
  const normal = new Float32Array(3 * sides * count);
  const colour = new Float32Array(3 * sides * count);
  const triangles = new Uint32Array(6 * sides * count);
  const ranges = []; // of each loop, in triangles
  let ring = 0; // rings so far
  let corner = 0; // corners of triangles so far
  const tangent = new THREE.Vector3();
  const side = new THREE.Vector3();
  const up = new THREE.Vector3();
  const last = new THREE.Vector3();
  const out = new THREE.Vector3();
  const paint = new THREE.Color();

  const addCurve = (p) => {
    const n = p.length / 3;
    last.set(0.31, 0.52, 0.79);
    for (let i = 0; i < n; ++i, ++ring) {
      const [before, after] = [3 * ((i + n - 1) % n), 3 * ((i + 1) % n)];
      tangent.set(p[after] - p[before], p[after + 1] - p[before + 1], p[after + 2] - p[before + 2]);
      if (tangent.lengthSq() === 0) tangent.set(1, 0, 0);
      tangent.normalize();
      side.copy(last).addScaledVector(tangent, -last.dot(tangent));
      if (side.lengthSq() < 1e-12) side.set(-tangent.y, tangent.x, tangent.z + 1).cross(tangent);
      side.normalize();
      last.copy(side);
      up.crossVectors(tangent, side);
      for (let k = 0; k < sides; ++k) {
        const angle = (2 * Math.PI * k) / sides;
        out.copy(side).multiplyScalar(Math.cos(angle)).addScaledVector(up, Math.sin(angle));
        const at = 3 * (ring * sides + k);
        for (let a = 0; a < 3; ++a) {
          normal[at + a] = out.getComponent(a);
          position[at + a] = p[3 * i + a] + radius * out.getComponent(a);
        }
        paint.toArray(colour, at);
      }
    }
    // The last ring is turned against the first: each of its corners joins the closest one.
    const first = ring - n;
    let turn = 0;
    let best = Infinity;
    for (let k = 0; k < sides; ++k) {
      let distance = 0;
      for (let a = 0; a < 3; ++a) {
        distance += (normal[3 * ((ring - 1) * sides) + a] - normal[3 * (first * sides + k) + a]) ** 2;
      }
      if (distance < best) [best, turn] = [distance, k];
    }
    for (let i = 0; i < n; ++i) {
      const here = (first + i) * sides;
      const next = i + 1 === n ? first * sides : here + sides;
      const shift = i + 1 === n ? turn : 0;
      for (let k = 0; k < sides; ++k) {
        const l = (k + 1) % sides;
        const [a, b] = [here + k, here + l];
        const [c, d] = [next + ((k + shift) % sides), next + ((l + shift) % sides)];
        triangles.set([a, b, d, a, d, c], corner);
        corner += 6;
      }
    }
  };

  for (const loop of data.loops) {
    const start = corner;
    paint.set(colours[loop.kind]);
    for (const curve of loop.curves) addCurve(curve);
    ranges.push([start, corner]);
  }

  const attributes = {
    position: new THREE.BufferAttribute(position, 3),
    normal: new THREE.BufferAttribute(normal, 3),
    color: new THREE.BufferAttribute(colour, 3),
  };
  const sphere = new THREE.Sphere(new THREE.Vector3(), data.extent);
  const meshOf = (material) => {
    const geometry = new THREE.BufferGeometry();
    for (const name of Object.keys(attributes)) geometry.setAttribute(name, attributes[name]);
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(0), 1));
    geometry.boundingSphere = sphere;
    const mesh = new THREE.Mesh(geometry, material);
    mesh.renderOrder = 1;
    mesh.userData.loops = []; // the number of the loop, and where its triangles end
    return mesh;
  };

  /// Shows these loops, given by their numbers, in a mesh of meshOf().
  const show = (mesh, numbers) => {
    let length = 0;
    for (const number of numbers) length += ranges[number][1] - ranges[number][0];
    const index = new Uint32Array(length);
    mesh.userData.loops = [];
    let at = 0;
    for (const number of numbers) {
      index.set(triangles.subarray(...ranges[number]), at);
      at += ranges[number][1] - ranges[number][0];
      mesh.userData.loops.push([number, at]);
    }
    mesh.geometry.dispose();
    mesh.geometry.setIndex(new THREE.BufferAttribute(index, 1));
    mesh.visible = length > 0;
  };

  /// The loop that a triangle of the mesh belongs to.
  const loopOf = (mesh, face) => mesh.userData.loops.find(([, end]) => 3 * face < end)[0];

  return { meshOf, show, loopOf };
}
