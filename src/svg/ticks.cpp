#include "svg/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/number_text.hpp"
#include "text/text.hpp"

namespace waywright::svg {

namespace {

// Boxes measure at least 2^-152 and at most 2^101, and the step between ticks is a fraction of that.
constexpr int kSmallestExponent = -50;
constexpr int kLargestExponent = 32;
constexpr std::array<std::int64_t, 3> kMantissas{1, 2, 5};
constexpr double kFinest = 0x1p-48;    // least step that doubles resolve, as a fraction of the largest coordinate
constexpr std::size_t kLongLabel = 8;  // labels of up to this many characters are easy to read
constexpr double kLabelSpace = 14.0;   // least distance of two labels, in pixels

/// The number mantissa * 10^exponent.
struct Decimal {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

std::string digits_of(std::int64_t mantissa) {
  std::string digits;
  base::append_unsigned(digits, static_cast<std::uint64_t>(std::abs(mantissa)));
  return digits;
}

std::string signed_number(int value) {
  std::string text(value < 0 ? "-" : "");
  base::append_unsigned(text, static_cast<std::uint64_t>(std::abs(value)));
  return text;
}

double nearest_double(const Decimal& number) {
  const std::string text =
      (number.mantissa < 0 ? "-" : "") + digits_of(number.mantissa) + "e" + signed_number(number.exponent);
  return text::read_number(text).value_or(0.0);
}

/// Returns the number with as many decimals as its exponent says: 0.50 for 50e-2.
std::string fixed(const Decimal& number) {
  std::string digits = digits_of(number.mantissa);
  if (number.mantissa != 0 && number.exponent > 0) digits.append(static_cast<std::size_t>(number.exponent), '0');
  if (number.exponent < 0) {
    const auto decimals = static_cast<std::size_t>(-number.exponent);
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - decimals, ".");
  }
  return (number.mantissa < 0 ? "-" : "") + digits;
}

/// Returns the number with one digit before the point and no trailing zeros: 1.25e12.
std::string scientific(const Decimal& number) {
  if (number.mantissa == 0) return "0";
  std::string digits = digits_of(number.mantissa);
  const int exponent = number.exponent + static_cast<int>(digits.size()) - 1;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.size() > 1) digits.insert(1, ".");
  return (number.mantissa < 0 ? "-" : "") + digits + "e" + signed_number(exponent);
}

/// Returns the multiples of a step in [min, max].
std::vector<Decimal> multiples_of(const Decimal& step, double min, double max) {
  const double size = nearest_double(step);
  std::vector<Decimal> multiples;
  const auto last = static_cast<std::int64_t>(std::floor(max / size)) + 1;
  // A quotient is rounded, so the loop tries one more on each end.
  for (auto i = static_cast<std::int64_t>(std::ceil(min / size)) - 1; i <= last; ++i) {
    const Decimal multiple{i * step.mantissa, step.exponent};
    const double position = nearest_double(multiple);
    if (position >= min && position <= max) multiples.push_back(multiple);
  }
  return multiples;
}

std::vector<Tick> labelled(const std::vector<Decimal>& numbers, std::string (*label)(const Decimal&)) {
  std::vector<Tick> ticks;
  for (const Decimal& number : numbers) ticks.push_back({nearest_double(number), label(number)});
  return ticks;
}

/// Calls visit(number) with each round number, ascending, until it returns true.
template <class Visit>
void visit_round_numbers(Visit visit) {
  for (int exponent = kSmallestExponent; exponent <= kLargestExponent; ++exponent) {
    for (const std::int64_t mantissa : kMantissas) {
      if (visit(Decimal{mantissa, exponent})) return;
    }
  }
}

}  // namespace

std::size_t longest_label(const std::vector<Tick>& ticks) {
  std::size_t longest = 0;
  for (const Tick& tick : ticks) longest = std::max(longest, tick.label.size());
  return longest;
}

std::vector<Tick> ticks_between(double min, double max, const TickRoom& room) {
  std::vector<Tick> ticks;
  const double finest = std::max(std::abs(min), std::abs(max)) * kFinest;
  visit_round_numbers([&](const Decimal& step) {
    const double size = nearest_double(step);
    const double spacing = size * room.pixels_per_unit;
    if (spacing < room.least_spacing || size < finest) return false;
    const std::vector<Decimal> numbers = multiples_of(step, min, max);
    ticks = labelled(numbers, fixed);
    std::vector<Tick> shorter = labelled(numbers, scientific);
    if (longest_label(ticks) > kLongLabel && longest_label(shorter) < longest_label(ticks)) ticks.swap(shorter);
    return ticks.size() < 2 ||
           static_cast<double>(longest_label(ticks)) * room.pixels_per_character + kLabelSpace <= spacing;
  });
  return ticks;
}

Tick scale_bar_length(double most) {
  Decimal best{1, kSmallestExponent};
  visit_round_numbers([&](const Decimal& length) {
    if (nearest_double(length) > most) return true;
    best = length;
    return false;
  });
  const std::string label = fixed(best);
  return {nearest_double(best), label.size() > kLongLabel ? scientific(best) : label};
}

}  // namespace waywright::svg
