# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers, words and pictures of all pages, which templates/ make of them. A page is one file that loads nothing. It adapts
to light and dark, narrow screens and print. The same data give the same bytes."""
import base64
import html
import math
import pathlib
import re

import jinja2

import dark
from results import DataError
from shares import unless_whole, upper_limit

PIXELS_AN_INCH = 150  # of the pictures in PNG: style.py


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


def image(path, alt, scale=False):
    """`alt` is text. With `scale`, colours go from none to all, and are inverted as a whole on dark pages."""
    width, height = size_of(path)
    drawn = f'width="{width}" height="{height}" alt="{escaped(alt)}" src="{inlined(path)}">'
    if scale:
        return f'<img class="scale" {drawn}'
    return f'<picture><source media="(prefers-color-scheme: dark)" srcset="{inlined(path, dark.picture(path))}"><img {drawn}</picture>'


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


# What templates call: these functions, and the macros of parts.html. Cells, captions and words are HTML.
TEMPLATES = jinja2.Environment(loader=jinja2.FileSystemLoader(pathlib.Path(__file__).with_name("templates")), undefined=jinja2.StrictUndefined,
                               trim_blocks=True, lstrip_blocks=True)
TEMPLATES.globals |= {function.__name__: function for function in (
    escaped, number, count, counted, rounded, percent, multiple, power, share_of_size, upper_limit, words, code, image, bar)}
TEMPLATES.filters["code"] = code
TEMPLATES.globals |= {name: getattr(TEMPLATES.get_template("parts.html").module, name) for name in ("table", "picture", "folded", "drawing")}


def rendered(template, **values):
    """The HTML of a template of templates/."""
    return TEMPLATES.get_template(template).render(values)
