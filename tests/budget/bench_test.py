"""The parts of scripts/bench.sh that need no emulator, on made-up counts."""
import sys
import unittest
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "scripts/bench"))
import budgets
import sizes
import stages
import tables
from budgets import Budget
from commands import BenchError
from image import Frame, short_path
from names import short_name
from plan import BOARDS, SCENES, Row, budget_rows, tier_rows

S1, S2 = (Row(scene, "qemu_mps2_an385", "mediump") for scene in ("S1", "S2"))


class Budgets(unittest.TestCase):
    def judged(self, count, limit=None, recorded=100000):
        return budgets.compare({S1: Budget(recorded, limit)}, {S1: count})

    def test_a_rise_above_one_percent_fails_and_names_the_row(self):
        (complaint,), notes = self.judged(101100)
        self.assertIn(f"{S1} takes 101100 instructions, 1.10 % more than the 100000", complaint)
        self.assertEqual(notes, [])

    def test_a_smaller_rise_passes(self):
        self.assertEqual(self.judged(100900), ([], []))
        self.assertEqual(self.judged(101000), ([], []))

    def test_the_limit_holds_whatever_is_recorded(self):
        (complaint,), _ = self.judged(750001, limit=750000, recorded=750000)
        self.assertIn(f"{S1} takes 750001 instructions; its limit is 750000", complaint)
        self.assertEqual(self.judged(750000, limit=750000, recorded=750000), ([], []))

    def test_a_fall_is_noted_only(self):
        complaints, (note,) = self.judged(98000)
        self.assertEqual(complaints, [])
        self.assertIn("2.00 % less", note)
        self.assertIn("--bless", note)

    def test_a_count_without_a_row_fails(self):
        (complaint,), _ = budgets.compare({S1: Budget(5, None)}, {S1: 5, S2: 5})
        self.assertIn(f"{S2} has no row", complaint)

    def test_a_row_without_a_count_fails(self):
        (complaint,), _ = budgets.compare({S1: Budget(5, None), S2: Budget(5, None)}, {S1: 5})
        self.assertIn(f"{S2} is in {budgets.FILE} but was not measured", complaint)

    def test_blessing_keeps_the_limits(self):
        text = budgets.write({S1: 7, S2: 8}, {S1: Budget(5, 9)})
        self.assertEqual(text.splitlines(), ["scene,board,tier,instructions,limit", "S1,qemu_mps2_an385,mediump,7,9",
                                             "S2,qemu_mps2_an385,mediump,8,"])
        self.assertEqual(budgets.parse(text), {S1: Budget(7, 9), S2: Budget(8, None)})

    def test_another_header_or_a_second_row_is_refused(self):
        self.assertRaises(BenchError, budgets.parse, "scene,board\n")
        self.assertRaises(BenchError, budgets.parse, budgets.write({S1: 7}, {}) + "S1,qemu_mps2_an385,mediump,8,\n")

    def test_the_file_has_every_row_and_the_limits(self):
        table = budgets.parse((PROJECT / budgets.FILE).read_text())
        self.assertEqual(sorted(table), sorted(budget_rows()))
        limits = {row.scene: budget.limit for row, budget in table.items() if budget.limit is not None}
        self.assertEqual(limits, {"S1": 750000, "S2": 1900000, "S3": 1000000, "S6": 450000})


class Stages(unittest.TestCase):
    def test_every_file_of_the_pipeline_has_a_stage_and_exists(self):
        core = PROJECT / "core/include/shade16"
        there = {f"pipeline/{path.name}" for path in (core / "pipeline").glob("*.hpp")}
        self.assertEqual({file for file in stages.files() if file.startswith("pipeline/")}, there)
        for file in stages.files():
            self.assertTrue((core / file).exists(), file)

    def test_the_innermost_file_with_a_stage_decides(self):
        multiply = Frame("shade16::multiply(int, int)", "num/mulhi.hpp")
        planes = Frame("shade16::PackedPlanes::PackedPlanes<shade16::mediump>(int)", "pipeline/paint_packed.hpp")
        span = Frame("void shade16::PackedPainter<shade16::Rgb565, true>::span(int) const", "pipeline/paint_packed.hpp")
        self.assertEqual(stages.stage_of([multiply, planes, span]), "setup")
        self.assertEqual(stages.stage_of([multiply, span]), "raster")

    def test_code_without_a_stage_works_for_its_caller(self):
        self.assertIsNone(stages.stage_of([Frame("memcpy", "firmware/runtime/memory_functions.cpp")]))
        self.assertIsNone(stages.stage_of([]))

    def test_a_new_file_of_the_pipeline_is_named(self):
        chain = [Frame("f", "pipeline/new.hpp")]
        self.assertRaisesRegex(BenchError, "pipeline/new.hpp has no stage", stages.stage_of, chain)


