// SPDX-License-Identifier: MIT
//
// The integrators: five textbook methods and Jostle's own.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "bench/integrators/integrator.h"

namespace jostle::bench::integrators {

struct IntegratorKind {
    const char* name;
    const char* about;
    double order;  // of the global error in smooth fields
    std::unique_ptr<Integrator> (*make)(const ParticleField& field);
};

std::span<const IntegratorKind> integrator_kinds();
const IntegratorKind* find_integrator(std::string_view name);  // null: there is none

}  // namespace jostle::bench::integrators
