# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: python_reference.py MODULES > PAGE

Prints the reference of the Python module, which lies in the folder MODULES: the signatures of its stubs, each with the
docstring of the module, in the order of the stubs. Modules that have the same functions are described once."""

import ast
import importlib
import inspect
import pathlib
import re
import sys
from itertools import groupby

NAME = "touchstone_contact"
# What pybind11 puts before a docstring, and before each one of an overloaded function.
SIGNATURE = re.compile(r"^(?:\d+\. )?\w+\(.*\) -> .*$|^Overloaded function\.$", re.MULTILINE)


def text_of(thing):
    """The docstring without signatures, unless it is that of every object."""
    text = thing.__doc__ if inspect.isclass(thing) else inspect.getdoc(thing)
    text = re.sub(r"\n{3,}", "\n\n", SIGNATURE.sub("", inspect.cleandoc(text or ""))).strip()
    return "" if thing.__doc__ == object.__init__.__doc__ else text


def is_public(name):
    return not name.startswith("_") or name == "__init__"


def signature(node):
    """A function as the stubs declare it, without `self`."""
    node.args.args = [argument for argument in node.args.args if argument.arg != "self"]
    name = "" if node.name == "__init__" else node.name
    returns = f" -> {ast.unparse(node.returns)}" if node.returns and name else ""
    return f"{name}({ast.unparse(node.args)}){returns}"


def decorations(node):
    return {ast.unparse(decoration) for decoration in node.decorator_list}


def members(node, thing, name, classes):
    """The lines about a class: its constructors and functions with their texts, and its properties."""
    methods, properties = {}, []
    bases = [classes[ast.unparse(base)] for base in node.bases if ast.unparse(base) in classes]
    for member in [*(member for base in bases for member in base.body), *node.body]:
        if isinstance(member, ast.AnnAssign):
            properties.append((member.target.id, ast.unparse(member.annotation), ""))
        if not isinstance(member, ast.FunctionDef) or not is_public(member.name):
            continue
        if "property" in decorations(member):
            properties.append((member.name, ast.unparse(member.returns), text_of(getattr(thing, member.name, None))))
        else:
            methods.setdefault(member.name, []).append(signature(member))
    for method, signatures in methods.items():
        yield from ["```python", *(f"{name}.{one}".replace(".(", "(") for one in signatures), "```", ""]
        yield from [text_of(getattr(thing, method, None)), ""]
    for property_name, kind, text in properties:
        yield f"- `{property_name}`: `{kind}`{'. ' + ' '.join(text.split()) if text else ''}"
    yield ""


def elsewhere(module, declared):
    """The functions of the module that its stubs import."""
    names = {node.name for node in declared if isinstance(node, ast.FunctionDef)}
    for name in module.__all__:
        if inspect.isfunction(thing := getattr(module, name)) and name not in names:
            declared_as = re.sub(r"(: |-> )'([^']*)'", r"\1\2", f"{name}{inspect.signature(thing)}")
            yield from [f"## {name}", "", "```python", declared_as, "```", "", text_of(thing), ""]


def page(module, stubs):
    yield from ["# Reference of the Python module", "", text_of(module), ""]
    declared = ast.parse(stubs).body
    classes = {node.name: node for node in declared if isinstance(node, ast.ClassDef)}
    values = [node for node in declared if isinstance(node, ast.AnnAssign) and ast.unparse(node.annotation) in classes]
    for node in declared:
        if isinstance(node, ast.FunctionDef) and is_public(node.name):
            yield from [f"## {node.name}", "", "```python", signature(node), "```", "", text_of(getattr(module, node.name)), ""]
        if isinstance(node, ast.ClassDef) and is_public(node.name):
            thing = getattr(module, node.name, None)  # a TypedDict is of the stubs alone
            yield from [f"## {node.name}", "", text_of(thing) if thing else ast.get_docstring(node) or "", ""]
            yield from members(node, thing, node.name, classes)
    yield from elsewhere(module, declared)
    for protocol, names in groupby(values, lambda node: ast.unparse(node.annotation)):  # filtered: _Path
        names = [node.target.id for node in names]
        yield from [f"## {', '.join(names)}", "", *(f"- `{name}`: {text_of(getattr(module, name))}" for name in names), ""]
        yield from members(classes[protocol], getattr(module, names[0]), names[0], classes)


def main():
    modules = pathlib.Path(sys.argv[1])
    sys.path.insert(0, str(modules))
    module = importlib.import_module(NAME)
    lines = "\n".join(page(module, (modules / NAME / "__init__.pyi").read_text()))
    print(re.sub(r"\n{3,}", "\n\n", lines).strip())


main()
