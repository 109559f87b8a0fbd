# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures for dark pages. White and black change places; colours that stand for methods stay what they are, so that a method
looks the same on a light page and on a dark one."""
import io
import re

PAPER, INK = (22, 24, 26), (232, 232, 228)  # of the dark style in page.py


def colour(red, green, blue):
    """A colour of a light page, from 0 to 255 each, as the dark page has it: the less saturated, the more it is inverted."""
    shares = red / 255, green / 255, blue / 255
    high, low = max(shares), min(shares)
    saturation = (high - low) / high if high else 0
    return tuple(round(saturation * 255 * share + (1 - saturation) * (low * paper + 255 * (share - low) + (1 - high) * ink))
                 for share, paper, ink in zip(shares, PAPER, INK))


def svg(text):
    """Text without a colour of its own is black on light pages."""
    def changed(match):
        return "#" + "".join(f"{part:02x}" for part in colour(*bytes.fromhex(match[1])))

    return re.sub(r"#([0-9a-fA-F]{6})\b", changed, text).replace("<svg ", f'<svg fill="#{bytes(INK).hex()}" ', 1)


def png(data):
    import matplotlib.image  # only where there is such a picture
    import numpy as np

    pixels = np.round(255 * matplotlib.image.imread(io.BytesIO(data), format="png")).astype(np.uint8)
    shares = pixels[..., :3] / 255  # as in `colour`
    high, low = shares.max(axis=2, keepdims=True), shares.min(axis=2, keepdims=True)
    saturation = (high - low) / np.maximum(high, 1 / 255)
    inverted = low * np.array(PAPER) + 255 * (shares - low) + (1 - high) * np.array(INK)
    pixels[..., :3] = np.round(saturation * 255 * shares + (1 - saturation) * inverted).astype(np.uint8)
    file = io.BytesIO()
    matplotlib.image.imsave(file, pixels, format="png", metadata={"Software": None})
    return file.getvalue()


def picture(path):
    """The bytes of a picture of ours, for dark pages."""
    return png(path.read_bytes()) if path.suffix == ".png" else svg(path.read_text(encoding="utf-8")).encode()
