# SPDX-License-Identifier: Apache-2.0
"""All claims that Gappa proves, one for each arithmetic that it is made for, as statements."""

import dataclasses
import fractions
import re

import double_words
import permanents
import prove
import quotients
import signs
import statement
import uses


@dataclasses.dataclass
class Claim:
    constant: str  # in bounds.h
    instance: str  # distinguishes claims about the same constant
    arithmetic: str
    proved: str  # the constant that is proved, and its unit
    unit: fractions.Fraction  # the smallest that occurs
    says: statement.Statement
    sign: str = ""  # a theorem that follows from it

    @property
    def name(self):
        return " ".join(filter(None, (self.constant, self.instance, "in", self.arithmetic)))

    @property
    def file_name(self):
        return re.sub(r"\W+", "_", self.name.replace("/", "quotient").replace("-", "_"))


def of_record(model, record):
    """The claims of one record."""
    constant, instance = record["constant"], record["instance"]
    if "nodes" in record:
        value, unit = prove.claimed_of(model, record), model[uses.UNITS[record["arithmetic"]]]
        arithmetic = f"fused {record['arithmetic']}" if prove.is_fused(record) else record["arithmetic"]
        yield Claim(constant, instance, arithmetic, f"{float(value)} units", unit, signs.claim(record, unit, value),
                    permanents.theorem(record, unit) if "monomials" in record else "")
    elif "words" in record:
        says = double_words.claim(record, record["proved"])
        yield Claim(constant, instance, "double-doubles", f"{record['proved']} u^2", double_words.UNIT, says)
    else:
        says = quotients.claim(record, record["proved"])
        yield Claim(constant, instance, "double-doubles", f"{record['proved']} u^2", quotients.UNIT**2, says)


def of_records(model, records):
    return [claim for record in records for claim in of_record(model, record)]
