// SPDX-License-Identifier: MIT
//
// What a joint of the world keeps from step to step, as the direct solver of joint groups takes it,
// and back. A group that touches down goes on from what it bore, and the other way round.
#pragma once

#include "physics/src/constraints/direct/direct_joint.h"
#include "physics/src/state/joint_store.h"

namespace jostle::physics {

// `carried`: the rotation of the body with which impulses turn.
WarmStartCache read_warm_start(const Joint& from, Quat carried);
void write_warm_start(Joint& to, Quat carried, const WarmStartCache& cache);

}  // namespace jostle::physics
