// SPDX-License-Identifier: MIT
//
// Simulated network conditions for tests and demonstrations: ClientOptions::network_conditions. The
// server uses the same simulator (jostle/base/network_simulator.h).
#pragma once

#include "jostle/base/network_simulator.h"

namespace jostle::client {

using jostle::NetworkConditions;
using jostle::NetworkSimulator;
using jostle::parse_network_conditions;

}  // namespace jostle::client
