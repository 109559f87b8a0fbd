# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `touchstone thesis`: every figure and table with its status, numbers and picture, in one file."""
from page import document, escaped, folded, inlined, number, smaller
from replacing import replacing

CHAPTERS = (("2", "Chapter 2: literature"), ("3", "Chapter 3: methodology"), ("4", "Chapter 4: the collision detection algorithm"),
            ("5", "Chapter 5: the virtual environment"), ("6", "Chapter 6: the case studies"),
            ("E", "Known errors of the method"))
LABELS = {"T": "the thesis's public text", "S": "another public source", "D": "derived in this project, by arithmetic or by an exact test",
          "C": "rests on values chosen here, because no public source gives them"}

STYLE = """
article { margin: 1.5rem 0; padding: 1rem; border: 1px solid var(--line); border-radius: .5rem; background: var(--soft); }
article h3 { margin: 0 0 .3rem; }
article img { margin: .8rem auto 0; }
article figure { margin: 0; } article thead th:first-child, article tbody th { background: var(--soft); }
.page { color: var(--dim); font-size: .88rem; font-weight: 400; } .status { font-weight: 600; }
.chosen { color: #8a5a00; } @media (prefers-color-scheme: dark) { .chosen { color: #e8b44c; } }
table { width: 100%; margin-top: .6rem; } tbody th { width: 46%; }
th:last-child, td:last-child { white-space: nowrap; padding-right: 0; } td { hyphens: manual; }
nav ul, .summary ul { padding-left: 1.2rem; }
.index { columns: 2 18rem; font-size: .88rem; padding-left: 0; list-style: none; }
.index li { break-inside: avoid; padding: .1rem 0; }
@media (max-width: 34rem) { article { padding: .7rem; } tbody th { width: 40%; } }
@media print { article { break-inside: avoid; } article img { max-height: 9cm; } }
"""


def name_of(entry):
    if entry["id"].startswith("table"):
        return "Table" + entry["id"][5:]
    return "Figure " + entry["id"]


def anchor(entry):
    return entry["id"].replace(" ", "-")


def picture(folder, entry, shown):
    """The smaller of both files, within the page; a picture that an earlier entry showed is named. `shown`: entries by their bytes."""
    if not entry["picture"]:
        return ""
    earlier = shown.setdefault(smaller(folder, entry["picture"]).read_bytes(), entry)
    if earlier is not entry:
        return f'<p>The picture is that of <a href="#{anchor(earlier)}">{name_of(earlier)}</a>.</p>'
    return (f'<figure><img decoding="async" alt="{escaped(entry["shows"])}" src="{inlined(smaller(folder, entry["picture"]))}">'
            f'<figcaption>{escaped(entry["shows"])} (<a href="{entry["picture"]}.svg">SVG</a>, '
            f'<a href="{entry["picture"]}.png">PNG</a>)</figcaption></figure>')


def numbers_table(rows):
    if not rows:
        return ""
    any_stated = any(row["stated"] for row in rows)
    body = ""
    for row in rows:
        unit = "" if not row["unit"] else (row["unit"] if row["unit"] == "°" else " " + row["unit"])
        ours = number(row["ours"]) + escaped(unit) + (" <small>[C]</small>" if row["rests_on"] else "")
        if row["lower"]:
            ours += (f'<br><small>{number(row["lower"], 4)} to {number(row["upper"], 4)}, 95 %, '
                     f'{int(row["samples"]):,} samples</small>')
        stated, agrees = "<small>none</small>", ""
        if row["stated"]:
            stated = f'{number(row["stated"])}{escaped(unit)} <small>[{row["label"]}]</small>'
            if float(row["tolerance"]) > 0:
                stated += f'<br><small>± {float(row["tolerance"]):.2g}</small>'
            tone = row["agrees"] if row["agrees"] == "no" or row["basis"] == "other source" else ""
            agrees = f'<span class="{tone}">{row["agrees"]}</span> <small>{row["basis"]}</small>'
        body += f'<tr><th scope="row">{escaped(row["what"])}</th><td>{ours}</td>'
        body += f"<td>{stated}</td><td>{agrees}</td></tr>" if any_stated else "</tr>"
    source = "derived here" if all(row["label"] == "D" for row in rows if row["stated"]) else "stated"
    beside = f'<th scope="col">{source}</th><th scope="col">agrees</th>' if any_stated else ""
    return (f'<table><thead><tr><th scope="col">number</th><th scope="col">ours</th>{beside}</tr></thead>'
            f"<tbody>{body}</tbody></table>")


def article(folder, entry, rows, shown):
    page = f' <span class="page">p. {entry["page"]}</span>' if entry["page"] else ""
    tone = {"reproduced": "yes", "differs": "no", "reproduced with chosen values": "chosen"}.get(entry["status"], "")
    return (f'<article id="{anchor(entry)}"><h3>{name_of(entry)}: {escaped(entry["caption"])}{page}</h3>'
            f'<div class="status {tone}">{escaped(status_of(entry, rows))}</div>'
            f'<p>{escaped(entry["text"])}</p>{picture(folder, entry, shown)}{numbers_table(rows)}</article>')


