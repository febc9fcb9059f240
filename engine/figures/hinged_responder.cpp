// SPDX-License-Identifier: MIT
#include "engine/figures/hinged_responder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "engine/numerics/at.hpp"

namespace impetus::inline figures {
namespace {

const Pose& pose_of(std::int32_t body, const std::vector<BodyState>& states) {
  return states[static_cast<std::size_t>(body)].pose;
}

constexpr std::int32_t kNone = ContactArms::kNone;

}  // namespace

void add_stops(std::span<const Figure> figures, std::size_t figure,
               const std::vector<BodyState>& states, double dt_s, std::vector<HingeStop>& stops) {
  const std::vector<Hinge>& hinges = figures[figure].hinges;
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    const Hinge& hinge = hinges[i];
    if (!hinge.is_limited()) {
      continue;
    }
    const Pose& parent = pose_of(hinge.parent, states);
    const double angle = angle_of(hinge, pose_of(hinge.child, states), parent);
    const Vector3 axis = parent.orientation * hinge.of_parent.axis;
    const auto add = [&](double room_rad, const Vector3& away) {
      if (room_rad < kStopReach) {
        stops.push_back({figure, i, away, dt_s > 0.0 ? std::max(0.0, room_rad) / dt_s : 0.0});
      }
    };
    add(angle - hinge.least_rad, axis);
    add(hinge.most_rad - angle, -axis);
  }
}

Vector3 opening_axis(const Hinge& hinge, const Pose& child, const Pose& parent) {
  const Vector3 across =
      (parent.orientation * hinge.of_parent.core).cross(child.orientation * hinge.of_child.core);
  const double length = across.norm();
  return length > 1e-9 ? Vector3(across / length)
                       : Vector3(parent.orientation * hinge.of_parent.axis);
}

const Hinge* hinge_between(const Figure& figure, BodyPair parts) {
  const std::int32_t child = std::max(parts.a, parts.b);
  const std::int32_t parent = std::min(parts.a, parts.b);
  if (!figure.has_part(child) || !figure.has_part(parent) || child == figure.first_part) {
    return nullptr;
  }
  const Hinge& hinge = figure.hinges[static_cast<std::size_t>(child - figure.first_part) - 1];
  return hinge.parent == parent ? &hinge : nullptr;
}

void add_folds(const Figure& figure, std::span<const double> rest_openings,
               const std::vector<BodyState>& states, std::vector<Contact>& folds) {
  for (std::size_t i = 0; i < figure.hinges.size(); ++i) {
    const Hinge& hinge = figure.hinges[i];
    if (!std::isfinite(hinge.fold_rad)) {
      continue;
    }
    const Pose& child = pose_of(hinge.child, states);
    const Pose& parent = pose_of(hinge.parent, states);
    const double beyond_rad = rest_openings[i] - hinge.fold_rad - opening_of(hinge, child, parent);
    if (!(beyond_rad > 0.0)) {
      continue;
    }
    Contact fold;
    fold.bodies = {hinge.parent, hinge.child};
    fold.touch.point = child.transform(hinge.of_child.anchor);
    const Vector3 apart = parent.position - child.position;
    fold.touch.normal =
        apart.norm() > 0.0 ? Vector3(apart.normalized()) : Vector3(Vector3::UnitX());
    fold.touch.depth_m =
        beyond_rad * std::min(hinge.of_child.anchor.norm(), hinge.of_parent.anchor.norm());
    folds.push_back(fold);
  }
}

void HingedBodies::gather(const std::vector<Contact>& contacts, const std::vector<HingeStop>& stops,
                          double least_share, const std::vector<BodyModel>& models,
                          const std::vector<BodyState>& states, const FiguresInMotion& figures) {
  least_share_ = least_share;
  models_ = &models;
  figures_ = figures;
  moving_.clear();
  slot_of_body_.assign(models.size(), kNone);
  place_moves_.clear();
  rows_.clear();
  changes_.clear();
  for (const Contact& contact : contacts) {
    Row row;
    const std::int32_t figure =
        is_wall(contact.bodies.b) ? -1 : figures.figure_of[at(contact.bodies.a)];
    const Hinge* hinge =
        figure < 0 ? nullptr : hinge_between(figures.figures[at(figure)], contact.bodies);
    if (hinge != nullptr) {
      row.turns = true;
      row.a.slot = slot_of(hinge->child, states);
      row.b.slot = slot_of(hinge->parent, states);
      row.normal =
          opening_axis(*hinge, states[at(hinge->child)].pose, states[at(hinge->parent)].pose);
    } else {
      row.normal = contact.touch.normal;
      row.a = side_at(contact.bodies.a, contact.touch.point, states);
      row.b = side_at(contact.bodies.b, contact.touch.point, states);
    }
    add_row(row);
  }
  for (const HingeStop& stop : stops) {
    const Hinge& hinge = figures.figures[stop.figure].hinges[stop.hinge];
    Row row;
    row.turns = true;
    row.normal = stop.axis;
    row.allowed = stop.allowed_rad_s;
    row.a.slot = slot_of(hinge.child, states);
    row.b.slot = slot_of(hinge.parent, states);
    add_row(row);
  }
}

