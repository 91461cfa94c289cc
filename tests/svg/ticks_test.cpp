#include "svg/ticks.hpp"

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace waywright::svg {
namespace {

using Labels = std::vector<std::string>;

Labels labels_between(double min, double max, double pixels_per_unit, double pixels_per_character = 0.0) {
  Labels labels;
  for (const Tick& tick : ticks_between(min, max, {pixels_per_unit, 70.0, pixels_per_character})) {
    labels.push_back(tick.label);
  }
  return labels;
}

TEST(TicksBetween, AreRoundNumbers) {
  EXPECT_EQ(labels_between(0, 10, 100), (Labels{"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10"}));
  EXPECT_EQ(labels_between(-3, 12.5, 40), (Labels{"-2", "0", "2", "4", "6", "8", "10", "12"}));
  EXPECT_EQ(labels_between(0, 512, 2.2),
            (Labels{"0", "50", "100", "150", "200", "250", "300", "350", "400", "450", "500"}));
  EXPECT_EQ(labels_between(-0.5, 0.7, 400), (Labels{"-0.4", "-0.2", "0.0", "0.2", "0.4", "0.6"}));
  EXPECT_EQ(labels_between(0, 1000, 0.4), (Labels{"0", "200", "400", "600", "800", "1000"}));
  EXPECT_EQ(labels_between(0, 1e6, 2e-4), (Labels{"0", "500000", "1000000"}));
  EXPECT_EQ(labels_between(0.51, 0.59, 1000), Labels{});
}

TEST(TicksBetween, AreInScientificNotationWhereThatIsShorter) {
  EXPECT_EQ(labels_between(0, 3e12, 1e-10), (Labels{"0", "1e12", "2e12", "3e12"}));
  EXPECT_EQ(labels_between(-1.5e-9, 0, 2e11), (Labels{"-1.5e-9", "-1e-9", "-5e-10", "0"}));
  EXPECT_EQ(labels_between(1e9, 1e9 + 1, 200), (Labels{"1000000000.0", "1000000000.5", "1000000001.0"}));
}

TEST(TicksBetween, LeaveRoomBetweenLabels) {
  // A label of 10 characters of 7 pixels each is as long as the step of 70 pixels, so only every second label remains.
  EXPECT_EQ(labels_between(1e9, 1e9 + 4, 70),
            (Labels{"1000000000", "1000000001", "1000000002", "1000000003", "1000000004"}));
  EXPECT_EQ(labels_between(1e9, 1e9 + 4, 70, 7.0), (Labels{"1000000000", "1000000002", "1000000004"}));
}

TEST(TicksBetween, ArePlacedWhereTheirLabelsSayAndEvenlySpaced) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-40.0, 99.0);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  int with_ticks = 0;
  for (int i = 0; i < 2000; ++i) {
    const double size = std::exp2(exponent(random));
    const double min = size * part(random);
    const double max = min + size * std::exp2(-20.0 * std::abs(part(random)));
    const double scale = 1100.0 / (max - min);
    const std::vector<Tick> ticks = ticks_between(min, max, {scale, 70.0, 7.0});
    with_ticks += ticks.size() >= 2 ? 1 : 0;
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      // Checks the labels with the C library's own conversion.
      ASSERT_EQ(std::strtod(ticks[k].label.c_str(), nullptr), ticks[k].position) << ticks[k].label;
      ASSERT_TRUE(ticks[k].position >= min && ticks[k].position <= max);
      if (k == 0) continue;
      const double spacing = (ticks[k].position - ticks[k - 1].position) * scale;
      ASSERT_GE(spacing, 69.9) << min << ' ' << max;
      ASSERT_GE(spacing, 7.0 * static_cast<double>(ticks[k].label.size()));
    }
  }
  EXPECT_GT(with_ticks, 1500);
}

TEST(TicksBetween, StayApartWhereDoublesAreSparse) {
  const double huge = std::ldexp(1.0, 100);
  const double next = std::nextafter(huge, 0.0);
  EXPECT_LE(ticks_between(next, huge, {1e3 / (huge - next), 70.0, 7.0}).size(), 1U);
  EXPECT_GE(ticks_between(-huge, huge, {1e3 / (2 * huge), 70.0, 7.0}).size(), 5U);
  EXPECT_GE(ticks_between(0, 1 / huge, {1e3 * huge, 70.0, 7.0}).size(), 5U);
}

TEST(ScaleBarLength, IsTheLargestRoundNumberThatFits) {
  EXPECT_EQ(scale_bar_length(120).label, "100");
  EXPECT_EQ(scale_bar_length(99.9).label, "50");
  EXPECT_EQ(scale_bar_length(0.2).label, "0.2");
  EXPECT_EQ(scale_bar_length(4.99).label, "2");
  EXPECT_EQ(scale_bar_length(3e-9).label, "2e-9");
  EXPECT_EQ(scale_bar_length(7e20).label, "5e20");
  EXPECT_EQ(scale_bar_length(7e20).position, 5e20);
}

}  // namespace
}  // namespace waywright::svg
