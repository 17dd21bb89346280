#!/usr/bin/env python3
"""That scripts/boards/panels.py makes of texts what it should, where today's panels do not show it, and finds headers that are stale."""
import subprocess
import sys
import tempfile
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts" / "boards"
sys.path.insert(0, str(SCRIPTS))
import panels  # noqa: E402

REST = "command 0x11\ndelay 120\ncommand 0x36 0xC0\n#: glass 10 20\n"
SLEEP_OUT = "0x11, then_wait, 24,"


def header(texts: dict[str, str]) -> str:
    with tempfile.TemporaryDirectory() as folder:
        for name, text in texts.items():
            (Path(folder) / f"{name}.txt").write_text(text)
        made = panels.headers(Path(folder))
    return made["mine.hpp"]


def rows(text: str) -> list[str]:
    """Of the first list."""
    lines = header({"mine": text + REST}).split("_beginning[] = {\n")[1].split("\n};")[0]
    return [line.strip() for line in lines.splitlines()]


def stale_is_found() -> bool:
    """In a copy of the two folders, with one byte changed in a text."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for part in ("scripts/boards", "boards/panels", "firmware/display"):
            (root / part).mkdir(parents=True)
            for file in (panels.ROOT / part).iterdir():
                if file.is_file():
                    (root / part / file.name).write_bytes(file.read_bytes())
        check = [sys.executable, "-B", str(root / "scripts/boards/panels.py")]
        fresh = subprocess.run(check, capture_output=True, text=True)
        text = root / "boards/panels/st7789.txt"
        text.write_text(text.read_text().replace("command 0xBB 0x28", "command 0xBB 0x29"))
        stale = subprocess.run(check, capture_output=True, text=True)
        subprocess.run(check + ["--write"], check=True)
        return fresh.returncode == 0 and stale.returncode == 1 and "st7789.hpp" in stale.stderr \
            and "0xBB, 1, 0x29" in (root / "firmware/display/st7789.hpp").read_text()


def main() -> int:
    own_gamma = header({"mine": REST, "mine_square": "# Has a gamma.\n\n#: as mine\n#: offset 1 2\n#: memory 15 25\ncommand 0xE0 1\ncommand 0x36 0x80\n"})
    cases = {
        "waits add up": rows("command 1 7\ndelay 3\ndelay 3\n") == ["0x01, 1 | then_wait, 0x07, 2,", SLEEP_OUT],
        "long waits are split": rows("command 1\n" + "delay 255\n" * 6) == ["0x01, then_wait, 255,", "0x00, then_wait, 51,", SLEEP_OUT],
        "a wait may come first": rows("delay 10\n") == ["0x00, then_wait, 2,", SLEEP_OUT],
        "a wait as the kernel stores it": rows("command 1\ncommand 0 10\n") == ["0x01, then_wait, 2,", SLEEP_OUT],
        "what drivers send is no row": rows("command 0x3A 0x55\ncommand 0x20\ncommand 0x13\ncommand 0x29\n") == [SLEEP_OUT],
        "its own list": own_gamma.count("_beginning[] = {") == 2 and ".beginning = mine_square_beginning" in own_gamma,
        "its comment": "// Has a gamma.\ninline constexpr DcsPanel mine_square{" in own_gamma,
        "offsets count from where memory begins": ".first_column = 1, .first_row = 3, .rows_mirrored = true," in own_gamma.replace("\n   ", ""),
        "a stale header is found": stale_is_found(),
    }
    wrong = [name for name, right in cases.items() if not right]
    print("\n".join(f"wrong: {name}" for name in wrong) or f"{len(cases)} properties of the headers hold.")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
