// The page: the surface, the loops as tubes, a table that is linked with them, and a slice.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { frameOf, readData } from './data.js';
import { ScaleBar } from './scale.js';
import { Skin } from './skin.js';
import { Slice } from './slice.js';
import { LoopTable, length, point } from './table.js';
import { makeTubes } from './tubes.js';

const colours = { handle: '#00a028', tunnel: '#dc1414', loop: '#1e5ae6' };
const flightMilliseconds = 600;

const element = (id) => document.getElementById(id);
const dark = matchMedia('(prefers-color-scheme: dark)');
const still = matchMedia('(prefers-reduced-motion: reduce)');

function describe(data) {
  const { betti, surface } = data;
  const plural = (n, one, many) => `${n} ${n === 1 ? one : many}`;
  element('title').textContent = `${data.file.split(/[\\/]/).pop()}: ${data.inside}`;
  const counts = data.open
    ? [plural(betti.b0, 'piece', 'pieces'), plural(betti.b1, 'independent loop', 'independent loops')]
    : [plural(betti.b0, 'component', 'components'), plural(betti.b1, 'tunnel', 'tunnels'),
       plural(betti.b2, 'cavity', 'cavities')];
  const frame = data.frame === 'index' ? 'index \u00d7 spacing' : data.frame;
  const whole = data.left_out.pieces === 0 ? ' of the same topology' : '';
  const how = data.mesh.same_topology ? whole : ', without its smallest handles';
  const simplified = data.mesh.triangles < surface.triangles
    ? `, drawn with ${data.mesh.triangles}${how}` : '';
  element('counts').textContent =
    `${counts.join(', ')}; ${data.dims.join(' \u00d7 ')} ${data.type}, spacing ` +
    `${data.spacing.join(' ')}; world is ${frame}, lengths in ${data.unit || 'the unit of the spacing'}; ` +
    `surface of ${surface.triangles} triangles${simplified}`;
  element('left-out').textContent = leftOut(data);
}

/// What the page lacks, in a sentence.
function leftOut(data) {
  const { pieces, piece_area: area, loops, loop_size: size } = data.left_out;
  const parts = [];
  if (pieces > 0) {
    parts.push(`${pieces} of ${data.surface.components} pieces of the surface, ` +
               `of area ${length(area, data, '\u00b2')} and less`);
  }
  if (loops > 0) {
    parts.push(`${loops} of ${loops + data.loops.length} loops, ` +
               `of size ${length(size ?? Infinity, data)} and less`);
  }
  return parts.length === 0 ? '' : `Left out, being small: ${parts.join('; ')}.`;
}

