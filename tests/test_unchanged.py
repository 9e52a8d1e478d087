#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests/unchanged takes for a difference that is meant, and what it refuses."""
import contextlib
import importlib.machinery
import importlib.util
import io
import json
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # nothing beside the script
LOADER = importlib.machinery.SourceFileLoader(
    "unchanged", str(pathlib.Path(__file__).with_name("unchanged")))
unchanged = importlib.util.module_from_spec(importlib.util.spec_from_loader("unchanged", LOADER))
LOADER.exec_module(unchanged)

BASE = "0123456789" * 4
# The texts of twenty outputs, and of the same with one that differs.
SAME = {f"cli/{example}/{number}.txt": "held\n" for example in "ab" for number in range(10)}
OTHER = SAME | {"cli/a/7.txt": "failed\n"}


class Compared(unittest.TestCase):
    def compare(self, first, second, *allowed):
        """Whether two sets of outputs are taken for the same, and what is printed of them."""
        with tempfile.TemporaryDirectory() as place:
            folders = [pathlib.Path(place) / name for name in ("before", "after")]
            for folder, texts in zip(folders, (first, second)):
                for name, text in texts.items():
                    (folder / name).parent.mkdir(parents=True, exist_ok=True)
                    (folder / name).write_text(text)
            with contextlib.redirect_stdout(io.StringIO()) as said:
                return unchanged.compare(*folders, (BASE, list(allowed))), said.getvalue()

    def assert_refused(self, found, *words):
        self.assertFalse(found[0], found[1])
        for word in words:
            self.assertIn(word, found[1])


class Differences(Compared):
    def test_equal_outputs_differ_in_nothing(self):
        self.assertTrue(self.compare(SAME, SAME)[0])

    def test_a_difference_is_refused_and_shown(self):
        self.assert_refused(self.compare(SAME, OTHER), "cli/a/7.txt: differs", "-held", "+failed")

    def test_an_output_more_or_less_is_a_difference(self):
        more = SAME | {"cli/f/0.txt": ""}
        self.assert_refused(self.compare(SAME, more), "cli/f/0.txt: is new")
        self.assert_refused(self.compare(more, SAME), "cli/f/0.txt: is missing")

    def test_a_pattern_allows_the_outputs_that_it_fits_alone(self):
        self.assertTrue(self.compare(SAME, OTHER, ("cli/a/7.*", "a reason"))[0])
        two = OTHER | {"cli/b/7.txt": "failed\n"}
        self.assert_refused(self.compare(SAME, two, ("cli/a/7.*", "a reason")), "cli/b/7.txt: differs")

    def test_a_pattern_that_nothing_needs_is_listed(self):
        same, said = self.compare(SAME, SAME, ("cli/a/7.*", "a reason"))
        self.assertTrue(same)
        self.assertIn("nothing differs by cli/a/7.*", said)

    def test_the_order_of_keys_alone_may_be_allowed(self):
        one = SAME | {"cli/a/x.json": '{"a": 1, "b": 2}'}
        order = ("cli/a/x.json", "order: of the table")
        self.assertTrue(self.compare(one, one | {"cli/a/x.json": '{"b": 2, "a": 1}'}, order)[0])
        self.assert_refused(self.compare(one, one | {"cli/a/x.json": '{"b": 2, "a": 3}'}, order),
                            "cli/a/x.json: differs")


class Shares(Compared):
    def test_a_pattern_that_fits_more_than_a_twentieth_is_refused(self):
        self.assertTrue(self.compare(SAME, OTHER, ("cli/a/7.txt", "fits one of twenty"))[0])
        wide = self.compare(SAME, OTHER, ("cli/a/[67].txt", "fits two"))
        self.assert_refused(wide, "cli/a/[67].txt fits 2 of 20 outputs, more than 5%")
        self.assert_refused(self.compare(SAME, SAME, ("*", "all that may come")), "* fits 20 of 20")

    def test_a_list_that_fits_more_than_a_quarter_is_refused(self):
        narrow = [(f"cli/a/{number}.txt", "fits one") for number in range(6)]
        self.assertTrue(self.compare(SAME, SAME, *narrow[:5])[0])
        self.assert_refused(self.compare(SAME, SAME, *narrow), "fit 6 of 20 outputs, more than 25%")

    def test_patterns_that_fit_the_same_outputs_count_once(self):
        same = [("cli/a/7.txt", f"reason {number}") for number in range(9)]
        self.assertTrue(self.compare(SAME, OTHER, *same)[0])


