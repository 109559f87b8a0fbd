#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: report.py RESULTS

Writes RESULTS/report.html, one page that loads nothing, from the data in RESULTS: a folder for each study of studies.py. A
study that was not run is named with the command that runs it. Exit status 1, and the file's name, where data are missing or
malformed. Same data, same bytes.
"""
import pathlib
import re
import sys

import studies
from chapters import (bench, bench_scenes, cell, cell_area, merging, meshes, motions, near_edge, recorded, regress, soak, soak_moving, stability, thesis,
                      tradeoff, tunnelling)
from chapters.opening import never_failed, scheme, terms, verdict
from page import code, count, document, escaped, folded, rounded, table, words
from replacing import replacing
from results import DataError, study_in

CHAPTERS = {"meshes": meshes, "near-edge": near_edge, "stability": stability, "tradeoff": tradeoff, "bench": bench, "regress": regress, "recorded": recorded, "soak": soak,
            "motions": motions, "tunnelling": tunnelling, "soak-moving": soak_moving,
            "bench-scenes": bench_scenes, "merging": merging, "cell": cell, "cell-area": cell_area, "thesis": thesis}

STYLE = """
body { font-size: .97rem; line-height: 1.45; }
header p.lead { font-size: 1.12rem; }
h2 { margin-top: 2.2rem; } #contents { columns: 3 15rem; column-gap: 2.5rem; padding-left: 1.9rem; } #contents li { break-inside: avoid; }
.verdict { border: 2px solid var(--line); border-radius: .5rem; background: var(--soft); padding: 0 1rem; }
.verdict h2 { margin: .8rem 0 .2rem; } .verdict li { margin: .5rem 0; } .verdict ul { padding-left: 1.1rem; margin: .5rem 0; }
.headline { font-size: 1.12rem; font-weight: 600; margin: .5rem 0; }
code { font-size: .93em; } tbody th code, td code { white-space: nowrap; }
.table { margin: 1.5rem 0; } td.figure, th.figure { text-align: right; padding-left: .6rem; } td.figure { white-space: nowrap; }
th[scope=row] { min-width: 8rem; max-width: 22rem; }
.bar { background: linear-gradient(to right, var(--bar) var(--share), transparent 0); min-width: 5.5rem; padding: 0 .25rem; border-radius: .15rem;
       -webkit-print-color-adjust: exact; print-color-adjust: exact; }
.stacked { height: 1.1rem; min-width: 14rem; border-radius: .15rem; -webkit-print-color-adjust: exact; print-color-adjust: exact; }
.short { border-left: 3px solid var(--link); padding-left: .8rem; }
pre { overflow-x: auto; background: var(--soft); padding: .5rem; border-radius: .3rem; }
code.call { white-space: normal; overflow-wrap: anywhere; }
dt { font-weight: 600; margin-top: .5rem; break-after: avoid; } dd { margin-left: 1.2rem; } .methods { columns: 2 22rem; }
iframe.cell { width: 100%; height: 46rem; border: 1px solid var(--line); border-radius: .3rem; }
.made { columns: 2 20rem; } .narrow .picture img { max-width: min(100%, 34rem); }
.paper { display: none; } .parts { display: flex; flex-wrap: wrap; justify-content: center; gap: 1rem; } svg.part { flex: 0 1 22rem; min-width: min(20rem, 100%); height: auto; }
.parts figure { flex: 1 1 20rem; max-width: 27rem; margin: .5rem 0; } figure > svg.part { display: block; width: 100%; max-width: 27rem; margin: 0 auto; min-width: 0; }
svg.scheme { display: block; width: 100%; max-width: 46rem; height: auto; margin: 0 auto; }
@media (min-width: 75rem) { .pair { display: grid; grid-template-columns: 1fr 1fr; gap: 1.5rem; margin-inline: calc(50% - min(48vw, 40rem)); } }
@media (min-width: 62rem) { .picture .scroll, figure.cell { margin-inline: calc(50% - min(48vw, 40rem)); }
  .table .scroll { width: max-content; min-width: 100%; max-width: min(96vw, 80rem); position: relative; left: 50%; transform: translateX(-50%); } }
