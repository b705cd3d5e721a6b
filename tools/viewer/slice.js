// One slice through the volume, in the scene and as a picture of its own.
import * as THREE from 'three';
import { sceneOf } from './data.js';

export class Slice {
  constructor(data, scene, redraw) {
    this.data = data;
    this.redraw = redraw;
    this.picture = document.getElementById('picture');
    this.controls = Object.fromEntries(
      ['sliced', 'axis', 'layer', 'layer-value'].map((id) => [id, document.getElementById(id)]),
    );
    this.material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide });
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material);
    this.mesh.visible = false;
    scene.add(this.mesh);
    this.controls.sliced.addEventListener('change', () => this.update());
    this.controls.axis.addEventListener('change', () => {
      this.setLayer(this.index[Number(this.controls.axis.value)]);
    });
    this.controls.layer.addEventListener('input', () => {
      this.index[Number(this.controls.axis.value)] = Number(this.controls.layer.value);
      this.update();
    });
    this.index = data.dims.map((n) => Math.floor(n / 2)); // voxel that the slice runs through
    this.controls.axis.value = '2';
    this.setLayer(this.index[2]);
  }

  /// Puts the slice across the loop.
  moveTo(loop, axis) {
    this.index = loop.index.map((x, a) => Math.min(Math.max(Math.round(x), 0), this.data.dims[a] - 1));
    this.controls.axis.value = String(axis);
    this.controls.sliced.checked = true;
    this.setLayer(this.index[axis]);
  }

  setLayer(layer) {
    this.controls.layer.max = String(this.data.dims[Number(this.controls.axis.value)] - 1);
    this.controls.layer.value = String(layer);
    this.update();
  }

  update() {
    const axis = Number(this.controls.axis.value);
    const layer = Number(this.controls.layer.value);
    this.controls['layer-value'].textContent = `${'ijk'[axis]} = ${layer}`;
    this.mesh.visible = this.controls.sliced.checked;
    this.draw(axis, layer);
    this.place(axis, layer);
    this.redraw();
  }

  /// Grey values; what is inside stands out by its tint.
  draw(axis, layer) {
    const { dims, block, bytes, iso_share: iso } = this.data.volume;
    const [u, v] = [0, 1, 2].filter((a) => a !== axis);
    const stride = [1, dims[0], dims[0] * dims[1]];
    const start = Math.min(Math.floor(layer / block), dims[axis] - 1) * stride[axis];
    const below = this.data.inside.includes('<');
    const image = new ImageData(dims[u], dims[v]);
    for (let y = 0; y < dims[v]; ++y) {
      for (let x = 0; x < dims[u]; ++x) {
        const value = bytes[start + x * stride[u] + y * stride[v]];
        const inside = below ? value <= 255 * iso : value >= 255 * iso;
        const at = 4 * (x + dims[u] * y);
        image.data.set(inside ? [value * 0.6 + 90, value * 0.6 + 75, value * 0.6 + 30, 255]
                              : [value, value, value, 255], at);
      }
    }
    this.picture.width = dims[u];
    this.picture.height = dims[v];
    this.picture.getContext('2d').putImageData(image, 0, 0);
    this.material.map?.dispose();
    const texture = new THREE.DataTexture(new Uint8Array(image.data.buffer), dims[u], dims[v]);
    texture.colorSpace = THREE.SRGBColorSpace;
    texture.magFilter = THREE.NearestFilter;
    texture.needsUpdate = true;
    this.material.map = texture;
    this.material.needsUpdate = true;
  }

  place(axis, layer) {
    const { dims, block } = this.data.volume;
    const [u, v] = [0, 1, 2].filter((a) => a !== axis);
    const corner = (x, y) => {
      const index = [0, 0, 0];
      index[axis] = layer;
      index[u] = x * dims[u] * block - 0.5;
      index[v] = y * dims[v] * block - 0.5;
      return sceneOf(this.data, index);
    };
    const corners = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(corners.flat(), 3));
    geometry.setAttribute('uv', new THREE.Float32BufferAttribute([0, 0, 1, 0, 1, 1, 0, 1], 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
  }
}
