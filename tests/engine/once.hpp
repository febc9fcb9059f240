// What the engine does step after step in memory that it keeps, done once: with what comes in, and
// what comes out returned.
// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "engine/collision/budgeted_refinement.hpp"
#include "engine/collision/contact_model.hpp"
#include "engine/collision/torque_span.hpp"
#include "engine/dynamics/nearest_velocities.hpp"
#include "engine/dynamics/responder.hpp"
#include "engine/dynamics/stop_at_entry.hpp"

namespace impetus {

/// See ContactModelling::add_pair_contacts().
inline std::vector<Contact> pair_contacts(BodyPair bodies, const PairRefinement& pair,
                                          const MovingTree& a, const MovingTree& b,
                                          const NormalFallbacks& fallbacks,
                                          const ContactModel& model) {
  std::vector<Contact> contacts;
  ContactModelling().add_pair_contacts(bodies, pair, a, b, fallbacks, model, contacts);
  return contacts;
}

/// See ContactModelling::add_wall_contacts().
inline std::vector<Contact> wall_contacts(std::int32_t body, const PairRefinement& pair,
                                          const MovingTree& a, const Enclosure& walls,
                                          const ContactModel& model) {
  std::vector<Contact> contacts;
  ContactModelling().add_wall_contacts(body, pair, a, walls, model, contacts);
  return contacts;
}

/// See TorqueSpan::keep_widest().
inline std::vector<TouchPoint> spanning_most_torque(std::vector<TouchPoint> contacts, int most,
                                                    double size_m) {
  TorqueSpan().keep_widest(contacts, most, size_m);
  return contacts;
}

/// See WorkSharing, of pairs that come in their order.
inline WorkDone refine_by_lists(std::span<RefinedPair> pairs,
                                const std::vector<PriorityList>& lists, WorkMeter& meter,
                                const RefinementSettings& settings = {}) {
  WorkSharing refinement;
  refinement.do_floor(pairs, lists, settings);
  std::vector<std::size_t> as_they_come(pairs.size());
  std::iota(as_they_come.begin(), as_they_come.end(), std::size_t{0});
  return refinement.refine(pairs, lists, as_they_come, meter, settings);
}

/// See stop_at_entry() with a memory.
inline Stopping stop_at_entry(const StepMade& step, std::vector<BodyState>& states,
                              std::vector<PlacedTree>& placed) {
  EntryMemory memory;
  return stop_at_entry(step, states, placed, memory);
}

/// Impulses in turn, as many passes as they take; see Responder.
inline ResponseResult respond(const std::vector<Contact>& contacts,
                              const std::vector<double>& restitutions,
                              const std::vector<BodyModel>& models,
                              std::vector<BodyState>& states) {
  return Responder().respond(contacts, restitutions, {}, models, states);
}

/// The same with one restitution for all.
inline ResponseResult respond(const std::vector<Contact>& contacts, double restitution,
                              const std::vector<BodyModel>& models,
                              std::vector<BodyState>& states) {
  return respond(contacts, std::vector<double>(contacts.size(), restitution), models, states);
}

/// Impulses found together; see Responder.
inline ResponseResult respond_together(const std::vector<Contact>& contacts,
                                       const std::vector<double>& restitutions,
                                       const std::vector<BodyModel>& models,
                                       std::vector<BodyState>& states) {
  ResponseRules rules;
  rules.method = ResponseMethod::kTogether;
  return Responder().respond(contacts, restitutions, rules, models, states);
}

/// The outcome of one problem, and the multipliers by row.
struct NearestVelocities {
  Projection outcome{Projection::kSolved};
  std::vector<double> multipliers;
};

/// One problem alone, of all the rows; see NearestVelocitySolver.
inline NearestVelocities project(const std::vector<ConstraintRow>& rows, std::vector<Vector6>& u,
                                 double tolerance) {
  RowColumns columns;
  std::vector<double> bounds;
  for (const ConstraintRow& row : rows) {
    RowBlock& block = columns.add_block(row.a.body, row.b.body, 1);
    for (int i = 0; i < 6; ++i) {
      std::fill_n(block.of_a[i], kRowLanes, row.a.direction[i]);
      std::fill_n(block.of_b[i], kRowLanes, row.b.direction[i]);
    }
    bounds.push_back(row.bound);
  }
  RowColumns unit;
  std::vector<double> lengths;
  unit.make_unit(columns, lengths);
  std::vector<std::size_t> all(rows.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  NearestVelocitySolver solver;
  const Projection outcome = solver.solve({unit, lengths, bounds}, all, u, tolerance);
  return {outcome, solver.multipliers()};
}

}  // namespace impetus
