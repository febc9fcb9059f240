// The oracle of the response: its methods as they read, without a memory of what has not changed
// and without arrays that outlive a step. engine/dynamics must give the same bits.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "engine/dynamics/nearest_velocities.hpp"
#include "tests/engine/once.hpp"

namespace impetus::plain {

double separation_speed(const Contact& contact, const std::vector<BodyModel>& models,
                        const std::vector<BodyState>& states);
ResponseResult incoming(const std::vector<Contact>& contacts, const std::vector<BodyModel>& models,
                        const std::vector<BodyState>& states);
void measure_residual(const std::vector<Contact>& contacts, const std::vector<BodyModel>& models,
                      const std::vector<BodyState>& states, ResponseResult& result);
void respond_in_turn(const std::vector<Contact>& contacts, const std::vector<std::size_t>& members,
                     const std::vector<double>& restitutions, const std::vector<BodyModel>& models,
                     std::vector<BodyState>& states, std::vector<double>& impulse_Ns);
ResponseResult respond(const std::vector<Contact>& contacts,
                       const std::vector<double>& restitutions,
                       const std::vector<BodyModel>& models, std::vector<BodyState>& states);
ResponseResult respond_together(const std::vector<Contact>& contacts,
                                const std::vector<double>& restitutions,
                                const std::vector<BodyModel>& models,
                                std::vector<BodyState>& states);
std::vector<std::vector<std::size_t>> islands_of(const std::vector<Contact>& contacts,
                                                 const std::vector<BodyModel>& models);
NearestVelocities project(const std::vector<ConstraintRow>& rows, std::vector<Vector6>& u,
                          double tolerance);

}  // namespace impetus::plain