class Fronts(Compared):
    """Of a search that had no time for all of its front."""

    def outputs(self, front, is_whole, time=1, table="one"):
        text = {"cycle_time_min": time, "front": front, "front_is_whole": is_whole}
        return SAME | {"cli/a/front.json": json.dumps(text), "export/ru/a/search.csv": table,
                       "export/ru/b/search.csv": "one"}

    def test_a_front_cut_short_is_compared_as_far_as_both_came(self):
        whole, short = self.outputs([1, 2, 3], True), self.outputs([1, 2], False, table="two")
        for pair in ((whole, short), (short, whole)):
            same, said = self.compare(*pair)
            self.assertTrue(same, said)
            self.assertIn("2 outputs with a front cut short", said)

    def test_another_front_or_answer_is_a_difference(self):
        short = self.outputs([1, 2], False)
        self.assert_refused(self.compare(short, self.outputs([1, 3], False)), "front.json: differs")
        self.assert_refused(self.compare(short, self.outputs([1, 2], False, time=2)),
                            "front.json: differs")

    def test_whole_fronts_and_tables_of_other_examples_are_compared(self):
        self.assert_refused(self.compare(self.outputs([1, 2, 3], True), self.outputs([1, 2], True)),
                            "front.json: differs")
        one = self.outputs([1, 2], False)
        self.assert_refused(self.compare(one, one | {"export/ru/b/search.csv": "two"}),
                            "export/ru/b/search.csv: differs")


class Printed(unittest.TestCase):
    def test_progress_is_left_out_and_nothing_else(self):
        said = ("Stages: 3, best 43.71 s, none below 40 s, 2103 judged, 5 s\n"
                "Ступеней: 3, лучшее 43,71 с, проверено 2103, 5 с\n"
                "17 of 50 parts, 2 s left\n0 of 12 points\n")
        stays = "1 of 17: wheel-dull.sparkout\nsparkout: the project has no batch (/batch)\n"
        self.assertEqual(unchanged.PROGRESS.sub(b"", (said + stays).encode()).decode(), stays)


class List(unittest.TestCase):
    def test_base_and_patterns_are_read(self):
        text = f"# A remark.\nbase {BASE}\n\ncli/a/* The reason has words\n"
        self.assertEqual(unchanged.expected_differences(text),
                         (BASE, [("cli/a/*", "The reason has words")]))

    def test_what_cannot_be_judged_by_is_refused(self):
        for text, word in (("", "base COMMIT"), ("cli/* A reason\n", "base COMMIT"),
                           ("base 6758418d\n", "40 digits"),
                           (f"base {BASE}\ncli/a/*\n", "without its reason: cli/a/*")):
            with self.subTest(text), self.assertRaisesRegex(ValueError, word.replace("*", r"\*")):
                unchanged.expected_differences(text)

    def test_outputs_are_known_before_anything_is_run(self):
        names = unchanged.names_of_outputs(unchanged.ROOT)
        for name in ("cli/shaft-30h6-factory/front.json", "cli/spindle/merged.txt", "new/bore.sparkout",
                     "export/ru/wheel-dull/search.xlsx", "python/starting.json",
                     "report/en/card/md/wheel-dull.md", "view/en/wheel-dull/feeds.png"):
            self.assertIn(name, names)
        everything = [(f"{kind}/*", "a reason") for kind in {name.split("/")[0] for name in names}]
        self.assertTrue(unchanged.too_wide(everything, names))


if __name__ == "__main__":
    unittest.main()
