#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: paper.py ROOT

The paper's numbers are those of its data: whatever the text asks for is made, from the data that it is said to be from, the
same bytes again; what is missing, interrupted, mixed, malformed or stale ends the build and is named; no measured number is
typed. LaTeX itself is run by `./check --full`."""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TESTS = pathlib.Path(__file__).resolve().parents[1]
sys.path += [str(TESTS / "papers"), str(TESTS / "system")]
import miniature  # noqa: E402
from running import expect  # noqa: E402


def build(root, results, output, *options):
    return subprocess.run(["/usr/bin/python3", "-B", root / "papers/build.py", *options, results, output], capture_output=True, text=True)


def text_of(root):
    files = [root / "papers/touchstone.tex", *sorted((root / "papers/sections").glob("*.tex"))]
    return {file: re.sub(r"(?<!\\)%.*", "", file.read_text()) for file in files}


def every_citation_is_an_entry(root):
    """And every entry is closed before the next one, as BibTeX wants it."""
    entries = re.findall(r"^@\w+\{([^,]*),(.*?)(?=^@|\Z)", (root / "papers/references.bib").read_text(), re.MULTILINE | re.DOTALL)
    for key, body in entries:
        expect(body.count("{") + 1 == body.count("}"), f"references.bib: the braces of {key} do not match")
    for file, text in text_of(root).items():
        for keys in re.findall(r"\\cite\w*\{([^}]*)\}", text):
            for key in keys.split(","):
                expect(key in dict(entries), f"{file.name}: no reference {key}")


def files_below(folder):
    return {path.relative_to(folder): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def edit(path, old, new):
    text = path.read_text()
    assert old in text, (path, old)
    path.write_text(text.replace(old, new, 1))


def what_the_text_asks_for_is_made(root, results, output):
    made = build(root, results, output, "--no-latex")
    expect(made.returncode == 0, made.stderr)
    keys = set(re.findall(r"\\defineval\{([^}]*)\}", (output / "values.tex").read_text()))
    for file, text in text_of(root).items():
        for key in re.findall(r"\\val\{([^}#]*)\}", text):
            expect(key in keys, f"{file.name}: no value {key}")
        for table in re.findall(r"\\input\{tables/([^}]*)\}", text):
            expect((output / f"tables/{table}.tex").exists(), f"{file.name}: no table {table}")
        for figure in re.findall(r"\\includegraphics\[[^]]*\]\{figures/([^}]*)\}", text):
            expect((output / f"figures/{figure}.pdf").exists(), f"{file.name}: no figure {figure}")


def data_make_the_numbers(root, results, output, scratch):
    values = (output / "values.tex").read_text()
    for line in (r"\defineval{near-edge/face/fast}{25\,\%}", r"\defineval{near-edge/foot-edge/thesis}{50\,\%}",
                 r"\defineval{engines/never-wrong-count}{1}", r"\defineval{engines/never-wrong}{\method{cgal-epeck-distance}}", r"\defineval{thesis/entries}{5}", r"\defineval{thesis/self-checks}{1}", r"\defineval{thesis/predicted}{1}", r"\defineval{stability/most-vertices}{1{,}000}", r"\defineval{soak/cases}{4}", r"\defineval{soak/limit}{0.53}", r"\defineval{soak/unlimited-share}{12\,\%}", r"\defineval{engines/polygons}{8}",
                 r"\defineval{stability/first/1e6/fast}{$2^{-51}$}", r"\defineval{stability/filtered-samples}{8}",
                 r"\defineval{bench/half-near/filtered/ratio}{1.50}", r"\defineval{bench/variants/commit}{0b1fcde08ba9}", r"\defineval{real/face/fast}{12\,\%}",
                 r"\defineval{thesis/home-poses-share}{45\,\%}", r"\defineval{thesis/base-turns}{149\textdegree{} and 66\textdegree{}}", r"\defineval{tradeoff/distance-right/filtered}{all}",
                 r"\defineval{motions/wrong/bullet}{25\,\%}", r"\defineval{motions/furthest/fcl}{$2^{-4}$}",
                 r"\defineval{motions/small/many}{25\,\%}", r"\defineval{recorded/doubles/near}{50\,\%}", r"\defineval{recorded/floats/wrong}{25\,\%}", r"\defineval{soak-moving/cases}{4}",
                 r"\defineval{cell/questions}{200}", r"\defineval{cell/nearest}{$2^{-2}$}"):
        expect(line in values, f"not there: {line}")
    expect("& 110 &" in (output / "tables/scenes.tex").read_text(), "112,345 ns are not 110 us")
    again = scratch / "again"
    build(root, results, again, "--no-latex")
    expect(files_below(output) == files_below(again), "the same data make other bytes")
    edit(results / "regress/outcomes.csv", "cgal-epeck-distance,doubles,u,0,0,8,", "cgal-epeck-distance,doubles,u,1,0,8,52")
    build(root, results, again, "--no-latex")
    expect(r"\defineval{engines/never-wrong-count}{0}" in (again / "values.tex").read_text(), "a wrong answer changes nothing")


def bench_says(family, name, contestant, what, which, value):
    """Spoils the bench: one number of one contestant."""
    def spoil(at):
        path = at / "bench/bench.json"
        bench = json.loads(path.read_text())
        contest = next(contest for contest in bench["contests"] if (contest["family"], contest["name"]) == (family, name))
        next(c for c in contest["contestants"] if c["name"] == contestant)[what][which] = value
        path.write_text(json.dumps(bench))

    return spoil


def what_is_wrong_with_the_data_is_named(root, results, output, scratch):
    sys.path.insert(0, str(root / "papers"))
    from build import DataError, write_inputs

    def spoiled(name, spoil):
        broken = scratch / "broken"
        shutil.rmtree(broken, ignore_errors=True)
        shutil.copytree(results, broken)
        spoil(broken)
        try:
            write_inputs(broken, scratch / "none")
            said = "no error"
        except DataError as error:
            said = str(error)
        expect(name in said, f"{name}: {said}")

    def run_says(key, value):
        return lambda at: (at / "soak/run.json").write_text(json.dumps(miniature.RUN | {"command": "touchstone soak", key: value}))

    unmade = build(root, scratch / "nowhere", scratch / "none", "--no-latex")
    expect((unmade.returncode, unmade.stderr.count("\n")) == (1, 1) and "not run" in unmade.stderr, f"without results: {unmade.stderr}")
    spoiled("soak: not run", lambda at: shutil.rmtree(at / "soak"))
    spoiled("soak/run.json: interrupted", run_says("interrupted", True))
    spoiled("studies of different programs", run_says("commit", "fedcba"))
    for study in ("regress", "bench-scenes", "motions", "recorded"):
        spoiled(f"{study}/run.json: the program was built without fcl, bullet-float, which the paper is about",
                lambda at: edit(at / f"{study}/run.json", '"fcl", "libccd", "bullet", "ode", "bullet-float"', '"libccd", "bullet", "ode"'))
        spoiled(f"{study}/run.json: the program was built without embree, fcl,", lambda at: edit(at / f"{study}/run.json", '"engines"', '"others"'))
    spoiled("rates.csv: no column trials", lambda at: edit(at / "near-edge/rates.csv", "trials", "tries"))
    spoiled("rates.csv: line 182: failures cannot be", lambda at: edit(at / "near-edge/rates.csv", ",1,4,", ",-1,4,"))
    spoiled("soak: ValueError: 1 answers of filtered differ", lambda at: edit(at / "soak/soak.csv", "1,1,1,0", "1,1,1,1"))
    spoiled("seed-4/rates.csv", lambda at: (at / "seeds/seed-4/rates.csv").unlink())
    spoiled("regress: ValueError: exact was not asked everything", lambda at: edit(at / "regress/outcomes.csv", "exact,doubles,u,0,0,8,", "exact,doubles,u,0,0,7,"))
    spoiled("recorded: ValueError: filtered differs", lambda at: edit(at / "recorded/recorded.csv", "filtered,8,4,0", "filtered,8,4,1"))
    spoiled("motions: ValueError: exact and filtered differ", lambda at: edit(at / "motions/ways.csv", "all,filtered,8,0", "all,filtered,8,1"))
    spoiled("stability: ValueError: filtered failed", lambda at: edit(at / "stability/failures.csv", "filtered,1,0,4", "filtered,1,1,4"))
    spoiled("meshes: ValueError: filtered differs", lambda at: edit(at / "meshes/meshes.csv", "8,0", "8,1"))
    spoiled("bench-scenes: ValueError: Scene is wrong", lambda at: edit(at / "bench-scenes/queries.csv", "1000,near,any,Scene,500,490,510,0", "1000,near,any,Scene,500,490,510,1"))
    spoiled("cell: ValueError: wrong about the case studies, against the text: thesis",
            lambda at: edit(at / "cell/case-2/methods.csv", "thesis,100,0,0", "thesis,100,1,0"))
    spoiled("cell: ValueError: a case study was not recorded", lambda at: shutil.rmtree(at / "cell/case-1"))
    spoiled("thesis: ValueError: no more values of the layout are free", lambda at: edit(at / "thesis/numbers.csv", "chosen freely,12", "chosen freely,10"))
    spoiled("thesis: ValueError: other figures differ than the text says: 4.1, table 5.1",
            lambda at: edit(at / "thesis/entries.csv", "4.1,reproduced with chosen values", "4.1,differs"))
    spoiled("thesis: ValueError: what the captions imply is not found", lambda at: edit(at / "thesis/predictions.csv", "-150,-150", "150,-150"))
    spoiled("thesis: ValueError: unknown status: better", lambda at: edit(at / "thesis/entries.csv", "not computable", "better"))
    spoiled("too noisy to quote: bench/random-triangles/filtered/ratio",
            lambda at: edit(at / "bench/bench.json", '"ratio": {', '"ratio": {"too_noisy": true, '))
    spoiled("too noisy to quote: tradeoff/time/filtered", lambda at: edit(at / "tradeoff/front.csv", "filtered,300,290,310", "filtered,300,190,310"))
    spoiled("too noisy to quote: scenes/moving/fcl", lambda at: edit(at / "bench-scenes/motions.csv", "FCL BVHModel,9000,8900,9100", "FCL BVHModel,9000,6000,9100"))
    spoiled("too noisy to quote: bench/nearness/near", bench_says("nearness", "2^-52", "filtered", "nanoseconds", "upper_quartile", 70))
    spoiled("bench: ValueError: EPICK's compare_squared_distance is faster", bench_says("random-triangles", "", "EPICK, compare", "nanoseconds", "median", 1))
    spoiled("bench/bench.json", lambda at: (at / "bench/bench.json").write_text("{"))


def what_is_stale_is_told(root, results, output, scratch):
    copy = scratch / "root"
    for folder in ("papers", "experiments/report", "tests/corpus"):
        shutil.copytree(root / folder, copy / folder)
    (copy / "robust/filtered/detail/signs").mkdir(parents=True)
    (copy / "robust/proofs").mkdir()
    for file in ("robust/filtered/detail/signs/bounds.h", "robust/proofs/CLAIMS.md"):
        shutil.copy(root / file, copy / file)
    expect(build(copy, results, output, "--no-latex").returncode == 0, "the paper cannot be built elsewhere")
    expect(build(copy, results, output, "--check").returncode == 0, "a fresh paper is called stale")
    for file, old, new in [("papers/sections/limits.tex", "Limits", "Bounds"), ("experiments/report/studies/stability.py", "slivers", "needles"),
                           ("experiments/report/studies/near_edge.py", "NEAR = 1", "NEAR = 2"), ("robust/filtered/detail/signs/bounds.h", "kVertex", "kVertices"),
                           ("robust/proofs/CLAIMS.md", "`kDot`", "`kDots`"), ("papers/listings/record.txt", "8 * 8", "12 * 13"),
                           ("tests/corpus/holes.jsonl", "\n", "\n\n")]:
        edit(copy / file, old, new)
        stale = build(copy, results, output, "--check")
        expect(stale.returncode == 1 and "older than the text" in stale.stderr, f"{file} changed: {stale.stderr}")
        edit(copy / file, new, old)
    edit(results / "soak/soak.csv", "triangle,4,3", "triangle,4,4")
    stale = build(copy, results, output, "--check")
    expect(stale.returncode == 1 and "older than the data of soak" in stale.stderr, stale.stderr)
    unbuilt = build(copy, results, scratch / "unbuilt", "--check")
    expect(unbuilt.returncode == 1 and "not built" in unbuilt.stderr, unbuilt.stderr)


# What a text may hold in digits: a year, a standard, the confidence of limits, a constant of a method or of the model, a setting of an engine.
STATED = {"2008", "754", "256", "95", "0.99", "12", "101", "201", "500"}


def no_measured_number_is_typed(root):
    for file, text in text_of(root).items():
        if file.name == "touchstone.tex":
            text = text[text.index(r"\begin{document}"):]
        text = re.sub(r"\\(val|cite[tp]?|autoref|label|input|includegraphics|ref)(\[[^]]*\])*\{[^}]*\}", "", text)
        text = re.sub(r"\$[^$]*\$|\\setlength\{[^}]*\}\{[^}]*\}|\\texttt\{[^}]*\}|\[width=[^]]*\]", "", text)
        for number in re.findall(r"(?<![\w.+])\d+(?:\.\d+)?", text):
            expect(number in STATED or float(number) < 10, f"{file.name}: {number} is typed")


def main(root):
    root = pathlib.Path(root)
    with tempfile.TemporaryDirectory() as folder:
        scratch = pathlib.Path(folder)
        results, output = scratch / "results", scratch / "paper"
        miniature.write(results)
        every_citation_is_an_entry(root)
        what_the_text_asks_for_is_made(root, results, output)
        what_is_wrong_with_the_data_is_named(root, results, output, scratch)
        data_make_the_numbers(root, results, output, scratch)
        what_is_stale_is_told(root, results, output, scratch)
        no_measured_number_is_typed(root)
    print("the paper is made of its data")


if __name__ == "__main__":
    main(*sys.argv[1:])
