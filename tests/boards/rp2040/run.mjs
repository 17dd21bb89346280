// Runs an ELF image on an emulated RP2040, from the boot stage on: prints what it says on UART 0 and ends with its exit status.
//   node run.mjs [--log FILE] [--tell WORD] IMAGE.elf
// The word is sent to UART 0 when the program first says something. The log is what a display on SPI 0 sees, a word an event: w<ms> time that passed, r0 and r1 its reset line, c<hex> a command and d<hex>
// a byte of data, by the data/command line.
import fs from 'node:fs';
import { ConsoleLogger, GPIOPinState, LogLevel, RP2040 } from 'rp2040js';

const COMMAND_LINE = 20, RESET_LINE = 21, SELECT_LINE = 17;
const BOOT_STAGE_AT = 0x20041f00, FLASH_AT = 0x10000000, MOST_INSTRUCTIONS = 4e9;

function fail(sentence) {
  console.error(sentence);
  process.exit(2);
}

/// Puts the segments of an ELF file for 32 bits into the flash.
function load(mcu, path) {
  const file = fs.readFileSync(path);
  if (file.readUInt32BE(0) !== 0x7f454c46) fail(`${path} is no ELF file.`);
  const at = file.readUInt32LE(28), size = file.readUInt16LE(42), count = file.readUInt16LE(44);
  for (let i = 0; i < count; ++i) {
    const head = at + i * size;
    const [type, offset, , address, bytes] = [0, 4, 8, 12, 16].map((field) => file.readUInt32LE(head + field));
    if (type === 1 && bytes > 0) mcu.flash.set(file.subarray(offset, offset + bytes), address - FLASH_AT);
  }
}

/// What the ROM does: checks the boot stage, copies it to RAM and calls it.
function boot(mcu) {
  const stage = mcu.flash.slice(0, 256);
  let crc = 0xffffffff;
  for (const byte of stage.subarray(0, 252)) {
    crc ^= byte << 24;
    for (let bit = 0; bit < 8; ++bit) crc = (crc << 1) ^ (crc < 0 ? 0x04c11db7 : 0);
  }
  if (crc >>> 0 !== new DataView(stage.buffer).getUint32(252, true)) fail('The boot stage has a wrong checksum: the chip would wait for a file over USB.');
  mcu.sram.set(stage, BOOT_STAGE_AT - 0x20000000);
  mcu.core.reset();
  mcu.core.registers[14] = 0;
  mcu.core.SP = 0x20042000;
  mcu.core.PC = BOOT_STAGE_AT;
}

const words = process.argv.slice(2);
const log = words[0] === '--log' ? fs.createWriteStream(words.splice(0, 2)[1]) : null;
let told = words[0] === '--tell' ? words.splice(0, 2)[1] : '';
if (words.length !== 1) fail('usage: node run.mjs [--log FILE] [--tell WORD] IMAGE.elf');

const mcu = new RP2040();
mcu.logger = new ConsoleLogger(LogLevel.Error, true);
load(mcu, words[0]);
boot(mcu);

let printed = '', status = null;
mcu.uart[0].onByte = (byte) => {
  for (const letter of told) mcu.uart[0].feedByte(letter.charCodeAt(0));
  told = '';
  printed += String.fromCharCode(byte);
  if (byte !== 10) return;
  const end = printed.match(/^exit (\d+)\n$/);
  if (end) status = Number(end[1]);
  else process.stdout.write(printed);
  printed = '';
};

let events = '', told_ms = 0, reset = true;
function tell(event) {
  const ms = Math.floor(mcu.clock.nanos / 1e6);
  if (ms > told_ms) events += `w${ms - told_ms}\n`;
  told_ms = ms;
  events += `${event}\n`;
  if (events.length > 1 << 16) log.write(events), (events = '');
}
const is_high = (line) => mcu.gpio[line].value === GPIOPinState.High;
if (log) mcu.gpio[RESET_LINE].addListener(() => { if (is_high(RESET_LINE) !== reset) tell(`r${Number((reset = !reset))}`); });

// A frame takes as long as on the wire, so that DMA and processor overlap.
const spi = mcu.spi[0];
const sent = mcu.clock.createAlarm(() => spi.completeTransmit(0));
spi.onTransmit = (value) => {
  if (log && !is_high(SELECT_LINE)) tell((is_high(COMMAND_LINE) ? 'd' : 'c') + value.toString(16));
  sent.schedule((spi.dataBits * 1e9) / spi.clockFrequency);
};

const ns_a_cycle = 1e9 / mcu.clkSys;
for (let i = 0; status === null; ++i) {
  if (i > MOST_INSTRUCTIONS) fail('The program does not end.');
  const cycles = mcu.core.waiting ? 1 : mcu.core.executeInstruction();
  mcu.clock.tick(cycles * ns_a_cycle);
}
if (log) log.end(events);
process.exitCode = status;
