// SPDX-License-Identifier: Zlib
// Copyright (c) 2026 the tuff authors
//
// Runs a WebAssembly program in node: node run.mjs PROGRAM. The ground that wasi-libc stands on, as far as tests need it: text goes to
// the same stream here, the result of main ends the process; there are no arguments and no files.
import { readFileSync, writeSync } from 'node:fs';

const OK = 0, NO_SUCH_FILE = 8, CHARACTER_DEVICE = 2;
const program = process.argv[2];
let memory;

const view = () => new DataView(memory.buffer);

function fd_write(file, vectors, count, written) {
  let length = 0;
  for (let i = 0; i < count; i++) {
    const start = view().getUint32(vectors + 8 * i, true);
    const bytes = view().getUint32(vectors + 8 * i + 4, true);
    for (let done = 0; done < bytes;) done += writeSync(file, new Uint8Array(memory.buffer, start + done, bytes - done));
    length += bytes;
  }
  view().setUint32(written, length, true);
  return OK;
}

function fd_fdstat_get(file, status) {
  for (let i = 0; i < 24; i++) view().setUint8(status + i, 0);
  view().setUint8(status, CHARACTER_DEVICE);
  return OK;
}

const ground = {
  fd_write, fd_fdstat_get,
  fd_close: () => NO_SUCH_FILE,
  fd_seek: () => NO_SUCH_FILE,
  proc_exit: code => process.exit(code),
};

const { instance } = await WebAssembly.instantiate(readFileSync(program), { wasi_snapshot_preview1: ground });
memory = instance.exports.memory;
instance.exports._start();
