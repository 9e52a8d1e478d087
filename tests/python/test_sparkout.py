# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python module gives the numbers of the command line, as arrays where there are many.

Called with the module, sparkout-cli and the folder of the examples."""
import functools
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

MODULE, CLI, EXAMPLES = sys.argv.pop(1), sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(pathlib.Path(MODULE).parent))
import sparkout  # noqa: E402

FACTORY = EXAMPLES / "shaft-30h6-factory.sparkout"
MEASURED = EXAMPLES / "shaft-30h6-measured.sparkout"
TWO_STAGE = EXAMPLES / "plunge-shaft-two-stage.sparkout"
SPINDLE = EXAMPLES / "setups/spindle.sparkout"


@functools.cache
def printed(*arguments):
    return subprocess.run([CLI, *arguments], capture_output=True, text=True, check=False).stdout


def cli(*arguments):
    """The JSON that the command line prints; of the same words it is asked once."""
    return json.loads(printed(*map(str, arguments)))


class OneLine(unittest.TestCase):
    """As a user types it: python3 -c, in a process of its own."""

    def test_search_batch_phases_and_fit_have_the_numbers_of_the_command_line(self):
        fit = "compliance,alpha"
        for question, file, command, *options in (
            ("search(project).to_dict()", TWO_STAGE, "optimize"),
            ("batch(project).to_dict()", FACTORY, "batch"),
            ("phases(project)", FACTORY, "phases"),
            (f"measured(project, fit='{fit}')", MEASURED, "measured", "--fit", fit),
        ):
            with self.subTest(command):
                line = ("import json, sys, sparkout; project = sparkout.Project.read(sys.argv[1]); "
                        f"print(json.dumps(sparkout.{question}))")
                done = subprocess.run(
                    [sys.executable, "-c", line, file], capture_output=True, text=True, check=True,
                    env=os.environ | {"PYTHONPATH": str(pathlib.Path(MODULE).parent)})
                self.assertEqual(json.loads(done.stdout), cli(command, file, *options, "--json"))


class Starting(unittest.TestCase):
    def test_the_project_is_that_of_the_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "seat.sparkout"
            subprocess.run([CLI, "new", "35k6", "--length", "28", "--stock", "0.15", "--ra", "0.8",
                            "--machine", "3М153", "-o", file], check=True, capture_output=True)
            mine = sparkout.starting("35k6", length_mm=28, stock_mm=0.15, ra_um=0.8,
                                     machine="3М153")
            self.assertEqual(mine, sparkout.Project.read(file))
        self.assertTrue(sparkout.phases(mine)["decided"])

    def test_what_is_refused_is_named(self):
        size = {"length_mm": 28, "stock_mm": 0.15}
        with self.assertRaisesRegex(ValueError, "30z6.*ISO 286"):
            sparkout.starting("30z6", **size)
        with self.assertRaisesRegex(ValueError, "turning.*plunge"):
            sparkout.starting("35k6", operation="turning", **size)
        with self.assertRaisesRegex(sparkout.ProjectError, "/machine/name.*3М151"):
            sparkout.starting("35k6", machine="no such", **size)
        with self.assertRaisesRegex(sparkout.ProjectError, "(?s)/part/diameter_mm.*3М174"):
            sparkout.starting("300h8", machine="3М151", **size)
        with self.assertRaisesRegex(sparkout.ProjectError, "/part/length_mm"):
            sparkout.starting("40h6", length_mm=90, stock_mm=0.15, shoulder="both")


class Evaluations(unittest.TestCase):
    def test_every_example_has_the_numbers_of_the_command_line(self):
        files = sorted(EXAMPLES.glob("*.sparkout"))
        self.assertGreater(len(files), 5)
        for file in files:
            with self.subTest(file.name):
                evaluation = sparkout.evaluate(sparkout.Project.read(file))
                self.assertEqual(evaluation.to_dict(), cli("simulate", file, "--json"))

    def test_requirements_are_those_of_the_command_line(self):
        for file in sorted(EXAMPLES.glob("*.sparkout")):
            evaluation = sparkout.evaluate(sparkout.Project.read(file))
            stated = evaluation.to_dict()["constraints"]
            mine = [(e["name"], e["where"], e["holds"]) for e in evaluation.requirements]
            self.assertEqual(len(mine), len(set(mine)))
            for worst in stated:  # of each kind
                self.assertIn((worst["name"], worst["where"], worst["ok"]), mine)
            self.assertEqual({e[0] for e in mine}, {e["name"] for e in stated})

    def test_a_cycle_is_judged_for_every_stock(self):
        for file in sorted(EXAMPLES.glob("*.sparkout")):
            judged = sparkout.evaluate(sparkout.Project.read(file)).judged
            stated = cli("simulate", file, "--json")["judged"]
            for key in ("state", "headline", "nominal"):
                self.assertEqual(getattr(judged, key), stated[key])
            for key in ("decided", "holds", "failing_share"):
                self.assertEqual(getattr(judged.stocks, key), stated["stocks"][key])
            self.assertEqual(
                [(each.name, each.why) for each in judged.not_decided],
                [(each["name"], each["why"]) for each in stated["not_decided"]],
            )

    def test_a_batch_is_judged_as_on_the_command_line(self):
        for name in ("shaft-30h6-factory", "shaft-30h6-calibrated"):
            file = EXAMPLES / f"{name}.sparkout"
            evaluation = sparkout.evaluate(sparkout.Project.read(file), batch=True)
            stated = cli("simulate", file, "--batch", "--json")
            self.assertEqual(evaluation.to_dict(), stated)
            judged = evaluation.judged
            for key in ("parts", "seed", "bad"):
                self.assertEqual(getattr(judged.batch, key), stated["judged"]["batch"][key])
            self.assertEqual(list(judged.batch.interval_95), stated["judged"]["batch"]["interval_95"])
        self.assertIsNone(sparkout.evaluate(sparkout.Project.read(FACTORY)).judged.batch)
        self.assertIsNone(sparkout.evaluate(sparkout.Project.read(FACTORY)).judged.measured)

    def test_measured_parts_that_are_moved_are_a_bias(self):
        moved = json.loads((EXAMPLES / "shaft-30h6-calibrated.sparkout").read_text())
        moved["measured"]["summaries"][0]["mean_um"] += 20
        project = sparkout.Project(json.dumps(moved))
        measured = sparkout.evaluate(project, batch=True).judged.measured
        self.assertEqual((measured.name, measured.where), ("diameter_min", "rz1"))
        self.assertAlmostEqual(measured.bias_um, 20, delta=2)
        with self.assertRaisesRegex(ValueError, "threads"):
            sparkout.evaluate(project, batch=True, threads=-1)

    def test_sections_have_their_radii(self):
        project = sparkout.Project.read(FACTORY)
        sections = sparkout.evaluate(project).sections
        self.assertEqual([each["where"] for each in sections], ["rz1", "nz", "rz2"])
        for section in sections:
            radii = section["radii_mm"]
            self.assertEqual(radii.shape, (project["/part/radii_per_section"],))
            self.assertLessEqual(section["diameter_min_mm"], section["diameter_max_mm"])
            self.assertAlmostEqual(2 * radii.mean(), section["diameter_max_mm"], delta=0.02)
            self.assertNotIn("waviness", section)

    def test_waviness_is_known_where_the_runout_of_the_wheel_is(self):
        inputs = json.loads(sparkout.Project.read(FACTORY).to_text())
        inputs["wheel"]["runout"] = {"amplitude_um": 2}
        inputs["part"]["radii_per_section"] = 360
        known = sparkout.evaluate(sparkout.Project(json.dumps(inputs))).sections
        self.assertTrue(all(0 < each["waviness"]["height_um"] <= 4 for each in known))
        inputs["part"]["radii_per_section"] = 12
        with self.assertRaisesRegex(sparkout.ProjectError, "/part/radii_per_section.*12 radii"):
            sparkout.evaluate(sparkout.Project(json.dumps(inputs)))

    def test_sections_part_and_burn_are_those_of_the_command_line(self):
        for file in sorted(EXAMPLES.glob("*.sparkout")):
            evaluation = sparkout.evaluate(sparkout.Project.read(file))
            stated = cli("simulate", file, "--json")
            places = stated.get("sections") or list(stated["zones"].values())
            self.assertEqual(len(evaluation.sections), len(places))
            for mine, its in zip(evaluation.sections, places):
                numbers = its.keys() - {"radii_um", "machine_known", "sections", "waviness"}
                self.assertIn("roundness_um", numbers)
                for key in numbers:
                    value = list(mine[key]) if isinstance(mine[key], tuple) else mine[key]
                    self.assertEqual(value, its[key], key)
            for key in stated["part"].keys() - {"machine_known"}:
                self.assertEqual(getattr(evaluation.part, key), stated["part"][key])
            for key, value in stated["burn"].items():
                self.assertEqual(getattr(evaluation.burn, key), value)

    def test_the_trace_adds_up_to_the_sections(self):
        evaluation = sparkout.evaluate(sparkout.Project.read(FACTORY))
        trace = evaluation.trace()
        for number, section in enumerate(evaluation.sections):
            for k, last in enumerate(section["radii_mm"]):
                mine = (trace["section"] == number) & (trace["radius"] == k)
                self.assertEqual(trace["radius_mm"][mine][-1], last)
                self.assertAlmostEqual(
                    trace["actual_mm"][mine].sum(), trace["accumulated_mm"][mine][-1], delta=1e-12
                )

    def test_feeds_end_with_the_cycle(self):
        evaluation = sparkout.evaluate(sparkout.Project.read(FACTORY))
        feeds = evaluation.feeds()
        self.assertEqual(set(feeds), {"rz1", "nz", "rz2"})
        for column in feeds.values():
            self.assertEqual(column["count"][-1], evaluation.count)
            self.assertTrue((np.diff(column["actual_sum_um"]) >= -1e-9).all())
        self.assertAlmostEqual(evaluation.time_by_stage_s.sum(), evaluation.time_s, delta=1e-9)

    def test_arrays_outlive_what_made_them(self):
        radii = sparkout.evaluate(sparkout.Project.read(FACTORY)).sections[0]["radii_mm"]
        before = radii.copy()
        for _ in range(20):
            sparkout.evaluate(sparkout.Project.read(FACTORY))
        self.assertTrue((radii == before).all())


class Projects(unittest.TestCase):
    def test_a_project_written_is_the_project_read(self):
        project = sparkout.Project.read(FACTORY)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "вал.sparkout"
            project.write(path)
            self.assertEqual(sparkout.Project.read(path), project)
            self.assertEqual(path.read_text(encoding="utf-8"), project.to_text())

    def test_values_are_changed_in_another_project(self):
        project = sparkout.Project.read(FACTORY)
        dull = project.with_values({"/wheel/dullness": 0.2, "/title": "dull"})
        self.assertEqual((dull["/wheel/dullness"], dull["/title"]), (0.2, "dull"))
        self.assertNotEqual(dull, project)
        self.assertGreater(
            sparkout.evaluate(dull).peak_normal_force_n,
            sparkout.evaluate(project).peak_normal_force_n,
        )

    def test_values_may_be_numpys(self):
        project = sparkout.Project.read(FACTORY)
        changed = project.with_values(
            {"/part/radii_per_section": np.int64(72), "/wheel/dullness": np.float64(0.1)}
        )
        self.assertEqual(changed["/part/radii_per_section"], 72)
        with self.assertRaises(TypeError):
            project.with_values({"/wheel/dullness": object()})

    def test_values_go_where_there_is_a_place(self):
        project = sparkout.Project.read(FACTORY)
        stages = project["/cycle/stages"]
        more = project.with_values({f"/cycle/stages/{len(stages)}": stages[-1]})
        self.assertEqual(len(more["/cycle/stages"]), len(stages) + 1)
        for path in ("/cycle/stages/4000000000/stock_mm", "/cycle/stages/99", "/no/such/place"):
            with self.subTest(path), self.assertRaises(KeyError):
                project.with_values({path: 1})
        for number in (float("nan"), float("inf")):
            with self.assertRaises(ValueError):
                project.with_values({"/wheel/dullness": number})

    def test_projects_compare_with_anything(self):
        project = sparkout.Project.read(FACTORY)
        self.assertFalse(project == None)  # noqa: E711
        self.assertFalse(project == 3)

    def test_faults_name_path_value_and_range(self):
        project = sparkout.Project.read(FACTORY)
        with self.assertRaises(sparkout.ProjectError) as raised:
            project.with_values({"/wheel/width_mm": -1})
        fault = raised.exception.issues[0]
        self.assertEqual(fault.path, "/wheel/width_mm")
        self.assertTrue(fault.is_error)
        self.assertEqual(fault.code, "out_of_range")
        self.assertIn("-1", fault.value)
        self.assertIn("mm", fault.limit)
        self.assertIn("/wheel/width_mm", str(raised.exception))
        self.assertIsInstance(raised.exception, ValueError)

    def test_what_is_no_project_is_refused(self):
        for text in ("", "{}", "[1", '{"format": "sparkout-project"}', "null", "\0"):
            with self.subTest(text), self.assertRaises(sparkout.ProjectError):
                sparkout.Project(text)

    def test_unknown_paths_and_missing_files_raise_what_python_raises(self):
        project = sparkout.Project.read(FACTORY)
        for path in ("/wheel/sharpness", "wheel", "/cycle/stages/99"):
            with self.subTest(path), self.assertRaises(KeyError):
                project[path]
        with self.assertRaises(FileNotFoundError):
            sparkout.Project.read("/nowhere/at-all.sparkout")


class Studies(unittest.TestCase):
    def test_phases_and_dressing_are_those_of_the_command_line(self):
        project = sparkout.Project.read(FACTORY)
        self.assertEqual(sparkout.phases(project), cli("phases", FACTORY, "--json"))
        self.assertEqual(
            sparkout.phases(project, from_mm=0.149, to_mm=0.15),
            cli("phases", FACTORY, "--from", "0.149", "--to", "0.15", "--json"),
        )
        waves = cli("waves", FACTORY, "--count", "70", "--frequencies", "46.7,25", "--json")
        self.assertEqual(sparkout.waves(project, 70, frequencies_hz=[46.7, 25]), waves)
        with self.assertRaisesRegex(ValueError, "counted: 3; allowed: 4"):
            sparkout.waves(project, 3)
        with self.assertRaisesRegex(ValueError, "frequencies_hz: 0"):
            sparkout.waves(project, 70, frequencies_hz=[0])
        with self.assertRaisesRegex(ValueError, "from_mm"):
            sparkout.phases(project, from_mm=0.2, to_mm=0.1)
        by_position = project.with_values({"/gauge/control": "position"})
        with self.assertRaisesRegex(sparkout.ProjectError, "gauge control"):
            sparkout.phases(by_position)
        with open(SPINDLE, encoding="utf-8") as file:
            self.assertEqual(sparkout.dressing(file.read()), cli("dressing", SPINDLE, "--json"))
        with self.assertRaisesRegex(sparkout.ProjectError, "wear"):
            sparkout.dressing(project.to_text())

    def test_a_batch_is_that_of_the_command_line(self):
        batch = sparkout.batch(sparkout.Project.read(FACTORY))
        summary = cli("batch", FACTORY, "--json")
        self.assertEqual(batch.status, "completed")
        self.assertEqual(batch.to_dict(), summary)
        self.assertEqual(batch.values.shape, (summary["parts"], len(batch.quantities)))
        self.assertEqual(batch.factor_values.shape, (summary["parts"], len(batch.factors)))
        self.assertEqual(len(summary["characteristics"]), len(batch.quantities))
        for column, each in zip(batch.values.T, summary["characteristics"]):
            self.assertEqual((np.nanmin(column), np.nanmax(column)), (each["min"], each["max"]))

    def test_threads_change_nothing(self):
        project = sparkout.Project.read(FACTORY)
        one, three = sparkout.batch(project, threads=1), sparkout.batch(project, threads=3)
        np.testing.assert_array_equal(one.values, three.values)

    def test_a_sweep_is_that_of_the_command_line(self):
        axis = {"input": "/wheel/dullness", "from": 0.02, "to": 0.1, "points": 5}
        project = sparkout.Project.read(FACTORY).with_values({"/sweep": {"inputs": [axis]}})
        sweep = sparkout.sweep(project)
        self.assertEqual(sweep.statuses, ["completed"] * 5)
        np.testing.assert_allclose(sweep.points[:, 0], np.linspace(0.02, 0.1, 5))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "sweep.sparkout"
            project.write(path)
            stated = cli("sweep", path, "--json")
        points = stated["points"]
        self.assertEqual(sweep.status, "completed")
        self.assertEqual(sweep.to_dict(), stated)
        time_column = sweep.quantities.index("time part [s]")
        for row, point in zip(sweep.values, points):
            stated = next(each for each in point["results"] if each["name"] == "time")
            self.assertEqual(row[time_column], stated["value"])

    def test_a_search_is_that_of_the_command_line(self):
        file = EXAMPLES / "shaft-30h6-optimal.sparkout"
        search = sparkout.search(sparkout.Project.read(file))
        stated = cli("optimize", file, "--json")
        for member in ("status", "method", "heuristic", "cycle_time_min", "gap", "grid_size"):
            self.assertEqual(getattr(search, member), stated[member], member)
        self.assertIsNone(search.rounds)  # of a robust search alone
        self.assertEqual(search.time_s / 60, stated["cycle_time_min"])
        self.assertEqual(search.binding, stated["binding"])
        found = sparkout.evaluate(search.project)
        self.assertTrue(found.holds)
        self.assertAlmostEqual(found.time_s, search.time_s, delta=1e-6)

    def test_a_search_states_all_that_the_command_line_states(self):
        project = sparkout.Project.read(TWO_STAGE)
        for options, arguments in (
            ({}, []),
            ({"robust": True}, ["--robust"]),
            ({"method": "labels"}, ["--method", "labels"]),
        ):
            search = sparkout.search(project, **options)
            self.assertEqual(search.to_dict(), cli("optimize", TWO_STAGE, *arguments, "--json"))
            self.assertTrue(any("your cycle" in each.lower() for each in search.text))
        front = sparkout.search(sparkout.Project.read(FACTORY), front=True).to_dict()
        self.assertTrue(front["front_is_whole"])
        self.assertEqual(front, cli("optimize", FACTORY, "--front", "--json"))
        with self.assertRaisesRegex(ValueError, "method: best; allowed: search"):
            sparkout.search(project, method="best")

    def test_a_full_search_is_continued_from_the_file_of_the_command_line(self):
        project = sparkout.Project.read(TWO_STAGE).with_values(
            {"/optimisation/stages": [1, 2], "/optimisation/radial_feed_mm_min": [0.1, 0.3, 0.6]})
        with tempfile.TemporaryDirectory() as folder:
            path, kept = (pathlib.Path(folder) / name for name in ("small.sparkout", "kept.json"))
            project.write(path)
            sparkout.search(project, method="full", time_limit_s=0, resume=kept)
            search = sparkout.search(project, method="full", resume=kept)
            pruned = sparkout.search(project)
            self.assertEqual((search.status, search.time_s), (pruned.status, pruned.time_s))
            before = kept.read_bytes()
            stated = cli("optimize", path, "--method", "full", "--resume", kept, "--json")
            self.assertEqual(search.to_dict(), stated)
            self.assertEqual(kept.read_bytes(), before)
            with self.assertRaisesRegex(ValueError, "other options, --method full; these are"):
                sparkout.search(project, method="full", robust=True, resume=kept)
            with self.assertRaisesRegex(ValueError, "resume needs the method full"):
                sparkout.search(project, resume=kept)
            with self.assertRaises(OSError):
                sparkout.search(project, method="full", resume=path.parent / "no" / "kept.json")

    def test_what_was_measured_is_that_of_the_command_line(self):
        project = sparkout.Project.read(MEASURED)
        self.assertEqual(sparkout.measured(project), cli("measured", MEASURED, "--json"))
        parameters = "compliance,alpha"
        fitted = sparkout.measured(project, fit=parameters)
        self.assertEqual(fitted, cli("measured", MEASURED, "--fit", parameters, "--json"))
        self.assertIn("status", fitted["identification"])
        with self.assertRaisesRegex(ValueError, "fit: beauty; allowed: alpha, beta"):
            sparkout.measured(project, fit="beauty")
        with self.assertRaisesRegex(ValueError, "none, huber, tukey"):
            sparkout.measured(project, fit=parameters, loss="l1")
        calibrated = sparkout.calibrated(project, fit="beta,gauge_setting", data="table 2")
        again = sparkout.measured(calibrated, fit="beta")
        self.assertAlmostEqual(again["identification"]["values"][0]["value"], 1, delta=0.05)
        with self.assertRaisesRegex(ValueError, "table: line"):
            sparkout.measured(project, table="Diameter, mm\nthirty\n")

    def test_a_recording_that_the_calibration_has_not_used_is_predicted(self):
        project = sparkout.Project.read(TWO_STAGE)
        recording = EXAMPLES.parent.parent / "tests/data/trials/62_noise_free_beta1.5.csv"
        calibrated = sparkout.calibrated(project, fit="alpha,beta,size_offset,time_shift",
                                         table=recording.read_text(), data="first.csv")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "calibrated.sparkout"
            calibrated.write(path)
            found = sparkout.measured(sparkout.Project.read(path))
            self.assertEqual(found, cli("measured", path, "--json"))
        row, = found["hold_out"]
        self.assertEqual((row["trace"], row["quantity"], row["unit"]), (0, "time", "s"))
        self.assertAlmostEqual(row["measured"], row["predicted"], delta=0.01)

    def test_a_lesson_is_checked_as_on_the_command_line(self):
        for name in ("01-force-and-balance", "06-burn"):
            file = EXAMPLES.parent / f"lessons/{name}.sparkout-lesson"
            checked = sparkout.check_lesson(file.read_text(encoding="utf-8"))
            self.assertEqual(checked, cli("course", "check", file, "--json"))
        with self.assertRaises(sparkout.ProjectError):
            sparkout.check_work("{}")

    def test_remedies_are_those_of_the_command_line_and_hold(self):
        project = sparkout.Project.read(EXAMPLES / "wheel-dull.sparkout").with_values({
            "/machine/limits/work_speed_rpm": [160, 160, 5]}) # a stage more is among the three
        found = sparkout.remedies(project)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "dull.sparkout"
            project.write(file)
            stated = cli("remedies", file, "--json")
        self.assertEqual(found.to_dict(), stated)
        self.assertIsNone(found.conflict)
        for member in ("goal", "status", "settings", "tried", "found", "runs"):
            self.assertEqual(getattr(found, member), stated[member], member)
        self.assertGreater(len(found.remedies), 0)
        self.assertEqual(len(found.remedies), len(stated["remedies"]))
        added = [each.before for each in found.remedies if "stages/2" in each.path]
        self.assertEqual(added, [None]) # a stage more has no value before
        for each, line in zip(found.remedies, stated["remedies"]):
            for member in ("kind", "path", "before", "value", "with_value", "failing",
                           "holds_beyond", "time_min", "time_change_min"):
                self.assertEqual(getattr(each, member), line[member], member)
            self.assertEqual(each.stock_mm, tuple(line["stock_mm"]))
            self.assertEqual(each.interval is None, each.kind == "starting_cycle")
            self.assertEqual(each.interval, line["interval"] and tuple(line["interval"]))
            self.assertEqual(each.rank, line["rank"])
            self.assertEqual(type(each).time_min.__doc__, "time of the cycle [min]")
            self.assertEqual(each.time_s / 60, line["time_min"])
            self.assertEqual(each.time_change_s / 60, line["time_change_min"])
            for one, other in zip(each.requirements, line["requirements"], strict=True):
                self.assertTrue(one["holds"] and other["ok"])
                for member in ("name", "where", "unit", "value", "limit", "margin"):
                    self.assertEqual(one[member], other[member], member)
            changed = sparkout.evaluate(each.project)
            self.assertTrue(changed.holds)
            self.assertEqual(changed.time_s, each.time_s)

    def test_why_no_remedy_helps_is_that_of_the_command_line(self):
        kinds = set()
        for values in ({"/machine/geometric_runout_um": 6}, {"/gauge/commands": 1},
                       {"/part/tolerance/radial_runout_um": 1e-6}):
            with self.subTest(values), tempfile.TemporaryDirectory() as folder:
                project = sparkout.Project.read(TWO_STAGE).with_values(values)
                changed = pathlib.Path(folder) / "changed.sparkout"
                project.write(changed)
                stated = cli("remedies", changed, "--json")["conflict"]
                found = sparkout.remedies(project)
                self.assertEqual({member: getattr(found.conflict, member) for member in stated},
                                 stated)
                self.assertEqual(set(stated),
                                 {"kind", "first", "second", "path", "value", "stock_mm"})
                self.assertTrue(found.text.startswith("Among the values tried, no single setting"))
                kinds.add(found.conflict.kind)
        self.assertIn("unmended", kinds)

    def test_a_cycle_that_does_not_end_is_no_measure_of_time(self):
        project = sparkout.Project.read(TWO_STAGE).with_values({
            "/cycle/stages/1/radial_feed_mm_min": 0,
            "/cycle/stages/1/spark_out": "until_size",
            "/batch": None})
        found = sparkout.remedies(project)
        self.assertGreater(len(found.remedies), 0)
        for each in found.remedies:
            self.assertIsNone(each.time_change_s)
            self.assertRegex(each.text, r": (the cycle takes )?[0-9.]+ (min|s); for every stock")

    def test_what_cannot_be_searched_is_refused(self):
        project = sparkout.Project.read(FACTORY).with_values({"/optimisation": None})
        with self.assertRaises(sparkout.ProjectError) as raised:
            sparkout.search(project)
        self.assertIn("/optimisation", str(raised.exception))

    def test_limits_of_time_and_threads(self):
        project = sparkout.Project.read(EXAMPLES / "shaft-30h6-optimal.sparkout")
        for limit_s in (float("nan"), -1.0):
            with self.subTest(limit_s), self.assertRaises(ValueError):
                sparkout.search(project, time_limit_s=limit_s)
        self.assertEqual(sparkout.search(project, time_limit_s=float("inf")).status, "proved")
        self.assertEqual(sparkout.search(project, time_limit_s=1e300).status, "proved")
        for threads in (-1, 100_000):
            with self.subTest(threads), self.assertRaises(ValueError):
                sparkout.batch(project, threads=threads)

    def test_ctrl_c_ends_a_long_batch(self):
        project = sparkout.Project.read(FACTORY).with_values({"/batch/parts": 1_000_000})
        threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            sparkout.batch(project)
        self.assertLess(time.monotonic() - begin, 5)

    def test_other_threads_go_on_meanwhile(self):
        project = sparkout.Project.read(FACTORY).with_values({"/batch/parts": 20_000})
        ticks, done = [], threading.Event()

        def tick():
            while not done.wait(0.01):
                ticks.append(time.monotonic())

        other = threading.Thread(target=tick)
        other.start()
        begin = time.monotonic()
        sparkout.batch(project, threads=1)
        took = time.monotonic() - begin
        done.set()
        other.join()
        self.assertGreater(len(ticks), took / 0.01 / 10)


if __name__ == "__main__":
    unittest.main(verbosity=2)
