// Numerics: the same numbers everywhere, and the right ones.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/numerics/random_stream.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::numerics_test {

// The promise of elementary_functions.hpp: radians, series and product each round a number below 1
// once.
constexpr double kTrigonometryError = 2e-16;

struct LongSineCosine {
  long double sine;
  long double cosine;
};

LongSineCosine reference(double angle_deg) {
  const long double turn = std::fmod(static_cast<long double>(angle_deg), 360.0L);
  const long double angle = turn * (std::numbers::pi_v<long double> / 180.0L);
  return {std::sin(angle), std::cos(angle)};
}

double worst_error(double angle_deg) {
  const SineCosine ours = sine_cosine_deg(angle_deg);
  const LongSineCosine exact = reference(angle_deg);
  return static_cast<double>(
      std::max(std::fabs(ours.sine - exact.sine), std::fabs(ours.cosine - exact.cosine)));
}

TEST(Atan2, AgreesWithLongDoubleTo1e15OverTheWholeCircle) {
  RandomStream random(7, "atan2");
  for (int trial = 0; trial < 200'000; ++trial) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(60)) - 30);
    const double x = uniform_in(random, -1.0, 1.0);
    const double y = scale * uniform_in(random, -1.0, 1.0);
    const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    ASSERT_LT(std::fabs(static_cast<double>(atan2_rad(y, x) - exact)), 1e-15) << y << ", " << x;
  }
}

TEST(Atan2, OfSmallAnglesIsRelativelyExact) {
  for (double y = 1e-3; y > 1e-300; y /= 7.0) {
    EXPECT_NEAR(atan2_rad(y, 1.0) / std::atan2(y, 1.0), 1.0, 1e-15) << y;
  }
}

TEST(Atan2, OfTheAxesAndDiagonals) {
  const double pi = std::numbers::pi;
  EXPECT_EQ(atan2_rad(0.0, 0.0), 0.0);
  EXPECT_EQ(atan2_rad(0.0, 2.0), 0.0);
  EXPECT_EQ(atan2_rad(0.0, -2.0), pi);
  EXPECT_EQ(atan2_rad(2.0, 0.0), pi / 2.0);
  EXPECT_EQ(atan2_rad(-2.0, 0.0), -pi / 2.0);
  EXPECT_EQ(atan2_rad(3.0, 3.0), pi / 4.0);
  EXPECT_EQ(atan2_rad(-3.0, -3.0), -3.0 * pi / 4.0);
}

TEST(Atan2, OfWhatIsNotANumberIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isnan(atan2_rad(nan, 1.0)));
  EXPECT_TRUE(std::isnan(atan2_rad(1.0, nan)));
  EXPECT_TRUE(std::isnan(atan2_rad(infinity, infinity)));
}

TEST(Trigonometry, AgreesWithTheLongDoubleLibraryOverAMillionDegrees) {
  double worst = 0.0;
  for (int i = -720'000; i <= 720'000; ++i) {
    worst = std::max(worst, worst_error(i * 0.001 + 1e-5));
  }
  RandomStream random(1, "angles");
  for (int i = 0; i < 200'000; ++i) {
    worst = std::max(worst, worst_error((random.uniform() - 0.5) * 2e6));
  }
  RecordProperty("worst_error", std::to_string(worst * 1e16) + "e-16");
  EXPECT_LE(worst, kTrigonometryError);
}

TEST(Trigonometry, MultiplesOfNinetyDegreesAreExact) {
  const double sines[] = {0.0, 1.0, 0.0, -1.0};
  for (int quarter = -4000; quarter <= 4000; ++quarter) {
    const SineCosine value = sine_cosine_deg(90.0 * quarter);
    EXPECT_EQ(value.sine, sines[quarter & 3]);
    EXPECT_EQ(value.cosine, sines[(quarter + 1) & 3]);
  }
}