BASES = {"fitted": "angles that captions state, for which the layout was solved", "input": "numbers of captions that the cell was built with",
         "other source": "numbers of other sources", "own check": "tests of this project: arithmetic, and the exact answer"}


def bases(stated):
    """How many numbers agree, by what that means; those of the known errors apart. `stated`: rows of numbers.csv."""
    own = [row for row in stated if row["id"].startswith("E.")]
    groups = [(text, [row for row in stated if row["basis"] == basis and row not in own]) for basis, text in BASES.items()]
    return [f"{sum(row['agrees'] == 'yes' for row in rows)} of {len(rows)}{distinct(rows)}: {text}"
            for text, rows in groups + [("known errors of the thesis's method: numbers of this project's own fact sheet, not of the thesis", own)] if rows]


def distinct(rows):
    """Captions repeat themselves: how many different numbers there are, if fewer than rows."""
    values = {(row["stated"], row["unit"]) for row in rows}
    return f" ({len(values)} different numbers)" if len(values) < len(rows) else ""


def fit(own):
    """How easily the layout fits: beside how many captions it does."""
    values = {row["what"]: row["ours"] for row in own.get("table 6.1", [])}
    try:
        free, captions = values["values of the layout that are chosen freely"], values["captioned moves of both cases that it must reproduce"]
        homes, share = values["home poses that were tried"], values["of these with a layout in which all captions hold"]
    except KeyError:
        return ""
    return (f"<p>The layout was solved for {number(captions)} captioned moves, with {number(free)} values that could be chosen. Of "
            f"{number(homes)} home poses tried, {number(share, 3)} % have a layout in which all captions hold.</p>")


def status_of(entry, rows):
    """As the page shows it: what a photograph shows cannot be computed, but the numbers of its caption may be."""
    if entry["status"].startswith("photograph") and any(row["stated"] for row in rows):
        return "photograph: its caption's numbers alone are computed"
    return entry["status"]


def chapter_of(entry):
    return entry["id"].removeprefix("table ").split(".")[0]


def write_page(folder, entries, numbers, run):
    own = {}
    for row in numbers:
        own.setdefault(row["id"], []).append(row)
    statuses = {}
    for entry in entries:
        status = status_of(entry, own.get(entry["id"], []))
        statuses[status] = statuses.get(status, 0) + 1
    stated = [row for row in numbers if row["stated"]]
    differing = [row for row in stated if row["agrees"] == "no"]
    counts = "".join(f"<li>{count} {escaped(status)}</li>" for status, count in sorted(statuses.items(), key=lambda item: -item[1]))
    differ = "".join(f'<li><a href="#{row["id"].replace(" ", "-")}">{escaped(row["id"])}</a>: {escaped(row["what"])}: '
                     f'{number(row["ours"])} {escaped(row["unit"])}, stated {number(row["stated"])} [{row["label"]}]</li>'
                     for row in differing)
    labels = "".join(f"<li><b>[{label}]</b> {text}</li>" for label, text in LABELS.items())
    sections, index, shown = "", "", {}
    for chapter, title in CHAPTERS:
        members = [entry for entry in entries if chapter_of(entry) == chapter]
        index += f'<h3>{title}</h3><ul class="index">' + "".join(
            f'<li><a href="#{anchor(entry)}">{name_of(entry)}</a>: {escaped(status_of(entry, own.get(entry["id"], [])))}</li>' for entry in members) + "</ul>"
        sections += f'<section><h2 id="chapter-{chapter}">{title}</h2>' + "".join(
            article(folder, entry, own.get(entry["id"], []), shown) for entry in members) + "</section>"
    body = f"""<header><h1>The figures of a 2008 thesis, as numbers</h1>
<p>H. Arshad, <cite>A Collision Detection Algorithm for Virtual Robot-Centered Flexible Manufacturing Cell</cite>, PhD thesis,
Universiti Putra Malaysia, 2008. Its front matter, with every caption, is public; its chapters from page 8 on are not. Captions are
cited from its lists of figures and tables; pictures and numbers are computed by <code>touchstone thesis</code>, none is copied.</p>
<div class="summary"><p>{len(entries)} figures and tables, {len(entries) - sum(chapter_of(e) == "E" for e in entries)} of the thesis
and {sum(chapter_of(e) == "E" for e in entries)} of known errors of its method:</p><ul>{counts}</ul>
<ul>{"".join(f"<li>{line}</li>" for line in bases(stated))}</ul>
{fit(own)}
<p>{"These differ:" if differing else "None differs."}</p>
{"<ul>" + differ + "</ul>" if differ else ""}
<p>Where a number comes from:</p><ul>{labels}</ul>
<p>Shares of random samples have Clopper-Pearson limits. {run["samples_asked"]:,} balls of each outline and radius, seed
{run["seed"]}; run.json says how to have the same again.</p></div>
<nav aria-label="All figures and tables">{folded("All figures and tables", index)}</nav></header>
<main>{sections}</main>
"""
    title = "The figures of a 2008 thesis, as numbers"
    with replacing(folder / "index.html") as file:
        file.write_text(document(title, "Every figure and table of the thesis, with its numbers beside ours.", STYLE, body), encoding="utf-8")
