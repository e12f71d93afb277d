// SPDX-License-Identifier: MIT
//
// The load that eight joints exerted on their bodies b in one pass, world axes.
#pragma once

#include "physics/src/constraints/contact_kernel.h"

namespace jostle::physics::JOSTLE_ISA {

struct JointLoad {
    Wide3 impulse;  // N s
    Wide3 angular;  // N m s
};

}  // namespace jostle::physics::JOSTLE_ISA
