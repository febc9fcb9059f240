// The contact model: what reaches the response and the report, for every reduction.
// SPDX-License-Identifier: MIT
#include "engine/collision/contact_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/dynamics/motion.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/once.hpp"

namespace impetus::contact_model_test {

constexpr std::uint64_t kSeed = 5;
constexpr double kLongStep_s = 1.0 / 60.0;  // so that bodies overlap by more than a node

WorldSettings with_reduction(std::string_view name, int most_per_pair = 4) {
  WorldSettings settings;
  settings.restitution = 0.8;
  settings.response = ResponseMethod::kTogether;
  settings.contacts = {make_reduction(name), most_per_pair};
  return settings;
}

/// Eight L-blocks that tumble into one another where nothing encloses them, or from wall to wall.
World meeting_l_blocks(WorldSettings settings, bool enclosed) {
  const World spread = enclosed_l_blocks(8, 3);
  std::vector<BodyState> states = spread.states();
  for (BodyState& state : states) {
    const Vector3 to_the_middle = -2.0 * state.pose.position / spread.models()[0].inverse_mass;
    state.linear_momentum = enclosed ? Vector3(4.0 * state.linear_momentum) : to_the_middle;
  }
  if (enclosed) {
    settings.enclosure = spread.settings().enclosure;
  }
  return {spread.models(), std::move(states), std::move(settings)};
}

TEST(ContactModel, TheLastNormalOfThePairComesFirstInTheChain) {
  NormalFallbacks fallbacks{Vector3(0.0, 2.0, 0.0), Vector3(0.0, 0.0, 3.0)};
  EXPECT_EQ(fallbacks.first_usable(), Vector3::UnitY());
  fallbacks.last_normal = Vector3(-4.0, 0.0, 0.0);
  EXPECT_EQ(fallbacks.first_usable(), -Vector3::UnitX());
}

TEST(ContactModel, BallsThatCoincideKeepTheNormalOfTheStepBefore) {
  const BodyModel model = ball(0.5, 1.0);
  World world({model, model}, {resting_at({0.0, 0.6, 0.0}), resting_at(Vector3::Zero())}, {});
  EXPECT_EQ(step_whole(world).collisions.at(0).contact.touch.normal, Vector3::UnitY());
  world.mutable_states()[0].pose.position.setZero();
  EXPECT_EQ(step_whole(world).collisions.at(0).contact.touch.normal, Vector3::UnitY());
  World unaware({model, model}, {resting_at(Vector3::Zero()), resting_at(Vector3::Zero())}, {});
  EXPECT_EQ(step_whole(unaware).collisions.at(0).contact.touch.normal, Vector3::UnitX());
}

TEST(ContactModel, TheAverageByNameHasTheBitsOfNoReduction) {
  for (const ResponseMethod method : {ResponseMethod::kInTurn, ResponseMethod::kTogether}) {
    WorldSettings settings;
    settings.response = method;
    World unnamed = meeting_l_blocks(settings, /*enclosed=*/true);
    settings.contacts.reduction = make_reduction("average");
    World named = meeting_l_blocks(settings, /*enclosed=*/true);
    int collisions = 0;
    for (int step = 0; step < 150; ++step) {
      const StepReport report = step_whole(unnamed);
      ASSERT_EQ(step_whole(named).state.hash, report.state.hash) << step;
      collisions += static_cast<int>(report.collisions.size());
    }
    EXPECT_GT(collisions, 20);
  }
}

TEST(ContactModel, WatchingTheNodesChangesNoBitAndShowsThemAll) {
  for (const std::string_view name : reduction_names()) {
    World unseen = meeting_l_blocks(with_reduction(name), /*enclosed=*/true);
    World watched = unseen;
    watched.watch_node_contacts(true);
    std::size_t most = 0;
    for (int step = 0; step < 120; ++step) {
      const StepReport report = step_whole(watched, kLongStep_s);
      ASSERT_EQ(step_whole(unseen, kLongStep_s).state.hash, report.state.hash)
          << name << ", " << step;
      ASSERT_GE(report.node_contacts.size(), report.contacts.size()) << name;
      most = std::max(most, report.node_contacts.size());
    }
    EXPECT_GT(most, 5U) << name;
  }
}

/// What StepReport says of its collisions and contacts.
void expect_consistent(const StepReport& report, int most_per_pair) {
  std::int32_t next = 0;
  BodyPair before{-1, 0};
  for (const CollisionReport& collision : report.collisions) {
    ASSERT_TRUE(before.a < collision.bodies.a ||
                (before.a == collision.bodies.a && before.b < collision.bodies.b))
        << "one report for each pair, in order";
    before = collision.bodies;
    ASSERT_EQ(collision.first_contact, next);
    ASSERT_GE(collision.contact_count, 1);
    ASSERT_LE(collision.contact_count, most_per_pair);
    next += collision.contact_count;
    double fastest_m_s = 0.0;
    double sum_Ns = 0.0;
    double deepest_m = -1.0;
    for (std::int32_t i = collision.first_contact; i < next; ++i) {
      const ReportedContact& contact = report.contacts.at(static_cast<std::size_t>(i));
      fastest_m_s = std::max(fastest_m_s, contact.approach_m_s);
      sum_Ns += contact.impulse_Ns;
      deepest_m = std::max(deepest_m, contact.touch.depth_m);
      ASSERT_NEAR(contact.touch.normal.norm(), 1.0, 1e-12);
    }
    ASSERT_EQ(collision.approach_m_s, fastest_m_s);
    ASSERT_EQ(collision.impulse_Ns, sum_Ns);
    ASSERT_EQ(collision.contact.touch.depth_m, deepest_m);
  }
  ASSERT_EQ(static_cast<std::size_t>(next), report.contacts.size())
      << "no contact without its pair";
}

TEST(ContactModel, EveryReductionKeepsEnergyMomentumAndItsReport) {
  for (const std::string_view name : reduction_names()) {
    for (const ResponseMethod method : {ResponseMethod::kInTurn, ResponseMethod::kTogether}) {
      WorldSettings settings = with_reduction(name, 3);
      settings.response = method;
      World world = meeting_l_blocks(settings, /*enclosed=*/false);
      const Vector3 momentum = total_momentum(world);
      const Vector3 angular = total_angular_momentum(world);
      double energy = total_energy(world);
      int several = 0;
      for (int step = 0; step < 100; ++step) {
        const StepReport report = step_whole(world, kLongStep_s);
        ASSERT_NO_FATAL_FAILURE(expect_consistent(report, 3)) << name << ", step " << step;
        // 1e-3: free motion's own error; an impact only takes.
        ASSERT_LE(total_energy(world), energy * (1.0 + 1e-3)) << name;
        energy = total_energy(world);
        for (const CollisionReport& collision : report.collisions) {
          several += collision.contact_count > 1 ? 1 : 0;
        }
      }
      EXPECT_LT((total_momentum(world) - momentum).norm(), 1e-11) << name;
      EXPECT_LT((total_angular_momentum(world) - angular).norm(), 1e-10) << name;
      if (name == "none" || make_reduction(name)->most() == 1) {
        EXPECT_EQ(several > 0, name == "none") << name;
      }
    }
  }
}

TEST(ContactModel, WallsGoThroughEveryReductionAndKeepTheirNormal) {
  for (const std::string_view name : reduction_names()) {
    World world = meeting_l_blocks(with_reduction(name), /*enclosed=*/true);
    int walls = 0;
    for (int step = 0; step < 200; ++step) {
      const StepReport report = step_whole(world);
      for (const CollisionReport& collision : report.collisions) {
        for (std::int32_t i = 0; is_wall(collision.bodies.b) && i < collision.contact_count; ++i) {
          const auto index = static_cast<std::size_t>(collision.first_contact + i);
          const Vector3 inward = inward_normal(kEnclosure - collision.bodies.b);
          ASSERT_LT((report.contacts[index].touch.normal - inward).norm(), 1e-15) << name;
          ++walls;
        }
      }
    }
    EXPECT_GT(walls, 20) << name;
  }
}

TEST(ContactModel, TheContactsOfSwappedTreesAreTheirOwnTurned) {
  // The descent lists node pairs in another order, so sums differ by rounding, and `first` and the
  // cap may break ties elsewhere: compared are the reductions that leave one contact of many.
  RandomStream random(kSeed, "swapped trees");
  const ContactModel average{make_reduction("average"), 4};
  int met = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const VolumeTree tree_a = random_tree(random, 4);
    const VolumeTree tree_b = random_tree(random, 4);
    PlacedTree a(tree_a);
    PlacedTree b(tree_b);
    a.move_to({random_in_cube(random, 0.5), random_turn(random)});
    b.move_to({random_in_cube(random, 0.5), random_turn(random)});
    PairRefinement pair(a, b);
    PairRefinement swapped(b, a);
    while (!pair.resolved()) {
      pair.refine_one_block();
    }
    while (!swapped.resolved()) {
      swapped.refine_one_block();
    }
    const auto x = pair_contacts({0, 1}, pair, {a}, {b}, {}, average);
    const auto y = pair_contacts({1, 0}, swapped, {b}, {a}, {}, average);
    ASSERT_EQ(x.size(), y.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      ASSERT_LT((x[i].touch.point - y[i].touch.point).norm(), 1e-12);
      ASSERT_LT((x[i].touch.normal + y[i].touch.normal).norm(), 1e-9);
      ASSERT_EQ(x[i].touch.depth_m, y[i].touch.depth_m);
      ++met;
    }
  }
  EXPECT_GT(met, 30);
}

