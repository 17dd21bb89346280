"""What is measured: scenes, boards and tiers, and where their images are."""
from typing import NamedTuple

SCENES = ("S1", "S2", "S3", "S4", "S5", "S6")
BOARDS = ("qemu_mps2_an385", "qemu_mps2_an386", "qemu_an385_m0plus")
TIERS = ("lowp", "mediump", "highp")
DEFAULT_BOARD = "qemu_mps2_an385"  # the board of the limits, and of the tiers' comparison
DEFAULT_TIER = "mediump"


class Row(NamedTuple):
    scene: str
    board: str
    tier: str

    def __str__(self):
        return f"{self.scene} on {self.board} in {self.tier}"

    @property
    def target(self):
        """Of CMake. The default tier's images are part of every build, the others are built when they are asked for."""
        return f"scene_{self.scene.lower()}" + ("" if self.tier == DEFAULT_TIER else f"_{self.tier}")

    def image(self, builds):
        return builds / self.board / "firmware" / f"{self.target}.elf"


def budget_rows(boards=BOARDS):
    """The rows that have a budget: each scene on each board, in the default tier."""
    return [Row(scene, board, DEFAULT_TIER) for board in boards for scene in SCENES]


def tier_rows():
    """The price of accuracy: the other tiers on the default board."""
    return [Row(scene, DEFAULT_BOARD, tier) for tier in TIERS if tier != DEFAULT_TIER for scene in SCENES]
