// The detail of bodies' latest collisions, and the colours that tell it.
// SPDX-License-Identifier: MIT
#include "experiments/run/body_detail.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#ifdef IMPETUS_PROGRAM_HAS_WINDOW
#include "experiments/drawing/body_colours.hpp"
#endif

namespace impetus::body_detail_test {

constexpr double kStepHz = 60.0;
constexpr std::int64_t kInView = 15;  // steps in a quarter of a second

CollisionReport collision_of(BodyPair bodies, int list, int level) {
  CollisionReport collision;
  collision.bodies = bodies;
  collision.list = list;
  collision.level = level;
  return collision;
}

TEST(LatestDetail, TellsTheMostUrgentListAndTheFinestLevelOfAStep) {
  LatestDetail latest(3, kStepHz);
  StepReport report;
  report.collisions = {collision_of({0, 1}, 1, 3), collision_of({0, 2}, 0, 2),
                       collision_of({2, kEnclosure}, 1, 0)};
  latest.take(1, report);
  EXPECT_EQ(latest.at(1), (std::vector<BodyDetail>{{0, 3}, {1, 3}, {0, 2}}));
}

TEST(LatestDetail, ForgetsAfterAQuarterOfASecond) {
  LatestDetail latest(2, kStepHz);
  StepReport report;
  report.collisions = {collision_of({0, 1}, 1, 2)};
  latest.take(4, report);
  EXPECT_EQ(latest.of(0, 4 + kInView - 1), (BodyDetail{1, 2}));
  EXPECT_EQ(latest.of(0, 4 + kInView), BodyDetail{});
}

// Of the last step within view in which the body collided: min list, max level.
TEST(LatestDetail, AgreesWithASearchThroughAllThatHappened) {
  constexpr unsigned kSeed = 64;
  std::mt19937 random(kSeed);
  constexpr std::size_t kBodies = 6;
  LatestDetail latest(kBodies, kStepHz);
  std::vector<std::vector<CollisionReport>> happened(1);
  for (std::int64_t step = 1; step <= 300; ++step) {
    StepReport report;
    for (auto count = random() % 3 == 0 ? 1 + random() % 3 : 0; count > 0; --count) {
      const auto a = static_cast<std::int32_t>(random() % kBodies);
      const auto b =
          static_cast<std::int32_t>((static_cast<std::uint64_t>(a) + 1 + random() % 5) % kBodies);
      report.collisions.push_back(collision_of({a, random() % 4 == 0 ? kEnclosure : b},
                                               static_cast<int>(random() % 3),
                                               static_cast<int>(random() % 5)));
    }
    latest.take(step, report);
    happened.push_back(report.collisions);
    for (std::size_t body = 0; body < kBodies; ++body) {
      BodyDetail expected;
      for (std::int64_t back = 0; back < std::min(kInView, step) && expected.list < 0; ++back) {
        for (const CollisionReport& each : happened[static_cast<std::size_t>(step - back)]) {
          const auto index = static_cast<std::int32_t>(body);
          if (each.bodies.a == index || each.bodies.b == index) {
            expected.list = expected.list < 0 ? each.list : std::min(expected.list, each.list);
            expected.level = std::max(expected.level, each.level);
          }
        }
      }
      ASSERT_EQ(latest.of(body, step), expected) << "seed " << kSeed << ", step " << step;
    }
  }
}

#ifdef IMPETUS_PROGRAM_HAS_WINDOW

double linear_from_srgb(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// What the three kinds of cones take of red, green and blue (Hunt-Pointer-Estevez): an eye that
/// lacks one has the others.
std::array<double, 3> cones_of(const BodyColour& colour) {
  const double r = linear_from_srgb(colour[0]);
  const double g = linear_from_srgb(colour[1]);
  const double b = linear_from_srgb(colour[2]);
  return {0.31399 * r + 0.63951 * g + 0.04650 * b, 0.15537 * r + 0.75789 * g + 0.08670 * b,
          0.01775 * r + 0.10945 * g + 0.87257 * b};
}

TEST(BodyColours, FinerLevelsAreLighterForEyesWithLongOrMiddleConesAlone) {
  for (int finest = 1; finest <= 6; ++finest) {
    for (int level = 1; level <= finest; ++level) {
      const auto coarser = cones_of(colour_of_level(level - 1, finest));
      const auto finer = cones_of(colour_of_level(level, finest));
      // Weber: a twentieth more is well seen side by side; shading hides more, so ask for a fifth.
      EXPECT_GT(finer[0], 1.2 * coarser[0]) << level << " of " << finest;
      EXPECT_GT(finer[1], 1.2 * coarser[1]) << level << " of " << finest;
    }
  }
}

TEST(BodyColours, PriorityIsRedThenBlue) {
  EXPECT_GT(colour_of_list(0)[0], 3.0F * colour_of_list(0)[2]);
  EXPECT_GT(colour_of_list(1)[2], 3.0F * colour_of_list(1)[0]);
  EXPECT_EQ(colour_of_list(1), colour_of_list(2));
}

TEST(BodyColours, TheKeyGoesThroughAllOfThem) {
  std::set<BodyColours> seen;
  BodyColours colours = BodyColours::kOwn;
  for (int press = 0; press < 3; ++press) {
    colours = next_colours(colours);
    seen.insert(colours);
  }
  EXPECT_EQ(seen.size(), 3U);
  EXPECT_EQ(colours, BodyColours::kOwn);
}

TEST(BodyColours, TellTheDetailAndLeaveBodiesThatAreApartPale) {
  const BodyColour own{0.2F, 0.6F, 0.3F};
  const std::vector<PosedBody> plain(3, PosedBody{{}, {"", 0.01, own}});
  const std::vector<BodyDetail> details{{0, 3}, {1, 0}, {}};
  std::vector<PosedBody> bodies = plain;
  colour_bodies(bodies, details, BodyColours::kOwn, 3);
  EXPECT_EQ(bodies[0].look.colour, own);
  for (const BodyColours colours : {BodyColours::kPriority, BodyColours::kLevel}) {
    bodies = plain;
    colour_bodies(bodies, details, colours, 3);
    const bool by_level = colours == BodyColours::kLevel;
    for (const std::size_t body : {0U, 1U}) {
      const BodyColour meant =
          by_level ? colour_of_level(details[body].level, 3) : colour_of_list(details[body].list);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(bodies[body].look.colour[channel], meant[channel], 0.15F);
      }
    }
    // Nearer to grey than its own colour is.
    EXPECT_LT(bodies[2].look.colour[1] - bodies[2].look.colour[0], 0.5F * (own[1] - own[0]));
  }
}

TEST(BodyColours, TheLegendNamesEveryLevelOnce) {
  EXPECT_TRUE(meanings_of(BodyColours::kOwn, 3).empty());
  EXPECT_EQ(meanings_of(BodyColours::kPriority, 3).size(), 3U);
  const auto levels = meanings_of(BodyColours::kLevel, 2);
  ASSERT_EQ(levels.size(), 4U);
  EXPECT_EQ(levels[0].meaning, "level 0, coarsest");
  EXPECT_EQ(levels[1].meaning, "level 1");
  EXPECT_EQ(levels[2].meaning, "level 2, finest");
  EXPECT_EQ(levels[1].colour, colour_of_level(1, 2));
}

#endif

}  // namespace impetus::body_detail_test
