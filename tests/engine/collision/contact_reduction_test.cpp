// Reductions of contacts: each against its definition, worked out by hand.
// SPDX-License-Identifier: MIT
#include "engine/collision/contact_reduction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "engine/collision/contact_patches.hpp"
#include "engine/numerics/elementary_functions.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/deepest_contact.hpp"
#include "tests/places/places.hpp"

namespace impetus::contact_reduction_test {

constexpr std::uint64_t kSeed = 42;
const Vector3 kX = Vector3::UnitX();
const Vector3 kY = Vector3::UnitY();
const Vector3 kZ = Vector3::UnitZ();

NodeContact at(const Vector3& point, const Vector3& normal, double depth_m) {
  NodeContact contact;
  contact.touch = {point, normal.normalized(), depth_m};
  contact.node_m = 0.1;
  contact.group_a = 0;
  contact.group_b = 0;
  return contact;
}

NodeContact on_groups(NodeContact contact, std::int32_t group_a, std::int32_t group_b) {
  contact.group_a = group_a;
  contact.group_b = group_b;
  return contact;
}

std::vector<TouchPoint> reduced(const ContactSums& sums) {
  std::vector<TouchPoint> contacts;
  sums.reduce_to(contacts);
  return contacts;
}

std::vector<TouchPoint> reduced(std::string_view name, const std::vector<NodeContact>& contacts,
                                const Vector3& fallback = kX) {
  const std::unique_ptr<ContactSums> sums = make_reduction(name)->make_sums();
  sums->begin(fallback);
  for (const NodeContact& contact : contacts) {
    sums->add(contact);
  }
  return reduced(*sums);
}

void expect_contact(const TouchPoint& found, const Vector3& point, const Vector3& normal,
                    double depth_m) {
  // A few roundings of numbers below 10.
  EXPECT_LT((found.point - point).norm(), 1e-14) << found.point.transpose();
  EXPECT_LT((found.normal - normal).norm(), 1e-15) << found.normal.transpose();
  EXPECT_EQ(found.depth_m, depth_m);
}

TEST(ContactReduction, NoneKeepsEveryContactAsItCame) {
  const std::vector<NodeContact> contacts{at({1, 2, 3}, kY, 0.1), at({4, 5, 6}, kZ, 0.3),
                                          at({1, 2, 3}, kY, 0.1)};
  const std::vector<TouchPoint> left = reduced("none", contacts);
  ASSERT_EQ(left.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    expect_contact(left[i], contacts[i].touch.point, contacts[i].touch.normal,
                   contacts[i].touch.depth_m);
  }
}

TEST(ContactReduction, AverageIsTheMeanPointTheMeanNormalAndTheGreatestDepth) {
  const std::vector<TouchPoint> left = reduced(
      "average",
      {at({1, 0, 0}, {3, 4, 0}, 0.1), at({3, 0, 6}, {-3, 4, 0}, 0.4), at({2, 3, 0}, kY, 0.2)});
  ASSERT_EQ(left.size(), 1U);
  expect_contact(left[0], {2, 1, 2}, kY, 0.4);
}

TEST(ContactReduction, AverageOfOpposedNormalsIsTheFallback) {
  const std::vector<TouchPoint> left =
      reduced("average", {at({1, 0, 0}, kX, 0.1), at({3, 0, 0}, -kX, 0.2)}, kZ);
  ASSERT_EQ(left.size(), 1U);
  expect_contact(left[0], {2, 0, 0}, kZ, 0.2);
}

TEST(ContactReduction, FirstIsTheOneThatWasEnteredLongestAgo) {
  NodeContact deep_and_fast = at({1, 0, 0}, kX, 0.4);
  deep_and_fast.approach_m_s = 4.0;
  deep_and_fast.since_entry_s = 0.1;
  NodeContact shallow_and_slow = at({2, 0, 0}, kY, 0.2);
  shallow_and_slow.approach_m_s = 1.0;
  shallow_and_slow.since_entry_s = 0.2;
  NodeContact parting = at({3, 0, 0}, kZ, 0.9);
  parting.approach_m_s = -1.0;
  parting.since_entry_s = 0.9;
  NodeContact parting_and_deeper = parting;
  parting_and_deeper.touch.depth_m = 1.0;
  expect_contact(reduced("first", {deep_and_fast, shallow_and_slow, parting}).at(0), {2, 0, 0}, kY,
                 0.2);
  expect_contact(reduced("first", {parting, deep_and_fast}).at(0), {1, 0, 0}, kX, 0.4);
  expect_contact(reduced("first", {parting, parting_and_deeper}).at(0), {3, 0, 0}, kZ, 1.0);
}

TEST(ContactReduction, TimeSinceEntryIsWhenMovingBackSpheresLastTouch) {
  // |(reach − depth) n − v t| = reach, solved by trying it.
  RandomStream random(kSeed, "entries");
  for (int trial = 0; trial < 300; ++trial) {
    const double reach_m = uniform_in(random, 0.5, 2.0);
    const double depth_m = reach_m * uniform_in(random, 0.0, 1.5);
    const Vector3 normal = random_direction(random);
    const Vector3 moving = uniform_in(random, 0.1, 3.0) * random_direction(random);
    const double time_s = time_since_entry_s(reach_m, depth_m, -normal.dot(moving), moving.norm());
    ASSERT_GE(time_s, 0.0);
    ASSERT_NEAR(((reach_m - depth_m) * normal - moving * time_s).norm(), reach_m, 1e-12)
        << "seed " << kSeed << ", trial " << trial;
  }
  // The limit of small depths: depth over approach.
  EXPECT_NEAR(time_since_entry_s(1.0, 1e-9, 0.5, 2.0) / (1e-9 / 0.5), 1.0, 1e-7);
  EXPECT_EQ(time_since_entry_s(1.0, 0.5, 0.0, 0.0), 0.0) << "nothing moves";
}

TEST(ContactReduction, GroupsAverageEachPairOfSurfaceGroupsApart) {
  const std::vector<NodeContact> contacts{
      on_groups(at({0, 0, 0}, kY, 0.1), 1, 7), on_groups(at({5, 0, 0}, kX, 0.3), 2, 7),
      on_groups(at({2, 0, 0}, kY, 0.2), 1, 7), on_groups(at({5, 4, 0}, kX, 0.2), 2, 7),
      on_groups(at({0, 9, 0}, kX, 0.5), 2, 8)};
  const std::vector<TouchPoint> left = reduced("groups", contacts);
  ASSERT_EQ(left.size(), 3U);
  expect_contact(left[0], {1, 0, 0}, kY, 0.2);
  expect_contact(left[1], {5, 2, 0}, kX, 0.3);
  expect_contact(left[2], {0, 9, 0}, kX, 0.5);
}

TEST(ContactReduction, AsManyGroupsAsThereAreStayApartInTheOrderInWhichTheyCame) {
  constexpr int kPairs = 300;
  std::vector<NodeContact> contacts;
  for (int round = 0; round < 2; ++round) {
    for (int pair = 0; pair < kPairs; ++pair) {
      contacts.push_back(
          on_groups(at({0.5 * pair, 2.0 * round, 0.0}, kZ, 0.1), pair % 17, pair / 17));
    }
  }
  const std::vector<TouchPoint> left = reduced("groups", contacts);
  ASSERT_EQ(left.size(), std::size_t{kPairs});
  for (int pair = 0; pair < kPairs; ++pair) {
    expect_contact(left[static_cast<std::size_t>(pair)], {0.5 * pair, 1.0, 0.0}, kZ, 0.1);
  }
}

TEST(ContactReduction, AGroupWhoseConeOpensIsSplit) {
  const std::vector<TouchPoint> left =
      reduced("groups", {at({0, 0, 0}, kY, 0.1), at({4, 0, 0}, -kY, 0.2), at({0, 2, 0}, kY, 0.3),
                         at({6, 0, 0}, -kY, 0.1)});
  ASSERT_EQ(left.size(), 2U);
  expect_contact(left[0], {0, 1, 0}, kY, 0.3);
  expect_contact(left[1], {5, 0, 0}, -kY, 0.2);
}

TEST(ContactReduction, ThePatchesOfACornerAreOneAndFarOrOtherwiseFacingOnesStayApart) {
  // Three faces of a corner against one face; then the same normal a metre away; then one across.
  const NodeContact corner_1 = on_groups(at({0.00, 0, 0}, {0.1, 1, 0}, 0.1), 1, 7);
  const NodeContact corner_2 = on_groups(at({0.15, 0, 0}, {-0.1, 1, 0}, 0.2), 2, 7);
  const NodeContact far = on_groups(at({1.0, 0, 0}, kY, 0.1), 3, 7);
  const NodeContact across = on_groups(at({0.05, 0, 0}, kX, 0.1), 4, 7);
  const std::vector<TouchPoint> left = reduced("groups", {corner_1, corner_2, far, across});
  ASSERT_EQ(left.size(), 3U);
  expect_contact(left[0], {0.075, 0, 0}, kY, 0.2);
  expect_contact(left[1], far.touch.point, kY, 0.1);
  expect_contact(left[2], across.touch.point, kX, 0.1);
}

TEST(ContactReduction, TwoNormalsOfOneGroupAreOneSurfaceUpTo120DegreesApart) {
  for (const double apart_deg : {60.0, 119.0, 121.0, 175.0}) {
    const auto [sine, cosine] = sine_cosine_deg(apart_deg);
    const NodeContact turned = at({1, 0, 0}, {sine, cosine, 0.0}, 0.2);
    EXPECT_EQ(reduced("groups", {at({0, 0, 0}, kY, 0.1), turned}).size(), apart_deg < 120 ? 1U : 2U)
        << apart_deg;
  }
}

TEST(ContactReduction, PatchesAreOneUpToTwiceTheGreaterNodeBeyondTheirLengths) {
  // An even row of four, .1 apart, goes √15 · .05 to each side of its middle, by its variance.
  const auto count_with = [](double x, double node_m) {
    std::vector<NodeContact> contacts;
    for (int i = 0; i < 4; ++i) {
      contacts.push_back(on_groups(at({0.1 * i, 0, 0}, kY, 0.1), 1, 7));
    }
    contacts.push_back(on_groups(at({x, 0, 0}, kY, 0.1), 2, 7));
    contacts.back().node_m = node_m;
    return reduced("groups", contacts).size();
  };
  const double end_m = 0.15 + 0.05 * std::sqrt(15.0);
  EXPECT_EQ(count_with(end_m + 0.199, 0.1), 1U);
  EXPECT_EQ(count_with(end_m + 0.201, 0.1), 2U);
  EXPECT_EQ(count_with(end_m + 0.201, 0.05), 2U) << "the greater node counts";
  EXPECT_EQ(count_with(end_m + 0.399, 0.2), 1U);
  EXPECT_EQ(count_with(end_m + 0.401, 0.2), 2U);
}

TEST(ContactReduction, WeightedWeighsByInterpenetrationAndOccupancies) {
  NodeContact likely = at({1, 0, 0}, {3, 4, 0}, 0.1);
  likely.interpenetration = 0.8;
  likely.occupancy_a = 0.5;
  likely.occupancy_b = 0.75;  // P = .3
  NodeContact unlikely = at({5, 0, 0}, {-3, 4, 0}, 0.4);
  unlikely.interpenetration = 0.4;
  unlikely.occupancy_a = 0.25;  // P = .1
  const std::vector<TouchPoint> left = reduced("weighted", {likely, unlikely});
  ASSERT_EQ(left.size(), 1U);
  // n = .3 (.6, .8) + .1 (−.6, .8) = (.12, .32); p = (.3·1 + .1·5) / .4
  expect_contact(left[0], {2, 0, 0}, Vector3(0.12, 0.32, 0.0).normalized(), 0.4);
}

TEST(ContactReduction, WeightsThatAreAllZeroGiveThePlainMean) {
  NodeContact one = at({1, 0, 0}, {3, 4, 0}, 0.1);
  NodeContact other = at({5, 0, 0}, {-3, 4, 0}, 0.4);
  one.occupancy_a = 0.0;
  other.interpenetration = 0.0;
  const std::vector<TouchPoint> left = reduced("weighted", {one, other});
  ASSERT_EQ(left.size(), 1U);
  expect_contact(left[0], {3, 0, 0}, kY, 0.4);
}

TEST(ContactReduction, DensityTakesTheDifferenceOfTheOutwardNormals) {
  NodeContact contact = at({1, 2, 3}, kX, 0.1);
  contact.outward_a = -kY;
  contact.outward_b = Vector3(0.6, 0.8, 0.0);
  expect_contact(reduced("density", {contact}).at(0), {1, 2, 3}, Vector3(0.6, 1.8, 0).normalized(),
                 0.1);
}

TEST(ContactReduction, DensitiesThatDoNotOpposeLeaveTheGeometricNormal) {
  NodeContact contact = at({1, 2, 3}, kX, 0.1);
  for (const auto& [of_a, of_b] :
       std::array<std::pair<Vector3, Vector3>, 4>{{{Vector3::Zero(), Vector3::Zero()},
                                                   {kY, kY},
                                                   {kY, kZ + 0.1 * kY},
                                                   {kY, Vector3::Zero()}}}) {
    contact.outward_a = of_a.norm() > 0.0 ? of_a.normalized() : of_a;
    contact.outward_b = of_b.norm() > 0.0 ? of_b.normalized() : of_b;
    EXPECT_EQ(density_contact_normal(contact), kX);
  }
}

/// Contacts of one cone of normals, in groups that lie metres apart.
std::vector<NodeContact> scattered(RandomStream& random) {
  std::vector<NodeContact> contacts;
  for (int i = 0; i < 30; ++i) {
    const auto group = static_cast<std::int32_t>(random.below(3));
    const Vector3 middle = 10.0 * group * kX;
    NodeContact contact = at(middle + random_in_cube(random, 0.3),
                             kY + 0.5 * random_direction(random), uniform_in(random, 0.01, 0.2));
    contact.group_a = group;
    contact.interpenetration = random.uniform();
    contact.occupancy_a = random.uniform();
    contact.occupancy_b = random.uniform();
    contact.approach_m_s = uniform_in(random, -0.5, 2.0);
    contact.since_entry_s = random.uniform();
    contact.outward_a = (-kY + 0.3 * random_direction(random)).normalized();
    contact.outward_b = (kY + 0.3 * random_direction(random)).normalized();
    contacts.push_back(contact);
  }
  return contacts;
}

void sort_by_place(std::vector<TouchPoint>& contacts) {
  std::sort(contacts.begin(), contacts.end(),
            [](const TouchPoint& x, const TouchPoint& y) { return x.point.x() < y.point.x(); });
}

TEST(ContactReduction, TheOrderInWhichContactsComeChangesRoundingAlone) {
  RandomStream random(kSeed, "orders");
  for (const std::string_view name : reduction_names()) {
    for (int trial = 0; trial < 50; ++trial) {
      std::vector<NodeContact> contacts = scattered(random);
      std::vector<TouchPoint> left = reduced(name, contacts);
      for (std::size_t i = contacts.size(); i > 1; --i) {
        std::swap(contacts[i - 1], contacts[random.below(i)]);
      }
      std::vector<TouchPoint> again = reduced(name, contacts);
      ASSERT_EQ(again.size(), left.size()) << name;
      sort_by_place(left);
      sort_by_place(again);
      for (std::size_t i = 0; i < left.size(); ++i) {
        ASSERT_LT((again[i].point - left[i].point).norm(), 1e-12) << name << ", seed " << kSeed;
        ASSERT_LT((again[i].normal - left[i].normal).norm(), 1e-13) << name;
        ASSERT_EQ(again[i].depth_m, left[i].depth_m) << name;
      }
    }
  }
}

TEST(ContactReduction, SwappingTheBodiesTurnsTheNormalsAndNothingElse) {
  RandomStream random(kSeed, "swapped bodies");
  for (const std::string_view name : reduction_names()) {
    for (int trial = 0; trial < 50; ++trial) {
      const std::vector<NodeContact> contacts = scattered(random);
      std::vector<NodeContact> swapped = contacts;
      for (NodeContact& contact : swapped) {
        contact.touch.normal = -contact.touch.normal;
        std::swap(contact.group_a, contact.group_b);
        std::swap(contact.occupancy_a, contact.occupancy_b);
        std::swap(contact.outward_a, contact.outward_b);
      }
      const std::vector<TouchPoint> left = reduced(name, contacts);
      const std::vector<TouchPoint> of_swapped = reduced(name, swapped);
      ASSERT_EQ(of_swapped.size(), left.size()) << name;
      for (std::size_t i = 0; i < left.size(); ++i) {
        ASSERT_LT((of_swapped[i].point - left[i].point).norm(), 1e-13) << name;
        ASSERT_LT((of_swapped[i].normal + left[i].normal).norm(), 1e-15) << name;
        ASSERT_EQ(of_swapped[i].depth_m, left[i].depth_m) << name;
      }
    }
  }
}

TEST(ContactReduction, NeverLeavesMoreThanItPromisesNorNoneOfSome) {
  RandomStream random(kSeed, "promises");
  for (const std::string_view name : reduction_names()) {
    const auto reduction = make_reduction(name);
    EXPECT_TRUE(reduced(*reduction->make_sums()).empty()) << name << " of nothing";
    for (int trial = 0; trial < 30; ++trial) {
      const auto left = static_cast<std::int64_t>(reduced(name, scattered(random)).size());
      ASSERT_GE(left, 1) << name;
      ASSERT_LE(left, std::min<std::int64_t>(30, reduction->most())) << name;
    }
  }
  EXPECT_EQ(most_contacts({}, 30), 1) << "the average";
  EXPECT_EQ(most_contacts({}, 0), 0);
  EXPECT_EQ(most_contacts({make_reduction("groups"), 4}, 30), 4);
  EXPECT_EQ(most_contacts({make_reduction("none"), 4}, 3), 3);
  EXPECT_EQ(most_contacts({make_reduction("first"), 4}, 3), 1);
}

TEST(ContactReduction, AnUnknownNameIsRefusedWithTheNamesThereAre) {
  try {
    make_reduction("mean");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "reduction: expected one of none, first, average, groups, density, weighted, "
                 "got \"mean\"");
  }
}

TEST(ContactReduction, TheReadmesExampleReducesAndIsTheCodeThatIsCompiledHere) {
  const ContactModel model{std::make_shared<ReductionBy<DeepestContact>>(), 4};
  const auto sums = reduction_of(model).make_sums();
  for (const double depth_m : {0.1, 0.3, 0.2}) {
    sums->add(at({depth_m, 0, 0}, kY, depth_m));
  }
  ASSERT_EQ(reduced(*sums).size(), 1U);
  expect_contact(reduced(*sums)[0], {0.3, 0, 0}, kY, 0.3);
  const auto text_of = [](const char* name) {
    std::ifstream file(source_folder() + name);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string code = text_of("/tests/engine/deepest_contact.hpp");
  const std::size_t first = code.find("/// The deepest");
  const std::string example = code.substr(first, code.find("\n}  // namespace") - first);
  ASSERT_GT(example.size(), 100U);
  EXPECT_NE(text_of("/engine/README.md").find(example), std::string::npos);
}

}  // namespace impetus::contact_reduction_test