void HingedBodies::add_row(Row row) {
  row.places.a = row.a.slot == kNone ? kNone : moving_[at(row.a.slot)].place;
  row.places.b = row.b.slot == kNone ? kNone : moving_[at(row.b.slot)].place;
  rows_.push_back(row);
}

HingedBodies::Side HingedBodies::side_at(std::int32_t body, const Vector3& point,
                                         const std::vector<BodyState>& states) {
  if (is_wall(body)) {
    return {};
  }
  return {slot_of(body, states), point - states[at(body)].pose.position};
}

std::int32_t HingedBodies::slot_of(std::int32_t body, const std::vector<BodyState>& states) {
  if (slot_of_body_[at(body)] == kNone) {
    const std::int32_t figure = figures_.figure_of[at(body)];
    if (figure >= 0) {
      add_figure(figure, states);
    } else {
      const bool moved = (*models_)[at(body)].inverse_mass > 0.0;
      place_moves_.push_back(moved ? 1 : 0);
      add_slot(at(body), static_cast<std::int32_t>(place_moves_.size()) - 1, moved, states);
    }
  }
  return slot_of_body_[at(body)];
}

void HingedBodies::add_figure(std::int32_t figure, const std::vector<BodyState>& states) {
  const Figure& own = figures_.figures[at(figure)];
  const bool free = !own.driven;
  place_moves_.push_back(free ? 1 : 0);
  if (free) {
    figures_.motions[at(figure)].look_at(
        std::span(states).subspan(at(own.first_part), at(own.part_count)));
  }
  for (std::int32_t part = 0; part < own.part_count; ++part) {
    const std::size_t body = at(own.first_part + part);
    add_slot(body, static_cast<std::int32_t>(place_moves_.size()) - 1,
             free && (*models_)[body].inverse_mass > 0.0, states);
  }
}

std::int32_t HingedBodies::add_slot(std::size_t body, std::int32_t place, bool moved,
                                    const std::vector<BodyState>& states) {
  const auto slot = static_cast<std::int32_t>(moving_.size());
  slot_of_body_[body] = slot;
  Moving added;
  added.index = body;
  added.place = place;
  added.moved = moved;
  added.inverse_mass = (*models_)[body].inverse_mass;
  added.inverse_inertia = world_inverse_inertia((*models_)[body], states[body]);
  follow(added, states[body]);
  added.speed_m_s = added.velocity.norm();
  added.spin_rad_s = added.spin.norm();
  moving_.push_back(added);
  return slot;
}

void HingedBodies::follow(Moving& body, const BodyState& state) {
  body.velocity = body.inverse_mass * state.linear_momentum;
  body.spin = body.inverse_inertia * state.angular_momentum;
}

double HingedBodies::speed_along(const Row& row, const Side& side) const {
  if (side.slot == kNone) {
    return 0.0;
  }
  const Moving& body = moving_[at(side.slot)];
  return row.turns ? row.normal.dot(body.spin)
                   : row.normal.dot(body.velocity + body.spin.cross(side.arm));
}

double HingedBodies::separation_speed(std::size_t row) const {
  const Row& own = rows_[row];
  return speed_along(own, own.a) - speed_along(own, own.b) + own.allowed;
}

double HingedBodies::incoming_speed(std::size_t row) const {
  const Row& own = rows_[row];
  double speed = 0.0;
  for (const Side* side : {&own.a, &own.b}) {
    if (side->slot != kNone) {
      const Moving& body = moving_[at(side->slot)];
      speed += own.turns ? body.spin_rad_s : body.speed_m_s + body.spin_rad_s * side->arm.norm();
    }
  }
  return speed;
}

PartImpulse HingedBodies::unit_impulse(const Row& row, const Side& side, double sign) const {
  const Vector3 impulse = sign * row.normal;
  return row.turns ? PartImpulse{Vector3::Zero(), impulse}
                   : PartImpulse{impulse, side.arm.cross(impulse)};
}

double HingedBodies::give(std::size_t row) {
  Row& own = rows_[row];
  if (own.first_change < 0) {
    find_changes(own);
  }
  double give = 0.0;
  for (std::int64_t i = 0; i < own.change_count; ++i) {
    const Change& change = changes_[static_cast<std::size_t>(own.first_change + i)];
    give += change.slot == own.a.slot ? moved_by(own, own.a, change.impulse) : 0.0;
    give -= change.slot == own.b.slot ? moved_by(own, own.b, change.impulse) : 0.0;
  }
  return give > least_share_ * give_alone(own) ? give : 0.0;
}

