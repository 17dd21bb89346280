#!/usr/bin/env python3
"""The presets of every folder under boards/: configure, build, test and workflow by the board's name.

usage: presets.py          exit code 1 where boards/presets.json is not what it should be
       presets.py --write  writes it
"""
import json
import sys
from pathlib import Path

BOARDS = Path(__file__).resolve().parents[2] / "boards"


def preset_files(names: list[str]) -> dict:
    hidden_configure = {"name": "board", "hidden": True, "generator": "Ninja",
                        "binaryDir": "${sourceDir}/build/${presetName}", "cacheVariables": {"BOARD": "${presetName}"}}
    hidden_test = {"name": "board", "hidden": True, "output": {"outputOnFailure": True},
                   "execution": {"jobs": 2, "noTestsAction": "error"}}
    return {
        "version": 6,
        "configurePresets": [hidden_configure] + [{"name": n, "inherits": "board"} for n in names],
        "buildPresets": [{"name": n, "configurePreset": n} for n in names],
        "testPresets": [hidden_test] + [{"name": n, "inherits": "board", "configurePreset": n} for n in names],
        "workflowPresets": [{"name": n, "steps": [{"type": step, "name": n} for step in ("configure", "build", "test")]}
                            for n in names],
    }


def as_text(presets: dict) -> str:
    """One line a preset, so that a new board is four new lines."""
    lists = []
    for key, value in presets.items():
        if isinstance(value, list):
            rows = ",\n".join("    " + json.dumps(row) for row in value)
            lists.append(f'  "{key}": [\n{rows}\n  ]')
        else:
            lists.append(f'  "{key}": {json.dumps(value)}')
    return "{\n" + ",\n".join(lists) + "\n}\n"


def main() -> int:
    names = sorted(path.parent.name for path in BOARDS.glob("*/board.cmake"))
    file = BOARDS / "presets.json"
    text = as_text(preset_files(names))
    if sys.argv[1:] == ["--write"]:
        file.write_text(text)
        return 0
    if not file.exists() or file.read_text() != text:
        print(f"boards/{file.name} is not made of the folders under boards/; run 'scripts/boards.sh'.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
