// Collision response by impulses that are found together, island by island.
//
//   repeat     of the contacts that approach now, find the least change of velocity (by energy)
//              after which each separates with at least ε times its approach
//   at last    the least change after which no contact approaches
//
// Only approaching contacts are in a problem, so each round keeps or lowers the energy, whatever
// the restitutions: ΔE = ½ Σ (1 − ε_i) j_i v_i ≤ 0. A wave passes on by one body a round, as in a
// Newton's cradle. (Dingliana 2002, sec. 3.3.1, corrected; Moreau 1988 for the projection)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/dynamics/contact_bodies.hpp"
#include "engine/dynamics/impulse.hpp"
#include "engine/dynamics/nearest_velocities.hpp"

namespace impetus::inline dynamics {

/// Of an island whose passes are limited, the most contacts that can be active at once, at most six
/// for each body that moves, for its impulses to be found together: beyond it the work grows with
/// the square of the contacts and more.
inline constexpr std::size_t kMostTogetherWhenLimited = 24;

/// Keeps its arrays from one island and step to the next.
class ImpulsesTogether {
 public:
  /// Adds the impulses of `members` of the contacts to `impulse_Ns`. False when a problem could not
  /// be solved, or the island is too large for the passes it may take: what was done until then
  /// stays, and the rest is for ImpulsesInTurn.
  bool respond(const std::vector<Contact>& contacts, std::span<const std::size_t> members,
               const std::vector<double>& restitutions, const ResponseRules& rules,
               double fastest_m_s, ContactBodies& bodies, std::vector<BodyState>& states,
               std::vector<double>& impulse_Ns);

 private:
  /// A body in coordinates whose square is twice its kinetic energy: (P/√m, Cᵀ L), C Cᵀ = I⁻¹.
  struct ScaledBody {
    std::int32_t place;  ///< among the ContactBodies
    std::size_t index;
    double root_of_inverse_mass;
    Matrix3 factor_transposed;
  };

  void describe(const ContactBodies& bodies);
  std::int32_t local_place(std::int32_t place, const ContactBodies& bodies);
  void add_rows(std::span<const std::size_t> run, const ContactBodies& bodies);
  void fill(LanesOf6& lanes, std::int32_t local, double sign, const LanesOf3& arms,
            const LanesOf3& normals) const;
  bool run_rounds(const std::vector<double>& restitutions, const ResponseRules& rules,
                  double tolerance_m_s, std::vector<BodyState>& states);
  void find_approaching(const std::vector<double>& restitutions, const ResponseRules& rules,
                        double tolerance_m_s, const std::vector<BodyState>& states);
  void scale_velocities(const std::vector<BodyState>& states);
  bool solve(double tolerance_m_s, std::vector<BodyState>& states);
  void push(std::size_t row, double impulse_Ns, std::vector<BodyState>& states);

  const std::vector<Contact>* contacts_{nullptr};  ///< while it responds
  std::vector<double>* impulse_Ns_{nullptr};
  std::span<const std::size_t> members_;
  std::vector<ScaledBody> bodies_;
  std::vector<std::int32_t> local_places_;  ///< by place among the ContactBodies
  std::vector<BodyPair> pairs_;             ///< of local places, by member: its row
  RowColumns rows_;                         ///< by member
  RowColumns unit_rows_;                    ///< the same, of unit length
  std::vector<double> lengths_;
  std::vector<double> bounds_;
  std::vector<double> speeds_;
  std::vector<Vector6> u_;
  std::vector<std::size_t> problem_;  ///< rows in question
  NearestVelocitySolver solver_;
};

}  // namespace impetus::inline dynamics
