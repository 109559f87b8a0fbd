// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/first_contact/polynomial.h"

#include <algorithm>

namespace touchstone::cell {
namespace {

Polynomial derivative(const Polynomial& p) {
  std::vector<mpz_class> result;
  for (std::size_t i = 1; i < p.coefficients().size(); ++i)
    result.push_back(mpz_class(p.coefficients()[i] * static_cast<unsigned long>(i)));
  return Polynomial(std::move(result));
}

/// Divided by the greatest common divisor of the coefficients.
Polynomial primitive(const Polynomial& p) {
  mpz_class content = 0;
  for (const mpz_class& c : p.coefficients()) content = gcd(content, c);
  if (content <= 1) return p;
  std::vector<mpz_class> result = p.coefficients();
  for (mpz_class& c : result) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), content.get_mpz_t());
  return Polynomial(std::move(result));
}

/// The remainder of a / b times a positive number. Requires b != 0.
Polynomial remainder(const Polynomial& a, const Polynomial& b) {
  std::vector<mpz_class> rest = a.coefficients();
  const std::vector<mpz_class>& divisor = b.coefficients();
  const mpz_class lead = abs(divisor.back());
  const bool negative = divisor.back() < 0;
  while (rest.size() >= divisor.size()) {
    mpz_class factor = negative ? mpz_class(-rest.back()) : rest.back();
    const std::size_t offset = rest.size() - divisor.size();
    for (mpz_class& c : rest) c *= lead;
    for (std::size_t i = 0; i < divisor.size(); ++i) rest[offset + i] -= factor * divisor[i];
    while (!rest.empty() && rest.back() == 0) rest.pop_back();
  }
  return primitive(Polynomial(std::move(rest)));
}

/// a / b times a number other than 0, where b divides a.
Polynomial quotient(const Polynomial& a, const Polynomial& b) {
  std::vector<mpz_class> rest = a.coefficients();
  const std::vector<mpz_class>& divisor = b.coefficients();
  std::vector<mpz_class> result(rest.size() - divisor.size() + 1);
  for (std::size_t at = result.size(); at-- > 0;) {
    const mpz_class factor = rest[at + divisor.size() - 1];
    for (mpz_class& c : rest) c *= divisor.back();
    for (mpz_class& c : result) c *= divisor.back();
    result[at] += factor;
    for (std::size_t i = 0; i < divisor.size(); ++i) rest[at + i] -= factor * divisor[i];
  }
  return primitive(Polynomial(std::move(result)));
}

Dyadic middle(const Dyadic& a, const Dyadic& b) {
  const unsigned shift = std::max(a.shift, b.shift);
  return {mpz_class((a.numerator << (shift - a.shift)) + (b.numerator << (shift - b.shift))), shift + 1};
}

bool equal(const Dyadic& a, const Dyadic& b) { return a.shift == b.shift && a.numerator == b.numerator; }

/// b - a <= 2^-bits?
bool within(const Dyadic& a, const Dyadic& b, unsigned bits) {
  const unsigned shift = std::max(a.shift, b.shift);
  const mpz_class width = (b.numerator << (shift - b.shift)) - (a.numerator << (shift - a.shift));
  return shift >= bits ? width <= mpz_class(mpz_class(1) << (shift - bits)) : width == 0;
}

}  // namespace

Polynomial::Polynomial(std::vector<mpz_class> coefficients) : coefficients_(std::move(coefficients)) {
  while (!coefficients_.empty() && coefficients_.back() == 0) coefficients_.pop_back();
}

int Polynomial::sign_at(const Dyadic& x) const {
  mpz_class value = 0;  // times 2^(shift degree)
  mp_bitcnt_t scale = 0;
  for (std::size_t i = coefficients_.size(); i-- > 0;) {
    value *= x.numerator;
    value += mpz_class(coefficients_[i] << scale);
    scale += x.shift;
  }
  return sgn(value);
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  std::vector<mpz_class> sum(std::max(a.coefficients_.size(), b.coefficients_.size()));
  for (std::size_t i = 0; i < a.coefficients_.size(); ++i) sum[i] += a.coefficients_[i];
  for (std::size_t i = 0; i < b.coefficients_.size(); ++i) sum[i] += b.coefficients_[i];
  return Polynomial(std::move(sum));
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + mpz_class(-1) * b; }

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.zero() || b.zero()) return {};
  std::vector<mpz_class> product(a.coefficients_.size() + b.coefficients_.size() - 1);
  for (std::size_t i = 0; i < a.coefficients_.size(); ++i)
    for (std::size_t j = 0; j < b.coefficients_.size(); ++j) product[i + j] += a.coefficients_[i] * b.coefficients_[j];
  return Polynomial(std::move(product));
}

Polynomial operator*(const mpz_class& a, const Polynomial& b) {
  std::vector<mpz_class> product = b.coefficients_;
  for (mpz_class& c : product) c *= a;
  return Polynomial(std::move(product));
}

