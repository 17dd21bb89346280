"""No image of a scene has code of a term that the scene does not need, and every term's code is found in some image.

usage: term_code_test.py <folder of a board's images> <shade16>
"""
import json
import subprocess
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "scripts/bench"))

from image import Image  # noqa: E402
from term_costs import foreign_code, rules  # noqa: E402


def main(images, shade16):
    complaints, found, looked_at = [], set(), 0
    for scene in sorted((PROJECT / "assets/scenes").glob("*.toml")):
        path = Path(images) / f"scene_{scene.stem}.elf"
        survey = json.loads(subprocess.run([shade16, "info", str(scene), "--json"], check=True, capture_output=True, text=True).stdout)
        needed = set(survey["needs"]["needed"])
        image = Image(path)
        complaints += foreign_code(image, needed)
        # The rules are no empty words: an image that is taken for one without any term breaks those of its own.
        found |= {sentence.split(" has code of ")[1].split(",")[0] for sentence in foreign_code(image, set())}
        looked_at += 1
    for terms in rules():
        if terms not in found:
            complaints.append(f"No image of {images} has code of {terms}: the rule can not fail.")
    print("\n".join([*complaints, f"{looked_at} images, {len(complaints)} complaints."]))
    return 1 if complaints or looked_at == 0 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
