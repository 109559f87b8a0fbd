# SPDX-License-Identifier: GPL-3.0-or-later
"""The style and the parts of all pages. A page is one file that loads nothing. It adapts to light and dark, narrow screens
and print. The same data give the same bytes."""
import base64
import html
import math
import re

import dark
from results import DataError
from shares import unless_whole

PIXELS_AN_INCH = 150  # of the pictures in PNG: style.py

STYLE = """
:root { color-scheme: light dark; --ink: #1c1c1c; --paper: #ffffff; --soft: #f2f2ef; --line: #d0d0c8; --dim: #595959;
        --good: #00634a; --bad: #a33b00; --link: #00558a; --bar: #eab68f; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e8e8e4; --paper: #16181a; --soft: #222528; --line: #43474b; --dim: #adb1b4; --good: #5fd0a8; --bad: #ff9d66;
          --link: #7cc4f2; --bar: #7a4520; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem; max-width: 60rem; font: 1rem/1.5 system-ui, sans-serif; color: var(--ink);
       background: var(--paper); overflow-wrap: break-word; }
h1 { line-height: 1.2; } h2 { margin-top: 3rem; border-bottom: 2px solid var(--line); line-height: 1.3; } h3 { line-height: 1.3; }
a { color: var(--link); }
figure { margin: 1rem 0; } figcaption { margin: .3rem auto .5rem; }
figcaption, .dim { color: var(--dim); font-size: .88rem; } small { color: var(--dim); font-size: .9em; }
img { display: block; max-width: 100%; height: auto; margin: 0 auto; background: #fff; border-radius: .3rem; }
.yes { color: var(--good); } .no { color: var(--bad); }
table { border-collapse: collapse; font-size: .9rem; }
th, td { text-align: left; vertical-align: top; padding: .25rem .6rem .25rem 0; border-top: 1px solid var(--line); }
thead th { border-top: 0; color: var(--dim); font-weight: 600; vertical-align: bottom; }
tbody th { font-weight: 400; }
thead th:first-child, tbody th { position: sticky; left: 0; background: var(--paper); z-index: 1; }
details { margin: 1rem 0; } summary { cursor: pointer; color: var(--link); }
svg text { fill: currentColor; stroke: none; }
@media (prefers-color-scheme: dark) { picture img { background: none; } img.scale { filter: invert(.91) hue-rotate(180deg); } article img { filter: brightness(.85); } }
.scroll { overflow-x: auto; background: linear-gradient(to right, var(--paper) 30%, transparent) 0 / 2rem 100% no-repeat local, linear-gradient(to left, var(--paper) 30%,
          transparent) 100% / 2rem 100% no-repeat local, linear-gradient(to right, var(--line), transparent) 0 / .7rem 100% no-repeat, linear-gradient(to left, var(--line),
          transparent) 100% / .7rem 100% no-repeat; }
@media (max-width: 40rem) { .picture .scroll::before, .scroll:has(> svg.scheme)::before { content: "scrolls sideways →"; position: sticky; left: 0; font-size: .8rem;
                            color: var(--dim); } } .scroll:focus-visible { outline: 2px solid var(--link); }
:target { outline: 3px solid var(--link); }
@media (max-width: 34rem) { body { padding: .6rem; } }
@media print { :root { --ink: #000; --paper: #fff; --soft: #fff; --line: #bbb; --dim: #444; --good: #00634a; --bad: #a33b00;
                       --link: #000; --bar: #eab68f; color-scheme: light; }
  body { max-width: none; padding: 0; font-size: 9.5pt; } tr, figure { break-inside: avoid; }
  h2, h3 { break-after: avoid; } nav { display: none; } .scroll { overflow: visible; } }
"""


def escaped(text):
    return html.escape(str(text), quote=True)


def number(text, digits=6):
    """HTML of a number; "none" of one that is not a number."""
    value = float(text)
    if value != value:
        return "none"
    shown = f"{value:.{digits}g}"
    if "e" in shown:
        mantissa, exponent = shown.split("e")
        shown = f"{float(mantissa):.4g} × 10<sup>{int(exponent)}</sup>"
    return shown.replace("-", "−")


def count(value):
    return f"{value:,}"


def rounded(value, digits=2):
    """The number with `digits` significant digits, without an exponent; whole numbers with commas."""
    if value == 0:
        return "0"
    value = float(f"{value:.{digits - 1}e}")
    places = max(0, digits - 1 - math.floor(math.log10(abs(value))))
    return f"{value:,.{places}f}".replace("-", "−")


def percent_number(share, digits=2):
    return unless_whole(share, rounded(100 * share, digits))


def percent(share, digits=2):
    return escaped(percent_number(share, digits)) + "\u00a0%"  # on one line


def multiple(ratio, digits=2):
    """A factor, as 3.5 ×."""
    return f"{rounded(ratio, digits)}\u00a0×"


def power(base, exponent):
    """A power as plain text, which alternative texts need: 2⁻³³."""
    return base + str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def share_of_size(share):
    """The least power of two that is not less than the share, up to the whole size."""
    exponent = math.ceil(math.log2(share))
    return power("2", exponent) if exponent < 0 else "1"


