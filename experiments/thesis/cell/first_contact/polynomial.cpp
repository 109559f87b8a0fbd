// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/first_contact/polynomial.h"

#include <algorithm>

namespace touchstone::kinematics {
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

Polynomial without_multiple_roots(const Polynomial& p) {
  const Polynomial repeated = common_divisor(p, derivative(p));
  return repeated.degree() > 0 ? quotient(p, repeated) : p;
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

mpz_class Polynomial::scaled_value_at(const Dyadic& x) const {
  mpz_class value = coefficients_.back(), term;
  mp_bitcnt_t scale = 0;
  for (std::size_t i = coefficients_.size() - 1; i-- > 0;) {
    scale += x.shift;
    mpz_mul(value.get_mpz_t(), value.get_mpz_t(), x.numerator.get_mpz_t());
    mpz_mul_2exp(term.get_mpz_t(), coefficients_[i].get_mpz_t(), scale);
    mpz_add(value.get_mpz_t(), value.get_mpz_t(), term.get_mpz_t());
  }
  return value;
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
// |i q_i| reach^(i - 1) and neither |x| nor |m| exceeds reach.
int Root::sign_of(const Polynomial& q) {
  if (q.degree() <= 0) return q.zero() ? 0 : sgn(q.coefficients().front());
  const mpz_class reach = (high_.numerator >> high_.shift) + 1;
  mpz_class power = 1, bound = 0;
  for (std::size_t i = 1; i < q.coefficients().size(); ++i) {
    bound += mpz_class(abs(q.coefficients()[i]) * static_cast<unsigned long>(i)) * power;
    power *= reach;
  }
  for (unsigned bits = 12;; bits *= 2) {
    refine(bits);
    if (equal(low_, high_)) return q.sign_at(high_);
    const Dyadic at = middle(low_, high_);
    const mpz_class value = q.scaled_value_at(at) << bits;
    const mpz_class error = bound << static_cast<mp_bitcnt_t>(q.degree()) * at.shift;
    if (mpz_cmpabs(value.get_mpz_t(), error.get_mpz_t()) > 0) return sgn(value);
    if (bits != 96) continue;  // closer than that as a rule only where it is a root of both
    const Polynomial common = common_divisor(square_free_, q);
    if (common.degree() > 0 && common.sign_at(low_) * common.sign_at(high_) <= 0 &&
        Sturm(without_multiple_roots(common)).roots(low_, high_) > 0)
      return 0;
  }
}

// A polynomial whose Bernstein coefficients over an interval change their sign once has one root inside, a simple one;
// where they do not, none.
class RootFinder {
 public:
  explicit RootFinder(const Polynomial& polynomial) : polynomial_(polynomial) {}

  std::vector<Root> roots(const Dyadic& end) {
    if (by_signs({0, 0}, end, bernstein(end), 0)) return std::move(roots_);
    roots_.clear();
    by_sturm(end);
    return std::move(roots_);
  }

 private:
  static constexpr int kHalvings = 12;

  void add(const Polynomial& square_free, const Dyadic& low, const Dyadic& high) {
    Root root;
    root.square_free_ = square_free;
    root.low_ = low, root.high_ = high;
    root.sign_above_ = square_free.sign_at(high);
    if (root.sign_above_ == 0) root.low_ = root.high_;
    roots_.push_back(std::move(root));
  }

  /// The Bernstein coefficients over [0, end], times a positive number.
  [[nodiscard]] std::vector<mpz_class> bernstein(const Dyadic& end) const {
    const std::vector<mpz_class>& c = polynomial_.coefficients();
    const std::size_t degree = c.size() - 1;
    std::vector<mpz_class> scaled(c.size()), result(c.size());
    for (std::size_t i = 0; i <= degree; ++i) {
      mpz_class power;
      mpz_pow_ui(power.get_mpz_t(), end.numerator.get_mpz_t(), i);
      scaled[i] = mpz_class(c[i] * power) << static_cast<mp_bitcnt_t>((degree - i) * end.shift);
    }
    mpz_class top, part;
    for (std::size_t j = 0; j <= degree; ++j)
      for (std::size_t i = 0; i <= j; ++i) {  // times degree!: C(j, i) / C(degree, i) is whole then
        mpz_bin_uiui(part.get_mpz_t(), j, i);
        mpz_fac_ui(top.get_mpz_t(), degree);
        part *= top;
        mpz_bin_uiui(top.get_mpz_t(), degree, i);
        part /= top;
        result[j] += part * scaled[i];
      }
    return result;
  }

  /// False where signs do not tell.
  bool by_signs(const Dyadic& low, const Dyadic& high, std::vector<mpz_class> b, int halvings) {
    if (b.front() == 0 || b.back() == 0) return false;
    int changes = 0, last = sgn(b.front());
    for (const mpz_class& c : b)
      if (sgn(c) != 0 && sgn(c) != last) ++changes, last = sgn(c);
    if (changes == 1) add(polynomial_, low, high);
    if (changes <= 1) return true;
    if (halvings == kHalvings) return false;
    // De Casteljau, both halves times 2^degree.
    const std::size_t degree = b.size() - 1;
    std::vector<mpz_class> left(b.size()), right(b.size());
    for (std::size_t i = 0; i <= degree; ++i) {
      left[i] = b[0] << static_cast<mp_bitcnt_t>(degree - i);
      right[degree - i] = b[degree - i] << static_cast<mp_bitcnt_t>(degree - i);
      for (std::size_t k = 0; k + i < degree; ++k) b[k] += b[k + 1];
    }
    const Dyadic between = middle(low, high);
    return by_signs(low, between, std::move(left), halvings + 1) &&
           by_signs(between, high, std::move(right), halvings + 1);
  }

  void by_sturm(const Dyadic& end) {
    const Polynomial repeated = common_divisor(polynomial_, derivative(polynomial_));
    const Polynomial square_free = without_multiple_roots(polynomial_);
    const Sturm sturm(square_free);
    struct Part {
      Dyadic low, high;
      int count;
    };
    const Dyadic zero{0, 0};
    std::vector<Part> parts{{zero, end, sturm.roots(zero, end)}};
    while (!parts.empty()) {
      const Part part = std::move(parts.back());
      parts.pop_back();
      if (part.count == 1) add(square_free, part.low, part.high);
      if (part.count <= 1) continue;
      const Dyadic between = middle(part.low, part.high);
      const int left = sturm.roots(part.low, between);
      parts.push_back({between, part.high, part.count - left});  // looked at after the other
      parts.push_back({part.low, between, left});
    }
    for (Root& root : roots_) root.multiple_ = repeated.degree() > 0 && root.sign_of(repeated) == 0;
  }

  const Polynomial& polynomial_;
  std::vector<Root> roots_;
};

std::vector<Root> real_roots(const Polynomial& polynomial, const Dyadic& end) {
  if (polynomial.degree() <= 0) return {};
  return RootFinder(polynomial).roots(end);
}

}  // namespace touchstone::kinematics
