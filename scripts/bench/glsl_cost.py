"""Instructions of a call of each function of GLSL's vocabulary, on a core with a long multiply and on one without."""
from commands import PROJECT, run
from counting import FrameCount
from image import Image

BOARDS = {"qemu_mps2_an385": "M3", "qemu_an385_m0plus": "M0+"}
OF_NUMBERS = ("mod", "divide", "mix", "smoothstep", "sqrt", "inversesqrt", "exp2", "exp", "log2", "log", "pow", "radians",
              "sin", "tan", "acos", "atan")
OF_VECTORS = ("dot", "cross", "length", "normalize", "reflect", "refract", "mat3_vec3", "mat4_vec4")
_CALLS = 16  # as in tests/budget/glsl_cost.cpp


def _count(plugin, board):
    """What a call costs, the loop around it taken off."""
    run(["cmake", "--preset", board], f"{board} cannot be configured")
    run(["cmake", "--build", "--preset", board, "--target", "glsl_cost"], f"{board} cannot be built")
    image = Image(PROJECT / "build" / board / "tests/glsl_cost.elf")

    def instructions(name):
        return FrameCount(image, plugin, board, marks=(f"begin_{name}", f"end_{name}")).instructions / _CALLS

    costs = {}
    for loop, names in (("number", OF_NUMBERS), ("vector", OF_VECTORS)):
        empty = instructions(loop)
        costs.update({name: round(instructions(name) - empty) for name in names})
    return costs


def table(plugin):
    costs = {board: _count(plugin, board) for board in BOARDS}
    lines = [f"| function | {' | '.join(BOARDS.values())} |", "|---|" + "---|" * len(BOARDS)]
    for name in OF_NUMBERS + OF_VECTORS:
        lines.append(f"| `{name.replace('_', ' * ')}` | " + " | ".join(str(costs[board][name]) for board in BOARDS) + " |")
    return "\n".join(lines)
