// SPDX-License-Identifier: MIT
//
// One integrator in one field at one rate.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/integrators/integrator_kinds.h"

namespace jostle::bench::integrators {

struct IntegratorRow {
    std::string field, method;
    double rate_hz = 0;
    double error = 0;                    // m: RMS distance from the truth over all steps
    std::optional<double> order;         // from the rate before this one
    std::optional<double> energy_drift;  // largest, over the energy at the start
    double ns_per_step = 0;              // processor time
};

// Rates ascending. A motion that leaves 1e6 m ends there; its error is what it is by then.
std::vector<IntegratorRow> integrator_rows(const ParticleField& field, const IntegratorKind& kind,
                                           const std::vector<double>& rates);

nlohmann::ordered_json to_json(const IntegratorRow& row);

}  // namespace jostle::bench::integrators
