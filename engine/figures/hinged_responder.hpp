// The response to the contacts of a step in which there are figures, and to the limits of their
// hinges: by impulses in turn, as Responder does without.
//
// Whoever pushes a part moves the whole figure: what a push does to all parts is found once for
// each contact that pushes, with the impulses of the hinges in it. So a contact with a part is as
// stiff as the figure is there, and no push pulls a hinge apart.
//
// Where hinges must not turn further, at their limits and where neighbours are folded together, are
// contacts that turn: an angular impulse of the child against the parent, never pulling, found
// among the impulses of all other contacts.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/collision/contact_model.hpp"
#include "engine/dynamics/contact_bodies.hpp"
#include "engine/dynamics/impulses_in_turn.hpp"
#include "engine/figures/figure.hpp"
#include "engine/figures/figure_motion.hpp"

namespace impetus::inline figures {

/// A limit within reach of the next step.
struct HingeStop {
  std::size_t figure{0};
  std::size_t hinge{0};
  Vector3 axis{Vector3::UnitZ()};  ///< world, unit: away from the limit the child turns about it
  double allowed_rad_s{0.0};       ///< at which it would arrive within a step; 0 at the limit
};

/// Adds the stops of a free figure's hinges that are nearer than kStopReach to a limit.
inline constexpr double kStopReach = 0.25;  ///< radians
void add_stops(std::span<const Figure> figures, std::size_t figure,
               const std::vector<BodyState>& states, double dt_s, std::vector<HingeStop>& stops);

/// The axis about which the child turns, against the parent, when the two open (world, unit).
Vector3 opening_axis(const Hinge& hinge, const Pose& child, const Pose& parent);

/// The hinge that joins the two parts; none: null.
const Hinge* hinge_between(const Figure& figure, BodyPair parts);

/// A contact for each pair of neighbours that are folded past their threshold: at the hinge, from
/// the second's centre of mass towards the first's, as deep as the tips of their cores are beyond
/// the threshold. `rest_openings` are opening_at_rest() of the hinges.
void add_folds(const Figure& figure, std::span<const double> rest_openings,
               const std::vector<BodyState>& states, std::vector<Contact>& folds);

/// The figures of a world and what moves them, one for one.
struct FiguresInMotion {
  std::span<const Figure> figures;
  std::span<FigureMotion> motions;          ///< those of driven figures are not asked
  std::span<const std::int32_t> figure_of;  ///< of each body; −1: none
};

/// Has the members that ImpulsesInTurn asks for. A place is what moves as one: a body, a free
/// figure. Keeps its arrays from one step to the next.
class HingedBodies {
 public:
  /// Looks anew at the contacts, then at the stops. Contacts of which hinges leave less than
  /// `least_share` (ResponseRules::least_share_of_give) do not give.
  void gather(const std::vector<Contact>& contacts, const std::vector<HingeStop>& stops,
              double least_share, const std::vector<BodyModel>& models,
              const std::vector<BodyState>& states, const FiguresInMotion& figures);

  [[nodiscard]] std::size_t contact_count() const { return rows_.size(); }

  /// By places; ContactArms::kNone: a wall.
  struct Ends {
    std::int32_t a;
    std::int32_t b;
  };
  [[nodiscard]] Ends contact(std::size_t i) const { return rows_[i].places; }
  [[nodiscard]] std::size_t body_count() const { return place_moves_.size(); }
  [[nodiscard]] bool moves(std::int32_t place) const {
    return place != ContactArms::kNone && place_moves_[static_cast<std::size_t>(place)] != 0;
  }

  /// Negative when the two approach: along the normal (m/s), or faster than a limit's room allows
  /// (rad/s).
  [[nodiscard]] double separation_speed(std::size_t row) const;
  [[nodiscard]] double incoming_speed(std::size_t row) const;

  /// How much an impulse of one changes the separation speed; 0 where hinges hold it.
  double give(std::size_t row);
  void push(std::size_t row, double impulse, std::vector<BodyState>& states);

 private:
  /// A body at a contact, or a part of a figure at one.
  struct Moving {
    std::size_t index{0};  ///< in the world
    std::int32_t place{0};
    bool moved{false};  ///< by impulses
    double inverse_mass{0.0};
    Matrix3 inverse_inertia{Matrix3::Zero()};
    Vector3 velocity{Vector3::Zero()};
    Vector3 spin{Vector3::Zero()};
    double speed_m_s{0.0};
    double spin_rad_s{0.0};
  };
  /// One end of a contact.
  struct Side {
    std::int32_t slot{ContactArms::kNone};  ///< of `moving_`
    Vector3 arm{Vector3::Zero()};
  };
  /// A contact, a fold or a stop.
  struct Row {
    Ends places{ContactArms::kNone, ContactArms::kNone};
    Side a;
    Side b;
    Vector3 normal{Vector3::UnitX()};  ///< or the axis about which a opens against b
    bool turns{false};
    double allowed{0.0};
    std::int64_t first_change{-1};  ///< −1: not yet found
    std::int64_t change_count{0};
  };
  /// What a push does to one body.
  struct Change {
    std::int32_t slot;
    PartImpulse impulse;  ///< that one along the normal leaves
  };

  std::int32_t slot_of(std::int32_t body, const std::vector<BodyState>& states);
  std::int32_t add_slot(std::size_t body, std::int32_t place, bool moved,
                        const std::vector<BodyState>& states);
  void add_figure(std::int32_t figure, const std::vector<BodyState>& states);
  Side side_at(std::int32_t body, const Vector3& point, const std::vector<BodyState>& states);
  void add_row(Row row);
  [[nodiscard]] double speed_along(const Row& row, const Side& side) const;
  /// How much an impulse of one moves a side along the normal that gets `own` of it.
  [[nodiscard]] double moved_by(const Row& row, const Side& side, const PartImpulse& own) const;
  /// The same of both sides as if no hinge held them.
  [[nodiscard]] double give_alone(const Row& row) const;
  [[nodiscard]] PartImpulse unit_impulse(const Row& row, const Side& side, double sign) const;
  void find_changes(Row& row);
  void add_changes_of_figure(const Row& row, std::int32_t figure);
  void follow(Moving& body, const BodyState& state);

  const std::vector<BodyModel>* models_{nullptr};
  FiguresInMotion figures_;
  double least_share_{0.0};
  std::vector<Moving> moving_;
  std::vector<std::int32_t> slot_of_body_;
  std::vector<std::uint8_t> place_moves_;
  std::vector<Row> rows_;
  std::vector<Change> changes_;
  std::vector<PartImpulse> impulses_;
};

/// Responds step after step, in memory that it keeps.
class HingedResponder {
 public:
  /// Applies impulses to `states`; a restitution in [0, 1] for each contact, none for the limits of
  /// hinges. The result is of the contacts, and valid until the next call. Of neighbours that are
  /// folded together it tells angles: speeds in rad/s, impulses in N m s.
  const ResponseResult& respond(const std::vector<Contact>& contacts,
                                const std::vector<HingeStop>& stops,
                                const std::vector<double>& restitutions, const ResponseRules& rules,
                                const std::vector<BodyModel>& models,
                                const FiguresInMotion& figures, std::vector<BodyState>& states);

 private:
  HingedBodies bodies_;
  ImpulsesInTurn<HingedBodies> in_turn_;
  std::vector<std::size_t> all_;
  std::vector<double> restitutions_;
  ResponseResult result_;
};

}  // namespace impetus::inline figures
