"""check_table.py itself, on made-up pages: it must be able to fail."""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from check_table import complaints_about, defined_tests

HEAD = "# Extremes\n\n| trap | elsewhere | shade16 | held by |\n|---|---|---|---|\n"
GOOD = "| zero | traps | is zero | `Suite.Zero` |\n"


class Table(unittest.TestCase):
    def complaints(self, rows, must_be_named=frozenset(), least_rows=1):
        return list(complaints_about(HEAD + rows, {"Suite.Zero", "Suite.One"}, must_be_named, least_rows))

    def test_a_good_table_passes(self):
        self.assertEqual(self.complaints(GOOD), [])
        self.assertEqual(self.complaints(GOOD + "| one | traps | is one | `Suite.Zero`, `Suite.One` |\n"), [])

    def test_a_test_that_does_not_exist(self):
        (complaint,) = self.complaints("| zero | traps | is zero | `Suite.Zero`, `Suite.Gone` |\n")
        self.assertIn("line 5: there is no test Suite.Gone", complaint)

    def test_a_row_without_a_test(self):
        (complaint,) = self.complaints("| zero | traps | is zero | by hand |\n")
        self.assertIn("no test holds 'zero'", complaint)

    def test_a_row_without_a_promise(self):
        (complaint,) = self.complaints("| zero | traps |  | `Suite.Zero` |\n")
        self.assertIn("none of them empty", complaint)

    def test_a_row_twice(self):
        (complaint,) = self.complaints(GOOD + GOOD)
        self.assertIn("has a row already", complaint)

    def test_a_test_of_extremes_that_no_row_names(self):
        (complaint,) = self.complaints(GOOD, must_be_named={"Suite.One"})
        self.assertIn("the test Suite.One is in no row", complaint)

    def test_too_few_rows(self):
        (complaint,) = self.complaints(GOOD, least_rows=2)
        self.assertIn("there are 1 rows, and should be at least 2", complaint)

    def test_names_of_every_kind_are_found_and_others_not(self):
        defined = defined_tests(Path(__file__).resolve().parents[2])
        for name in ("Q16.ProductsSaturateAtBothEnds", "Lit.NoLightIsBlack", "OnePicture.BandsOfAnyHeightEqualTheFullFrame", "compile_fail.target_too_wide", "proof.multiply"):
            self.assertIn(name, defined)
        for name in ("Q16.Gone", "compile_fail.gone", "proof.gone"):
            self.assertNotIn(name, defined)


if __name__ == "__main__":
    unittest.main()
