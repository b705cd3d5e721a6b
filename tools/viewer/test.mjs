// Promises of the page, kept in headless Chromium. Run by tests/viewer_test.
//   node test.mjs ISOLOOP FOLDER_OF_VOLUMES
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import puppeteer from 'puppeteer-core';

const [isoloop, volumes] = process.argv.slice(2).map((path) => resolve(path));
const work = mkdtempSync(join(tmpdir(), 'isoloop-viewer-'));
const engine = join(volumes, 'engine_256x256x128_uint8.raw');
const patience = { timeout: 240000 };

const run = (...words) => execFileSync(isoloop, words, { cwd: work, stdio: ['ignore', 'ignore', 'pipe'] });

const browser = await puppeteer.launch({
  executablePath: '/usr/bin/chromium',
  protocolTimeout: patience.timeout,
  args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-gl=angle', '--use-angle=swiftshader',
         '--enable-unsafe-swiftshader'],
});

/// Opens a page from disk, without a network. `trouble`: what it complains of.
async function open(file, { width = 1200, height = 800, dark = false } = {}) {
  const page = await browser.newPage();
  const trouble = [];
  page.on('console', (m) => { if (['error', 'warn'].includes(m.type())) trouble.push(m.text()); });
  page.on('pageerror', (e) => trouble.push(e.message));
  page.on('request', (r) => { if (!/^(file|data|blob):/.test(r.url())) trouble.push(r.url()); });
  await page.setViewport({ width, height });
  await page.emulateMediaFeatures([
    { name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' },
    { name: 'prefers-reduced-motion', value: 'reduce' },
  ]);
  await page.goto(`file://${join(work, file)}`, { waitUntil: 'load', ...patience });
  await page.waitForFunction(() => window.isoloop?.state.firstPicture, patience);
  return { page, trouble };
}

const state = (page) => page.evaluate(() => window.isoloop.state);

/// How many pixels of the picture are green, red, blue, and how bright its background is.
const pixels = (page) => page.evaluate(() => {
  const viewer = window.isoloop;
  viewer.draw();
  const { width, height } = viewer.canvas;
  const copy = new OffscreenCanvas(width, height).getContext('2d');
  copy.drawImage(viewer.canvas, 0, 0);
  const { data } = copy.getImageData(0, 0, width, height);
  const count = { green: 0, red: 0, grey: 0, other: 0, corner: data[0] };
  for (let i = 0; i < data.length; i += 4) {
    const [r, g, b] = [data[i], data[i + 1], data[i + 2]];
    if (g > r + 50 && g > b + 50) ++count.green;
    else if (r > g + 60 && r > b + 60) ++count.red;
    else if (Math.abs(r - data[0]) + Math.abs(g - data[1]) + Math.abs(b - data[2]) > 24) ++count.grey;
    else ++count.other;
  }
  return count;
});

/// How many pixels of the picture lean to green, and how many to red, as tinted surfaces do, and how
/// far in the mean; the tubes' pixels are left out.
const tinted = (page) => page.evaluate(() => {
  const viewer = window.isoloop;
  const tubes = [viewer.rest, viewer.chosenMesh, viewer.ghost];
  const seen = tubes.map((mesh) => mesh.visible);
  for (const mesh of tubes) mesh.visible = false;
  viewer.draw();
  const { width, height } = viewer.canvas;
  const copy = new OffscreenCanvas(width, height).getContext('2d');
  copy.drawImage(viewer.canvas, 0, 0);
  tubes.forEach((mesh, i) => { mesh.visible = seen[i]; });
  const { data } = copy.getImageData(0, 0, width, height);
  const count = { green: 0, red: 0 };
  const sum = { green: 0, red: 0 };
  for (let i = 0; i < data.length; i += 4) {
    const [r, g, b] = [data[i], data[i + 1], data[i + 2]];
    const lean = g > r + 8 && g > b + 8 ? 'green' : r > g + 8 && r > b + 8 ? 'red' : null;
    if (!lean) continue;
    ++count[lean];
    sum[lean] += Math.abs(r - g);
  }
  const mean = (lean) => sum[lean] / Math.max(count[lean], 1);
  return { ...count, lean: { green: mean('green'), red: mean('red') } };
});

const moved = (a, b) => Math.hypot(...a.camera.map((x, i) => x - b.camera[i]));

const tests = {
  async 'a torus has a green loop and a red one, in the picture too'() {
    run('generate', 'torus', '--size', '48', '-o', 'torus.nrrd');
    run('view', 'torus.nrrd', '--inside', 'below', '--iso', '0', '-o', 'torus.html');
    const { page, trouble } = await open('torus.html');
    assert.equal((await state(page)).tubes, 2);
    const isSeen = (id) => page.$eval(id, (e) => e.closest('.row').getClientRects().length > 0);
    assert.ok(await isSeen('#least') && !await isSeen('#piece'), 'there is one piece alone');
    const all = await pixels(page);
    assert.ok(all.green > 200 && all.red > 200 && all.grey > 5000, JSON.stringify(all));
    assert.ok(all.corner > 240, 'light');
    await page.click('#handles');
    const tunnels = await pixels(page);
    assert.equal((await state(page)).tubes, 1);
    assert.equal(tunnels.green, 0);
    assert.ok(tunnels.red > 200);
    await page.click('#tunnels');
    const none = await pixels(page);
    assert.equal((await state(page)).tubes, 0);
    assert.equal(none.red, 0);
    assert.ok(none.grey > 5000, 'the surface is still there');
    assert.deepEqual(trouble, []);
  },

  async 'a click on a row flies to its loop, and a click on a loop finds its row'() {
    const { page, trouble } = await open('torus.html');
    const before = await state(page);
    const rows = await page.$$('#rows tr');
    assert.equal(rows.length, 2);
    await rows[0].click();
    const after = await state(page);
    assert.ok(moved(before, after) > 5, 'the camera moves');
    assert.equal(await page.$eval('#rows tr[aria-selected=true]', (r) => r.rowIndex), 1);
    assert.match(await page.$eval('#status', (p) => p.textContent), /^handle loop 1: size /);
    assert.ok((await pixels(page)).green > 500);
    // From here the loop's own middle point is in the middle of the picture: click beside it.
    const spot = await page.evaluate(() => {
      const viewer = window.isoloop;
      viewer.choose(undefined);
      const curve = viewer.data.loops[0].curves[0];
      const p = viewer.camera.position.clone().fromArray(curve, 0).project(viewer.camera);
      const box = viewer.canvas.getBoundingClientRect();
      return [box.left + ((p.x + 1) / 2) * box.width, box.top + ((1 - p.y) / 2) * box.height];
    });
    assert.equal((await state(page)).chosen, undefined);
    await page.mouse.click(...spot);
    assert.equal((await state(page)).chosen, 0);
    await page.keyboard.press('Escape');
    assert.equal((await state(page)).chosen, undefined);
    assert.deepEqual(trouble, []);
  },

  async 'the slider of the least size takes small loops away'() {
    const { page } = await open('torus.html');
    const rows = () => page.$$eval('#rows tr', (r) => r.length);
    assert.equal(await rows(), 2);
    await page.$eval('#least', (e) => { e.value = '1000'; e.dispatchEvent(new Event('input')); });
    assert.equal(await rows(), (await state(page)).tubes);
    assert.equal(await rows(), 1);
  },

  async 'the slider of the largest size takes large loops away'() {
    const { page } = await open('torus.html');
    const ids = () => page.$$eval('#rows tr', (rows) => rows.map((r) => r.cells[0].textContent));
    const before = await ids();
    await page.$eval('#most', (e) => { e.value = '999'; e.dispatchEvent(new Event('input')); });
    const after = await ids();
    assert.equal(after.length, 1);
    await page.$eval('#least', (e) => { e.value = '1000'; e.dispatchEvent(new Event('input')); });
    assert.equal((await ids()).length, 0);
    await page.$eval('#most', (e) => { e.value = '1000'; e.dispatchEvent(new Event('input')); });
    assert.deepEqual([...after, ...await ids()].sort(), before.sort());
  },

  async 'a bar says how long lengths are, in the unit of the file'() {
    const { page } = await open('torus.html');
    const bar = () => page.evaluate(() => {
      const viewer = window.isoloop;
      viewer.draw();
      // What the bar measures: a way across the picture where the camera turns.
      const text = document.getElementById('scale-text').textContent;
      const pixels = document.getElementById('scale-bar').getBoundingClientRect().width;
      const across = viewer.camera.position.clone().sub(viewer.controls.target).normalize();
      across.cross(viewer.camera.up).normalize().multiplyScalar(parseFloat(text));
      const end = viewer.controls.target.clone().add(across).project(viewer.camera);
      return { text, pixels, expected: Math.abs(end.x / 2) * viewer.canvas.clientWidth };
    });
    const far = await bar();
    assert.ok(Math.abs(far.pixels - far.expected) < 4, JSON.stringify(far));
    assert.ok(far.pixels > 40 && far.pixels < 140, JSON.stringify(far));
    await page.focus('canvas');
    for (let i = 0; i < 12; ++i) await page.keyboard.press('+');
    const near = await bar();
    assert.ok(parseFloat(near.text) < parseFloat(far.text), JSON.stringify([far, near]));
    assert.ok(Math.abs(near.pixels - near.expected) < 4, JSON.stringify(near));
    run('view', 'torus.nrrd', '--inside', 'below', '--iso', '0', '--spacing', '0.5mm', '-o', 'mm.html');
    const stated = await open('mm.html');
    assert.match(await stated.page.$eval('#scale-text', (e) => e.textContent), / mm$/);
    assert.match(await stated.page.$eval('#head', (e) => e.textContent), /size \(mm\)length \(mm\)/);
    assert.deepEqual(stated.trouble, []);
  },

  async 'a million pieces: 15 MB, 5 s; small ones are left out, said, and can be hidden'() {
    const n = 201; // one ball, and a voxel at every other place but near it
    const bytes = new Uint8Array(n ** 3);
    for (let z = 1; z < n; ++z) for (let y = 1; y < n; ++y) for (let x = 1; x < n; ++x) {
      const ball = Math.hypot(x - 100, y - 100, z - 100) - 12;
      if (ball < 0 || (ball > 3 && x % 2 && y % 2 && z % 2)) bytes[x + n * (y + n * z)] = 200;
    }
    writeFileSync(join(work, `dust_${n}x${n}x${n}_uint8.raw`), bytes);
    const start = Date.now();
    run('view', `dust_${n}x${n}x${n}_uint8.raw`, '--iso', '100', '-o', 'dust.html');
    const seconds = (Date.now() - start) / 1000;
    const size = statSync(join(work, 'dust.html')).size;
    assert.ok(size <= 15e6, `${size} bytes`);
    const { page, trouble } = await open('dust.html');
    const { firstPicture } = await state(page);
    console.log(`     ${seconds} s, ${size} bytes, first picture after ${Math.round(firstPicture)} ms`);
    assert.ok(firstPicture <= 5000, `first picture after ${firstPicture} ms`);
    assert.match(await page.$eval('#left-out', (p) => p.textContent),
                 /^Left out, being small: 99\d{4} of 99\d{4} pieces of the surface, of area \d/);
    const drawn = () => page.evaluate(() => window.isoloop.skin.geometry.drawRange.count / 3);
    const all = await drawn();
    assert.ok(all > 20000, `${all} triangles`);
    await page.$eval('#piece', (e) => { e.value = '1000'; e.dispatchEvent(new Event('input')); });
    const ball = await drawn();
    assert.ok(ball > 100 && ball < all / 2, `${ball} triangles`);
    assert.deepEqual(trouble, []);
  },

  async 'a noisy scan of 8 732 loops: 15 MB, 5 s'() {
    const knee = join(volumes, 'MRknee_128x128x128_uint8.raw');
    if (!existsSync(knee)) return `needs ${knee}`;
    run('view', knee, '--iso', '80', '-o', 'knee.html');
    const size = statSync(join(work, 'knee.html')).size;
    assert.ok(size <= 15e6, `${size} bytes`);
    const { page, trouble } = await open('knee.html');
    const { tubes, firstPicture } = await state(page);
    console.log(`     ${size} bytes, first picture after ${Math.round(firstPicture)} ms`);
    assert.equal(tubes, 8732);
    assert.ok(firstPicture <= 5000, `first picture after ${firstPicture} ms`);
    assert.deepEqual(trouble, []);
  },

  async 'the slice shows the voxels'() {
    const { page } = await open('torus.html');
    const before = await pixels(page);
    await page.click('#sliced');
    assert.ok((await pixels(page)).grey > before.grey + 5000);
    const values = await page.$eval('#picture', (c) => new Set(
      c.getContext('2d').getImageData(0, 0, c.width, c.height).data).size);
    assert.ok(values > 20, `${values} grey values`);
  },

  async 'features are tinted: those of handles green, those of tunnels red, the chosen one stronger'() {
    run('generate', 'engine_block', '--size', '104', '-o', 'block.vdb');
    run('view', 'block.vdb', '-o', 'block.html');
    const { page, trouble } = await open('block.html');
    const both = await tinted(page);
    assert.ok(both.green > 1000 && both.red > 1000, JSON.stringify(both));
    await page.click('#handles');
    const tunnels = await tinted(page);
    assert.equal(tunnels.green, 0, 'of handles that are not shown there is no tint');
    assert.ok(tunnels.red >= both.red, JSON.stringify(tunnels));
    await page.click('#handles');
    await page.click('#features');
    const plain = await tinted(page);
    assert.equal(plain.green + plain.red, 0, 'plain');
    await page.click('#features');
    for (const [kind, lean, other] of [['handle', 'green', 'red'], ['tunnel', 'red', 'green']]) {
      await page.evaluate((k) => {
        const viewer = window.isoloop;
        viewer.choose(viewer.data.loops.findIndex((loop) => loop.kind === k));
        document.getElementById('sliced').click();
      }, kind);
      const chosen = await tinted(page);
      assert.ok(chosen[lean] > 500, JSON.stringify(chosen));
      assert.ok(chosen.lean[lean] > 1.2 * both.lean[lean], JSON.stringify([both, chosen]));
      assert.equal(chosen[other], 0, JSON.stringify(chosen));
      assert.match(await page.$eval('#status', (p) => p.textContent), / deep, .* thick/);
    }
    assert.deepEqual(trouble, []);
  },

  async 'a column sorts by a click on its head'() {
    const { page } = await open('torus.html');
    const lengths = () => page.$$eval('#rows tr', (rows) => rows.map((r) => Number(r.cells[2].textContent)));
    await page.click('#head th:nth-child(3) button');
    const up = await lengths();
    assert.equal(await page.$eval('#head th:nth-child(3)', (h) => h.ariaSort), 'ascending');
    await page.click('#head th:nth-child(3) button');
    assert.deepEqual(await lengths(), up.reverse());
  },

  async 'a screen reader finds names for all that can be used'() {
    const { page } = await open('torus.html');
    const tree = await page.accessibility.snapshot({ interestingOnly: true });
    const nameless = [];
    const look = (node) => {
      if (/button|checkbox|slider|combobox/i.test(node.role) && !node.name) nameless.push(node);
      (node.children ?? []).forEach(look);
    };
    look(tree);
    assert.deepEqual(nameless, []);
    await page.focus('canvas');
    const before = await state(page);
    await page.keyboard.press('ArrowLeft');
    assert.ok(moved(before, await state(page)) > 1, 'arrow keys turn the picture');
  },

  async 'it is dark where the reader wants it dark, and fits a phone'() {
    const { page, trouble } = await open('torus.html', { width: 390, height: 844, dark: true });
    const seen = await pixels(page);
    assert.ok(seen.corner < 40, 'dark');
    assert.ok(seen.green > 30 && seen.red > 30, JSON.stringify(seen));
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= 390, `${wide} pixels wide`);
    const view = await page.$eval('#view', (e) => e.getBoundingClientRect().height);
    assert.ok(view >= 250, `${view} pixels of picture`);
    await page.click('#rows button');
    assert.equal((await state(page)).chosen, 0);
    assert.deepEqual(trouble, []);
  },

  async 'pages of a ball and of no surface say so and are usable'() {
    run('generate', 'ball', '--size', '32', '-o', 'ball.vdb');
    run('view', 'ball.vdb', '-o', 'ball.html');
    run('view', 'ball.vdb', '--iso', '-1000', '-o', 'empty.html');
    const ball = await open('ball.html');
    assert.ok((await pixels(ball.page)).grey > 20000);
    assert.match(await ball.page.$eval('#status', (p) => p.textContent), /no loops/);
    await ball.page.click('#home');
    await ball.page.click('#sliced');
    const empty = await open('empty.html');
    assert.match(await empty.page.$eval('#message', (p) => p.textContent), /no surface/);
    await empty.page.click('#sliced');
    assert.ok((await pixels(empty.page)).grey > 20000, 'the slice');
    assert.deepEqual([...ball.trouble, ...empty.trouble], []);
  },

  async 'ten thousand loops are usable'() {
    const n = 39;
    let seed = 1;
    const noise = Float32Array.from({ length: n ** 3 }, () => {
      seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
      return seed / 2 ** 31 - 1;
    });
    writeFileSync(join(work, `noise_${n}x${n}x${n}_float32.raw`), noise);
    run('view', `noise_${n}x${n}x${n}_float32.raw`, '--iso', '0', '-o', 'many.html');
    const { page, trouble } = await open('many.html');
    const loops = await page.evaluate(() => window.isoloop.data.loops.length);
    assert.ok(loops >= 9500, `${loops} loops`);
    assert.equal((await state(page)).tubes, loops);
    assert.ok((await page.$$('#rows tr')).length < 1000, 'rows come in portions');
    await page.evaluate((last) => window.isoloop.choose(last), loops - 1);
    assert.equal(await page.$$eval('#rows tr[aria-selected=true]', (r) => r.length), 1);
    const start = Date.now();
    await page.$eval('#least', (e) => { e.value = '700'; e.dispatchEvent(new Event('input')); });
    const left = (await state(page)).tubes;
    assert.ok(left > 0 && left < loops);
    console.log(`     ${loops} loops, the slider takes ${Date.now() - start} ms`);
    assert.deepEqual(trouble, []);
  },

  async 'the engine: 40 loops, 8 MB, 3 s, every tunnel by the keyboard'() {
    if (!existsSync(engine)) return `needs ${engine}`;
    run('view', engine, '--iso', '70', '-o', 'engine.html');
    const bytes = statSync(join(work, 'engine.html')).size;
    assert.ok(bytes <= 8e6, `${bytes} bytes`);
    const { page, trouble } = await open('engine.html');
    const first = await state(page);
    assert.equal(first.tubes, 40);
    console.log(`     ${bytes} bytes, first picture after ${Math.round(first.firstPicture)} ms`);
    const seen = await pixels(page);
    assert.ok(seen.green > 1000 && seen.red > 500, JSON.stringify(seen));
    await page.focus('#rows button');
    const tunnels = new Set();
    await page.keyboard.press('Enter');
    for (let i = 0; i < 39; ++i) {
      await page.keyboard.press('ArrowDown');
      const words = await page.$eval('#status', (p) => p.textContent);
      if (words.startsWith('tunnel')) tunnels.add(words);
    }
    assert.equal(tunnels.size, 20);
    assert.ok((await pixels(page)).red > 500, 'the last tunnel loop is in sight');
    assert.ok(first.firstPicture <= 3000, `first picture after ${first.firstPicture} ms`);
    assert.deepEqual(trouble, []);
  },
};

let failed = 0;
const only = process.argv[4];
for (const [name, test] of Object.entries(tests)) {
  if (only && !name.includes(only)) continue;
  try {
    const missing = await test();
    console.log(missing ? `skip ${name}: ${missing}` : `ok   ${name}`);
  } catch (error) {
    ++failed;
    console.log(`FAIL ${name}\n${error.stack}`);
  }
}
await browser.close();
rmSync(work, { recursive: true });
process.exit(failed === 0 ? 0 : 1);
