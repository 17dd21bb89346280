"""Tables in docs/boards.md between two marks, made of what the folders and the records say."""
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "boards.md"
END = "<!-- end -->\n"


def keep_table(name: str, lines: list[str]) -> int:
    """With --write the page gets the table; without, the exit code is 1 where it has another."""
    begin = f"<!-- {name}: made by scripts/boards.sh -->\n"
    text = PAGE.read_text()
    before, rest = text.split(begin)
    _, after = rest.split(END, 1)
    fresh = before + begin + "\n".join(lines) + "\n" + END + after
    if sys.argv[1:] == ["--write"]:
        PAGE.write_text(fresh)
    elif fresh != text:
        print(f"The table '{name}' in docs/boards.md is not what the folders under boards/ say; run 'scripts/boards.sh'.", file=sys.stderr)
        return 1
    return 0
