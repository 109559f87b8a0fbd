# SPDX-License-Identifier: GPL-3.0-or-later
"""The questions of both case studies of the thesis, recorded in its cell."""
from studies.cell import CASES, Questions
from values.latex import count


def values(study):
    questions = Questions(study)
    if len(questions.cases) != len(CASES):
        raise ValueError("a case study was not recorded")
    if wrong := [method for method in questions.methods if questions.wrong(method)]:
        raise ValueError(f"wrong about the case studies, against the text: {', '.join(wrong)}")
    yield "questions", count(questions.asked)
    yield "methods", str(len(questions.methods))
    yield "nearest", f"$2^{{-{questions.nearest()}}}$"
    yield "nearer", f"$2^{{-{questions.nearest() + 1}}}$"