/// Keeps what a reduction is told of each node contact.
class KeptContacts final : public ContactReduction {
 public:
  explicit KeptContacts(std::vector<NodeContact>& kept) : kept_(&kept) {}
  [[nodiscard]] std::unique_ptr<ContactSums> make_sums() const override {
    return std::make_unique<Sums>(*kept_);
  }
  [[nodiscard]] std::int64_t most() const override { return 1; }
  [[nodiscard]] unsigned terms() const override { return kAllTerms; }

 private:
  class Sums final : public ContactSums {
   public:
    explicit Sums(std::vector<NodeContact>& kept) : kept_(&kept) {}
    void begin(const Vector3& /*fallback*/) override {}
    void add(const NodeContact& contact) override { kept_->push_back(contact); }
    void reduce_to(std::vector<TouchPoint>& contacts) const override {
      contacts.push_back(kept_->back().touch);
    }

   private:
    std::vector<NodeContact>* kept_;
  };

  std::vector<NodeContact>* kept_;
};

TEST(ContactModel, TheTimeSinceEntryOfBoxesGoesByTheirHalfWidthsAlongTheNormal) {
  const Vector3 half_m(0.2, 0.05, 0.15);
  const VolumeTree tree({{Box{Vector3::Zero(), half_m, Quaternion::Identity()}, 0, 0, {}}}, {0});
  PlacedTree a(tree);
  PlacedTree b(tree);
  a.move_to({{0.02, 0.09, 0.0}, Quaternion::Identity()});
  BodyMotion sliding;
  sliding.velocity = {0.3, -0.5, 0.0};
  std::vector<NodeContact> kept;
  const ContactModel model{std::make_shared<KeptContacts>(kept), 4};
  pair_contacts({0, 1}, PairRefinement(a, b), {a, sliding}, {b}, {}, model);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_NEAR(kept[0].touch.depth_m, 0.01, 1e-12);
  EXPECT_NEAR(kept[0].approach_m_s, 0.5, 1e-12);
  const double speed_m_s = sliding.velocity.norm();
  EXPECT_NEAR(kept[0].since_entry_s, time_since_entry_s(0.1, 0.01, 0.5, speed_m_s), 1e-12);
}

