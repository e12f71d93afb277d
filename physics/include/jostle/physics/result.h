// SPDX-License-Identifier: MIT
//
// Error reporting of the solver: the types of jostle/base/result.h.
#pragma once

#include "jostle/base/result.h"

namespace jostle::physics {

using jostle::Error;
using jostle::ErrorCode;
using jostle::Result;
using jostle::Status;

}  // namespace jostle::physics
