// SPDX-License-Identifier: MIT
#include "core/flatfold/open_orders.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace kiri {

namespace {

/// Unknowns that are equal or opposite to each other.
class TiedTerms {
 public:
  explicit TiedTerms(std::size_t count) : parents_(count) {
    for (std::size_t i = 0; i < count; ++i) parents_[i] = static_cast<Term>(2 * i);
  }
  Term find(Term t) {
    std::uint32_t u = unknownOf(t);
    Term sign = t & 1;
    while (unknownOf(parents_[u]) != u) {
      const Term up = parents_[u];
      // Halve the way to the root.
      parents_[u] = parents_[unknownOf(up)] ^ (up & 1);
      sign ^= parents_[u] & 1;
      u = unknownOf(parents_[u]);
    }
    return 2 * u + sign;
  }
  /// False: they were known to be opposite.
  bool unite(Term a, Term b) {
    a = find(a);
    b = find(b);
    if (unknownOf(a) == unknownOf(b)) return a == b;
    if (a < b) std::swap(a, b);
    parents_[unknownOf(a)] = b ^ (a & 1);
    hasChanged_ = true;
    return true;
  }
  bool takeChange() { return std::exchange(hasChanged_, false); }

 private:
  std::vector<Term> parents_;
  bool hasChanged_ = false;
};

/// An even number of up to four terms holds, or an odd one; or the three are not all equal; or not
/// both.
enum class TieKind : std::uint8_t { Even, Odd, NotAllEqual, NotBoth };
struct OpenTie {
  TieKind kind = TieKind::Even;
  Clause terms{kNoTerm, kNoTerm, kNoTerm, kNoTerm};
  auto operator<=>(const OpenTie&) const = default;
};

struct TieHash {
  std::size_t operator()(const OpenTie& tie) const {
    std::uint64_t hash = static_cast<std::uint64_t>(tie.kind);
    for (const Term t : tie.terms) {
      hash = (hash ^ t) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

class OpenOrdersMaker {
 public:
  OpenOrdersMaker(const OrderProblem& problem, const FacetRelation& relation,
                  const KnownOrders& known, WorkMeter& meter)
      : problem_(problem), relation_(relation), known_(known), meter_(meter), tied_(openPairs()) {}

  Result<OpenOrders> make() {
    gatherTies();
    if (!isContradicted_) gatherCircles();
    while (!isContradicted_ && tied_.takeChange() && meter_.spend(ties_.size() * 20)) renew();
    if (meter_.isStopped()) {
      return meter_.error("the orders that mountains and valleys decide were found");
    }
    out_.isContradicted = isContradicted_;
    if (!isContradicted_) write();
    return std::move(out_);
  }

 private:
  std::size_t openPairs() {
    placeOf_.assign(problem_.pairs.size(), 0);
    for (std::uint32_t p = 0; p < problem_.pairs.size(); ++p) {
      if (known_.isKnown(p)) continue;
      placeOf_[p] = static_cast<std::uint32_t>(out_.pairs.size());
      out_.pairs.push_back(p);
    }
    return out_.pairs.size();
  }

  Term termOf(Literal l) { return tied_.find(2 * placeOf_[l.pair()] + (l.isNegated() ? 1 : 0)); }

  void unite(Term a, Term b) { isContradicted_ = !tied_.unite(a, b) || isContradicted_; }

  void gatherTies() {
    for (const SameOrder& same : problem_.same) {
      if (!known_.isKnown(same.first.pair())) unite(termOf(same.first), termOf(same.second));
    }
    for (const Interleaving& i : problem_.interleavings) {
      bool isOdd = false;
      std::vector<Term> terms;
      for (const Literal l : {i.ac, i.bc, i.ad, i.bd}) {
        if (known_.isKnown(l.pair())) {
          isOdd ^= known_.isTrue(l);
        } else {
          terms.push_back(termOf(l));
        }
      }
      if (!terms.empty()) addParity(terms, isOdd);
    }
  }

  /// The number of terms that hold is even, or odd.
  void addParity(std::vector<Term> terms, bool isOdd) {
    for (Term& t : terms) {
      t = tied_.find(t);
      isOdd ^= (t & 1) != 0;
      t &= ~Term{1};
    }
    std::sort(terms.begin(), terms.end());
    std::vector<Term> left;
    for (const Term t : terms) {
      if (!left.empty() && left.back() == t) {
        left.pop_back();
      } else {
        left.push_back(t);
      }
    }
    if (left.empty()) {
      isContradicted_ = isContradicted_ || isOdd;
    } else if (left.size() == 2) {
      unite(left[0], left[1] ^ (isOdd ? 1 : 0));
    } else {
      keep(isOdd ? TieKind::Odd : TieKind::Even, left);
    }
  }

  /// Three orders around three facets: all equal would be a ring.
  void addNotAllEqual(std::array<Term, 3> t) {
    for (Term& term : t) term = tied_.find(term);
    std::sort(t.begin(), t.end());
    const bool isSame01 = unknownOf(t[0]) == unknownOf(t[1]);
    const bool isSame12 = unknownOf(t[1]) == unknownOf(t[2]);
    if (!isSame01 && !isSame12) {
      // All three turned mean the same.
      if ((t[0] & 1) != 0) {
        for (Term& term : t) term = opposite(term);
      }
      keep(TieKind::NotAllEqual, {t[0], t[1], t[2]});
    } else if (isSame01 && t[0] == t[1]) {
      unite(t[2], opposite(t[0]));
    } else if (isSame12 && t[1] == t[2]) {
      unite(t[0], opposite(t[1]));
    }
  }

  void addNotBoth(Term a, Term b) {
    a = tied_.find(a);
    b = tied_.find(b);
    if (a == opposite(b)) return;
    if (a == b) {
      keep(TieKind::NotBoth, {a});
    } else {
      keep(TieKind::NotBoth, {std::min(a, b), std::max(a, b)});
    }
  }

  void keep(TieKind kind, const std::vector<Term>& terms) {
    OpenTie tie;
    tie.kind = kind;
    std::copy(terms.begin(), terms.end(), tie.terms.begin());
    if (ties_.insert(tie).second && ties_.size() * kBytesATie > meter_.memory()) {
      meter_.meetMemoryLimit();
    }
  }

  bool isKept(TieKind kind, Term a, Term b, Term c) const {
    OpenTie tie;
    tie.kind = kind;
    tie.terms = {a, b, c, kNoTerm};
    return ties_.count(tie) != 0;
  }

  /// Facets with an open order to one, a bit each.
  void readOpenRow(std::uint32_t facet, std::vector<std::uint64_t>& row) const {
    const std::uint64_t* near = relation_.overlapping(facet);
    const std::uint64_t* above = known_.above(facet);
    const std::uint64_t* below = known_.below(facet);
    for (std::size_t w = 0; w < row.size(); ++w) row[w] = near[w] & ~above[w] & ~below[w];
  }

  /// Every three facets of one stack with two open orders or three.
  void gatherCircles() {
    std::vector<std::uint64_t> open(relation_.words());
    for (std::uint32_t corner = 0; corner < problem_.facetCount; ++corner) {
      readOpenRow(corner, open);
      for (std::size_t w = 0; w < open.size(); ++w) {
        for (std::uint64_t bits = open[w]; bits != 0; bits &= bits - 1) {
          const std::uint32_t f = static_cast<std::uint32_t>(w * 64) +
                                  static_cast<std::uint32_t>(std::countr_zero(bits));
          gatherCirclesAt(corner, f, open);
          if (isContradicted_ || !meter_.spend(4 * open.size())) return;
        }
      }
    }
  }

  void gatherCirclesAt(std::uint32_t corner, std::uint32_t f,
                       const std::vector<std::uint64_t>& open) {
    const std::uint64_t* near = relation_.overlapping(f);
    std::size_t seen = 0;
    for (std::size_t w = f >> 6; w < open.size(); ++w) {
      std::uint64_t bits = open[w] & near[w];
      if (w == f >> 6) bits &= ~std::uint64_t{0} << (f & 63);
      for (; bits != 0; bits &= bits - 1) {
        const std::uint32_t g =
            static_cast<std::uint32_t>(w * 64) + static_cast<std::uint32_t>(std::countr_zero(bits));
        ++seen;
        gatherCircle(corner, f, g);
      }
    }
    meter_.spend(seen * 40);
  }

  /// The orders of `corner` with f and g are open, f < g.
  void gatherCircle(std::uint32_t corner, std::uint32_t f, std::uint32_t g) {
    const Term up = termOf(relation_.above(corner, f));
    const Term down = termOf(relation_.above(g, corner));
    if (up == opposite(down)) return;  // both above the corner or both below: no ring
    const Literal between = relation_.above(f, g);
    if (known_.isKnown(between.pair())) {
      // corner > f > g > corner, or all turned.
      const bool isAbove = known_.isTrue(between);
      const Term a = isAbove ? up : opposite(up);
      const Term b = isAbove ? down : opposite(down);
      if (a != b && isKept(TieKind::NotBoth, std::min(a, b), std::max(a, b), kNoTerm)) return;
      if (relation_.haveCommonStack(corner, f, g)) addNotBoth(a, b);
      return;
    }
    if (corner > f) return;  // seen from the lowest of the three
    const Term third = termOf(between);
    if (third == opposite(up) || third == opposite(down)) return;
    std::array<Term, 3> t{up, down, third};
    std::sort(t.begin(), t.end());
    const Term turn = t[0] & 1;
    if (isKept(TieKind::NotAllEqual, t[0] ^ turn, t[1] ^ turn, t[2] ^ turn)) return;
    if (relation_.haveCommonStack(corner, f, g)) addNotAllEqual(t);
  }

  /// Says all ties again in the classes there are now.
  void renew() {
    std::vector<OpenTie> old(ties_.begin(), ties_.end());
    std::sort(old.begin(), old.end());
    ties_.clear();
    for (const OpenTie& tie : old) {
      std::vector<Term> terms(tie.terms.begin(), tie.terms.begin() + sizeOf(tie.terms));
      switch (tie.kind) {
        case TieKind::Even:
        case TieKind::Odd:
          addParity(terms, tie.kind == TieKind::Odd);
          break;
        case TieKind::NotAllEqual:
          addNotAllEqual({terms[0], terms[1], terms[2]});
          break;
        case TieKind::NotBoth:
          addNotBoth(terms.front(), terms.back());
          break;
      }
    }
  }

  void write() {
    std::vector<std::uint32_t> numberOf(out_.pairs.size(), kNoTerm);
    for (std::size_t i = 0; i < out_.pairs.size(); ++i) {
      const Term root = tied_.find(static_cast<Term>(2 * i));
      std::uint32_t& number = numberOf[unknownOf(root)];
      if (number == kNoTerm) number = out_.formula.unknowns++;
      out_.terms.push_back(2 * number + (root & 1));
    }
    for (const OpenTie& tie : ties_) {
      std::vector<Term> terms;
      for (const Term t : tie.terms) {
        if (t != kNoTerm) terms.push_back(2 * numberOf[unknownOf(t)] + (t & 1));
      }
      writeClauses(tie.kind, terms);
    }
    std::vector<Clause>& list = out_.formula.clauses;
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  void writeClauses(TieKind kind, std::vector<Term>& terms) {
    if (kind == TieKind::NotBoth) {
      for (Term& t : terms) t = opposite(t);
      writeClause(terms, 0);
    } else if (kind == TieKind::NotAllEqual) {
      writeClause(terms, 0);
      writeClause(terms, 7);
    } else {
      // Forbids every choice of values with the wrong parity.
      for (unsigned turned = 0; turned < 1U << terms.size(); ++turned) {
        const bool isOddChoice = (std::popcount(turned) & 1) != 0;
        if (isOddChoice == (kind == TieKind::Even)) writeClause(terms, turned);
      }
    }
  }

  void writeClause(const std::vector<Term>& terms, unsigned turned) {
    Clause clause{kNoTerm, kNoTerm, kNoTerm, kNoTerm};
    for (std::size_t i = 0; i < terms.size(); ++i) clause[i] = terms[i] ^ (turned >> i & 1);
    std::sort(clause.begin(), clause.end());
    out_.formula.clauses.push_back(clause);
  }

  static constexpr std::size_t kBytesATie = 64 + 32;

  const OrderProblem& problem_;
  const FacetRelation& relation_;
  const KnownOrders& known_;
  WorkMeter& meter_;
  OpenOrders out_;
  std::vector<std::uint32_t> placeOf_;  ///< by pair: its place among the open ones
  TiedTerms tied_;
  std::unordered_set<OpenTie, TieHash> ties_;
  bool isContradicted_ = false;
};

}  // namespace

Result<OpenOrders> openOrdersOf(const OrderProblem& problem, const FacetRelation& relation,
                                const KnownOrders& known, WorkMeter& meter) {
  return OpenOrdersMaker(problem, relation, known, meter).make();
}

}  // namespace kiri
