// A bar that says how long lengths are at the distance of what the camera turns about.

const widestBar = 130; // pixels

/// The largest of 1, 2 and 5 times a power of ten that is no more than `most`.
export function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  const digit = [5, 2, 1].find((d) => d * power <= most * (1 + 1e-9));
  return digit * power;
}

export class ScaleBar {
  constructor(data, camera, controls) {
    this.data = data;
    this.camera = camera;
    this.controls = controls;
    this.box = document.getElementById('scale');
    this.bar = document.getElementById('scale-bar');
    this.text = document.getElementById('scale-text');
    this.box.hidden = false;
  }

  update(height) {
    const distance = this.camera.position.distanceTo(this.controls.target);
    const tall = 2 * distance * Math.tan((this.camera.fov * Math.PI) / 360); // world, top to bottom
    if (!(tall > 0) || !(height > 0)) return;
    const length = roundLength((widestBar * tall) / height);
    this.bar.style.width = `${(length * height) / tall}px`;
    const digits = Math.max(0, -Math.floor(Math.log10(length)));
    this.text.textContent = `${length.toFixed(digits)} ${this.data.unit}`.trim();
  }
}
