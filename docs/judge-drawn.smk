# SPDX-License-Identifier: GPL-3.0-or-later
# Draws cases, judges methods or an engine of yours by them, and tells it as one run would: a page of docs/engines.md.
#
#     snakemake -s docs/judge-drawn.smk --cores 8 --config judge="--engine ./engine=mine --keys contact --summary"
#
# Continues after any end. The same bytes, however many parts there are.
TOUCHSTONE = config.get("touchstone", "touchstone")
JUDGE = config.get("judge", "--methods fast --summary")
DRAW = config.get("draw", "--family u --ball near-edge")
CASES = int(config.get("cases", 1_000_000))
PARTS = int(config.get("parts", 8))


def first(part):
    return CASES * (part - 1) // PARTS


rule all:
    input:
        "judged.txt",


# Case i depends on the options and i alone.
rule draw:
    output:
        "drawn/{part}.jsonl",
    params:
        first=lambda wildcards: first(int(wildcards.part)),
        samples=lambda wildcards: first(int(wildcards.part) + 1) - first(int(wildcards.part)),
    shell:
        "{TOUCHSTONE} cases {DRAW} --expected --first {params.first} --samples {params.samples} > {output}"


rule cases:
    input:
        expand("drawn/{part}.jsonl", part=range(1, PARTS + 1)),
    output:
        "cases.jsonl",
    shell:
        "cat {input} > {output}"


# A part that was killed continues where it was.
rule judge:
    input:
        "cases.jsonl",
    output:
        "parts/{part}/run.json",
    shell:
        "{TOUCHSTONE} judge {input} {JUDGE} --part {wildcards.part}/{PARTS} --quiet --resume --output parts/{wildcards.part}"


# An expectation that is not met, exit status 1, does not end the workflow.
rule merge:
    input:
        expand("parts/{part}/run.json", part=range(1, PARTS + 1)),
    output:
        "judged.txt",
    params:
        folders=lambda wildcards, input: [path[: -len("/run.json")] for path in input],
    shell:
        "{TOUCHSTONE} merge {params.folders} --force --output judged > {output} || test $? -eq 1"
