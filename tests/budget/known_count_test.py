"""The counter must be exact: known_count.cpp says how many instructions its first frame has.

usage: known_count_test.py <image> <board> <instruction_counter.so>
"""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts/bench"))
from counting import FrameCount
from image import Image

IN_MAIN, IN_HELPER = 6 + 2 * 100 + 3, 3 * 3


class KnownCount(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.image = Image(IMAGE)
        helper = cls.image.extent("helper")
        cls.frame = FrameCount(cls.image, PLUGIN, BOARD, [(helper.start, helper.stop)])

    def test_every_instruction_of_the_first_frame_is_counted_once(self):
        self.assertEqual(self.frame.instructions, IN_MAIN + IN_HELPER)
        self.assertEqual(self.frame.by_function(), {"main": IN_MAIN, "helper": IN_HELPER})

    def test_shared_code_is_counted_for_each_caller(self):
        by_caller = {}
        for _, caller, count in self.frame.counts:
            by_caller[caller] = by_caller.get(caller, 0) + count
        self.assertEqual(by_caller.pop(0), IN_MAIN)
        self.assertEqual(list(by_caller.values()), [3, 3, 3])
        self.assertTrue(all(caller in self.image.extent("main") for caller in by_caller))

    def test_the_deepest_store_is_the_stack(self):
        self.assertEqual(self.frame.stack_bytes, 4096)

    def test_two_runs_agree(self):
        self.assertEqual(FrameCount(self.image, PLUGIN, BOARD).instructions, self.frame.instructions)


if __name__ == "__main__":
    IMAGE, BOARD, PLUGIN = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])
