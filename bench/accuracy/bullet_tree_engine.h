// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "bench/accuracy/accuracy_engine.h"

namespace jostle::bench::accuracy {

// Bullet's multibody world: jointed bodies as one tree in joint coordinates (Featherstone's
// algorithm); a joint that closes a loop is a point constraint. Modes: mb, mb-rk4. Contacts,
// springs and bodies without joints are not supported.
std::unique_ptr<Engine> make_bullet_tree_engine();

}  // namespace jostle::bench::accuracy
