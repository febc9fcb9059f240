// The one contact that contacts and their impulses come to.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/collision/contact_model.hpp"

namespace impetus::inline dynamics {

/// The direction of the impulses' sum, unit, and their mean place; of impulses that are all zero,
/// the deepest contact. `impulse_Ns` (along each contact's normal) is as long as `contacts`, which
/// must not be empty.
TouchPoint net_contact(const std::vector<Contact>& contacts, const std::vector<double>& impulse_Ns);

}  // namespace impetus::inline dynamics
