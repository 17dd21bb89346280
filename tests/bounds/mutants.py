#!/usr/bin/env python3
"""Changes table entries and rounding constants of the core by one unit: the measured bounds must notice.

usage: mutants.py COMPILER PROJECT_DIRECTORY SCRATCH_DIRECTORY

Golden frames and hashes of kernels take no part. A mutant that lives is named, and must be among those that are explained.
"""
import pathlib
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

NEEDED_KILLS = 18


@dataclass
class Mutant:
    name: str
    header: str  # of num/
    old: str
    new: str
    measures: str  # files of host_sim/bounds
    survives: str = ""  # why, where no bound can notice


MUTANTS = [
    Mutant("rsqrt: an entry, up", "rsqrt.hpp", "static_cast<uint16_t>(min<uint64_t>((lowered + 2048) >> 12, 65533));\n        }", "static_cast<uint16_t>(min<uint64_t>((lowered + 2048) >> 12, 65533));\n        }\n        ++y[7];", "tables"),
    Mutant("rsqrt: an entry, down", "rsqrt.hpp", "static_cast<uint16_t>(min<uint64_t>((lowered + 2048) >> 12, 65533));\n        }", "static_cast<uint16_t>(min<uint64_t>((lowered + 2048) >> 12, 65533));\n        }\n        --y[41];", "tables"),
    Mutant("rsqrt: the cap of its table", "rsqrt.hpp", "(lowered + 2048) >> 12, 65533)", "(lowered + 2048) >> 12, 65532)", "tables"),
    Mutant("rsqrt: the line's rounding", "rsqrt.hpp", "fraction + 0x8000) >> 16", "fraction + 0x8001) >> 16", "roots",
           "one value in 65,536 moves by one unit, seldom where the error is largest"),
    Mutant("reciprocal: an entry", "reciprocal.hpp", "(uint32_t{1} << 23)) >> 24, 65535));\n        }", "(uint32_t{1} << 23)) >> 24, 65535));\n        }\n        ++y[17];", "tables"),
    Mutant("quotient: the last correction", "reciprocal.hpp", "while (n - q * d >= d) ++q;", "while (n - q * d > d) ++q;", "reciprocals"),
    Mutant("floor_quotient: below zero", "reciprocal.hpp", ": -1 - static_cast<int32_t>(quotient(static_cast<uint32_t>(-1 - n), d));", ": -static_cast<int32_t>(quotient(static_cast<uint32_t>(-1 - n), d));", "reciprocals"),
    Mutant("shift_right_round: half", "bits.hpp", "constexpr int32_t shift_right_round(int32_t x, int n) {\n    return n == 0 ? x : (x >> n) + ((x >> (n - 1)) & 1);", "constexpr int32_t shift_right_round(int32_t x, int n) {\n    return n == 0 ? x : (x >> n) + ((x - 1) >> (n - 1) & 1);", "bits"),
    Mutant("Scaled: the carry of rounding", "scaled.hpp", "            mantissa >>= 1;\n            ++exponent;", "            mantissa >>= 1;", "scaled"),
    Mutant("sqrt: the exponent", "rsqrt.hpp", "/ 2 - 63);", "/ 2 - 62);", "roots"),
    Mutant("rounded_root: half", "rounded.hpp", "return n - multiply(root, root) > root ? root + 1 : root;", "return n - multiply(root, root) >= root ? root + 1 : root;", "roots"),
    Mutant("rounded_quotient: half", "rounded.hpp", "if ((n - q * d) * 2 >= d) ++q;", "if ((n - q * d) * 2 >= d + 1) ++q;", "roots"),
    Mutant("luma: a weight", "channels.hpp", "green = 38470", "green = 38471", "colors"),
    Mutant("as_accumulator: the bit that makes one", "accumulator.hpp", "+ (c.raw >> 15)", "+ (c.raw >> 14)", "colors"),
    Mutant("sincos: pi", "angle.hpp", "0xC90FDAA2", "0xC90FDAA3", "angles",
           "an angle moves by a quarter of an ulp at most, and not where the series errs most"),
    Mutant("sincos: a divisor", "angle.hpp", "0x0CCCCCCD", "0x0CCCCCCE", "tables"),
    Mutant("Angle: a literal's half", "angle.hpp", "(scaled + 180) / 360", "(scaled + 180) / 360 + 1", "angles"),
    Mutant("log table: an entry", "shininess_shared.hpp", "        lower_by_curvature(exact, y);\n    }\n};\n/// 2^-f", "        lower_by_curvature(exact, y);\n        ++y[30];\n    }\n};\n/// 2^-f", "tables"),
    Mutant("exp table: an entry", "shininess_shared.hpp", "y[128] = y[0] >> 1;", "y[128] = y[0] >> 1, --y[60];", "tables"),
    Mutant("window: an entry", "shininess_window.hpp", "w.y[i] = lowered(exact, i);", "w.y[i] = static_cast<uint16_t>(lowered(exact, i) + (i == 5));", "tables"),
    Mutant("middles: a logarithm", "scaled_power.hpp", "uint64_t{inverse[i]} << 32) + 0x8000) >> 16);\n        }", "uint64_t{inverse[i]} << 32) + 0x8000) >> 16);\n        }\n        ++log[9];", "tables"),
    Mutant("middles: a power", "scaled_power.hpp", "((2 * i + 1) << 42));", "((2 * i + 1) << 42)) + (i == 20);", "tables"),
    Mutant("exp2_negative: its rounding", "power.hpp", "(y >> 32) + (y >> 31 & 1)", "(y >> 32) + 1", "powers",
           "rounded up it errs by a unit at most, as 2^0 does, which is not in the range"),
    Mutant("roots of a half: an entry", "power.hpp", "            square = y[k];\n        }", "            square = y[k];\n        }\n        ++y[20];", "tables"),
    Mutant("arctangent: the first guess", "arc.hpp", "c1 = 0x288E9CFD", "c1 = 0x288E9CFE", "angles", "the Newton step squares the guess's error of 6e-4 away"),
]


