# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: plain_english.py SOURCE
       plain_english.py --self-test

Refuses turns of phrase that readers stumble over, in the prose of pages, the comments and string literals of C++, the
string literals and templates of the report, the paper, and the two commands. Names file and line, and what to write instead.
Exit status 1 if it finds one.
"""

import contextlib
import io
import pathlib
import re
import sys
import tempfile

# Pattern, what to write instead, an example that the pattern must find.
BANNED = [
    (r"(?<!there )\b(?:is|are|was|were) no (?!longer\b|more\b|less\b|\w+er\b)", '"is not a ...", "is not ..."', "This is no ball."),
    (r"(?<!there )\b(?:is|are) none\b", '"is not one", "does not exist", "is invalid"', "A polygon that is none is refused."),
    (r"\bso many\b", "the number, or the name of the count", "Of so many samples one is drawn."),
    (r"\bgo(?:es)? on\b", '"continues"', "It goes on where it stopped."),
    (r"\b(?:comes?|came) out\b", '"results", "is written", "yields"', "The same bytes come out."),
    (r"\bwhoever\b", "the actor: the caller, the user", "Whoever calls sees to it."),
    (r"\b(?:of others|another's)\b", '"third-party", "other ..."', "Engines of others are slower."),
    (r"\b(?:is|are) asked of\b", "the actor and what it does", "Nothing is asked of anybody."),
    (r"\bof choice\b", '"optional"', "The key is of choice."),
    (r"\banew\b", '"again"', "The run begins anew."),
    (r"(?<!one )\bat a time\b", "what is repeated, and how often", "It takes two at a time."),
    (r"\bstands? twice\b|\b(?:is|are) there twice\b", '"duplicate ..."', "The id stands twice."),
    (r"\bpass(?:es|ed)? over\b(?! the contact)|\bpass \w+ over\b", '"skips", "ignores"', "Boxes pass over far faces."),
    (r"\b(?:tells?|told) of\b", '"reports", "detects", "notices"', "No case told of the bug."),
    (r"\bh(?:e|o)ld against\b", '"compared with"', "The answers are held against it."),
    (r"\bleads? nowhere\b", "the requirement", "A step of 0 leads nowhere."),
    (r"\bbut for\b", '"except"', "All but for the first are kept."),
    (r", be it\b", '"even if"', "A shared point, be it only a vertex."),
    (r"(?:^|(?<=[.;:] ))nor\b", "the usual order of words", "Nor were others wrong."),
    (r"(?:^|(?<=[.;:] ))of the (?:last|first|former|latter)\b", "the usual order of words", "Of the last alone bounds are proved."),
    (r"^(?:What|Of) (?#docstring)", "a verb for a function, a noun phrase for a type", "/// What a way came to nothing by."),
]

ONLY_IN_DOCSTRINGS = "(?#docstring)"
FENCE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`[^`\n]+`")
PARAGRAPH = re.compile(r"^[^\n]*\S[^\n]*(?:\n(?! *(?:[-*>|#]|\d+\.) )[^\n]*\S[^\n]*)*", re.MULTILINE)
MARKER = re.compile(r"^ *(?:[-*>|#]+|\d+\.) ")
COMMENT = re.compile(r"(?:^ *//.*\n)+|(?<=[\s;]) ///?<? .*", re.MULTILINE)
TOKEN = re.compile(r"""^\s*\#include[^\n]*|//[^\n]*|/\*.*?\*/|(?<!\w)'(?:[^'\\]|\\.)+'"""
                   r"""|(?P<texts>(?:R"(\w*)\(.*?\)\2"|"(?:[^"\\\n]|\\.)*"|\s+(?="))+)""", re.MULTILINE | re.DOTALL)
ESCAPE = re.compile(r'R"\w*\(|\\.|"')
PYTHON = re.compile(r"""\#[^\n]*|(?P<texts>(?:[rbf]*(?P<quote>\"{3}|'{3}|"|')(?:\\.|(?!(?P=quote)).)*?(?P=quote)\s*)+)""",
                    re.DOTALL | re.IGNORECASE)
VALUE = re.compile(r"\{[^{}]*\}")  # of an f-string
MARKUP = re.compile(r"\{#.*?#\}|\{%.*?%\}|<[^>]*>", re.DOTALL)
QUOTE = re.compile(r"""(?:\b[rbf]+)?(?:\"{3}|'{3}|"|(?<!\w)'|'(?!\w))|\\.""", re.IGNORECASE)


def blank(match):
    """As many characters, so that places stay."""
    return re.sub(r"[^\n]", " ", match[0])


def page_texts(text):
    """Paragraphs, list items and lines of tables."""
    text = CODE.sub(lambda match: "X" * len(match[0]), FENCE.sub(blank, text))
    for match in PARAGRAPH.finditer(text):
        yield match.start(), MARKER.sub(blank, match[0]), False


def comments(text, is_header):
    """Comments; those of headers with three slashes are docstrings."""
    for match in COMMENT.finditer(text):
        yield match.start(), re.sub(r"^ *///?<?", blank, match[0], flags=re.MULTILINE), is_header and match[0].lstrip().startswith("///")


def literals(text):
    """String literals; adjacent ones are one text."""
    for match in TOKEN.finditer(text):
        if match["texts"] and match["texts"].strip():
            yield match.start(), ESCAPE.sub(blank, match[0]), False


def python_texts(text):
    """String literals; adjacent ones are one text, and the values of f-strings are words."""
    for match in PYTHON.finditer(text):
        if match["texts"]:
            yield match.start(), QUOTE.sub(blank, VALUE.sub(lambda value: "X" * len(value[0]), match[0])), False


