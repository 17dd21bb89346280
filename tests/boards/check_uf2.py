#!/usr/bin/env python3
"""A UF2 file as a Pico's ROM would take it: every field of every block, and the checksum of the boot stage. A byte that is not as it
should be must be found: each is changed in turn in the first blocks.

usage: check_uf2.py IMAGE.bin IMAGE.uf2
"""
import struct
import sys
from pathlib import Path

FLASH, FLASH_BYTES = 0x10000000, 2 << 20


def boot_checksum(stage: bytes) -> int:
    crc = 0xFFFFFFFF
    for byte in stage:
        crc ^= byte << 24
        for _ in range(8):
            crc = (crc << 1 ^ (0x04C11DB7 if crc >> 31 else 0)) & 0xFFFFFFFF
    return crc


def read(file: bytes) -> bytes:
    """The flash image in a UF2 file."""
    if not file or len(file) % 512:
        raise ValueError(f"a UF2 file is made of blocks of 512 bytes, and this one has {len(file)} bytes")
    image = b""
    for number in range(len(file) // 512):
        block = file[number * 512:(number + 1) * 512]
        fields = struct.unpack("<8I", block[:32]) + struct.unpack("<I", block[508:])
        expected = (0x0A324655, 0x9E5D5157, 0x2000, FLASH + number * 256, 256, number, len(file) // 512, 0xE48BFF56, 0x0AB16F30)
        if fields != expected:
            at = next(i for i, pair in enumerate(zip(fields, expected)) if pair[0] != pair[1])
            raise ValueError(f"field {at} of block {number} is 0x{fields[at]:08X}, expected 0x{expected[at]:08X}")
        if any(block[288:508]):
            raise ValueError(f"block {number} has something behind its 256 bytes")
        image += block[32:288]
    if len(image) > FLASH_BYTES:
        raise ValueError(f"the image has {len(image)} bytes, and the flash {FLASH_BYTES}")
    if struct.unpack("<I", image[252:256])[0] != boot_checksum(image[:252]):
        raise ValueError("the boot stage's checksum is not that of its bytes")
    return image


def refused(file: bytes) -> bool:
    try:
        read(file)
    except ValueError:
        return True
    return False


def main() -> int:
    image, file = (Path(name).read_bytes() for name in sys.argv[1:3])
    try:
        if read(file)[:len(image)] != image:
            raise ValueError("the file holds another image")
    except ValueError as error:
        print(f"{sys.argv[2]}: {error}.", file=sys.stderr)
        return 1
    for at in range(512):
        changed = bytearray(file[:1024])
        changed[24:28] = changed[536:540] = struct.pack("<I", 2)  # two blocks in all
        assert not refused(bytes(changed))
        changed[at] ^= 1
        if not refused(bytes(changed)):
            print(f"Byte {at} may be changed, and nobody notices.", file=sys.stderr)
            return 1
    print(f"{len(file) // 512} blocks are as they should be, and a change of any of the first 512 bytes is found.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
