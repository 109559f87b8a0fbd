# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: test_report.py TOUCHSTONE SOURCE SCRATCH

The report is one page that loads nothing, links to what is there, says what was not run, and has its numbers from the data."""
import csv
import html.parser
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import tiny

TOUCHSTONE, SOURCE, SCRATCH = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
REPORT = SOURCE / "experiments/report/report.py"
sys.path.insert(0, str(SOURCE / "experiments/report"))

from looks import EXACT, rounds
from page import rounded, share_of_size, upper_limit
from report import CHAPTERS, asked_in, page
from results import DataError, study_in
from style import rows_of

VOID = {"meta", "img", "source", "br", "link", "input", "path", "line", "circle", "polygon"}


class Page(html.parser.HTMLParser):
    """What a page holds: ids, links, pictures, what it loads, and its visible text."""

    def __init__(self, text):
        super().__init__()
        self.ids, self.links, self.images, self.loaded, self.open, self.shown = [], [], [], [], [], []
        self.feed(text)
        self.text = re.sub(r"\s+", " ", "".join(self.shown))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag not in VOID:
            self.open.append(tag)
        if "id" in attributes:
            self.ids.append(attributes["id"])
        if tag == "a":
            self.links.append(attributes.get("href"))
        if tag == "img":
            self.images.append(attributes)
        if tag in ("script", "link", "object", "embed", "video", "audio", "base"):
            self.loaded.append(tag)
        self.loaded += [attributes[name] for name in ("src", "srcset", "data", "poster", "background") if
                        attributes.get(name) and not attributes[name].startswith("data:")]

    def handle_endtag(self, tag):
        if tag not in VOID:
            assert self.open and self.open[-1] == tag, f"</{tag}> closes {self.open[-3:]}"
            self.open.pop()

    def handle_data(self, data):
        if not {"style", "script", "title"} & set(self.open):
            self.shown.append(data)


def report(results):
    """The page, or the message of the error."""
    try:
        return page(results), ""
    except DataError as error:
        return None, str(error)


def edited(path, edit):
    """Rewrites the rows of a CSV file: `edit` changes one in place."""
    rows = rows_of(path)
    for row in rows:
        edit(row)
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.original = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(dir=SCRATCH))) / "results"
        tiny.write(TOUCHSTONE, SOURCE, cls.original)
        cls.whole, complaint = report(cls.original)
        assert cls.whole is not None, complaint
        cls.page = Page(cls.whole)
        cls.light = cls.original.parent / "light"  # the cell's page is long
        shutil.copytree(cls.original, cls.light)
        (cls.light / "cell/cell.html").write_text("<canvas></canvas>")

    def setUp(self):
        self.results = self.original.parent / "changed"
        shutil.copytree(self.light, self.results)
        self.addCleanup(shutil.rmtree, self.results)

    def changed(self):
        text, complaint = report(self.results)
        self.assertIsNotNone(text, complaint)
        return Page(text)

    def complaint(self):
        text, complaint = report(self.results)
        self.assertIsNone(text, "no error")
        return complaint

    def test_loads_nothing(self):
        self.assertEqual(self.page.loaded, [])
        self.assertNotRegex(re.search(r"<style>(.*?)</style>", self.whole, re.S)[1], r"url\(|@import")
        self.assertIn("default-src &#x27;none&#x27;", self.whole)  # the cell's page, within this one

    def test_is_well_formed(self):
        self.assertEqual(self.page.open, [])
        self.assertEqual(len(self.page.ids), len(set(self.page.ids)))

    def test_links_resolve(self):
        for link in self.page.links:
            path, _, anchor = link.partition("#")
            self.assertNotRegex(link, "^[a-z]+:")
            if not path:
                self.assertIn(anchor, self.page.ids, link)
            else:
                self.assertTrue((self.original / path).exists(), link)
                if anchor:
                    self.assertIn(f'id="{anchor}"', (self.original / path).read_text(encoding="utf-8"), link)

    def test_pictures_say_what_they_show(self):
        wanted = sum(map(len, tiny.PICTURES.values()))
        self.assertGreater(len(self.page.images), wanted)  # and those of the thesis
        for image in self.page.images:
            self.assertGreater(len(image["alt"]), 20)
            self.assertGreater(int(image["width"]), 0)
        self.assertEqual(self.whole.count("<figcaption"), self.whole.count("<figure"))

    def test_shows_no_number_that_is_none(self):
        self.assertNotRegex(self.page.text, r"\b(nan|NaN|None|inf)\b|\{|\}")

    def test_same_data_same_bytes(self):
        self.assertEqual(report(self.original)[0], self.whole)

    def test_is_written_where_the_data_are(self):
        def call():
            return subprocess.run([sys.executable, "-B", str(REPORT), str(self.results)], capture_output=True, text=True)

        self.assertEqual((call().returncode, call().stderr), (0, ""))
        self.assertEqual((self.results / "report.html").read_text(encoding="utf-8"), report(self.results)[0])
        (self.results / "soak/soak.csv").unlink()
        self.assertEqual((call().returncode, call().stderr), (1, f"report.py: {self.results / 'soak/soak.csv'}: No such file "
                                                                 "or directory\n"))

    def test_says_how_each_study_was_made(self):
        for name in CHAPTERS:
            run = json.loads((self.original / name / "run.json").read_text())
            for word in (run["command"], run["commit"] or "unknown", run["compiler"], run["machine"]):
                self.assertIn(re.sub(r"\s+", " ", word), self.page.text)

    def test_a_run_names_its_processor_with_family_and_model(self):
        processor = json.loads((self.original / "soak/run.json").read_text())["processor"]
        if "model name" in pathlib.Path("/proc/cpuinfo").read_text():
            self.assertRegex(processor, r"\S \(\w+ family \d+, model \d+, stepping \d+\)$")
        else:
            self.assertEqual(processor, "")

    def test_names_a_study_that_was_not_run_with_its_command(self):
        for name in CHAPTERS:
            gone = self.results.parent / "gone"
            (self.results / name).rename(gone)
            page = self.changed()
            gone.rename(self.results / name)
            self.assertFalse([link for link in page.links if link.startswith(f"{name}/")])
            behind = page.text.partition(f"Not run: {CHAPTERS[name].TITLE}.")[2]
            self.assertTrue(re.search(rf"touchstone .*--(?:output|json) changed/{name}\b", behind[:900]), behind[:900])

    def test_a_killed_study_is_not_shown(self):
        (self.results / "soak/run.json").unlink()
        page = self.changed()
        self.assertIn("It was begun, and has not come to its end.", page.text)
        self.assertNotIn("in 200 cases", page.text)

    def test_says_if_a_study_was_interrupted_or_is_of_another_commit(self):
        path = self.results / "soak/run.json"
        path.write_text(json.dumps(json.loads(path.read_text()) | {"interrupted": True, "samples_asked": 1000, "commit": "another+"}))
        text = self.changed().text
        self.assertIn("Interrupted: 200 of 1,000 samples were done", text)
        self.assertIn("The studies were made by different commits", text)

    def test_missing_data_are_an_error_that_names_the_file(self):
        for file in ("near-edge/rates.csv", "meshes/meshes.csv", "tradeoff/front.csv", "stability/failures.csv", "regress/outcomes.csv",
                     "soak/soak.csv", "cell/moves.csv", "cell/cell.html", "thesis/entries.csv", "bench-scenes/queries.csv",
                     "bench/bench.json", "cell-area/plan.csv"):
            with self.subTest(file=file):
                aside = self.results / "aside"
                (self.results / file).rename(aside)
                self.assertIn(f"{self.results / file}: No such file", self.complaint())
                aside.rename(self.results / file)

    def test_times_are_those_of_the_bench(self):
        path = self.results / "bench/bench.json"
        self.assertIn("took filtered 1.50 × the time of fast", self.changed().text)
        path.write_text(path.read_text().replace('"ratio": {"median": 1.5', '"ratio": {"median": 2.25'))
        self.assertIn("took filtered 2.25 × the time of fast", self.changed().text)
        path.write_text('{"contests": []}')
        self.assertIn(f"{path}: no contest random-triangles", self.complaint())

    def test_the_price_is_one_number_with_its_quartiles_and_repetitions(self):
        path = self.results / "bench/bench.json"
        bench = json.loads(path.read_text())
        ratio = next(c for c in bench["contests"][0]["contestants"] if c["name"] == "filtered")["ratio"]
        ratio |= {"median": 1.25, "lower_quartile": 1.2, "upper_quartile": 1.31, "repetitions": [1.25] * 11}
        path.write_text(json.dumps(bench))
        self.assertIn("took filtered 1.25 × the time of fast (quartiles of 11 repetitions in turns: 1.20 to 1.31)", self.changed().text)
        ratio["too_noisy"] = True
        path.write_text(json.dumps(bench))
        self.assertNotIn("Price:", self.changed().text)

    def test_the_headline_is_an_outcome_of_the_data(self):
        path = self.results / "meshes/meshes.csv"

        def of_plain_doubles(row):
            return (row["method"], row["test"]) == ("fast", "contact") and row["place"] != "foot"

        own = [row for row in rows_of(path) if of_plain_doubles(row)]
        wrong, answers = (sum(int(row[name]) for row in own) for name in ("wrong", "trials"))
        self.assertGreater(wrong, 0)
        self.assertIn(f"Within two doubles of contact with 4 faces of real meshes, careful plain doubles are wrong in {rounded(100 * wrong / answers)} % of "
                      f"{answers} answers. filtered was never wrong in any of", self.changed().text)
        shutil.rmtree(self.results / "meshes")
        self.assertIn("Within u × size of contact with random polygons, careful plain doubles are wrong in", self.changed().text)

    def test_what_stress_beyond_the_promise_shows_is_told_apart(self):
        path = self.results / "stability/failures.csv"
        fails = lambda axis: edited(path, lambda row: row.update(failed_samples=row["samples"] if row["axis"] == axis else "0")
                                    if (row["method"], row["nearness"], row["test"]) == ("fast", "ample", "contact") else None)
        fails("small")
        text = self.changed().text
        self.assertIn("it promises none: filtered none and fast 100 %", text)
        self.assertIn("of polygons of promised sizes failed: filtered none and fast none", text)
        fails("aspect")
        self.assertNotIn("promised sizes failed: filtered none and fast none", self.changed().text)

    def test_the_verdict_says_of_no_method_that_it_was_wrong_which_was_not(self):
        def counted():
            """By whether methods bound their errors: those that were wrong, and those that were not."""
            asked = [asked_in(study_in(self.results / name), name) for name in CHAPTERS]
            wrong = {m: sum(counts[m].wrong for counts in asked if m in counts) for m in dict.fromkeys(m for counts in asked for m in counts)}
            return wrong, [m for m in wrong if rounds(m)], [m for m in wrong if m in EXACT - {"exact"} and not wrong[m]]

        def said():
            wrong, unbounded, sure = counted()
            k = sum(wrong[m] > 0 for m in unbounded)
            text = self.changed().text
            self.assertIn(f"{'All' if k == len(unbounded) else f'{k} of'} {len(unbounded)} methods that compute in floats or doubles without bounding their errors", text)
            self.assertIn(f"these never were: {', '.join(sure[:-1])} and {sure[-1]}.", text)
            return k, sure

        before, sure = said()
        self.assertIn("interval", sure)
        edited(self.results / "tradeoff/bands.csv", lambda row: row.update(wrong="1") if row["method"] == "interval" else None)
        self.assertNotIn("interval", said()[1])
        for study in ("near-edge/bands.csv", "tradeoff/bands.csv", "regress/outcomes.csv", "meshes/meshes.csv", "cell/methods.csv"):
            names = {"failures", "wrong", "wrong_hits", "wrong_misses"}
            edited(self.results / study, lambda row: row.update({name: "0" for name in names & row.keys()}) if row["method"] == "thesis" else None)
        self.assertEqual(said()[0], before - 1)

    def test_a_phone_shows_the_verdict_whole(self):
        box = self.whole.partition('class="verdict"')[2].partition("</section>")[0]
        drawn = re.findall(r'<svg class="(\w+)" viewBox="0 0 (\d+) ', box)
        self.assertEqual(len(drawn), 1)
        for kind, width in drawn:
            self.assertEqual(kind, "part")
            self.assertLessEqual(int(width), 400)  # so that letters of 12 are legible at 320 pixels
        self.assertNotRegex(box, "<img|<table")

    def test_cost_against_nearness_is_that_of_the_bench(self):
        path = self.results / "bench/bench.json"
        bench = json.loads(path.read_text())
        times = [(contest["family"], contest["name"], c["nanoseconds"]) for contest in bench["contests"] for c in contest["contestants"] if c["name"] == "filtered"]
        for family, name, nanoseconds in times:
            if family == "nearness":
                nanoseconds["median"] = {"2^-52": 70.0, "2^-1": 8.0}.get(name, 9.0)
            elif name.startswith("asked"):
                nanoseconds["median"] = 0.5 if name == "asked 8 times" else 500
        path.write_text(json.dumps(bench))
        text = self.changed().text
        self.assertIn("filtered takes 8.00 ns far from contact and 70.0 ns at it", text)
        self.assertIn("8 vertices: by 8 questions", text)
        for _, _, nanoseconds in times:
            nanoseconds["upper_quartile"] = 100
        path.write_text(json.dumps(bench))
        text = self.changed().text
        self.assertIn("in this run the times are too noisy to tell", text)
        self.assertIn("8 vertices: too noisy to tell", text)
        self.assertNotIn("filtered takes", text)

    def test_times_of_scenes_that_are_noise_are_not_quoted(self):
        path = self.results / "bench-scenes/queries.csv"
        edited(path, lambda row: row.update(nanoseconds="87654", lower_quartile="87000", upper_quartile="88000"))
        self.assertIn("88 µs", self.changed().text)
        edited(path, lambda row: row.update(upper_quartile="190000"))
        text = self.changed().text
        self.assertNotIn("88 µs", text)
        self.assertIn("too noisy to tell", text)

    def test_a_wrong_answer_changes_what_the_robot_does(self):
        moves = rows_of(self.results / "cell/driven/moves.csv")
        gap = next(float(row["gap"]) for row in moves if row["gap"])
        self.assertIn(f"it stops in the notch, {rounded(gap)} mm from any material", self.page.text)
        edited(self.results / "cell/driven/moves.csv", lambda row: row.update(gap="2.5") if row["gap"] else None)
        self.assertIn("it stops in the notch, 2.5 mm from any material", self.changed().text)
        (self.results / "cell/driven/disagreements.jsonl").write_text("{}\n")
        self.assertIn("disagreements.jsonl: its first case cannot be read", self.complaint())
        shutil.rmtree(self.results / "cell/driven")
        self.assertNotIn("it stops in the notch", self.changed().text)

    def test_what_the_cell_asks_is_counted_from_both_cases(self):
        asked = sum(int(rows_of(self.results / f"cell/case-{n}/near.csv")[0]["questions"]) for n in (1, 2))
        self.assertIn(f"of {asked:,} questions about every face at every stop, not one wrong answer of 2 methods", self.page.text)
        for n in (1, 2):
            edited(self.results / f"cell/case-{n}/near.csv", lambda row: row.update(near="3" if int(row["exponent"]) <= 9 else "0"))
        edited(self.results / "cell/case-2/methods.csv", lambda row: row.update(wrong_misses="7") if row["method"] == "thesis" else None)
        text = self.changed().text
        self.assertIn("wrong answers of thesis 7", text)
        self.assertIn("The nearest is within 2⁻⁹ of the face’s size", text)
        shutil.rmtree(self.results / "cell/case-1")
        shutil.rmtree(self.results / "cell/case-2")
        self.assertNotIn("In both case studies", self.changed().text)

    def test_places_where_what_captions_imply_is_not_found_are_counted_apart(self):
        path = self.results / "thesis/predictions.csv"
        middle = lambda row: (row["line"], row["angle_deg"]) == ("between", "-16")
        self.assertIn("At 273 of 273 places of the storage for which the layout was not fitted, the base's two turns", self.page.text)
        edited(path, lambda row: row.update(elbow_at_machine_deg="-35") if middle(row) else None)
        text = self.changed().text
        self.assertIn("At 272 of 273 places", text)
        self.assertIn("At 1 an angle differs. Much", text)
        found = ("base_to_storage_deg", "base_to_machine_deg", "elbow_at_machine_deg", "shoulder_at_machine_deg")
        edited(path, lambda row: row.update({name: "" for name in found} | {"failure": "out of reach"}) if middle(row) else None)
        self.assertIn("At 272 of 273 places", self.changed().text)
        self.assertIn("At 1 the process fails (1: out of reach). Much", self.changed().text)
        edited(self.results / "thesis/sensitivity.csv",
               lambda row: row.update(highest=str(float(row["value"]) + 0.25)) if row["parameter"] == "machine height" else None)
        self.assertIn("changes by a step: the machine height by 0.25 mm (shoulder at the machine) and", self.changed().text)

    def test_malformed_data_are_an_error_that_names_the_line(self):
        path = self.results / "near-edge/bands.csv"
        whole = path.read_text()
        lines = whole.splitlines()
        for broken, complaint in (
                ("\n".join([lines[0].replace(",samples,", ",examples,"), *lines[1:]]), "no column samples"),
                ("\n".join([*lines[:2], lines[2] + ",1", *lines[3:]]), "line 3: 17 cells instead of 16"),
                ("\n".join([*lines[:2], lines[2].replace(",4,", ",four,", 1), *lines[3:]]), "line 3: samples cannot be 'four'"),
                ("\n".join([*lines[:2], lines[2].rsplit(",", 10)[0] + ",nan,0,1,0,1,0,0,,", *lines[3:]]), "line 3: "),
                ("", "no column family")):
            path.write_text(broken)
            self.assertIn(f"{path}: {complaint}", self.complaint())
        path.write_text(whole)
        for file, broken in (("soak/run.json", "{"), ("soak/run.json", "[]"), ("soak/run.json", '{"command": "touchstone soak"}'),
                             ("cell/cell.html", "<html></html>"), ("near-edge/rates-planar.svg", "<svg>"), ("methods.txt", "fast\n")):
            aside = (self.results / file).read_text()
            (self.results / file).write_text(broken)
            self.assertIn(f"{self.results / file}: ", self.complaint())
            (self.results / file).write_text(aside)

    def test_a_run_json_of_impossible_values_is_an_error_that_names_them(self):
        path = self.results / "soak/run.json"
        run = json.loads(path.read_text())
        for key, values in {"seed": [-7, True, 1.5, "1"], "samples_done": [-1, None], "seconds": [math.nan, math.inf, -1, "2"],
                            "date": ["x", 5], "commit": [5, []], "machine": [None]}.items():
            for value in values:
                path.write_text(json.dumps(run | {key: value}))
                self.assertIn(f"{path}: {key} cannot be {json.dumps(value)}", self.complaint())

    def test_data_that_do_not_fit_together_are_an_error_that_names_the_study(self):
        for file in ("near-edge/rates.csv", "near-edge/bands.csv", "regress/outcomes.csv"):
            path = self.results / file
            whole = path.read_text()
            path.write_text(whole.splitlines(keepends=True)[0])  # cut behind the names
            self.assertIn(f"{path.parent}: its data do not fit together", self.complaint())
            path.write_text(whole)

    def test_infinite_shares_are_an_error(self):
        edited(self.results / "near-edge/worst.csv", lambda row: row.update(climbed_share="inf"))
        self.assertIn("worst.csv: line 2: climbed_share cannot be 'inf'", self.complaint())

    def test_no_results_are_an_error(self):
        shutil.rmtree(self.results)
        self.assertIn(f"{self.results}: is not a folder", self.complaint())
        self.results.mkdir()
        self.assertIn(f"{self.results}: does not contain the run.json of any study", self.complaint())

    def test_the_verdict_on_real_input_is_in_the_data(self):
        path = self.results / "meshes/meshes.csv"
        trials = sum(int(row["trials"]) for row in rows_of(path) if row["method"] == "fast" and row["test"] == "contact" and row["place"] != "foot")
        self.assertIn(f"of {trials:,} final answers were wrong", self.page.text)
        edited(path, lambda row: row.update(wrong="0") if row["test"] == "contact" and row["method"] == "fast" and row["place"] != "edge" else None)
        edited(path, lambda row: row.update(wrong="3") if row["test"] == "contact" and row["method"] == "fast" and row["place"] == "edge" else None)
        self.assertIn(f"careful plain doubles (fast) {rounded(100 * 3 / trials)} %", self.changed().text)
        edited(path, lambda row: row.update(wrong="0"))
        self.assertIn("final answers were wrong: none of those asked", self.changed().text)

    def test_the_verdict_on_random_polygons_is_in_the_data(self):
        edited(self.results / "near-edge/worst.csv", lambda row: row.update(sampled_share="", climbed_share=""))
        self.assertIn("a search found no wrong answer away from contact", self.changed().text)
        edited(self.results / "near-edge/worst.csv", lambda row: row.update(climbed_share="0.001") if row["method"] == "fast" else None)
        self.assertIn("10⁶ sizes away: fast 1 mm and 1 mm.", self.changed().text)
        edited(self.results / "near-edge/rates.csv", lambda row: row.update(failures=row["trials"]) if row["method"] == "fast" else None)
        self.assertIn("careful plain doubles (fast) 100 %", self.changed().text)

    def test_what_never_failed_is_counted_from_the_data(self):
        only = self.original.parent / "only"
        shutil.copytree(self.results / "soak", only / "soak")
        self.addCleanup(shutil.rmtree, only)
        rows = rows_of(only / "soak/soak.csv")
        answers = sum(int(row["cases"]) for row in rows if row["family"] == "all")
        self.assertEqual(answers, sum(int(row["cases"]) for row in rows if row["family"] != "all"))
        text = Page(report(only)[0]).text
        self.assertIn("filtered was never wrong in the study below", text)
        self.assertIn("differed from exact arithmetic in none of 200 adversarial cases", text)
        self.assertIn(f"The certified path under attack{answers:,}200 cases0{rounded(100 * upper_limit(200))}", text)

    def test_each_placement_and_threshold_has_polygons_of_its_own(self):
        for study, places in (("near-edge", 16), ("tradeoff", 6)):
            bands = rows_of(self.results / study / "bands.csv")
            polygons = [int(row["samples"]) for row in bands if (row["family"], row["method"], row["test"]) == ("u", "filtered", "contact")]
            self.assertEqual(len(polygons), places)
            self.assertEqual(asked_in(study_in(self.results / study), study)["filtered"].trials, sum(polygons))

    def test_what_is_compared_with_itself_is_not_counted(self):
        cases = sum(int(row["cases"]) for row in rows_of(self.results / "regress/outcomes.csv") if (row["method"], row["numbers"]) == ("filtered", "doubles"))
        row = f"Other engines on the same questions{cases:,}10 polygons0"
        self.assertIn(row, self.page.text)
        edited(self.results / "regress/outcomes.csv", lambda row: row.update(method="thesis-1") if row["method"] == "exact" else None)
        self.assertNotIn(row, self.changed().text)

    def test_a_failure_of_what_must_not_fail_is_said_first(self):
        edited(self.results / "soak/soak.csv", lambda row: row.update(differences="1"))
        text = self.changed().text
        self.assertIn("against its guarantee", text)
        self.assertNotIn("filtered was never wrong", text)
        self.assertNotIn("How sure:", text)
        self.assertNotRegex(text, "these never were: filtered")
        self.assertIn("Compared with exact answers, filtered was wrong in The certified path under attack.", text)
        self.assertIn("none: it failed", text)

    def test_times_are_in_the_data(self):
        def tenfold(row):
            if row["method"] == "filtered":
                row["median_ns"] = "1000"
            if row["method"] == "fast":
                row["median_ns"] = "10"

        edited(self.results / "tradeoff/timings.csv", tenfold)

        def tradeoff():
            return re.search(r'<h2 id="tradeoff">.*?</section>', report(self.results)[0], re.S)[0]

        self.assertIn("100\u00a0×", tradeoff())
        edited(self.results / "tradeoff/timings.csv", lambda row: row.update(lower_quartile_ns="10", upper_quartile_ns="16"))
        self.assertIn("too noisy to tell", tradeoff())
        self.assertNotIn("100\u00a0×", tradeoff())

    def test_engines_that_were_not_built_in_are_named(self):
        self.assertRegex(self.page.text, r"Not in this build[^.]*\bbullet\b")

    def test_engines_are_asked_in_floats_too(self):
        edited(self.results / "regress/outcomes.csv", lambda row: row.update(wrong="3", first_offset_exponent="8")
               if (row["method"], row["numbers"]) == ("cgal-epick-intersect", "floats") else None)
        share = 100 * 3 / int(next(row for row in rows_of(self.results / "regress/outcomes.csv"))["cases"])
        self.assertRegex(self.changed().text, rf"cgal-epick-intersect.{{0,200}}{share:.2g}\s%2⁻⁸")


class Numbers(unittest.TestCase):
    def test_are_rounded_and_not_cut(self):
        self.assertEqual([rounded(v) for v in (0, 0.996, 9.96, 8.05, 99.6, 1234, 0.00035)], ["0", "1.0", "10", "8.1", "100", "1,200", "0.00035"])

    def test_a_limit_is_the_share_at_which_no_failure_has_five_per_cent(self):
        self.assertAlmostEqual((1 - upper_limit(300)) ** 300, 0.05)

    def test_shares_of_the_size_are_rounded_outwards(self):
        self.assertEqual([share_of_size(s) for s in (0.25, 0.26, 0.9, 1, 3)], ["2⁻²", "2⁻¹", "1", "1", "1"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