def level(text):
    """A level of stress from its name in the data: 1e4 as 10⁴, 2^20 as 2²⁰."""
    parts = re.fullmatch(r"(?:1e|(2)\^)(-?\d+)", text)
    return power(parts[1] or "10", parts[2]) if parts else escaped(text).replace("-", "−")


def upper_limit(trials):
    """The one-sided 95 % limit of a probability after `trials` independent trials without a failure (Clopper and Pearson)."""
    return 1 - 0.05 ** (1 / trials)


def counted(number, plural, singular=None):
    """1 mesh, 2 meshes; the singular is the plural without its last letter, if it is not given."""
    return f"{count(number)} {(singular or plural[:-1]) if number == 1 else plural}"


def words(parts, last="and"):
    """A list in a sentence: a, b and c."""
    parts = list(parts)
    return parts[0] if len(parts) == 1 else ", ".join(parts[:-1]) + f" {last} " + parts[-1] if parts else ""


def code(text):
    return f"<code>{escaped(text)}</code>"


def inlined(path, data=None):
    """A picture as an address that holds it, or other `data` of its kind."""
    kind = {".svg": "image/svg+xml", ".png": "image/png"}[path.suffix]
    return f"data:{kind};base64,{base64.b64encode(path.read_bytes() if data is None else data).decode()}"


def smaller(folder, stem):
    """Of STEM.svg and STEM.png, the smaller file; None where there is neither."""
    files = [path for path in (folder / f"{stem}.svg", folder / f"{stem}.png") if path.is_file()]
    return min(files, key=lambda path: path.stat().st_size, default=None)


def size_of(path):
    """Of a picture of ours, as it is meant to be seen: CSS pixels, 96 an inch."""
    if path.suffix == ".png":
        head = path.read_bytes()[:24]
        if len(head) == 24 and head[1:4] == b"PNG":
            return tuple(round(int.from_bytes(head[place:place + 4], "big") * 96 / PIXELS_AN_INCH) for place in (16, 20))
    else:
        tag = re.search(r"<svg [^>]*>", path.read_text(encoding="utf-8", errors="replace"))
        sides = [re.search(rf' {side}="([\d.]+)pt"', tag[0] if tag else "") for side in ("width", "height")]
        if all(sides):
            return tuple(round(float(side[1]) * 4 / 3) for side in sides)
    raise DataError(f"{path}: is not a picture that the studies drew")


def image(path, alt):
    width, height = size_of(path)
    return (f'<picture><source media="(prefers-color-scheme: dark)" srcset="{inlined(path, dark.picture(path))}">'
            f'<img width="{width}" height="{height}" alt="{escaped(alt)}" src="{inlined(path)}"></picture>')


def picture(path, alt, caption, scale=False):
    """`alt` is text, `caption` HTML. With `scale`, colours go from none to all, and are inverted as a whole on dark pages."""
    if scale:
        width, height = size_of(path)
        drawn = f'<img class="scale" width="{width}" height="{height}" alt="{escaped(alt)}" src="{inlined(path)}">'
    else:
        drawn = image(path, alt)
    return (f'<figure class="picture"><div class="scroll" tabindex="0" role="group" aria-label="A picture; scrolls sideways '
            'where it is wider">'
            f"{drawn}</div><figcaption>{caption}</figcaption></figure>")


def bar(fraction, shown):
    """A number before a bar of so much of the cell."""
    return f'<div class="bar" style="--share: {100 * min(max(fraction, 0), 1):.3g}%">{shown}</div>'


def stacked(shares, colours, names):
    """A bar of parts, whose shares are its title."""
    edges, before = [], 0
    for share, colour in zip(shares, colours):
        edges.append(f"{colour} {100 * before:.4g}% {100 * (before + share):.4g}%")
        before += share
    said = ", ".join(f"{name} {percent_number(share)} %" for name, share in zip(names, shares) if share)
    return f'<div class="stacked" role="img" aria-label="{escaped(said)}" title="{escaped(said)}" style="background: linear-gradient(to right, {", ".join(edges)})"></div>'


def table(caption, head, rows, figures=()):
    """Cells are HTML; the first of each row is its head, the columns in `figures` stand to the right. Scrolls within itself."""
    def right(column):
        return ' class="figure"' if column in figures else ""

    top = "".join(f'<th scope="col"{right(i)}>{cell}</th>' for i, cell in enumerate(head))
    body = "".join("<tr>" + "".join(f"<td{right(i)}>{cell}</td>" if i else f'<th scope="row">{cell}</th>'
                                    for i, cell in enumerate(row)) + "</tr>\n" for row in rows)
    return (f'<figure class="table"><figcaption>{caption}</figcaption><div class="scroll" tabindex="0" role="group" '
            f'aria-label="A table; scrolls sideways where it is '
            f'wider"><table><thead><tr>{top}</tr></thead>\n<tbody>{body}</tbody></table></div></figure>')


def folded(title, body):
    """HTML that a reader opens."""
    return f"<details><summary>{escaped(title)}</summary>{body}</details>"


def document(title, description, style, body):
    """A whole page."""
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="description" content="{escaped(description)}">
<title>{escaped(title)}</title><style>{STYLE}{style}</style></head><body>
{body}</body></html>
"""
