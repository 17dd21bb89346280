// node run_wasm.mjs <module>: lets the module say its hashes.
import { readFileSync } from 'node:fs';

let memory;
const print = (address) => {
    const bytes = new Uint8Array(memory.buffer, address);
    process.stdout.write(Buffer.from(bytes.subarray(0, bytes.indexOf(0))));
};

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), { console: { print } });
memory = instance.exports.memory;
instance.exports.say_hashes();
