// SPDX-License-Identifier: MIT
//
// The solver's calls report errors as all of Jostle does.
#pragma once

#include "jostle/base/result.h"

namespace jostle::physics {

using jostle::Error;
using jostle::ErrorCode;
using jostle::Result;
using jostle::Status;

}  // namespace jostle::physics
