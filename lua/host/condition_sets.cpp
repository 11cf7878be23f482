#include "lua/host/condition_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/rounding.h"
#include "lua/host/condition_comparisons.h"

namespace lsos {

namespace {

// A closed interval; an open end is replaced by the next representable number.
struct Interval {
  double low, high;
};
using Set = std::vector<Interval>;

Set intersection(const Set& a, const Set& b) {
  Set both;
  for (const Interval& x : a) {
    for (const Interval& y : b) {
      const Interval part{std::max(x.low, y.low), std::min(x.high, y.high)};
      if (part.low <= part.high) both.push_back(part);
    }
  }
  return both;
}

// Union of two sets. Intervals that touch or overlap are merged, which keeps the sets small.
Set joined(Set a, const Set& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::ranges::sort(a, {}, &Interval::low);
  Set merged;
  for (const Interval& part : a) {
    const bool touches =
        !merged.empty() && part.low <= std::nextafter(merged.back().high, infinite);
    if (touches) {
      merged.back().high = std::max(merged.back().high, part.high);
    } else {
      merged.push_back(part);
    }
  }
  return merged;
}

// For each quantity on which an expression depends, the values outside which it cannot hold.
using Sets = std::map<std::string, Set>;

// Values where both expressions may hold.
Sets both(Sets a, const Sets& b) {
  for (const auto& [quantity, set] : b) {
    const auto [at, is_new] = a.try_emplace(quantity, set);
    if (!is_new) at->second = intersection(at->second, set);
  }
  return a;
}

// Values where at least one of the expressions may hold.
Sets either(const Sets& a, const Sets& b) {
  Sets any;
  for (const auto& [quantity, set] : a) {
    const auto other = b.find(quantity);
    if (other != b.end()) any.emplace(quantity, joined(set, other->second));
  }
  return any;
}

// The quantity for which no value is left; nullptr: none.
const std::string* quantity_without_values(const Sets& sets) {
  const auto found = std::ranges::find_if(sets, [](const auto& set) { return set.second.empty(); });
  return found == sets.end() ? nullptr : &found->first;
}

Set values_of(const std::string& how, double number) {
  const double below = std::nextafter(number, -infinite), above = std::nextafter(number, infinite);
  if (how == "<") return {{-infinite, below}};
  if (how == "<=") return {{-infinite, number}};
  if (how == ">") return {{above, infinite}};
  if (how == ">=") return {{number, infinite}};
  if (how == "==") return {{number, number}};
  return {{-infinite, below}, {above, infinite}};
}

std::string opposite(const std::string& how) {
  if (how == "<") return ">=";
  if (how == "<=") return ">";
  if (how == ">") return "<=";
  if (how == ">=") return "<";
  return how == "==" ? "~=" : "==";
}

Sets sets_of(const SingleComparison& c, const std::string& how) {
  Set set = intersection(values_of(how, c.number), {{c.bounds.low, c.bounds.high}});
  if (c.is_magnitude) {
    Set mirrored;
    for (const Interval& part : set) mirrored.push_back({-part.high, -part.low});
    set = joined(std::move(set), mirrored);
  }
  return {{c.quantity, std::move(set)}};
}

// Whether a quantity is undefined while the rover stands.
bool may_have_no_value(const std::string& quantity) {
  return quantity == "slip" || quantity == "slip_max";
}

// A part of a condition: values where it may hold, and values where it may not.
struct Part {
  Sets yes, no;
};

class Reader {
 public:
  explicit Reader(const std::vector<ConditionWord>& words) : words_(words) {}

  std::string doubt() {
    const Part whole = any_of();
    if (!never_.empty()) {
      return fmt::format(
          "its comparisons of {} exclude each other, so that they never all hold; "
          "did you mean 'or'?",
          never_);
    }
    if (const std::string* quantity = quantity_without_values(whole.no)) {
      return fmt::format("it always holds, whatever {} is", *quantity);
    }
    return "";
  }

 private:
  bool is_at(std::string_view text) const {
    return at_ < words_.size() && words_[at_].kind != ConditionWord::Kind::text &&
           words_[at_].text == text;
  }

  Part any_of() {
    Part part = all_of();
    while (is_at("or")) {
      ++at_;
      const Part other = all_of();
      part = {either(part.yes, other.yes), both(part.no, other.no)};
    }
    return part;
  }

  Part all_of() {
    Part part = term();
    bool is_reported = false;
    while (is_at("and")) {
      ++at_;
      const Part other = term();
      is_reported =
          is_reported || quantity_without_values(part.yes) || quantity_without_values(other.yes);
      part = {both(part.yes, other.yes), either(part.no, other.no)};
      const std::string* quantity = quantity_without_values(part.yes);
      // A comparison that never holds by itself is reported elsewhere (sizes_doubt).
      if (quantity != nullptr && !is_reported && never_.empty()) never_ = *quantity;
    }
    return part;
  }

  Part term() {
    if (is_at("not")) {
      ++at_;
      Part part = term();
      std::swap(part.yes, part.no);
      return part;
    }
    if (is_at("(")) {
      const std::size_t begin = at_++;
      Part part = any_of();
      if (is_at(")")) ++at_;
      if (at_ >= words_.size() || ends_operand(words_[at_])) return part;
      at_ = begin;  // an operand of something larger
      return skipped();
    }
    if (auto c = comparison_at(words_, at_)) {
      at_ = c->end;
      // While the quantity has no value, neither the comparison nor its opposite holds.
      if (may_have_no_value(c->quantity)) return {sets_of(*c, c->how), {}};
      return {sets_of(*c, c->how), sets_of(*c, opposite(c->how))};
    }
    return skipped();
  }

  // Skips a term that is neither a comparison nor in brackets; it may hold or not.
  Part skipped() {
    for (int depth = 0; at_ < words_.size(); ++at_) {
      if (is_at("(")) ++depth;
      if (is_at(")") && --depth < 0) break;
      if (depth == 0 && (is_at("and") || is_at("or"))) break;
    }
    return {};
  }

  const std::vector<ConditionWord>& words_;
  std::size_t at_ = 0;
  std::string never_;
};

}  // namespace

std::string sets_doubt(const std::vector<ConditionWord>& words) { return Reader(words).doubt(); }

}  // namespace lsos
