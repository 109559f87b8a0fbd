# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: python_reference.py ROOT MODULES

The reference of the Python module has a heading for each public name of the module, a text under each heading, and one
under each signature. A constructor's text is that of its class."""

import re
import subprocess
import sys

root, modules = sys.argv[1:]
sys.path.insert(0, modules)
import touchstone_contact  # noqa: E402

page = subprocess.run([sys.executable, "-B", f"{root}/docs/python_reference.py", modules], check=True,
                      stdout=subprocess.PIPE, text=True).stdout
headings = {name for heading in re.findall(r"^## (.+)$", page, re.MULTILINE) for name in heading.split(", ")}
faults = [f"{name}: has no heading" for name in touchstone_contact.__all__ if name not in headings | {"__version__"}]
sections = re.split(r"^## (.+)$", page, flags=re.MULTILINE)[1:]
for heading, section in zip(sections[::2], sections[1::2]):
    if not section.strip():
        faults.append(f"{heading}: has no text")
    blocks = re.split(r"^```python\n(.+?)^```$", section, flags=re.MULTILINE | re.DOTALL)[1:]
    for signature, text in zip(blocks[::2], blocks[1::2]):
        if not signature.startswith(f"{heading}(") and (not text.strip() or text.strip().startswith("- `")):
            faults.append(f"{signature.strip()}: has no text")
print("\n".join([*faults, f"{len(headings)} names, {len(faults)} faults"]))
sys.exit(bool(faults) or len(headings) < 10)