@media (max-width: 40rem) { .picture img { max-width: none; } svg.scheme { min-width: 36rem; } iframe.cell { height: 38rem; } th[scope=row] { max-width: 11rem; } }
@media print { iframe.cell { display: none; } .paper { display: block; } .table { break-inside: auto; }
  .table figcaption { break-after: avoid; } table { font-size: 8pt; }
  th[scope=row] { min-width: 0; } td.figure, th.figure { padding-left: .3rem; } .bar { min-width: 0; }
  .picture .scroll { margin-inline: 0; } .picture img { max-width: 100%; max-height: 17cm; width: auto; } }
"""


def interrupted(study):
    run = study.run
    return "" if study.complete else (f'<p class="no"><b>Interrupted</b>: {count(run["samples_done"])} of {count(run["samples_asked"])} samples '
                                      "were done; numbers here are of those.</p>")


def made(found):
    """How each study was run."""
    rows = []
    for name, study in found.items():
        run = study.run
        missing = f", {count(run['samples_missing'])} not found" if run["samples_missing"] else ""
        rows.append([f'<a href="#{name}">{escaped(CHAPTERS[name].TITLE)}</a>', f'<code class="call">{escaped(run["command"])}</code>', str(run["seed"]),
                     f"{count(run['samples_done'])} of {count(run['samples_asked'])}{missing}", f"{rounded(run['seconds'])} s, {run['parts']} × {run['threads']}",
                     escaped(run["date"][:16].replace("T", " ")), f'<a href="{study.folder.name}/">{study.folder.name}/</a>'])

    def lines(key, shown=escaped):
        return "".join(f"<li>{shown(each)}</li>" for each in dict.fromkeys(str(study.run.get(key) or "unknown") for study in found.values()))

    return ('<section><h2 id="made">How this was made</h2>'
            + folded("The commands, seeds and times", table("The studies, each by one command; the same seed gives the same data, times aside.",
                                                            ["study", "command", "seed", "samples", "time, parts × threads", "at (UTC)", "data"], rows))
            + f"<ul class=\"made\">{lines('commit', lambda c: 'commit ' + code(c))}{lines('compiler')}{lines('flags', code)}{lines('processor')}{lines('machine')}</ul></section>")


def not_run(results, missing):
    """What the page lacks, with the commands; a study that was begun and not ended is told apart."""
    if not missing:
        return ""
    items = ""
    for name in missing:
        study = studies.by_name(name)
        calls = "\n".join(studies.shown(call, f"{results.name}/{name}") for call in study.full)
        begun = " It was begun, and has not come to its end." if (results / name).exists() else ""
        how = "./reproduce" if study.quick else "./reproduce --paper" if study.paper else "./reproduce --full"
        items += f"<dt>{escaped(CHAPTERS[name].TITLE)}</dt><dd>{code(how)} runs it, or:{begun}<pre tabindex=\"0\"><code>{escaped(calls)}</code></pre></dd>"
    return f'<section><h2 id="not-run">Not run</h2><p>Not run: {words([escaped(CHAPTERS[name].TITLE) for name in missing])}.</p>' + folded(
        "The commands that run them", f"<dl>{items}</dl>") + "</section>\n"


def read_all(results, found):
    """What each study says: how often methods were asked, its sentence and its chapter. Data that do not fit together are an
    error that names the study."""
    said = {}
    for name, study in found.items():
        chapter = CHAPTERS[name]
        try:
            said[name] = chapter.asked(study), chapter.finding(study), chapter.chapter(study)
        except (ArithmeticError, AttributeError, LookupError, StopIteration, TypeError, ValueError) as error:
            raise DataError(f"{results / name}: its data do not fit together: {type(error).__name__}: {error}") from None
    return said


def sections(found, said):
    text = ""
    for name, chapter in CHAPTERS.items():
        if name in found:
            _, finding, body = said[name]
            text += (f'<section><h2 id="{name}">{escaped(chapter.TITLE)}</h2>{interrupted(found[name])}<p class="short">{finding}</p>{body}'
                     "</section>\n")
    return text


def commits(found):
    """The commits, compilers and processors of the studies, and a warning if the commits differ."""
    def distinct(key):
        return list(dict.fromkeys(str(study.run.get(key) or "unknown") for study in found.values()))

    commit = distinct("commit")
    dates = sorted(distinct("date"))
    text = (f"Made between {dates[0][:16].replace('T', ' ')} and {dates[-1][:16].replace('T', ' ')} UTC on "
            f"{words(map(escaped, distinct('processor')))} with {words(map(escaped, distinct('compiler')))}, commit "
            f"{words(code(c[:12] + '+' * c.endswith('+')) for c in commit)}.")
    if len(commit) > 1:
        text += ' <b class="no">The studies were made by different commits; see each study.</b>'
    if any(c.endswith("+") for c in commit):
        text += " A + after a commit means that the sources differed from it."
    return text


def reproducing(results):
    return f"""<section><h2 id="reproducing">Reproduce this page</h2>
