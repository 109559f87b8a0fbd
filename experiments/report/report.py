#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: report.py RESULTS

Writes RESULTS/report.html, one page that loads nothing, from the data in RESULTS: a folder for each study in studies/. A
study that was not run is named with the command that runs it. Exit status 1, and the file's name, where data are missing or
malformed. Same data, same bytes.
"""
import pathlib
import re
import sys

import jinja2

import opening
import studies
from page import code, count, escaped, rendered, rounded
from replacing import replacing
from results import DataError, study_in

CHAPTERS = studies.chapters()


def asked_in(study, name):
    """How often methods were asked; empty of a study that is not about methods."""
    return CHAPTERS[name].asked(study) if hasattr(CHAPTERS[name], "asked") else {}


def distinct(found, key):
    return list(dict.fromkeys(str(study.run.get(key) or "unknown") for study in found.values()))


def minute(date):
    return date[:16].replace("T", " ")


def made(name, study):
    """How a study was run."""
    run = study.run
    missing = f", {count(run['samples_missing'])} not found" if run["samples_missing"] else ""
    title = escaped(CHAPTERS[name].TITLE)
    return {"name": name, "title": title, "cells": [
        f'<a href="#{name}">{title}</a>', f'<code class="call">{escaped(run["command"])}</code>', str(run["seed"]),
        f"{count(run['samples_done'])} of {count(run['samples_asked'])}{missing}", f"{rounded(run['seconds'])} s, {run['parts']} × {run['threads']}",
        escaped(minute(run["date"])), f'<a href="{study.folder.name}/">{study.folder.name}/</a>']}


def missing(name, results):
    """A study that was begun and not ended is told apart."""
    run = CHAPTERS[name].RUN
    return {"title": escaped(CHAPTERS[name].TITLE), "begun": (results / name).exists(),
            "how": "./reproduce" if run.quick else "./reproduce --paper" if run.paper else "./reproduce --full",
            "calls": "\n".join(studies.shown(call, f"{results.name}/{name}") for call in run.full)}


def read_all(results, found):
    """What each study says: how often methods were asked, and its chapter. Data that do not fit together are an error that names
    the study."""
    asked, chapters = {}, []
    for name, study in found.items():
        module = CHAPTERS[name]
        try:
            asked[name] = asked_in(study, name)
            chapters.append(rendered(f"{name.replace('-', '_')}.html", name=name, title=module.TITLE, study=study, **module.told(study)))
        except (ArithmeticError, AttributeError, LookupError, StopIteration, TypeError, ValueError, jinja2.UndefinedError) as error:
            raise DataError(f"{results / name}: its data do not fit together: {type(error).__name__}: {error}") from None
    return asked, chapters


def page(results):
    if not results.is_dir():
        raise DataError(f"{results}: is not a folder")
    found = {name: study for name in CHAPTERS if (study := study_in(results / name))}
    if not found:
        raise DataError(f"{results}: does not contain the run.json of any study")
    asked, chapters = read_all(results, found)
    commits = distinct(found, "commit")
    machines = [shown(each) for key, shown in (("commit", lambda c: "commit " + code(c)), ("compiler", escaped), ("flags", code), ("processor", escaped),
                                               ("machine", escaped)) for each in distinct(found, key)]
    text = rendered(
        "report.html", dates=[minute(date) for date in sorted(distinct(found, "date"))], processors=list(map(escaped, distinct(found, "processor"))),
        compilers=list(map(escaped, distinct(found, "compiler"))), commits=[c[:12] + "+" * c.endswith("+") for c in commits],
        changed=any(c.endswith("+") for c in commits), verdict=opening.verdict(found, asked), chapters=chapters,
        never_failed=opening.never_failed(asked, {name: module.TITLE for name, module in CHAPTERS.items()}),
        made=[made(*item) for item in found.items()], missing=[missing(name, results) for name in CHAPTERS if name not in found], machines=machines,
        folder=results.name, methods=opening.methods(results))
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