TEST(Trigonometry, SineIsOddAndCosineIsEven) {
  for (double angle_deg = 0.013; angle_deg < 400.0; angle_deg += 0.37) {
    const SineCosine plus = sine_cosine_deg(angle_deg);
    const SineCosine minus = sine_cosine_deg(-angle_deg);
    EXPECT_EQ(plus.sine, -minus.sine) << angle_deg;
    EXPECT_EQ(plus.cosine, minus.cosine) << angle_deg;
  }
}

TEST(Trigonometry, ADegreeAtFiftySevenCentimetresIsAboutACentimetre) {
  // 2 · 0.57 m · tan(½°)
  EXPECT_NEAR(metres_per_degree(0.57), 2.0 * 0.57 * std::tan(std::numbers::pi / 360.0), 1e-16);
  EXPECT_NEAR(metres_per_degree(0.57), 0.00995, 5e-6);
}

TEST(RandomStream, FirstValuesAreTheCommittedOnes) {
  // From an independent implementation of xoshiro256** seeded by SplitMix64 (Python).
  RandomStream random(42, "golden");
  EXPECT_EQ(random.next_bits(), 0xb84480bb6dc33d90ULL);
  EXPECT_EQ(random.next_bits(), 0x346d1aa65134a98fULL);
  EXPECT_EQ(random.next_bits(), 0x3641758df83366ebULL);
  EXPECT_EQ(random.next_bits(), 0x25815ecf3ac7d062ULL);
  EXPECT_EQ(random.uniform(), 0x750cf105ecb09p-53);
}

TEST(RandomStream, DerivedSeedsAreTheCommittedOnes) {
  EXPECT_EQ(derived_seed(0, ""), 0xe220a8397b1dcdafULL);
  EXPECT_EQ(derived_seed(1, "order/causality/P01"), 0x8bf92a5c69217912ULL);
  EXPECT_EQ(derived_seed(0x8000000000000000ULL, "practice"), 0x20e17c72287e40c7ULL);
}

TEST(RandomStream, UniformLiesInZeroToOneWithTheRightMeanAndSpread) {
  RandomStream random(7, "uniform");
  constexpr int kDraws = 1'000'000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  // Standard errors: sqrt(1/12/n) for the mean, sqrt(4/45/n) for the mean square; five of each.
  EXPECT_NEAR(sum / kDraws, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / kDraws));
}

double chi_square(const std::vector<int>& counts) {
  const double expected =
      std::accumulate(counts.begin(), counts.end(), 0.0) / static_cast<double>(counts.size());
  double sum = 0.0;
  for (const int count : counts) {
    sum += (count - expected) * (count - expected) / expected;
  }
  return sum;
}

TEST(RandomStream, BelowIsUniformOverSmallCounts) {
  RandomStream random(7, "below");
  std::vector<int> counts(10, 0);
  for (int i = 0; i < 200'000; ++i) {
    ++counts[random.below(10)];
  }
  EXPECT_LT(chi_square(counts), 33.72);  // 9 degrees of freedom, p = 1e-4
}

TEST(RandomStream, BelowHasNoBiasWhereARemainderAloneWouldHave) {
  // 3 · 2^62 does not divide 2^64: `bits % count` would give the first third twice as often.
  constexpr std::uint64_t kThird = std::uint64_t{1} << 62;
  RandomStream random(7, "below");
  std::vector<int> counts(3, 0);
  for (int i = 0; i < 30'000; ++i) {
    ++counts[random.below(3 * kThird) / kThird];
  }
  EXPECT_LT(chi_square(counts), 18.42);  // 2 degrees of freedom, p = 1e-4
}

TEST(RandomStream, OfOneThingThereIsOneChoice) {
  RandomStream random(7, "below");
  EXPECT_EQ(random.below(1), 0U);
}

TEST(RandomStream, OtherNamesAndSeedsGiveOtherNumbers) {
  const std::vector<RandomStream> streams{{1, "a"}, {1, "b"}, {1, "ab"}, {1, "ba"},
                                          {1, ""},  {2, "a"}, {1, "a/"}, {1, std::string(1, '\0')},
                                          {0, ""},  {97, "b"}};
  std::vector<std::uint64_t> firsts;
  for (RandomStream stream : streams) {
    firsts.push_back(stream.next_bits());
  }
  std::sort(firsts.begin(), firsts.end());
  EXPECT_EQ(std::adjacent_find(firsts.begin(), firsts.end()), firsts.end());
}

