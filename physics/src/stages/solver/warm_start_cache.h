// SPDX-License-Identifier: MIT
//
// Converts the persistent state of a joint to the form of the direct solver of joint groups, and
// back. A group keeps its joint loads when it gets its first contact, and vice versa.
#pragma once

#include "physics/src/constraints/direct/direct_joint.h"
#include "physics/src/state/joint_store.h"

namespace jostle::physics {

// `carried`: rotation of the body that impulses rotate with.
WarmStartCache read_warm_start(const Joint& from, Quat carried);
void write_warm_start(Joint& to, Quat carried, const WarmStartCache& cache);

}  // namespace jostle::physics
