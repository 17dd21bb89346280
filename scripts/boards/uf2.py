#!/usr/bin/env python3
"""A flash image as a UF2 file, which a Raspberry Pi Pico takes as a USB drive does a copy.

usage: uf2.py IMAGE.bin IMAGE.uf2

Source: github.com/microsoft/uf2, "USB Flashing Format"; the family is that of RP2040 in its list.
"""
import struct
import sys
from pathlib import Path

FIRST_MAGIC, SECOND_MAGIC, LAST_MAGIC = 0x0A324655, 0x9E5D5157, 0x0AB16F30
FAMILY_IS_GIVEN, RP2040 = 0x2000, 0xE48BFF56
FLASH, PAYLOAD, BLOCK = 0x10000000, 256, 512


def blocks(image: bytes) -> bytes:
    count = -(-len(image) // PAYLOAD)
    file = bytearray()
    for number in range(count):
        payload = image[number * PAYLOAD:(number + 1) * PAYLOAD]
        head = struct.pack("<8I", FIRST_MAGIC, SECOND_MAGIC, FAMILY_IS_GIVEN, FLASH + number * PAYLOAD, PAYLOAD, number, count, RP2040)
        file += head + payload.ljust(BLOCK - len(head) - 4, b"\0") + struct.pack("<I", LAST_MAGIC)
    return bytes(file)


def main() -> int:
    if len(sys.argv) != 3:
        print("usage: uf2.py IMAGE.bin IMAGE.uf2", file=sys.stderr)
        return 2
    Path(sys.argv[2]).write_bytes(blocks(Path(sys.argv[1]).read_bytes()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
