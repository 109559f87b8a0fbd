# SPDX-License-Identifier: Apache-2.0
"""The error-free transformations that a recorder prints, and the theory in which Coq finds each exact: from the theorem of
coq/error_free.v about the same operations in the same order."""

import prove

# What both words add up to, and what is required besides doubles that nothing overflows from.
EXACT = {"two_sum": "a + b", "two_difference": "a - b", "quick_two_sum": "a + b", "two_product": "a * b"}
REQUIRED = {"quick_two_sum": "a = 0 \\/ Rabs b <= Rabs a", "two_product": "large (a * b)"}
OPERATIONS = {"+": "{} + {}", "-": "{} - {}", "*": "{} * {}", "fused -": "{} * {} - {}"}


class Transformation:
    """A recorded transformation, for each target that compiles it so."""

    def __init__(self, record, targets):
        self.record, self.name, self.targets = record, record["transformation"], targets
        self.is_fused = prove.is_fused(record)
        self.file_name = f"error_free_{self.name}{'_fused' if self.is_fused else ''}"

    def theory(self):
        lines, required = [], REQUIRED.get(self.name)
        term = {node["node"]: self.term(node) for node in self.record["nodes"]}
        for node in self.record["nodes"]:
            if "operation" in node:
                of = OPERATIONS[node["operation"]].format(*(term[operand] for operand in node["of"]))
                lines.append(f"  let {term[node['node']]} := rnd ({of}) in")
        high, low = (term[self.record[word]] for word in ("high", "low"))
        theorem = "fused_product" if self.is_fused else self.name
        return "\n".join([
            "Require Import Reals Touchstone.error_free.", "Open Scope R_scope.", "",
            f"Theorem proved a b : format a -> format b -> {f'{required} -> ' if required else ''}", *lines,
            f"  {high} + {low} = {EXACT[self.name]}.", f"Proof. exact ({theorem} a b). Qed.", "", "Print Assumptions proved.", ""])

    @staticmethod
    def term(node):
        if "input" in node:
            return node["input"]
        return str(node["constant"]) if "constant" in node else f"c{node['node']}"


def transformations(records):
    """Each once, whatever the targets are."""
    found = {}
    for record in records:
        if "transformation" in record:
            key = repr((record["transformation"], record["nodes"]))
            found.setdefault(key, (record, []))[1].append(record["target"])
    return [Transformation(*each) for each in found.values()]