def template_texts(text):
    """Paragraphs of HTML; its tags and the statements of templates are blank, and the values in it are words."""
    return page_texts(MARKUP.sub(blank, re.sub(r"\{\{.*?\}\}", lambda match: re.sub(r"[^\n]", "X", match[0]), text, flags=re.DOTALL)))


def texts_of(name, text):
    """The place and words of each text, and whether it is a docstring."""
    if name.endswith(".py"):
        return python_texts(text)
    if name.endswith(".html"):
        return template_texts(text)
    if name.endswith((".h", ".cpp")):
        return [*comments(text, name.endswith(".h")), *literals(text)]
    return page_texts(text)


def squeezed(words):
    """The words between single spaces, and the place of each character."""
    places = [match.start() for match in re.finditer(r"\S|(?<=\S)\s(?=\s*\S)", words)]
    return re.sub(r"\s", " ", "".join(words[place] for place in places)), places


def faults_of(name, text):
    """The line and the fault of each phrase that is found."""
    found = []
    for begin, words, is_docstring in texts_of(name, text):
        line_of_words, places = squeezed(words)
        for pattern, instead, _ in BANNED:
            if ONLY_IN_DOCSTRINGS in pattern and not is_docstring:
                continue
            for match in re.finditer(pattern, line_of_words, 0 if ONLY_IN_DOCSTRINGS in pattern else re.IGNORECASE):
                line = text.count("\n", 0, begin + places[match.start()]) + 1
                found.append((line, f'{name}:{line}: "{match[0].strip()}": write {instead}'))
    return sorted(found)


def files(root):
    """What is searched at all: pages, the paper, C++, the report and the two commands."""
    found = [*root.glob("*.md"), root / "check", root / "reproduce", *(root / "experiments/report").rglob("*.py"),
             *(root / "experiments/report/templates").glob("*.html")]
    for folder in ("bindings", "docs", "experiments", "geometry", "papers", "robust", "tests"):
        found += [file for file in (root / folder).rglob("*") if file.suffix in (".md", ".tex", ".h", ".cpp")]
    return sorted(found)


def main(root):
    root, faults, searched = pathlib.Path(root), [], 0
    for file in files(root):
        searched += 1
        faults += [fault for _, fault in faults_of(file.relative_to(root).as_posix(), file.read_text())]
    print("\n".join([*faults, f"{searched} files, {len(faults)} faults"]))
    return 1 if faults or not searched else 0


def self_test():
    """Every pattern finds its example in each kind of text, on the right line, and good text passes."""
    faults = []

    def expect(name, text, line):
        found = sorted({place for place, _ in faults_of(name, text)})
        if found != ([line] if line else []):
            faults.append(f"{name}: found {found}, not {line}:\n{text}")

    for _, _, example in BANNED:
        if example.startswith("///"):
            expect("a.h", f"\nint x;\n{example}\nint f();\n", 3)
            expect("a.h", f"int x;  ///< {example[4:]}\n", 1)
            continue
        middle = example.find(" ", 5)
        broken = example[:middle], example[middle + 1:]
        expect("a.md", f"# Title\n\n```cpp\nFine.\n```\n\nFine. {example}\n", 7)
        expect("a.md", f"- Fine.\n- {example}\n", 2)
        expect("a.h", f"/// Fine.\n/// {example}\nvoid f();\n", 2)
        expect("a.cpp", f'int x = 1;\nthrow Error("{example}");\n', 2)
        expect("a.cpp", f'f(R"(Fine.\n{example} )");\n', 2)
        expect("check", f"echo\n\n{example}\n", 3)
        for name, text in (("a.md", "\n{}\n{}\n"), ("a.h", "\n/// {}\n/// {}\n"), ("a.cpp", '\nf("{} "\n  "{}");\n'),
                           ("a.py", '\nf("{} "\n  f"{}")\n'), ("a.html", "\n<p>{}\n{}</p>\n"), ("a.cpp", "\n// {}\n// {}\n")):
            if not list(faults_of(name, text.format(*broken))):
                faults.append(f"{name}: not found across lines: {example}")
        expect("a.md", f"Fine.\n\n```txt\n{example}\n```\n", 0)
        expect("a.md", f"`{example}`\n", 0)
        expect("a.cpp", f"int x;\n// {example}\n", 2)
        expect("a.cpp", f"int x;  // {example}\n", 1)
        expect("a.py", f"x = 1  # \"\ny = f\"{{x}}: \"\ny += f'''{{x}} is fine.\n{example}'''\n", 4)
        expect("a.py", f"# {example}\n", 0)
        expect("a.html", f"<p>Fine.</p>\n{{# {example} #}}\n<p>{{{{ value }}}} is fine. {example}</p>\n", 3)
        expect("a.cpp", f'f(\'"\', "//", 1\'000, "{example}");  // "\n', 1)
    for good in ("There is no tolerance.", "It is no longer than that.", "What is proved", "One at a time.", "The number of the last is 3."):
        expect("a.md", good + "\n", 0)
    expect("a.cpp", '#include "so many.h"\n', 0)
    with tempfile.TemporaryDirectory() as folder:  # and the search of a tree fails
        for name in ("check", "reproduce", "README.md", "docs/page.md"):
            path = pathlib.Path(folder, name)
            path.parent.mkdir(exist_ok=True)
            path.write_text("Whoever reads this.\n" if name == "docs/page.md" else "Fine.\n")
        with contextlib.redirect_stdout(io.StringIO()) as said:
            status = main(folder)
        if status != 1 or 'docs/page.md:1: "Whoever": write' not in said.getvalue():
            faults.append("a tree with a banned phrase passes")
    print("\n".join(faults) or f"{len(BANNED)} patterns")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else main(*sys.argv[1:]))