// Beside the deepest, one that turns the smaller body adds most, though another pushes elsewhere:
// by the size of the larger body it would turn nothing.
TEST(ContactModel, TorquesAreMeasuredByTheSizeOfTheSmallerBody) {
  const VolumeTree small =
      two_levels({{0.0, 0.0, 0.0}, {0.15, 0.0, 0.0}, {0.0, 0.2, 0.0}}, 0.05, 0.25);
  const VolumeTree large =
      two_levels({{0.0, -0.09, 0.0}, {0.15, -0.095, 0.0}, {0.02, 0.11, 0.0}}, 0.05, 10.0);
  const ContactModel two_of_all{make_reduction("none"), 2};
  for (const bool small_first : {true, false}) {
    PlacedTree a(small_first ? small : large);
    PlacedTree b(small_first ? large : small);
    PairRefinement pair(a, b);
    while (!pair.resolved()) {
      pair.refine_one_block();
    }
    ASSERT_EQ(pair.overlapping().size(), 3U);
    const std::vector<Contact> kept = pair_contacts({0, 1}, pair, {a}, {b}, {}, two_of_all);
    ASSERT_EQ(kept.size(), 2U);
    EXPECT_NEAR(kept[0].touch.point.x(), 0.0, 1e-12);
    EXPECT_NEAR(kept[1].touch.point.x(), 0.15, 1e-12);
  }
}

