// What a step has spent and what it must still be able to pay.
//
//   spent      tests done
//   reserved   for each pair, what modelling and response could cost wherever it is interrupted:
//              of its last complete level, or of the next once that is complete, whichever is more
//
// Before a block, its tests are added to `spent` and the pair's reserve is raised to what the block
// could find; after it, lowered to what it found. A pair that turns out to be apart holds nothing.
// So at any time what was spent and what is still due fit into what was granted, or into the floor.
// (Dingliana 2002, eq. 3.9, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/collision/contact_reduction.hpp"
#include "engine/collision/pair_refinement.hpp"
#include "engine/scheduling/priority.hpp"
#include "engine/scheduling/work_costs.hpp"

namespace impetus::inline collision {

/// A pair, or a body and the walls, that is refined in a step.
struct RefinedPair {
  BodyPair bodies;
  int list{0};
  PairRefinement refinement;
  int walls{1};                ///< for a body and the enclosure: how many walls it could touch
  double eye_distance_m{1.0};  ///< of the place of the collision, for orders by what is seen
  double acuity{1.0};          ///< relative to the fovea's, there; for visible-first traversal
  const Noticing* noticing{nullptr};  ///< the same where the metric goes by somebody's
  double noticed_arcmin{0.0};         ///< with it, the gap that is noticed there half of the time
  bool hinged{false};                 ///< one of the bodies is a part of a figure
  bool looked_at{true};               ///< its roots are tested; else no work was left for that
};

/// What detection, modelling and response of a pair cost, by bounds that hold in advance.
class PhaseCosts {
 public:
  PhaseCosts(const WorkCosts& costs, const ContactModel& contacts)
      : costs_(costs), contacts_(contacts) {}

  /// Of `tests` node-pair tests of the pair.
  [[nodiscard]] std::int64_t of_tests(const RefinedPair& pair, std::int64_t tests) const {
    return tests * (pair.refinement.of_spheres() ? costs_.sphere_test : costs_.volume_test);
  }

  /// Of modelling `nodes` overlapping pairs of nodes: what is spent on it, too.
  [[nodiscard]] std::int64_t of_modelling(const RefinedPair& pair, std::int64_t nodes) const {
    const bool plain = pair.refinement.of_spheres() || is_wall(pair.bodies.b);
    return (costs_.model + (plain ? 0 : costs_.volume_model)) * nodes * pair.walls;
  }

  /// `hinged`: with a part of a figure, the whole of which answers.
  [[nodiscard]] std::int64_t of_response(std::int64_t contacts, bool hinged) const {
    return (costs_.response + (hinged ? costs_.hinged_response : 0)) * contacts;
  }

  /// At most, of all that follows when `nodes` pairs of nodes overlap.
  [[nodiscard]] std::int64_t of_later_phases(const RefinedPair& pair, std::int64_t nodes) const {
    return of_modelling(pair, nodes) +
           of_response(pair.walls * most_contacts(contacts_, nodes), pair.hinged);
  }

 private:
  WorkCosts costs_;
  ContactModel contacts_;
};

/// Keeps account of the work of one step.
class WorkLedger {
 public:
  /// Forgets all before. `already_spent` is part of the floor.
  void begin(const PhaseCosts& costs, std::size_t pairs, std::int64_t already_spent) {
    costs_ = costs;
    spent_ = already_spent;
    reserved_ = 0;
    reserves_.assign(pairs, 0);
  }

  /// What the ledger would stand at once the pair's next block is done, at most.
  struct Demand {
    std::int64_t total{0};
    std::int64_t reserved{0};
  };
  [[nodiscard]] Demand for_next_block(const RefinedPair& pair, std::size_t index) const;

  /// Of tests that were done, and of where the pair stands after them.
  void note(const RefinedPair& pair, std::size_t index, std::int64_t tests);

  [[nodiscard]] std::int64_t spent() const { return spent_; }
  [[nodiscard]] std::int64_t reserved() const { return reserved_; }
  [[nodiscard]] std::int64_t total() const { return spent_ + reserved_; }

 private:
  PhaseCosts costs_{{}, {}};
  std::int64_t spent_{0};
  std::int64_t reserved_{0};
  std::vector<std::int64_t> reserves_;  ///< by pair
};

}  // namespace impetus::inline collision