double HingedBodies::moved_by(const Row& row, const Side& side, const PartImpulse& own) const {
  const Moving& body = moving_[at(side.slot)];
  const Vector3 spin = body.inverse_inertia * own.angular;
  return row.turns ? row.normal.dot(spin)
                   : row.normal.dot(body.inverse_mass * own.linear + spin.cross(side.arm));
}

double HingedBodies::give_alone(const Row& row) const {
  double give = 0.0;
  for (const Side* side : {&row.a, &row.b}) {
    if (side->slot != kNone && moving_[at(side->slot)].moved) {
      give += moved_by(row, *side, unit_impulse(row, *side, 1.0));
    }
  }
  return give;
}

void HingedBodies::find_changes(Row& row) {
  row.first_change = static_cast<std::int64_t>(changes_.size());
  const auto figure_at = [&](const Side& side) {
    return side.slot == kNone || !moving_[at(side.slot)].moved
               ? -1
               : figures_.figure_of[moving_[at(side.slot)].index];
  };
  const std::int32_t figure_a = figure_at(row.a);
  const std::int32_t figure_b = figure_at(row.b);
  for (const auto& [side, figure, sign] :
       {std::tuple(&row.a, figure_a, 1.0), std::tuple(&row.b, figure_b, -1.0)}) {
    const bool moved = side->slot != kNone && moving_[at(side->slot)].moved;
    if (moved && figure < 0) {
      changes_.push_back({side->slot, unit_impulse(row, *side, sign)});
    }
  }
  if (figure_a >= 0) {
    add_changes_of_figure(row, figure_a);
  }
  if (figure_b >= 0 && figure_b != figure_a) {
    add_changes_of_figure(row, figure_b);
  }
  row.change_count = static_cast<std::int64_t>(changes_.size()) - row.first_change;
}

void HingedBodies::add_changes_of_figure(const Row& row, std::int32_t figure) {
  const Figure& own = figures_.figures[at(figure)];
  impulses_.assign(at(own.part_count), PartImpulse{});
  for (const auto& [side, sign] : {std::pair(&row.a, 1.0), std::pair(&row.b, -1.0)}) {
    if (side->slot != kNone) {
      const auto body = static_cast<std::int32_t>(moving_[at(side->slot)].index);
      if (own.has_part(body)) {
        const PartImpulse unit = unit_impulse(row, *side, sign);
        PartImpulse& part = impulses_[at(body - own.first_part)];
        part.linear += unit.linear;
        part.angular += unit.angular;
      }
    }
  }
  figures_.motions[at(figure)].add_hinge_impulses(impulses_);
  for (std::int32_t part = 0; part < own.part_count; ++part) {
    const std::int32_t slot = slot_of_body_[at(own.first_part + part)];
    if (moving_[at(slot)].moved) {
      changes_.push_back({slot, impulses_[at(part)]});
    }
  }
}

void HingedBodies::push(std::size_t row, double impulse, std::vector<BodyState>& states) {
  const Row& own = rows_[row];
  for (std::int64_t i = 0; i < own.change_count; ++i) {
    const Change& change = changes_[static_cast<std::size_t>(own.first_change + i)];
    Moving& body = moving_[at(change.slot)];
    BodyState& state = states[body.index];
    state.linear_momentum += impulse * change.impulse.linear;
    state.angular_momentum += impulse * change.impulse.angular;
    follow(body, state);
  }
}

const ResponseResult& HingedResponder::respond(const std::vector<Contact>& contacts,
                                               const std::vector<HingeStop>& stops,
                                               const std::vector<double>& restitutions,
                                               const ResponseRules& rules,
                                               const std::vector<BodyModel>& models,
                                               const FiguresInMotion& figures,
                                               std::vector<BodyState>& states) {
  bodies_.gather(contacts, stops, rules.least_share_of_give, models, states, figures);
  const std::size_t count = bodies_.contact_count();
  restitutions_.assign(restitutions.begin(), restitutions.end());
  restitutions_.resize(count, 0.0);
  note_incoming(bodies_, contacts.size(), result_);
  all_.resize(count);
  std::iota(all_.begin(), all_.end(), std::size_t{0});
  in_turn_.look_at(bodies_);
  if (!in_turn_.respond(all_, restitutions_, rules, bodies_, states, result_.impulse_Ns)) {
    in_turn_.finish(restitutions_, rules, bodies_, states, result_.impulse_Ns);
  }
  note_residual(bodies_, result_);
  result_.impulse_Ns.resize(contacts.size());
  return result_;
}

}  // namespace impetus::inline figures