class Viewer {
  constructor(data) {
    this.data = data;
    this.canvas = document.createElement('canvas');
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute(
      'aria-label', 'The surface and its loops. Arrow keys turn it, plus and minus zoom.');
    element('view').prepend(this.canvas);
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true });
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(35, 1, data.extent / 1000, data.extent * 20);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener('change', () => this.redraw());
    this.addLights();
    this.skin = new Skin(data);
    this.scene.add(this.skin.mesh);
    this.scaleBar = new ScaleBar(data, this.camera, this.controls);
    this.addTubes();
    this.slice = new Slice(data, this.scene, () => this.redraw());
    this.table = new LoopTable(data, (n) => this.choose(n));
    this.addEvents();
    this.applyFilter();
    this.setColours();
    this.resize();
    this.home(false);
  }

  addLights() {
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8890a0, 2.2));
    const lamp = new THREE.DirectionalLight(0xffffff, 1.6);
    lamp.position.set(-1, 1, 2);
    this.camera.add(lamp);
    this.scene.add(this.camera);
  }

  addTubes() {
    const voxel = Math.min(...this.data.spacing);
    const radius = Math.min(Math.max(0.0035 * this.data.extent, 0.2 * voxel), 2 * voxel);
    this.tubes = makeTubes(this.data, radius, colours);
    this.restMaterial = new THREE.MeshLambertMaterial({ vertexColors: true });
    this.rest = this.tubes.meshOf(this.restMaterial);
    this.chosenMesh = this.tubes.meshOf(
      new THREE.MeshLambertMaterial({ vertexColors: true, emissive: 0x303030 }));
    // The chosen loop shines through whatever hides it.
    this.ghost = this.tubes.meshOf(new THREE.MeshBasicMaterial({
      vertexColors: true, transparent: true, opacity: 0.4, depthTest: false, depthWrite: false,
    }));
    this.ghost.renderOrder = 3;
    this.scene.add(this.rest, this.chosenMesh, this.ghost);
  }

  addEvents() {
    const listen = (id, event, action) => element(id).addEventListener(event, action);
    for (const id of ['handles', 'tunnels']) listen(id, 'change', () => this.applyFilter());
    for (const id of ['least', 'most', 'piece']) listen(id, 'input', () => this.applyFilter());
    listen('opacity', 'input', () => this.paint());
    listen('features', 'change', () => this.paint());
    listen('home', 'click', () => { this.choose(undefined); this.home(true); });
    listen('shot', 'click', () => this.savePicture());
    dark.addEventListener('change', () => this.setColours());
    new ResizeObserver(() => this.resize()).observe(element('view'));
    let down = null;
    this.canvas.addEventListener('pointerdown', (e) => { down = [e.clientX, e.clientY]; });
    this.canvas.addEventListener('pointerup', (e) => {
      if (down && Math.hypot(e.clientX - down[0], e.clientY - down[1]) < 5) this.pick(e);
    });
    this.canvas.addEventListener('keydown', (e) => this.steer(e));
    document.addEventListener('keydown', (e) => {
      if (e.key === 'Escape') this.choose(undefined);
    });
    const sized = this.data.loops.map((l) => l.size).filter(Number.isFinite);
    this.largest = sized.reduce((a, b) => Math.max(a, b), 0);
    element('piece').closest('.row').hidden = this.data.mesh.pieces.length < 2;
    if (this.data.open) element('handles').closest('.row').hidden = true;
    element('features').closest('label').hidden = !this.data.loops.some((loop) => loop.feature);
  }

  /// Where a slider stands between 0 and `largest`; fine steps for small values.
  shareOf(id, largest) {
    return largest * (Number(element(id).value) / 1000) ** 3;
  }

  applyFilter() {
    const { data } = this;
    const least = this.shareOf('least', this.largest);
    const isEnd = element('most').value === element('most').max;
    const most = isEnd ? Infinity : this.shareOf('most', this.largest);
    const area = this.shareOf('piece', data.mesh.pieces[0]?.area ?? 0);
    element('least-value').textContent = length(least, data);
    element('most-value').textContent = isEnd ? 'any' : length(most, data);
    element('piece-value').textContent = length(area, data, '\u00b2');
    const wanted = { handle: element('handles').checked, tunnel: element('tunnels').checked, loop: true };
    this.visible = data.loops.filter((loop) => wanted[loop.kind] && loop.size >= least &&
                                               loop.size <= most && loop.pieceArea >= area);
    this.skin.showPieces(area);
    this.table.filter(this.visible);
    this.showTubes();
    this.tell();
  }

  showTubes() {
    const numbers = this.visible.map((loop) => loop.number);
    this.tubes.show(this.rest, numbers.filter((n) => n !== this.chosen));
    for (const mesh of [this.chosenMesh, this.ghost])
      this.tubes.show(mesh, numbers.filter((n) => n === this.chosen));
    const faded = this.chosen !== undefined;
    this.restMaterial.transparent = faded;
    this.restMaterial.opacity = faded ? 0.2 : 1;
    this.restMaterial.depthWrite = !faded;
    this.restMaterial.needsUpdate = true;
    this.paint();
  }

  paint() {
    const share = Number(element('opacity').value) / 100;
    element('opacity-value').textContent = `${Math.round(100 * share)} %`;
    this.skin.paint(element('features').checked ? this.visible : [], this.chosen, share);
    this.redraw();
  }

  setColours() {
    this.scene.background = new THREE.Color(dark.matches ? 0x16181c : 0xffffff);
    this.redraw();
  }

  tell() {
    const { loops, found, decimals } = this.data;
    const loop = loops[this.chosen];
    if (loop) {
      element('status').textContent =
        `${loop.kind} loop ${loop.id}: size ${length(loop.size, this.data)}, length ` +
        `${length(loop.length, this.data)}, at ${point(loop.world, decimals)}` +
        (loop.feature ? `, ${length(loop.feature.depth, this.data)} deep, ` +
          `${length(loop.feature.thickness, this.data)} thick` : '') +
        (loop.fix === 'none' ? '' : `; ${loop.fix} along it to remove the ${loop.kind}`);
    } else if (loops.length === 0) {
      element('status').textContent = found === 0 ? 'There are no loops: no handle, no tunnel.'
                                                  : `None of ${found} loops is reported.`;
    } else {
      element('status').textContent = `${this.visible.length} of ${found} loops shown`;
    }
  }

  /// Chooses the loop with this number, or none, and flies to it.
  choose(chosen) {
    this.chosen = chosen;
    this.table.mark(chosen);
    this.showTubes();
    this.tell();
    if (chosen === undefined) return;
    const loop = this.data.loops[chosen];
    const frame = frameOf(this.data, loop);
    this.slice.moveTo(loop, frame.axis);
    const target = new THREE.Vector3(...frame.middle);
    // From where the camera is, but never within 30 degrees of the loop's own plane.
    const away = this.camera.position.clone().sub(this.controls.target).normalize();
    const normal = new THREE.Vector3(...frame.normal).normalize();
    if (normal.dot(away) < 0) normal.negate();
    if (normal.lengthSq() > 0 && normal.dot(away) < 0.5) away.add(normal).normalize();
    const distance = Math.max(6 * frame.radius, 0.2 * this.data.extent);
    this.fly(target, target.clone().addScaledVector(away, distance));
  }

  home(animated) {
    const away = new THREE.Vector3(0.75, 0.45, 0.48).normalize();
    const fit = Math.min(1, this.camera.aspect);
    const distance = (0.56 * this.data.extent) / Math.tan((this.camera.fov * Math.PI) / 360) / fit;
    this.fly(new THREE.Vector3(), away.multiplyScalar(distance), animated);
  }

  fly(target, position, animated = true) {
    cancelAnimationFrame(this.flight);
    const from = [this.controls.target.clone(), this.camera.position.clone()];
    const start = performance.now();
    const step = (now) => {
      const share = animated && !still.matches ? Math.min((now - start) / flightMilliseconds, 1) : 1;
      const eased = Math.max(0, share * share * (3 - 2 * share));
      this.controls.target.lerpVectors(from[0], target, eased);
      this.camera.position.lerpVectors(from[1], position, eased);
      this.controls.update();
      this.redraw();
      if (share < 1) this.flight = requestAnimationFrame(step);
    };
    step(start);
    if (!animated || still.matches) return;
    this.flight = requestAnimationFrame(step);
  }

  steer(event) {
    const turn = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    const zoom = { '+': 0.85, '=': 0.85, '-': 1 / 0.85 }[event.key];
    if (!turn && !zoom) return;
    event.preventDefault();
    const arm = this.camera.position.clone().sub(this.controls.target);
    if (turn) {
      const away = new THREE.Spherical().setFromVector3(new THREE.Vector3(arm.x, arm.z, -arm.y));
      away.theta += 0.12 * turn[0];
      away.phi += 0.12 * turn[1];
      away.makeSafe();
      const v = new THREE.Vector3().setFromSpherical(away);
      arm.set(v.x, -v.z, v.y);
    } else {
      arm.multiplyScalar(zoom);
    }
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
  }

  pick(event) {
    const box = this.canvas.getBoundingClientRect();
    const at = new THREE.Vector2(
      (2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(at, this.camera);
    const hits = ray.intersectObjects([this.rest, this.chosenMesh].filter((m) => m.visible));
    if (hits.length === 0) return;
    this.choose(this.tubes.loopOf(hits[0].object, hits[0].faceIndex));
  }

  savePicture() {
    this.draw();
    this.canvas.toBlob((blob) => {
      const link = document.createElement('a');
      link.href = URL.createObjectURL(blob);
      link.download = 'isoloop.png';
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    });
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = element('view');
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  redraw() {
    if (this.pending) return;
    this.pending = requestAnimationFrame(() => this.draw());
  }

  draw() {
    cancelAnimationFrame(this.pending);
    this.pending = 0;
    this.renderer.render(this.scene, this.camera);
    this.scaleBar.update(this.canvas.clientHeight);
    this.firstPicture ??= performance.now();
  }

  /// What is to be seen, for tests.
  get state() {
    return {
      tubes: [this.rest, this.chosenMesh].flatMap((m) => (m.visible ? m.userData.loops : [])).length,
      camera: this.camera.position.toArray(),
      chosen: this.chosen,
      firstPicture: this.firstPicture,
    };
  }
}

const data = readData();
describe(data);
try {
  window.isoloop = new Viewer(data);
} catch (error) {
  element('message').textContent = `No picture: ${error.message}. The table needs none.`;
  const table = new LoopTable(data, (chosen) => table.mark(chosen));
  table.filter(data.loops);
}
if (data.surface.triangles === 0) element('message').textContent = 'There is no surface at this iso value.';