class Sizes(unittest.TestCase):
    def test_code_belongs_to_a_stage_or_to_whom_it_is(self):
        span = Frame("void shade16::PackedPainter<shade16::Rgb565, true>::span(int) const", "pipeline/paint_packed.hpp")
        for chain, part in {(span, Frame("main", "firmware/apps/turntable.cpp")): "raster",
                            (Frame("shade16::multiply(int, int)", "num/mulhi.hpp"), span): "raster",
                            (Frame("shade16::multiply(int, int)", "num/mulhi.hpp"),): "num",
                            (Frame("main", "firmware/apps/turntable.cpp"),): "app",
                            (Frame("memcpy", "firmware/runtime/memory_functions.cpp"),): "runtime",
                            (Frame("__aeabi_lmul", "lib1funcs.S"),): "compiler's library", (): "compiler's library"}.items():
            self.assertEqual(sizes.part_of(chain), part)


class Names(unittest.TestCase):
    def test_only_the_name_is_left(self):
        for long, short in {
                "void shade16::detail::walk<false, shade16::Edge>(shade16::Box const&)": "walk",
                "shade16::Pipeline<shade16::Needs{true, false}>::draw(int) const": "Pipeline::draw",
                "shade16::operator-(shade16::Block, shade16::Block)": "operator-",
                "shade16::operator<< <int>(int)": "operator<<",
                "auto shade16::f<4>(int) const::{lambda(int)#1}::operator()(int) const": "f::{lambda}::operator()",
                "light_point(int) [clone .isra.0]": "light_point",
                "memcpy": "memcpy"}.items():
            self.assertEqual(short_name(long), short)

    def test_a_path_begins_where_the_project_does(self):
        for long, short in {"/a/core/include/shade16/num/q16.hpp": "num/q16.hpp",
                            "/tests/a/firmware/apps/scene.cpp": "firmware/apps/scene.cpp",
                            "../../lib1funcs.S": "lib1funcs.S", "??": "??"}.items():
            self.assertEqual(short_path(long), short)


class Tables(unittest.TestCase):
    def setUp(self):
        values = dict.fromkeys(tables.COLUMNS, 1234)
        self.results = tables.in_order({row: values for row in tier_rows() + budget_rows()})

    def test_rows_are_sorted(self):
        self.assertEqual(len(self.results), len(BOARDS) * len(SCENES) + 2 * len(SCENES))
        self.assertEqual([row.tier for row in list(self.results)[:3]], ["lowp", "mediump", "highp"])

    def test_the_document_changes_between_its_markers_only(self):
        text = ("a\n<!-- boards: written by scripts/bench.sh --update -->\nold\n<!-- end of boards -->\nb\n"
                "<!-- tiers: written by scripts/bench.sh --update -->\n<!-- end of tiers -->\nc\n")
        new = tables.update_document(text, self.results)
        self.assertRegex(new, r"(?s)^a\n<!-- boards.*\| S1 \| qemu_mps2_an385 \| 1,234 .*<!-- end of boards -->\nb\n")
        self.assertRegex(new, r"(?s)<!-- tiers.*\| S1 \| 1,234 \(100 %\).*<!-- end of tiers -->\nc\n$")
        self.assertNotIn("old", new)
        self.assertEqual(tables.update_document(new, self.results), new)
        self.assertRaisesRegex(BenchError, "lacks the line", tables.update_document, "a\n", self.results)


if __name__ == "__main__":
    unittest.main()
