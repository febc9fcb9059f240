// The pairs of one priority list that wait for work, and which of them is next.
//
//   depth-first    as they come, by falling priority: one after the other
//   breadth-first  the coarsest level first
//   best-first     the most visible gap that the next level is expected to remove per unit of work:
//                    (fit error now − fit error then, in degrees at the eye)
//                    × probability that the surfaces meet, κ ρ_a ρ_b of the likeliest nodes
//                    / what the tests of the next level cost
//   visible-first  the most visible error that finer levels are expected to remove, per unit of
//                  work:
//                    gap expected to open, in degrees at the eye
//                    × acuity there, relative to the fovea's (relative_acuity.hpp)
//                    / (what the tests of the next level cost × levels until then)
//
// A gap shows where coarse bounds touch and surfaces do not. Let the deepest nodes overlap by δ,
// and let D be what the fit errors lose until a finer level. Its bounds lie closer to the surfaces
// by between nothing and D, as far as is known each as likely. Where that is more than δ they part,
// and the gap that goes with them is at least the rest: (D − δ)² / 2D, on average. Of several finer
// levels the one that pays most counts. Bounds that overlap deeply, as those of bodies that
// really touch, so come last, which best-first takes first.
//
// Ties go to the pair of higher priority. A pair's urgency changes only when a level of it is
// complete, so one that was begun is finished first.
// (Dingliana 2002, fig. 5.1 and eq. 4.6; Klein and Zachmann 2003 for the expectation)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "engine/collision/work_ledger.hpp"

namespace impetus::inline collision {

/// How soon a pair comes, larger sooner; zero for depth-first.
double urgency(const RefinedPair& pair, Traversal traversal, const PhaseCosts& costs);

/// The pairs of one list that wait, the most urgent first.
class WaitingPairs {
 public:
  void clear() {
    waiting_.clear();
    first_ = 0;
    is_queue_ = true;
  }
  [[nodiscard]] bool empty() const { return first_ == waiting_.size(); }

  /// `index` is the pair's rank by priority.
  void add(std::size_t index, double urgency);

  /// Precondition: !empty().
  [[nodiscard]] std::size_t next() const { return waiting_[first_].index; }
  void remove_next();

 private:
  /// A pair that waits.
  struct Waiting {
    double urgency;
    std::size_t index;
  };
  static bool comes_after(const Waiting& x, const Waiting& y);
  void become_heap();

  /// As long as each comes after the last: those from first_ on, in order. From then on a heap, and
  /// first_ is 0.
  std::vector<Waiting> waiting_;
  std::size_t first_{0};
  bool is_queue_{true};
};

}  // namespace impetus::inline collision
