"""Makes the pictures of the textured scenes: python3 assets/scenes/make_pictures.py

crate.png  64x64    planks in a frame, a factor of the light
bricks.png 64x64    heights of a wall of bricks, a relief
globe.png  128x64   a graticule, for spheres
"""
import math
import pathlib
import random
import struct
import zlib


def write_png(path, width, height, pixel, channels):
    """`pixel(x, y)` counts rows from the top, and gives 1 or 3 codes."""
    rows = b"".join(b"\0" + bytes(code for x in range(width) for code in pixel(x, y)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2 if channels == 3 else 0, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def noise(seed):
    table = random.Random(seed)
    values = [[table.random() for _ in range(64)] for _ in range(64)]
    return lambda x, y: values[y % 64][x % 64]


def crate(x, y):
    grain = noise(1)(x // 4, y)
    border = min(x, y, 63 - x, 63 - y) < 8
    gap = border and min(x, y, 63 - x, 63 - y) == 7
    plank = (y // 12) % 2
    gap = gap or (not border and y % 12 == 0)
    nail = border and (x % 48 in (3, 4) or x % 48 in (11, 12)) and (y % 48 in (3, 4) or y % 48 in (11, 12))
    shade = (0.72 if border else 0.86 + 0.08 * plank) * (0.86 + 0.14 * grain)
    shade *= 0.35 if gap else 0.5 if nail else 1
    return tuple(int(255 * shade * c) for c in (0.86, 0.62, 0.36))


def bricks(x, y):
    along = (x + 8 * (y // 8 % 2)) % 16
    edge = min(along, 15 - along, y % 8, 7 - y % 8)
    return (int(255 * min(1, edge / 1.5) * (0.92 + 0.08 * noise(2)(x, y))),)


def globe(x, y):
    latitude, longitude = 90 - 180 * (y + 0.5) / 64, 360 * (x + 0.5) / 128
    line = y % 8 == 0 or x % 16 == 0
    land = math.sin(math.radians(longitude * 2 + 40)) * math.cos(math.radians(latitude * 3)) + 0.4 * math.sin(math.radians(longitude * 5))
    if abs(latitude) > 72:
        base = (232, 240, 244)
    else:
        base = (92, 150, 70) if land > 0.35 else (38, 92, 160)
    return tuple(min(255, c + 60) for c in base) if line else base


folder = pathlib.Path(__file__).parent
write_png(folder / "crate.png", 64, 64, crate, 3)
write_png(folder / "bricks.png", 64, 64, bricks, 1)
write_png(folder / "globe.png", 128, 64, globe, 3)
