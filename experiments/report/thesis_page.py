# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `touchstone thesis`: every figure and table with its status, numbers and picture, in one file."""
import base64
import html

CHAPTERS = (("2", "Chapter 2: literature"), ("3", "Chapter 3: methodology"), ("4", "Chapter 4: the collision detection algorithm"),
            ("5", "Chapter 5: the virtual environment"), ("6", "Chapter 6: the case studies"),
            ("E", "Known errors of the method"))
LABELS = {"T": "the thesis's public text", "S": "another public source", "D": "derived by arithmetic, or by an exact test",
          "C": "rests on values chosen here, because no public source gives them"}

STYLE = """
:root { color-scheme: light dark; --ink: #1c1c1c; --paper: #ffffff; --soft: #f2f2ef; --line: #d0d0c8; --dim: #595959;
        --good: #00634a; --bad: #a33b00; --link: #00558a; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e8e8e4; --paper: #16181a; --soft: #222528; --line: #43474b; --dim: #adb1b4; --good: #5fd0a8; --bad: #ff9d66;
          --link: #7cc4f2; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem; max-width: 56rem; font: 1rem/1.5 system-ui, sans-serif; color: var(--ink);
       background: var(--paper); overflow-wrap: break-word; }
h1 { line-height: 1.2; } h2 { margin-top: 3rem; border-bottom: 2px solid var(--line); }
a { color: var(--link); }
article { margin: 1.5rem 0; padding: 1rem; border: 1px solid var(--line); border-radius: .5rem; background: var(--soft); }
article h3 { margin: 0 0 .3rem; line-height: 1.3; }
article img { display: block; max-width: 100%; height: auto; margin: .8rem auto 0; background: #fff; border-radius: .3rem; padding: .3rem; }
.page, figcaption, small { color: var(--dim); font-size: .85rem; }
figure { margin: 0; } figcaption { margin: .3rem auto .5rem; }
.status { font-weight: 600; } .yes { color: var(--good); } .no { color: var(--bad); }
table { width: 100%; border-collapse: collapse; font-size: .9rem; margin-top: .6rem; }
th, td { text-align: left; vertical-align: top; padding: .25rem .5rem .25rem 0; border-top: 1px solid var(--line); }
thead th { border-top: 0; color: var(--dim); font-weight: 600; }
tbody th { font-weight: 400; width: 46%; }
th:last-child, td:last-child { white-space: nowrap; padding-right: 0; } td { hyphens: manual; }
nav ul, .summary ul { padding-left: 1.2rem; }
.index { columns: 2 18rem; font-size: .88rem; padding-left: 0; list-style: none; }
.index li { break-inside: avoid; padding: .1rem 0; }
:target { outline: 3px solid var(--link); }
@media (max-width: 34rem) { body { padding: .6rem; } article { padding: .7rem; } tbody th { width: 40%; } }
@media print { body { max-width: none; font-size: 9.5pt; --soft: #fff; } article, tr { break-inside: avoid; } h2, h3 { break-after: avoid; } nav { display: none; }
  article img { max-height: 9cm; } }
"""


def escaped(text):
    return html.escape(text, quote=True)


def number(text, digits=6):
    value = float(text)
    if value != value:
        return "none"
    shown = f"{value:.{digits}g}"
    if "e" in shown:
        mantissa, exponent = shown.split("e")
        shown = f"{float(mantissa):.4g} × 10<sup>{int(exponent)}</sup>"
    return shown.replace("-", "−")


def name_of(entry):
    if entry["id"].startswith("table"):
        return "Table" + entry["id"][5:]
    return "Figure " + entry["id"]


def anchor(entry):
    return entry["id"].replace(" ", "-")


