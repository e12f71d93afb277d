// SPDX-License-Identifier: MIT
//
// A bad link, for tests and demonstrations: ClientOptions::link. What it is made of is shared with
// the server (jostle/base/network_simulator.h).
#pragma once

#include "jostle/base/network_simulator.h"

namespace jostle::client {

using jostle::NetworkConditions;
using jostle::NetworkSimulator;
using jostle::parse_network_conditions;

}  // namespace jostle::client
