// SPDX-License-Identifier: MIT
//
// Bodies and joints of QueryService.Inspect as tables.
#pragma once

#include <string>

#include "jostle/v1/query.pb.h"

namespace jostle::ctl {

std::string inspection_text(const v1::InspectResponse& response);

}  // namespace jostle::ctl
