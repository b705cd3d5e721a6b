// Takes a picture of a page with one loop chosen.
//   node picture.mjs PAGE.html PICTURE.png KIND ID
import { resolve } from 'node:path';
import puppeteer from 'puppeteer-core';

const [html, picture, kind, id] = process.argv.slice(2);
const browser = await puppeteer.launch({
  executablePath: '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-gl=angle', '--use-angle=swiftshader',
         '--enable-unsafe-swiftshader'],
});
const page = await browser.newPage();
await page.setViewport({ width: 1120, height: 640 });
await page.emulateMediaFeatures([
  { name: 'prefers-color-scheme', value: 'light' },
  { name: 'prefers-reduced-motion', value: 'reduce' },
]);
await page.goto(`file://${resolve(html)}`, { waitUntil: 'load' });
await page.waitForFunction(() => window.isoloop?.state.firstPicture);
await page.evaluate((wanted) => {
  const { loops } = window.isoloop.data;
  window.isoloop.choose(loops.findIndex((loop) => `${loop.kind} ${loop.id}` === wanted));
}, `${kind} ${id}`);
await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
await page.screenshot({ path: picture });
await browser.close();
