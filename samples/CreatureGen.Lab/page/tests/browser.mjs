// A real browser, from npm alone, with WebGL 2 in software; and the lab's own server.
import { spawn } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { dirname, extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import chromium, { inflate, setupLambdaEnvironment } from '@sparticuz/chromium';
import { chromium as driver } from 'playwright-core';

export const labFolder = fileURLToPath(new URL('../../', import.meta.url));
export const program = join(labFolder, 'bin/Release/net10.0/CreatureGen.Lab.dll');

/** Starts the browser. Where the system lacks the libraries that it needs, those of its package serve. */
export async function openBrowser() {
  const options = {
    executablePath: await chromium.executablePath(),
    headless: true,
    args: ['--no-sandbox', '--no-zygote', '--disable-dev-shm-usage', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--force-color-profile=srgb'],
  };
  try {
    return await driver.launch(options);
  } catch {
    const own = await inflate(join(dirname(fileURLToPath(import.meta.resolve('@sparticuz/chromium'))), '../bin/al2023.tar.br'));
    setupLambdaEnvironment(join(own, 'lib'));
    return driver.launch(options);
  }
}

/** Starts the lab on a free port and waits for the line that tells its address. */
export function serveLab() {
  const process = spawn('dotnet', [program, '--port', '0'], { stdio: ['ignore', 'pipe', 'pipe'] });
  return new Promise((resolve, reject) => {
    let told = '';
    process.stdout.on('data', text => {
      told += text;
      const address = /http:\/\/\S+/.exec(told);
      if (address) {
        resolve({ address: address[0], close: () => process.kill() });
      }
    });
    process.stderr.on('data', text => { told += text; });
    process.on('exit', code => reject(new Error(`the lab ended with ${code}: ${told}`)));
  });
}

const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.json': 'application/json', '.wasm': 'application/wasm', '.svg': 'image/svg+xml' };

/** Serves a folder below a path as a plain host does, without any header but the type. */
export function serveFolder(folder, below) {
  const server = createServer((request, answer) => {
    const path = new URL(request.url, 'http://localhost').pathname;
    try {
      const name = path.startsWith(below) ? path.slice(below.length) || 'index.html' : '';
      const bytes = readFileSync(join(folder, name));
      answer.writeHead(200, { 'Content-Type': types[extname(name)] ?? 'application/octet-stream' }).end(bytes);
    } catch {
      answer.writeHead(404).end();
    }
  });
  return new Promise(resolve => {
    server.listen(0, '127.0.0.1', () => resolve({ address: `http://localhost:${server.address().port}${below}`, close: () => { server.close(); server.closeAllConnections(); } }));
  });
}
