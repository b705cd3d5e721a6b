// The surface's colours: grey, and the features of the loops that are shown tinted.
import * as THREE from 'three';

const grey = new THREE.Color(0x9aa3b2);
const tints = { handle: new THREE.Color(0x8fdba4), tunnel: new THREE.Color(0xf2a39d) };
const strong = { handle: new THREE.Color(0x1fb455), tunnel: new THREE.Color(0xe5433b) };

export class Skin {
  constructor(data) {
    this.data = data;
    const count = data.mesh.points.length / 3;
    this.colours = new THREE.BufferAttribute(new Uint8Array(4 * count), 4, true);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(data.mesh.points, 3));
    geometry.setAttribute('color', this.colours);
    geometry.setIndex(new THREE.BufferAttribute(data.mesh.index, 1));
    geometry.computeVertexNormals();
    this.geometry = geometry;
    this.material = new THREE.MeshLambertMaterial({
      vertexColors: true, transparent: true, depthWrite: false, side: THREE.DoubleSide,
    });
    this.mesh = new THREE.Mesh(geometry, this.material);
    this.mesh.renderOrder = 2; // over the tubes: it is see-through
  }

  /// Shows the pieces whose area is `least` or more; they come the largest first.
  showPieces(least) {
    let triangles = 0;
    for (const piece of this.data.mesh.pieces) {
      if (piece.area < least) break;
      triangles += piece.triangles;
    }
    this.geometry.setDrawRange(0, 3 * triangles);
  }

  /// Tints the features of these loops; where they overlap, the shortest loop's is seen. `opacity`:
  /// of what is grey, 0 to 1; what is tinted is less see-through, a chosen feature least.
  paint(loops, chosen, opacity) {
    this.mesh.visible = opacity > 0;
    this.material.depthWrite = opacity > 0.95;
    const pixels = new Uint32Array(this.colours.array.buffer); // four bytes each
    const pixelOf = (colour, alpha) => {
      const rgba = [...colour.toArray(), alpha].map((x) => Math.round(255 * x));
      return new Uint32Array(new Uint8Array(rgba).buffer)[0];
    };
    pixels.fill(pixelOf(grey, opacity));
    const shown = chosen === undefined ? [...loops].sort((a, b) => b.length - a.length)
                                       : loops.filter((loop) => loop.number === chosen);
    const [colours, alpha] = chosen === undefined ? [tints, opacity ** 0.8] : [strong, opacity ** 0.5];
    for (const loop of shown) {
      if (!loop.feature) continue;
      const pixel = pixelOf(colours[loop.kind], alpha);
      for (const range of loop.feature.points) pixels.fill(pixel, ...range);
    }
    this.colours.needsUpdate = true;
  }
}
