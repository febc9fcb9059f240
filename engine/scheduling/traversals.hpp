// Orders of work: which pair of a priority list gets the next block of it.
//
// Each is a class and a row of the table in traversals.cpp, which says what it is: of one's own, a
// class alone. Ties go to the pair of higher priority. (Dingliana 2002, fig. 5.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace impetus::inline scheduling {

/// How far the refinement of a pair has come, and what an order of work may expect of more. Some of
/// it takes time to find: it is found when it is asked for.
class PairProgress {
 public:
  /// Whether no work could change the answer.
  [[nodiscard]] virtual bool resolved() const = 0;
  /// The last complete one.
  [[nodiscard]] virtual int level() const = 0;
  /// That the pair may come to.
  [[nodiscard]] virtual int finest_level() const = 0;
  /// How far the gap between two surfaces whose nodes overlap at `level` can be (metres).
  [[nodiscard]] virtual double fit_error_m(int level) const = 0;
  /// Of the overlapping nodes, the largest probability that their surfaces meet, in [0, 1].
  [[nodiscard]] virtual double likeliest_collision() const = 0;
  /// Of the overlapping nodes, how deep the deepest reach into each other (metres). Precondition:
  /// not resolved().
  [[nodiscard]] virtual double deepest_overlap_m() const = 0;
  /// Of the tests until the next level is complete (units of work).
  [[nodiscard]] virtual std::int64_t work_of_next_level() const = 0;
  /// Of the place of the collision, for traversals that look at kEyeDistanceTerm.
  [[nodiscard]] virtual double eye_distance_m() const = 0;
  /// There, relative to the fovea's, for traversals that look at kAcuityTerm.
  [[nodiscard]] virtual double acuity() const = 0;
  /// The probability that a gap there is noticed, for the same; none where the schedule's metric
  /// goes by nobody's noticing.
  [[nodiscard]] virtual std::optional<double> noticed(double gap_deg) const = 0;

 protected:
  ~PairProgress() = default;
};

/// What a traversal may look at, as bits.
enum TraversalTerm : unsigned {
  kProgressTerm = 1,     ///< all that changes when a level is complete
  kEyeDistanceTerm = 2,  ///< eye_distance_m()
  kAcuityTerm = 4,       ///< acuity(): with it the gaze decides what is refined
};

/// An order of work.
class Traversal {
 public:
  virtual ~Traversal() = default;

  /// The terms that urgency() looks at; all, unless the traversal says less.
  [[nodiscard]] virtual unsigned terms() const {
    return kProgressTerm | kEyeDistanceTerm | kAcuityTerm;
  }

  /// How soon the pair comes, larger sooner. It is asked when the pair begins to wait and, with
  /// kProgressTerm, whenever a level of it is complete: so a level that was begun is finished
  /// first. What is not a number counts as 0.
  [[nodiscard]] virtual double urgency(const PairProgress& pair) const = 0;
};

/// The traversal called `name`, always the same. Throws std::invalid_argument that lists the names
/// there are.
std::shared_ptr<const Traversal> make_traversal(std::string_view name);

/// The name that makes it; empty for one of a user's own.
std::string_view traversal_name(const Traversal& traversal);

/// The names make_traversal() takes; the first is what a schedule does as it stands.
std::vector<std::string_view> traversal_names();

/// What each of them does: "depth-first: one pair after the other, ..."
std::string traversals_in_words();

}  // namespace impetus::inline scheduling
