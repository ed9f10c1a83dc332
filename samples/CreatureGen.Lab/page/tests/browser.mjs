// A real browser, from npm alone, with WebGL 2 in software; and the lab's own server.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import chromium from '@sparticuz/chromium';
import { chromium as driver } from 'playwright-core';

export const labFolder = fileURLToPath(new URL('../../', import.meta.url));
export const program = join(labFolder, 'bin/Release/net10.0/CreatureGen.Lab.dll');

/** Starts the browser. */
export async function openBrowser() {
  const executablePath = await chromium.executablePath();
  return driver.launch({
    executablePath,
    headless: true,
    args: ['--no-sandbox', '--no-zygote', '--disable-dev-shm-usage', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--force-color-profile=srgb'],
  });
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