def measure(mutant, compiler, project, scratch):
    """What the measured bounds say: nothing for a mutant that lives."""
    home = scratch / mutant.name.replace(" ", "_").replace(":", "").replace(",", "")
    shutil.rmtree(home, ignore_errors=True)
    include = home / "include"
    shutil.copytree(project / "core/include", include)
    if mutant.old:
        header = include / "shade16/num" / mutant.header
        header.write_text(header.read_text().replace(mutant.old, mutant.new))
    files = mutant.measures.split()
    sources = [project / "tests/bounds/measure_some.cpp", project / "host_sim/bounds/measure.cpp"] + [project / f"host_sim/bounds/{file}.cpp" for file in files]
    calls = "".join(f"add_{file}(all);" for file in files)
    command = [compiler, "-std=c++20", "-O1", f"-I{include}", f"-I{project}", f"-DSHADE16_ADD={calls}", *map(str, sources), "-o", str(home / "program")]
    built = subprocess.run(command, capture_output=True, text=True)
    if built.returncode != 0:
        raise SystemExit(f"{mutant.name}: does not compile:\n{built.stderr}")
    try:
        ran = subprocess.run([home / "program"], capture_output=True, text=True, timeout=300)
    except subprocess.TimeoutExpired:
        return "it does not end"
    finally:
        shutil.rmtree(home)
    if ran.returncode not in (0, 1):
        return f"it ended with {ran.returncode}"
    return ran.stdout.strip()


def main(compiler, project, scratch):
    project, scratch = pathlib.Path(project), pathlib.Path(scratch)
    scratch.mkdir(parents=True, exist_ok=True)
    for mutant in MUTANTS:  # before anything is compiled
        count = (project / "core/include/shade16/num" / mutant.header).read_text().count(mutant.old)
        if count != 1:
            print(f"{mutant.name}: {mutant.header} holds {mutant.old!r} {count} times; expected it once.")
            return 1
    every = " ".join(sorted({file for mutant in MUTANTS for file in mutant.measures.split()}))
    with ThreadPoolExecutor(2) as pool:
        verdicts = list(pool.map(lambda m: measure(m, compiler, project, scratch), [Mutant("the core as it is", "", "", "", every), *MUTANTS]))
    if verdicts[0]:
        print(f"The core as it is breaks a bound: {verdicts[0]}.")
        return 1
    killed, unexplained = 0, 0
    for mutant, verdict in zip(MUTANTS, verdicts[1:]):
        killed += bool(verdict)
        unexplained += not verdict and not mutant.survives
        print(f"{mutant.name}: " + (f"killed, {verdict.splitlines()[0]}" if verdict else f"lives, {mutant.survives or 'and nobody knows why'}"))
    print(f"{killed} of {len(MUTANTS)} killed; expected at least {NEEDED_KILLS}, and a reason for each other.")
    return 0 if killed >= NEEDED_KILLS and unexplained == 0 else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
