"""scripts/boards/stacks.py must complain where it should."""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts/boards"))
from stacks import complaint, told

RECORD = {"board": (500, 1000)}


class Stacks(unittest.TestCase):
    def test_what_is_recorded_is_right(self):
        self.assertEqual(complaint("board", 500, 1000, RECORD), "")
        self.assertEqual(complaint("board", 499, 1000, RECORD), "")

    def test_a_byte_more_is_found(self):
        self.assertIn("uses 501 bytes", complaint("board", 501, 1000, RECORD))

    def test_a_full_stack_is_found(self):
        self.assertIn("which has 1000", complaint("board", 1000, 1000, {"board": (1000, 1000)}))

    def test_another_stack_or_no_row_is_found(self):
        self.assertIn("stack of 999", complaint("board", 500, 999, RECORD))
        self.assertIn("no row", complaint("other", 500, 1000, RECORD))

    def test_every_emulator_can_be_told(self):
        for command in (["qemu", "-semihosting-config", "enable=on,target=native,chardev=text", "-kernel"], ["qemu", "-semihosting"], ["node", "run.mjs"]):
            self.assertIn("stack", " ".join(told(command, "stack")))


if __name__ == "__main__":
    unittest.main()
