#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: build.py RESULTS OUTPUT [--no-latex]
       build.py --check RESULTS OUTPUT

Makes OUTPUT/touchstone.pdf, every number, table and figure of it from the studies in RESULTS. The same data give the
same bytes. A study or a number that is missing, an interrupted study, a program without one of the engines that the paper is
about, or studies of different programs are errors (status 1). --no-latex stops before LaTeX is called. --check builds nothing: it fails where OUTPUT was made from other
data than those that are in RESULTS now, from another text or by other code.
"""
import argparse
import hashlib
import importlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

PAPERS = pathlib.Path(__file__).resolve().parent
ROOT = PAPERS.parent
sys.path.append(str(PAPERS))
sys.path.append(str(ROOT / "experiments/report"))

from results import DataError, study_in  # noqa: E402
from studies import modules  # noqa: E402
from values import corpus, proofs  # noqa: E402
from values.latex import decimal, escaped, table  # noqa: E402

# By their folders in RESULTS, in the order of the report: what makes values and tables of each. PREFIX before the keys of \val, if it is not the name.
STUDIES = {name: importlib.import_module(f"values.{path.stem}") for name in modules()
           if (path := PAPERS / "values" / f"{name.replace('-', '_')}.py").exists()}

# Libraries of others that the paper's tables are about, as run.json names them; and the studies that ask them.
ENGINES = ["embree", "fcl", "libccd", "bullet", "ode", "bullet-float"]
ASKING = ["regress", "bench-scenes", "motions", "recorded"]

# By figures, and not row by row.
ALSO_READ = {"bench": {"bench.json"}, "near-edge": {f"map-reflex-vertex-foot-{distance}.csv" for distance in (0, 1000)}}


class Recording:
    """A study that remembers which of its files were read."""

    def __init__(self, study):
        self.folder, self.run, self._study, self.files = study.folder, study.run, study, {"run.json"}

    def rows(self, name, **columns):
        self.files.add(name)
        return self._study.rows(name, **columns)


def read_studies(results):
    studies = {}
    for name in STUDIES:
        study = study_in(results / name)
        if study is None:
            raise DataError(f"{results / name}: not run; ./reproduce --paper runs it")
        if not study.complete:
            raise DataError(f"{results / name}/run.json: interrupted; ./reproduce --paper ends it")
        if name in ASKING and (lacking := [engine for engine in ENGINES if engine not in study.run.get("engines", [])]):
            raise DataError(f"{results / name}/run.json: the program was built without {', '.join(lacking)}, which the paper is about; "
                            "./reproduce --paper installs them and builds it anew")
        studies[name] = Recording(study)
    commits = {study.run.get("commit") for study in studies.values()}
    if len(commits) != 1:
        raise DataError(f"{results}: studies of different programs: {', '.join(sorted(map(str, commits)))}")
    return studies


def run_values(studies):
    run = studies["near-edge"].run
    yield "commit", escaped((run.get("commit") or "unknown")[:12])
    yield "date", min(study.run["date"] for study in studies.values())[:10]
    for name in ("compiler", "flags", "machine", "processor"):
        yield name, escaped(run[name]).replace("-", "{-}")
    yield "cores", str(run["cores"])


def digest(paths):
    sums = hashlib.sha256()
    for path in sorted(paths):
        sums.update(hashlib.sha256(path.read_bytes()).digest())
    return sums.hexdigest()


def command_of(run):
    """Without its output, and with a long list of files cut short."""
    words = re.sub(r" --(output|json|baseline) ('[^']*'|\S+)", "", run["command"])
    return re.sub(r"((?:'[^']*'|\S+)\.(?:stl|obj|off|ply|gltf|glb)\b'? ){3,}", "MESH... ", words)


def data_table(studies, digests):
    rows = []
    for name, study in studies.items():
        command = escaped(command_of(study.run)).replace("--", "-{}-").replace(",", r",\allowbreak{}")
        rows.append([name, rf"\raggedright\ttfamily {command}", decimal(study.run["seconds"]), rf"\texttt{{{digests[name][:8]}}}"])
    return table(r"lp{.6\textwidth}rr", ["folder", "command", "seconds", "data"], rows)


def write_inputs(results, output):
    """values.tex, tables, figures, and data.json: what they were made from."""
    studies = read_studies(results)
    values = {f"run/{key}": value for key, value in run_values(studies)}
    values |= {f"corpus/{key}": value for key, value in corpus.values()}
    values |= {f"proofs/{key}": value for key, value in proofs.values()}
    tables = dict(proofs.tables())
    for name, module in STUDIES.items():
        studies[name].files |= ALSO_READ.get(name, set())
        try:
            values |= {f"{getattr(module, 'PREFIX', name)}/{key}": value for key, value in module.values(studies[name])}
            tables |= dict(module.tables(studies[name])) if hasattr(module, "tables") else {}
        except (ArithmeticError, AttributeError, LookupError, StopIteration, TypeError, ValueError) as error:
            raise DataError(f"{results / name}: {type(error).__name__}: {error}") from None
    refuse_noise(values)
    for folder in ("tables", "figures"):
        (output / folder).mkdir(parents=True, exist_ok=True)
    import figures  # when the numbers are right: it is slow to come
    figures.draw(results, output / "figures")
    digests = data_digests(results, {name: sorted(study.files) for name, study in studies.items()})
    tables["data"] = data_table(studies, digests)
    for name, text in tables.items():
        (output / "tables" / f"{name}.tex").write_text(text)
    (output / "values.tex").write_text("".join(f"\\defineval{{{key}}}{{{value}}}%\n" for key, value in values.items() if value is not None))
    record = {"files": {name: sorted(study.files) for name, study in studies.items()}, "sums": digests, "sources": digest(sources())}
    (output / "data.json").write_text(json.dumps(record, indent=1) + "\n")
    return studies


def refuse_noise(values):
    """The text may not quote a ratio of times that its run shows to be noise; its value is None."""
    text = "".join(path.read_text() for path in (PAPERS / "sections").glob("*.tex"))
    if noisy := [key for key in sorted(set(re.findall(r"\\val\{([^}]*)\}", text))) if key in values and values[key] is None]:
        raise DataError(f"too noisy to quote: {', '.join(noisy)}; measure again on an idle machine")


def data_digests(results, files):
    return {name: digest([results / name / file for file in its]) for name, its in files.items()}


def sources():
    """What the paper is made of besides the data: its text, what reads and draws the data, and files that it counts."""
    text = [path for kind in ("*.tex", "*.bib", "*.py", "*.json") for path in PAPERS.rglob(kind)]
    return [*text, *(path for kind in ("*.py", "*.html", "*.css") for path in (ROOT / "experiments/report").rglob(kind)), *corpus.files(), *proofs.files(), *(PAPERS / "listings").glob("*.txt")]


def run_latex(output, studies):
    for path in (PAPERS / "touchstone.tex", PAPERS / "references.bib"):
        shutil.copy(path, output)
    for folder in ("sections", "listings"):
        shutil.copytree(PAPERS / folder, output / folder, dirs_exist_ok=True)
    date = max(study.run["date"] for study in studies.values())
    epoch = subprocess.run(["date", "-d", date, "+%s"], check=True, capture_output=True, text=True).stdout.strip()
    environment = os.environ | {"SOURCE_DATE_EPOCH": epoch, "FORCE_SOURCE_DATE": "1", "max_print_line": "1000"}
    made = subprocess.run(["latexmk", "-g", "-pdf", "-interaction=nonstopmode", "-halt-on-error", "-silent", "touchstone.tex"], cwd=output,
                          env=environment, capture_output=True, text=True)
    log = (output / "touchstone.log").read_text(errors="replace") if (output / "touchstone.log").exists() else made.stdout
    lines = log.splitlines()
    bibliography = (output / "touchstone.blg").read_text(errors="replace").splitlines() if (output / "touchstone.blg").exists() else []
    faults = ([line for line in lines if line.startswith("!")] or [line for line in bibliography if "---line" in line] or
              [line for line in lines if re.search(r"undefined|multiply defined|Overfull .hbox \(\d\d", line)])
    if made.returncode != 0 or faults:
        raise DataError("\n".join([f"{output}/touchstone.log:", *faults]))


def check(results, output):
    try:
        record = json.loads((output / "data.json").read_text())
    except OSError as error:
        raise DataError(f"{output}/data.json: {error.strerror}: the paper was not built") from None
    if record.get("sources") != digest(sources()):
        raise DataError(f"{output}: older than the text of the paper, or what makes it of the data")
    now = data_digests(results, record["files"])
    if stale := [name for name, sum_ in record["sums"].items() if now[name] != sum_]:
        raise DataError(f"{output}: older than the data of {', '.join(stale)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--no-latex", action="store_true")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    try:
        if options.check:
            return check(options.results, options.output)
        studies = write_inputs(options.results, options.output)
        if not options.no_latex:
            run_latex(options.output, studies)
            print(options.output / "touchstone.pdf")
    except (DataError, OSError) as error:
        sys.exit(f"build.py: {error}")


if __name__ == "__main__":
    main()