def picture(folder, entry):
    """The smaller of both files, within the page."""
    if not entry["picture"]:
        return ""
    files = [(folder / f"{entry['picture']}.{kind}", mime) for kind, mime in (("svg", "image/svg+xml"), ("png", "image/png"))]
    path, mime = min(((path, mime) for path, mime in files), key=lambda file: file[0].stat().st_size)
    data = base64.b64encode(path.read_bytes()).decode()
    return (f'<figure><img decoding="async" alt="{escaped(entry["shows"])}" src="data:{mime};base64,{data}">'
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
            agrees = f'<span class="{row["agrees"]}">{row["agrees"]}</span>'
        body += f'<tr><th scope="row">{escaped(row["what"])}</th><td>{ours}</td>'
        body += f"<td>{stated}</td><td>{agrees}</td></tr>" if any_stated else "</tr>"
    beside = '<th scope="col">stated</th><th scope="col">agrees</th>' if any_stated else ""
    return (f'<table><thead><tr><th scope="col">number</th><th scope="col">ours</th>{beside}</tr></thead>'
            f"<tbody>{body}</tbody></table>")


def article(folder, entry, rows):
    page = f' <span class="page">p. {entry["page"]}</span>' if entry["page"] else ""
    tone = "yes" if entry["status"].startswith("reproduced") else "no" if entry["status"] == "differs" else ""
    return (f'<article id="{anchor(entry)}"><h3>{name_of(entry)}: {escaped(entry["caption"])}{page}</h3>'
            f'<div class="status {tone}">{escaped(entry["status"])}</div>'
            f'<p>{escaped(entry["text"])}</p>{picture(folder, entry)}{numbers_table(rows)}</article>')


def chapter_of(entry):
    return entry["id"].removeprefix("table ").split(".")[0]


def write_page(folder, entries, numbers, run):
    own = {}
    for row in numbers:
        own.setdefault(row["id"], []).append(row)
    statuses = {}
    for entry in entries:
        statuses[entry["status"]] = statuses.get(entry["status"], 0) + 1
    stated = [row for row in numbers if row["stated"]]
    differing = [row for row in stated if row["agrees"] == "no"]
    counts = "".join(f"<li>{count} {escaped(status)}</li>" for status, count in sorted(statuses.items(), key=lambda item: -item[1]))
    differ = "".join(f'<li><a href="#{row["id"].replace(" ", "-")}">{escaped(row["id"])}</a>: {escaped(row["what"])}: '
                     f'{number(row["ours"])} {escaped(row["unit"])}, stated {number(row["stated"])} [{row["label"]}]</li>'
                     for row in differing)
    labels = "".join(f"<li><b>[{label}]</b> {text}</li>" for label, text in LABELS.items())
    sections, index = "", ""
    for chapter, title in CHAPTERS:
        members = [entry for entry in entries if chapter_of(entry) == chapter]
        index += f'<h3>{title}</h3><ul class="index">' + "".join(
            f'<li><a href="#{anchor(entry)}">{name_of(entry)}</a>: {escaped(entry["status"])}</li>' for entry in members) + "</ul>"
        sections += f'<section><h2 id="chapter-{chapter}">{title}</h2>' + "".join(
            article(folder, entry, own.get(entry["id"], [])) for entry in members) + "</section>"
    text = f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>The figures of a 2008 thesis, as numbers</title><style>{STYLE}</style></head><body>
<header><h1>The figures of a 2008 thesis, as numbers</h1>
<p>H. Arshad, <cite>A Collision Detection Algorithm for Virtual Robot-Centered Flexible Manufacturing Cell</cite>, PhD thesis,
Universiti Putra Malaysia, 2008. Its front matter, with every caption, is public; its chapters from page 8 on are not. Captions are
cited from its lists of figures and tables; pictures and numbers are computed by <code>touchstone thesis</code>, none is copied.</p>
<div class="summary"><p>{len(entries)} figures and tables, {len(entries) - sum(chapter_of(e) == "E" for e in entries)} of the thesis
and {sum(chapter_of(e) == "E" for e in entries)} of known errors of its method:</p><ul>{counts}</ul>
<p>{len(stated) - len(differing)} of {len(stated)} numbers that are stated somewhere come out{"; these do not:" if differing else "."}</p>
{"<ul>" + differ + "</ul>" if differ else ""}
<p>Where a number comes from:</p><ul>{labels}</ul>
<p>Shares of random samples have Clopper-Pearson limits. {run["samples_asked"]:,} balls of each outline and radius, seed
{run["seed"]}; run.json says how to have the same again.</p></div>
<nav aria-label="All figures and tables">{index}</nav></header>
<main>{sections}</main></body></html>
"""
    (folder / "index.html").write_text(text, encoding="utf-8")
