# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact numbers a + b sqrt(d) with rational a, b and d >= 0, and their order."""
import math
from fractions import Fraction


class Surd:
    """a + b sqrt(d). Two surds in one sum or product must have the same d, unless one of them is rational."""

    def __init__(self, a, b=0, d=0):
        self.a, self.b, self.d = Fraction(a), Fraction(b), Fraction(d)
        root = rational_root(self.d)
        if root is not None:
            self.a, self.b, self.d = self.a + self.b * root, Fraction(0), Fraction(0)
        if self.b == 0:
            self.d = Fraction(0)

    def field(self, other):
        """The other number as a surd, and the d of both."""
        other = other if isinstance(other, Surd) else Surd(other)
        assert not self.b or not other.b or self.d == other.d, "roots of different numbers"
        return other, self.d or other.d

    def __add__(self, other):
        other, d = self.field(other)
        return Surd(self.a + other.a, self.b + other.b, d)

    def __mul__(self, other):
        other, d = self.field(other)
        return Surd(self.a * other.a + self.b * other.b * d, self.a * other.b + self.b * other.a, d)

    def __neg__(self):
        return Surd(-self.a, -self.b, self.d)

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other

    def __truediv__(self, number):
        """By a rational number."""
        return Surd(self.a / number, self.b / number, self.d)

    def __pow__(self, exponent):
        assert exponent == 2
        return self * self

    __radd__, __rmul__ = __add__, __mul__

    def __eq__(self, other):
        return compare(self, other) == 0

    def __lt__(self, other):
        return compare(self, other) < 0

    def __le__(self, other):
        return compare(self, other) <= 0

    def __gt__(self, other):
        return compare(self, other) > 0

    def __ge__(self, other):
        return compare(self, other) >= 0

    def bounds(self, bits):
        """Rational numbers below and above, at most 2^-bits |b| apart."""
        n, m = self.d.numerator, self.d.denominator  # sqrt(n / m) = sqrt(n m) / m
        root = math.isqrt(n * m << 2 * bits)
        ends = [self.a + self.b * Fraction(root + k, m << bits) for k in (0, 1)]
        return min(ends), max(ends)


def rational_root(d):
    """The square root of a rational number, if it is rational."""
    n, m = math.isqrt(d.numerator), math.isqrt(d.denominator)
    return Fraction(n, m) if n * n == d.numerator and m * m == d.denominator else None


def sign(x):
    return (x > 0) - (x < 0)


def sign_of_sum(a, b, d):
    """The sign of a + b sqrt(d)."""
    if sign(a) * sign(b) >= 0 or d == 0:
        return sign(a) or sign(b) * (d != 0)
    return sign(a) * sign(a * a - b * b * d)


def compare(x, y):
    """-1, 0 or 1. Of x - y = a + b sqrt(d) + c sqrt(e), the roots' sum has the square b b d + c c e + 2 b c sqrt(d e)."""
    x, y = (z if isinstance(z, Surd) else Surd(z) for z in (x, y))
    a, b, d, c, e = x.a - y.a, x.b, x.d, -y.b, y.d
    if b == 0 or c == 0 or d == e:
        return sign_of_sum(a, b + c, d or e)
    roots = sign(b) if sign(b) == sign(c) else sign(b) * sign(b * b * d - c * c * e)
    if sign(a) * roots >= 0:
        return sign(a) or roots
    return sign(a) * sign_of_sum(a * a - b * b * d - c * c * e, -2 * b * c, d * e)


def between(x, y):
    """A rational number strictly between x < y."""
    bits = 8
    while True:
        low, high = x.bounds(bits)[1], y.bounds(bits)[0]
        if low < high:
            return (low + high) / 2
        bits *= 2


def nearest_double(x):
    """The double nearest to a number, ties to even, never -0; None beyond the finite doubles."""
    def rounded(value):
        try:
            return value.numerator / value.denominator + 0.0  # int / int is correctly rounded in Python
        except OverflowError:
            return None

    if not isinstance(x, Surd) or x.b == 0:
        return rounded(x.a if isinstance(x, Surd) else x)
    bits = 64
    while True:  # an irrational number is no tie
        low, high = map(rounded, x.bounds(bits))
        if low == high:
            return low
        bits *= 2
