# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: notebook.py NOTEBOOK FOLDER

Runs the cells of a notebook in their order, as Jupyter does, and writes what they draw to FOLDER: figures of matplotlib, and
the values with which cells end. Exit status 1 if a cell fails, if one stores its output, or if nothing is drawn.
"""

import ast
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def main(notebook, folder):
    folder.mkdir(parents=True, exist_ok=True)
    cells = [cell for cell in json.loads(notebook.read_text())["cells"] if cell["cell_type"] == "code"]
    if any(cell["outputs"] or cell["execution_count"] for cell in cells):
        sys.exit(f"{notebook}: store it without outputs")
    names, drawn = {"__name__": "__main__"}, 0
    plt.show = lambda: None  # keeps the figures
    for number, cell in enumerate(cells):
        tree = ast.parse("".join(cell["source"]), f"{notebook}, cell {number}")
        last = ast.Expression(tree.body.pop().value) if isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, f"cell {number}", "exec"), names)
        value = eval(compile(last, f"cell {number}", "eval"), names) if last else None
        if hasattr(value, "_repr_svg_"):
            (folder / f"cell-{number}.svg").write_text(value._repr_svg_())
            drawn += 1
        for figure in map(plt.figure, plt.get_fignums()):
            figure.savefig(folder / f"cell-{number}.png", bbox_inches="tight")
            drawn += 1
        plt.close("all")
    return 0 if drawn > 1 else f"{notebook}: draws {drawn} pictures"


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