TEST(RandomStream, SameSeedAndNameGiveTheSameNumbers) {
  RandomStream one(9, "order");
  RandomStream two(9, "order");
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(one.next_bits(), two.next_bits());
  }
}

TEST(RandomStream, ShuffleIsAPermutation) {
  RandomStream random(3, "shuffle");
  for (std::size_t size = 0; size < 40; ++size) {
    std::vector<std::size_t> items(size);
    std::iota(items.begin(), items.end(), 0U);
    const std::vector<std::size_t> sorted = items;
    random.shuffle(items);
    std::sort(items.begin(), items.end());
    EXPECT_EQ(items, sorted);
  }
}

TEST(RandomStream, ShuffleMakesEveryOrderEquallyLikely) {
  RandomStream random(3, "orders");
  std::vector<int> counts(27, 0);
  for (int i = 0; i < 60'000; ++i) {
    std::vector<std::size_t> items{0, 1, 2};
    random.shuffle(items);
    ++counts[items[0] * 9 + items[1] * 3 + items[2]];
  }
  counts.erase(std::remove(counts.begin(), counts.end(), 0), counts.end());
  ASSERT_EQ(counts.size(), 6U);
  EXPECT_LT(chi_square(counts), 25.74);  // 5 degrees of freedom, p = 1e-4
}

TEST(Bits, FoldingAChangedWordAlwaysChangesTheHash) {
  // A bijection of the word for any hash: the inverse of fold_bits must exist, so no two words of
  // a long run collide. One bit at a time, and dense runs of words.
  RandomStream random(5, "fold");
  for (int trial = 0; trial < 2'000; ++trial) {
    const std::uint64_t hash = random.next_bits();
    const std::uint64_t word = random.next_bits();
    for (int bit = 0; bit < 64; ++bit) {
      ASSERT_NE(fold_bits(hash, word), fold_bits(hash, word ^ (std::uint64_t{1} << bit)));
    }
  }
  std::vector<std::uint64_t> hashes;
  for (std::uint64_t word = 0; word < 200'000; ++word) {
    hashes.push_back(fold_bits(17, word));
  }
  std::sort(hashes.begin(), hashes.end());
  EXPECT_EQ(std::adjacent_find(hashes.begin(), hashes.end()), hashes.end());
}

/// The inverse of an odd number modulo 2^64, by Newton's iteration.
constexpr std::uint64_t inverse_of(std::uint64_t odd) {
  std::uint64_t inverse = odd;
  for (int i = 0; i < 6; ++i) {
    inverse *= 2 - odd * inverse;
  }
  return inverse;
}

constexpr std::uint64_t undo_shift(std::uint64_t x, int shift) {
  std::uint64_t result = x;
  for (int i = 0; i < 64 / shift; ++i) {
    result = x ^ (result >> shift);
  }
  return result;
}

TEST(Bits, MixingCanBeUndoneSoItLosesNothing) {
  RandomStream random(5, "mix");
  for (int i = 0; i < 10'000; ++i) {
    const std::uint64_t word = random.next_bits();
    std::uint64_t x = undo_shift(mix_bits(word), 31) * inverse_of(0x94d049bb133111ebULL);
    x = undo_shift(x, 27) * inverse_of(0xbf58476d1ce4e5b9ULL);
    ASSERT_EQ(undo_shift(x, 30), word);
  }
}

TEST(Bits, BothZerosHashEqualAndNothingElseDoes) {
  EXPECT_EQ(canonical_bits(0.0), canonical_bits(-0.0));
  EXPECT_NE(canonical_bits(0.0), canonical_bits(5e-324));
  EXPECT_NE(canonical_bits(5e-324), canonical_bits(-5e-324));
  EXPECT_NE(canonical_bits(1.0), canonical_bits(std::nextafter(1.0, 2.0)));
}

}  // namespace impetus::numerics_test