<p>On a Debian 12 machine, in a clone of the repository:</p>
<pre tabindex="0"><code>./reproduce          # the studies with small samples, and this page
./reproduce --full   # all studies with their full samples: about half an hour</code></pre>
<p>Both can be interrupted and run again: finished studies are skipped, interrupted ones continue, and the page is the same
(except for times). Each study can be run alone by the command below it. The same seed gives the same data, byte for byte,
with any number of threads; for studies that run on many machines (<code>near-edge</code>, <code>stability</code>,
<code>tradeoff</code>, <code>soak</code>), also by any number of parts. <code>experiments/report/report.py {escaped(results.name)}</code> writes this page again.</p>
<details><summary>Test your own engine</summary><p>An engine is any program that reads cases, one line of JSON each, and prints its answers:</p>
<pre tabindex="0"><code>touchstone cases --failing fast --expected &gt; cases.jsonl   # random cases on which plain doubles are wrong
touchstone judge --engine './engine' cases.jsonl            # compares its answers with the exact ones
touchstone regress --baseline tests/experiments/judge/regress/baseline.json   # compares the built-in engines with their baseline</code></pre>
<p>How to write one, in ten lines of Python or C++: <code>docs/engines.md</code>; how to build one in:
<code>docs/adding-methods.md</code>; some thousand certified cases: <code>tests/corpus</code>.</p></details></section>
"""


def page(results):
    if not results.is_dir():
        raise DataError(f"{results}: is not a folder")
    found = {name: study for name in CHAPTERS if (study := study_in(results / name))}
    if not found:
        raise DataError(f"{results}: does not contain the run.json of any study")
    missing = [name for name in CHAPTERS if name not in found]
    said = read_all(results, found)
    asked = {name: counts for name, (counts, _, _) in said.items()}
    titles = {name: CHAPTERS[name].TITLE for name in CHAPTERS}
    contents = "".join(f'<li><a href="#{name}">{escaped(title)}</a></li>' for name, title in titles.items() if name in found)
    body = f"""<header><h1>Touchstone: does a ball touch a polygon, and how sure is the answer?</h1>
<p class="lead">Collision programs ask millions of times whether a ball touches a flat face. They answer with floating-point
numbers, which round; where the rounding decides, a branch goes the wrong way. This page measures how often different methods are
wrong, how far from contact, and the cost of never being wrong, with {code("filtered")}, which gives the answer of exact arithmetic.</p>
<p class="dim">{commits(found)} Every number and picture is generated from the data beside this page.</p></header>
<main>{verdict.box(found, asked)}
<nav aria-label="Contents"><h2>Contents</h2><ol id="contents"><li><a href="#question">The question, and the words used
here</a></li>{contents}
<li><a href="#made">How this was made</a></li><li><a href="#reproducing">Reproduce this page; test your own engine</a></li><li><a
href="#methods">The methods</a></li></ol></nav>
<section><h2 id="question">The question, and the words used here</h2>{scheme.PICTURE}{folded("The words used here", terms.TERMS)}</section>
{never_failed.table_of(asked, titles)}
{sections(found, said)}{not_run(results, missing)}{made(found)}{reproducing(results)}{terms.methods(results)}</main>
"""
    text = document("Touchstone: the report", "Where ball-polygon contact tests fail, how often, and how sure exact answers "
                                              "are.", STYLE, body)
    return re.sub(r"[ \t]+\n", "\n", text)


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: report.py RESULTS")
    results = pathlib.Path(sys.argv[1])
    try:
        text = page(results)
    except DataError as error:
        sys.exit(f"report.py: {error}")
    with replacing(results / "report.html") as file:
        file.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
