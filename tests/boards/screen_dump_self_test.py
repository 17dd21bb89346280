#!/usr/bin/env python3
"""That screen_dump.py finds what is wrong with a screen: a pixel that is one code off, the wrong size, a block that is not of one colour."""
import sys

from screen_dump import Picture, must_be_alike

BITS = [5, 6, 5]


def picture(width: int, height: int, changed: tuple[int, bytes] = (0, b"")) -> Picture:
    rgb = bytearray(b"\x10\x20\x40" * (width * height))
    at, value = changed
    rgb[3 * at:3 * at + len(value)] = value
    return Picture(width, height, bytes(rgb))


def said(check) -> str:
    try:
        check()
    except ValueError as error:
        return str(error)
    return ""


def main() -> int:
    frame = picture(8, 4)
    cases = {
        "": lambda: must_be_alike(picture(8, 4, (5, b"\x17\x23\x47")), frame, BITS),  # the same codes, widened in another way
        "the pixel at 5, 0 shows [3, 8, 8], and the frame has [2, 8, 8]": lambda: must_be_alike(picture(8, 4, (5, b"\x18")), frame, BITS),
        "the display shows 4x4 pixels, the frame has 8x4": lambda: must_be_alike(picture(4, 4), frame, BITS),
        "the block of 2x2 at 3, 1 is not of one colour": lambda: picture(8, 4, (11, b"\x18")).every(2),
    }
    wrong = [f"expected '{sentence}', found '{said(check)}'" for sentence, check in cases.items() if said(check) != sentence]
    print("\n".join(wrong) or f"{len(cases)} screens are judged right.")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
