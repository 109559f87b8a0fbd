# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: as_code_test.py SOURCE SCRATCH

The cases as code: every number of the header in C is that of the cases, the page's loop compiles without a warning and judges an
engine in floats, which passes and fails with a planted error, and the files in Rust and Python have the same cases."""
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE, SCRATCH = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
AS_CODE = SOURCE / "experiments/judge/corpus/as_code.py"
FLOATS = sorted((SOURCE / "tests/corpus/floats").glob("*.jsonl"))
CC = ["cc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O1", "-ffp-contract=off"]

# The rule for a sphere and a triangle of many engines in floats: the closest point by the region in which the centre projects.
# It knows no other polygons.
ENGINE = """
static float dot(const float *a, const float *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static void sub(const float *a, const float *b, float *to) { for (int k = 0; k < 3; ++k) to[k] = a[k] - b[k]; }
static float squared_from(const float *p, const float *a, const float *u, float s, const float *v, float t) {
  float d[3];
  for (int k = 0; k < 3; ++k) d[k] = a[k] + s * u[k] + t * v[k] - p[k];
  return dot(d, d);
}
int touches(const float center[3], float radius, const float (*v)[3], int loops, const int *sizes) {
  float ab[3], ac[3], ap[3], bp[3], cp[3], square;
  (void)loops; (void)sizes;
  sub(v[1], v[0], ab); sub(v[2], v[0], ac); sub(center, v[0], ap); sub(center, v[1], bp); sub(center, v[2], cp);
  const float d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp), d6 = dot(ac, cp);
  const float va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (d1 <= 0 && d2 <= 0) square = squared_from(center, v[0], ab, 0, ac, 0);
  else if (d3 >= 0 && d4 <= d3) square = squared_from(center, v[0], ab, 1, ac, 0);
  else if (vc <= 0 && d1 >= 0 && d3 <= 0) square = squared_from(center, v[0], ab, d1 / (d1 - d3), ac, 0);
  else if (d6 >= 0 && d5 <= d6) square = squared_from(center, v[0], ab, 0, ac, 1);
  else if (vb <= 0 && d2 >= 0 && d6 <= 0) square = squared_from(center, v[0], ab, 0, ac, d2 / (d2 - d6));
  else if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const float w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    square = squared_from(center, v[0], ab, 1 - w, ac, w);
  } else square = squared_from(center, v[0], ab, vb / (va + vb + vc), ac, vc / (va + vb + vc));
  return square <= radius * radius;
}
"""

PRINT = """
#include "touchstone_cases.h"
#include <stdio.h>
int main(void) {
  for (const touchstone_case *c = touchstone_cases; c < touchstone_cases + TOUCHSTONE_CASES; ++c) {
    printf("%s %d %d %d", c->id, c->moves, c->planar, c->contact);
    for (int k = 0; k < 3; ++k) printf(" %a %a %a %a", (double)c->center[k], (double)c->to[k], c->point[k], c->normal[k]);
    printf(" %a %a %a %a", (double)c->radius, c->time, c->distance, c->depth);
    for (int l = 0, i = 0; l < c->loops; ++l) {
      printf(" loop");
      for (int end = i + c->loop_sizes[l]; i < end; ++i)
        printf(" %a %a %a", (double)c->vertices[i][0], (double)c->vertices[i][1], (double)c->vertices[i][2]);
    }
    printf("\\n");
  }
  return 0;
}
"""


def expected_words(case):
    """What PRINT prints of a case; numbers as they are."""
    answer, moves = case["expected"], "motion" in case
    center = case["ball"]["center"]
    words = [case["id"], moves, answer["off_plane"] == 0, answer["contact"]]
    ends = case["motion"]["to"] if moves else center
    for k in range(3):
        words += [center[k], ends[k], *((answer[key] or [None] * 3)[k] for key in ("point", "contact_normal"))]
    words += [case["ball"]["radius"], *(answer.get(key) for key in ("time", "distance", "depth"))]
    for loop in [case["polygon"]["outer"], *case["polygon"]["holes"]]:
        words += ["loop", *(x for vertex in loop for x in vertex)]
    return words


def same(word, value):
    if isinstance(value, str):
        return word == value
    return math.isnan(float.fromhex(word)) if value is None else float.fromhex(word) == value


def cases_of(files):
    return [case for file in files for case in map(json.loads, file.read_text().splitlines()) if "error" not in case["expected"]]


class AsCode(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(dir=SCRATCH))
        self.addCleanup(shutil.rmtree, self.folder)

    def write(self, language, name, files):
        done = subprocess.run([sys.executable, "-B", AS_CODE, language, *files], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        (self.folder / name).write_text(done.stdout)
        return done.stdout

    def compiled(self, source):
        (self.folder / "it.c").write_text(source)
        subprocess.run([*CC, "it.c", "-o", "it", "-lm"], cwd=self.folder, check=True)
        return subprocess.run(["./it"], cwd=self.folder, capture_output=True, text=True)

    def test_the_header_has_every_number_of_every_case(self):
        for files, kind in (FLOATS, "float"), ([SOURCE / "tests/corpus" / f"{name}.jsonl" for name in ("exponents", "moving", "rejections")], "double"):
            self.assertIn(f"typedef {kind} touchstone_real;", self.write("c", "touchstone_cases.h", files))
            lines = self.compiled(PRINT).stdout.splitlines()
            cases = cases_of(files)
            self.assertEqual(len(lines), len(cases))
            for line, case in zip(lines, cases):
                words, values = line.split(" "), expected_words(case)
                self.assertEqual(len(words), len(values), case["id"])
                self.assertTrue(all(map(same, words, values)), line)

    def test_the_loop_of_the_page_judges_an_engine_in_floats(self):
        page = (SOURCE / "docs/engines.md").read_text()
        loop = re.search(r"^```c\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)[1]
        loop = loop.replace("!c->planar", "c->loops != 1 || c->loop_sizes[0] != 3 || c->size > 0x1p60")  # where its squares overflow
        beyond = ("exponents", "point", "sliver", "vertex")  # where it errs by more than the page's margin
        self.write("c", "touchstone_cases.h", [file for file in FLOATS if file.stem not in beyond])
        sound = self.compiled(loop + ENGINE)
        self.assertEqual((sound.returncode, sound.stdout), (0, ""))
        planted = self.compiled(loop + ENGINE.replace("a[k] + s * u[k]", "a[k] - s * u[k]"))
        self.assertEqual(planted.returncode, 1)
        self.assertGreater(planted.stdout.count("expected"), 5)

    def test_python_has_the_same_cases(self):
        self.write("python", "touchstone_cases.py", FLOATS)
        names = {}
        exec((self.folder / "touchstone_cases.py").read_text(), names)  # pylint: disable=exec-used
        cases = cases_of(FLOATS)
        self.assertEqual([one.id for one in names["CASES"]], [case["id"] for case in cases])
        for one, case in zip(names["CASES"], cases):
            loops = [case["polygon"]["outer"], *case["polygon"]["holes"]]
            self.assertEqual([[list(vertex) for vertex in loop] for loop in one.loops], loops)
            self.assertEqual((list(one.center), one.radius, one.contact), (case["ball"]["center"], case["ball"]["radius"], case["expected"]["contact"]))

    @unittest.skipUnless(shutil.which("rustc"), "there is no rustc")
    def test_rust_has_the_same_cases(self):
        self.write("rust", "cases.rs", FLOATS)
        (self.folder / "main.rs").write_text('#![allow(dead_code)]\nmod cases;\nfn main() { for c in cases::CASES.iter() { println!("{} {} {:?} {}", c.id, '
                                             'c.contact, c.radius as f64, cases::VERTICES[c.vertices.0 + c.vertices.1 - 1][2] as f64); } }\n')
        subprocess.run(["rustc", "--edition", "2021", "main.rs"], cwd=self.folder, check=True)
        lines = subprocess.run(["./main"], cwd=self.folder, capture_output=True, text=True, check=True).stdout.splitlines()
        for line, case in zip(lines, cases_of(FLOATS), strict=True):
            name, contact, radius, last = line.split(" ")
            vertex = [*case["polygon"]["outer"], *(v for hole in case["polygon"]["holes"] for v in hole)][-1]
            self.assertEqual((name, contact == "true", float(radius), float(last)),
                             (case["id"], case["expected"]["contact"], case["ball"]["radius"], vertex[2]))

    def test_ids_of_any_characters_and_closed_loops_are_code(self):
        case = json.loads((SOURCE / "tests/corpus/features.jsonl").read_text().splitlines()[0])
        case["id"] = 'a"b\\c ??/ \u0001 \u00e9 \u2028 \U0001f600 end'
        case["polygon"] = {"closed": True, "outer": [*case["polygon"]["outer"], case["polygon"]["outer"][0]]}
        (self.folder / "odd.jsonl").write_text("\n" + json.dumps(case, ensure_ascii=False) + "\n  \n")
        self.write("c", "touchstone_cases.h", [self.folder / "odd.jsonl"])
        printed = self.compiled(PRINT).stdout
        self.assertEqual(printed.split(" end ")[0] + " end", case["id"])
        self.assertEqual(len(printed.split(" loop ")[1].split()), 3 * (len(case["polygon"]["outer"]) - 1))
        if shutil.which("rustc"):
            self.write("rust", "cases.rs", [self.folder / "odd.jsonl"])
            (self.folder / "main.rs").write_text('#![allow(dead_code)]\nmod cases;\nfn main() { println!("{}", cases::CASES[0].id); }\n')
            subprocess.run(["rustc", "--edition", "2021", "main.rs"], cwd=self.folder, check=True)
            self.assertEqual(subprocess.run(["./main"], cwd=self.folder, capture_output=True, text=True, check=True).stdout, case["id"] + "\n")

    def test_nothing_is_not_code(self):
        for files in ([SOURCE / "tests/corpus/rejections.jsonl"], [SOURCE / "tests/corpus/meshes/moving.jsonl"], ["/no/such/file"]):
            done = subprocess.run([sys.executable, "-B", AS_CODE, "c", *files], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertNotIn("Traceback", done.stderr)

    def test_a_faulty_case_is_named(self):
        (self.folder / "faulty.jsonl").write_text('{"id":"a"}\n')
        done = subprocess.run([sys.executable, "-B", AS_CODE, "c", self.folder / "faulty.jsonl"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("faulty.jsonl: line 1: is not a case with its whole answer", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
