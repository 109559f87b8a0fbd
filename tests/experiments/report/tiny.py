# SPDX-License-Identifier: GPL-3.0-or-later
"""Tiny results of every study, by the program itself, so that the report is tested on the formats that it writes."""
import concurrent.futures
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "tests/papers"), str(ROOT / "tests/system"), str(ROOT / "experiments/report")]

from miniature import BENCH
from running import run
from studies import CELL, MESHES, modules
from studies.thesis import rows_of, write_page

MESH = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
PICTURES = {
    "near-edge": ["rates-planar", "maps-reflex-vertex"],
    "stability": ["failures", "onset"],
    "tradeoff": ["front-not-right"],
    "bench-scenes": ["queries-torus"],
    "motions": ["grazing-pass", "steps"],
    "cell-area": ["cell-area-plan", "cell-area-heights"],
}
SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="72pt" height="36pt" viewBox="0 0 72 36"><path d="M0 0L72 36"/></svg>'


def calls(source, mesh):
    """The tiny calls of the studies, by their names."""
    files = {CELL: str(source / CELL), MESHES: mesh}
    return {name: [files.get(word, word) for word in module.RUN.tiny] for name, module in modules().items() if module.RUN.tiny}


def write(program, source, results):
    """A folder for each study, pictures of one line, and the thesis's page."""
    results.mkdir(parents=True)
    mesh = results / "tetrahedron.obj"
    mesh.write_text(MESH)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        list(pool.map(lambda item: run(program, *item[1], "--output", str(results / item[0])), reversed(calls(source, str(mesh)).items())))
    cell, folder = str(source / "experiments/thesis/cell/cells/aristo.json"), results / "cell"
    of_preset = lambda preset, *more: ["cell", "run", cell, "--preset", preset, "--methods", "filtered,thesis", *more]
    for n in (1, 2):
        run(program, *of_preset(f"case {n}", "--every-face", "--output", folder / f"case-{n}"))
    run(program, *of_preset("U-part", "--output", folder / "u-part"))
    driven = of_preset("U-part", "--drive", "thesis", "--output", folder / "driven")
    run(program, *driven, expected=1)  # into the vice
    run(program, "cell", "export", cell, folder / "cell.html", "--methods", "filtered")
    for path in (results / "near-edge").glob("map-*.csv"):
        path.write_text("".join(path.read_text().splitlines(keepends=True)[:200]))  # enough of one
    (results / "methods.txt").write_text(run(program, "methods").stdout)
    thesis = results / "thesis"
    entries, numbers = rows_of(thesis / "entries.csv"), rows_of(thesis / "numbers.csv")
    stems = [(pathlib.Path(folder), stem) for folder, names in PICTURES.items() for stem in names]
    stems += [(pathlib.Path("thesis"), entry["picture"]) for entry in entries if entry["picture"]]
    for folder, stem in stems:
        (results / folder / f"{stem}.svg").write_text(SVG)
    # The bench itself prepares polygons of 100,000 vertices, which takes minutes.
    (results / "bench").mkdir()
    (results / "bench/bench.json").write_text(json.dumps(BENCH))
    run_record = json.loads((results / "soak/run.json").read_text(encoding="utf-8"))
    (results / "bench/run.json").write_text(json.dumps(run_record | {"command": "touchstone bench"}))
    write_page(thesis, entries, numbers, json.loads((thesis / "run.json").read_text(encoding="utf-8")))