Polynomial common_divisor(const Polynomial& a, const Polynomial& b) {
  Polynomial high = primitive(a), low = primitive(b);
  if (high.degree() < low.degree()) std::swap(high, low);
  while (!low.zero()) {
    Polynomial rest = remainder(high, low);
    high = std::move(low);
    low = std::move(rest);
  }
  return high;
}

Sturm::Sturm(const Polynomial& square_free) : chain_{primitive(square_free)} {
  Polynomial next = primitive(derivative(square_free));
  while (!next.zero()) {
    chain_.push_back(next);
    next = mpz_class(-1) * remainder(chain_[chain_.size() - 2], chain_.back());
  }
}

int Sturm::changes(const Dyadic& x) const {
  int changes = 0, last = 0;
  for (const Polynomial& p : chain_) {
    const int sign = p.sign_at(x);
    if (sign != 0 && last != 0 && sign != last) ++changes;
    if (sign != 0) last = sign;
  }
  return changes;
}

void Root::refine(unsigned bits) {
  while (!within(low_, high_, bits)) {
    Dyadic between = middle(low_, high_);
    const int sign = square_free_.sign_at(between);
    if (sign == 0) {
      low_ = high_ = std::move(between);
    } else {
      (sign == sign_above_ ? high_ : low_) = std::move(between);
    }
  }
}

// From the middle m of what holds the root x, |q(x) - q(m)| <= bound |x - m|, where the bound is the sum of
// |i q_i| reach^(i - 1) and no |x| or |m| exceeds reach.
int Root::sign_of(const Polynomial& q) {
  if (q.degree() <= 0) return q.zero() ? 0 : sgn(q.coefficients().front());
  mpz_class reach = (high_.numerator >> high_.shift) + 1, power = 1, bound = 0;
  for (std::size_t i = 1; i < q.coefficients().size(); ++i) {
    bound += mpz_class(abs(q.coefficients()[i]) * static_cast<unsigned long>(i)) * power;
    power *= reach;
  }
  const auto bits_of_bound = static_cast<unsigned>(mpz_sizeinbase(bound.get_mpz_t(), 2));
  for (unsigned bits = 64; bits <= 1024; bits *= 2) {
    refine(bits);
    if (equal(low_, high_)) return q.sign_at(high_);
    // q -+ 2^(bits_of_bound - bits) of one sign: so is q at the root.
    const Dyadic at = middle(low_, high_);
    const auto shifted = [&](int direction) {
      std::vector<mpz_class> scaled = q.coefficients();
      for (mpz_class& c : scaled) c <<= bits;
      scaled.front() += direction * mpz_class(mpz_class(1) << bits_of_bound);
      return Polynomial(std::move(scaled)).sign_at(at);
    };
    const int above = shifted(1), below = shifted(-1);
    if (above == below) return above;
    if (bits == 128) {  // closer than this only where it is a root of both
      const Polynomial common = common_divisor(square_free_, q);
      if (common.degree() > 0 && Sturm(common).roots(low_, high_) > 0) return 0;
    }
  }
  // Not a root of q, and next to one: the last word is that of a width at which q has none.
  const Sturm of_q(quotient(q, common_divisor(q, derivative(q))));
  unsigned bits = 2048;
  while (of_q.roots(low_, high_) > 0) refine(bits), bits *= 2;
  return q.sign_at(high_);
}

std::vector<Root> real_roots(const Polynomial& polynomial, const Dyadic& end) {
  std::vector<Root> roots;
  if (polynomial.degree() <= 0) return roots;
  const Polynomial repeated = common_divisor(polynomial, derivative(polynomial));
  const Polynomial square_free = repeated.degree() > 0 ? quotient(polynomial, repeated) : primitive(polynomial);
  const Sturm sturm(square_free);
  struct Part {
    Dyadic low, high;
    int count;
  };
  const Dyadic zero{0, 0};
  std::vector<Part> parts{{zero, end, sturm.roots(zero, end)}};
  while (!parts.empty()) {
    Part part = std::move(parts.back());
    parts.pop_back();
    if (part.count == 0) continue;
    if (part.count == 1) {
      Root root;
      root.square_free_ = square_free;
      root.low_ = part.low, root.high_ = part.high;
      root.sign_above_ = square_free.sign_at(part.high);
      if (root.sign_above_ == 0) root.low_ = root.high_;
      roots.push_back(std::move(root));
      continue;
    }
    const Dyadic between = middle(part.low, part.high);
    const int left = sturm.roots(part.low, between);
    parts.push_back({between, part.high, part.count - left});  // looked at after the other
    parts.push_back({part.low, between, left});
  }
  for (Root& root : roots) root.multiple_ = repeated.degree() > 0 && root.sign_of(repeated) == 0;
  return roots;
}

}  // namespace touchstone::cell