/// A plate whose tree is a box of 25 boxes, so that many nodes touch and their normals are right.
BodyModel plate_of_boxes() {
  const Vector3 half_m(0.2, 0.05, 0.15);
  BodyModel plate = solid_body(box_mesh(2.0 * half_m), /*depth=*/0);
  std::vector<VolumeNode> nodes{{Box{Vector3::Zero(), half_m, Quaternion::Identity()}, 1, 25, {}}};
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) {
      const Vector3 cell_m(half_m.x() / 5.0, half_m.y(), half_m.z() / 5.0);
      nodes.push_back(
          {Box{{2.0 * i * cell_m.x(), 0.0, 2.0 * j * cell_m.z()}, cell_m, Quaternion::Identity()},
           0,
           0,
           {}});
    }
  }
  plate.tree = std::make_shared<VolumeTree>(nodes, std::vector<std::int32_t>{0, 1});
  return plate;
}

/// The spin (rad/s) of a plate that fell flat on another that nothing moves, askew by a little.
double spin_after_falling_flat(int most_per_pair) {
  const BodyModel falling = plate_of_boxes();
  BodyModel table = falling;
  table.inverse_mass = 0.0;
  table.inverse_inertia.setZero();
  World world(
      {falling, table},
      {moving(falling, {0.01, 0.11, -0.015}, {0.0, -0.5, 0.0}), resting_at(Vector3::Zero())},
      with_reduction("none", most_per_pair));
  int touched = 0;
  for (int step = 0; step < 30; ++step) {
    for (const CollisionReport& collision : step_whole(world).collisions) {
      EXPECT_EQ(collision.contact_count, most_per_pair);
      ++touched;
    }
  }
  EXPECT_GT(touched, 0);
  EXPECT_GT(world.states()[0].linear_momentum.y(), 0.0);
  return angular_velocity(falling, world.states()[0]).norm();
}

TEST(ContactModel, ABoxThatFallsFlatOnAnotherKeepsFourSpreadContactsAndDoesNotTurn) {
  EXPECT_LT(spin_after_falling_flat(4), 1e-9);
  EXPECT_GT(spin_after_falling_flat(1), 0.1) << "one corner cannot hold it";
}

TEST(ContactModel, AWorldWithoutAnyContactPerPairIsRefused) {
  WorldSettings settings;
  settings.contacts.most_per_pair = 0;
  try {
    const World world({}, {}, settings);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "world: a pair needs one contact or more");
  }
}

}  // namespace impetus::contact_model_test
