# SPDX-License-Identifier: GPL-3.0-or-later
"""Tiny results of every study, by the program itself, so that the report is tested on the formats that it writes."""
import concurrent.futures
import json
import pathlib
import sys

TESTS = pathlib.Path(__file__).resolve().parents[2]
sys.path += [str(TESTS / "papers"), str(TESTS / "system")]

from miniature import BENCH
from running import run

MESH = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
PICTURES = {
    "near-edge": ["rates-rotated", "maps-reflex-vertex"],
    "stability": ["failures", "onset"],
    "tradeoff": ["front-not-right"],
    "bench-scenes": ["queries-torus"],
    "motions": ["grazing-pass"],
    "tunnelling": ["tunnelling"],
    "cell-area": ["cell-area-plan", "cell-area-heights"],
}
SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="72pt" height="36pt" viewBox="0 0 72 36"><path d="M0 0L72 36"/></svg>'


def calls(source, mesh):
    cell = str(source / "experiments/thesis/cell/cells/aristo.json")
    return {
        "meshes": ["meshes", mesh, "--methods", "exact,filtered,fast,cgal-double,thesis"],
        "near-edge": ["near-edge", "--methods", "filtered,fast,thesis", "--families", "u", "--samples", "4", "--search", "2", "--no-pictures"],
        "stability": ["stability", "--methods", "filtered,fast", "--axes", "aspect,origin,small,rounding", "--samples", "2", "--no-pictures"],
        "tradeoff": ["tradeoff", "--methods", "fast,filtered,exact,interval", "--families", "u", "--samples", "2", "--queries", "2",
                     "--repetitions", "1", "--no-pictures"],
        "regress": ["regress", "--methods", "exact,filtered,fast,thesis,cgal-epick-intersect", "--samples", "1"],
        "soak": ["soak", "--samples", "200"],
        "motions": ["motions", "--methods", "exact,filtered,fast,cgal-epeck-distance", "--vertices", "6", "--samples", "1", "--no-pictures"],
        "tunnelling": ["tunnelling", "--samples", "100", "--repetitions", "1", "--no-pictures"],
        "recorded": ["recorded", "--methods", "fast,filtered", "--samples", "1", "--balls", "6", "--steps", "90"],
        "soak-moving": ["soak", "--moving", "--samples", "100"],
        "cell": ["cell", "run", cell, "--methods", "filtered,fast"],
        "cell-area": ["cell", "area", cell, "--angle-step", "90", "--length-step", "500", "--no-pictures"],
        "merging": ["merging", mesh, "--compare", "10", "--repetitions", "1"],
        "bench-scenes": ["bench-scenes", "--max-faces", "1000", "--samples", "10", "--repetitions", "1", "--no-pictures"],
        "thesis": ["thesis", "--quick", "--samples", "100", "--no-pictures"],
    }


def write(program, source, results):
    """A folder for each study, pictures of one line, and the thesis's page."""
    from studies.thesis import rows_of, write_page

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
