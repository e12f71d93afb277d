// SPDX-License-Identifier: MIT
//
// What water does to one body in one sub-step: pressure on its wet panels, drag, and the loss to
// waves of its own.
#pragma once

#include <vector>

#include "jostle/modules/waves.h"
#include "modules/fields/src/load.h"
#include "modules/fields/src/wave_train.h"

namespace jostle::modules::fields_detail {

// Memory used again from body to body.
struct WaterScratch {
    struct Wet {
        physics::Vec3 area;  // m^2, outward
        physics::Vec3 arm;   // m: its middle from the centre of mass
    };
    std::vector<physics::Vec3> arms;  // of a surface's vertices from the centre of mass, m
    WaveTrain::Pressure pressure;     // there
    std::vector<Wet> wet;
    double wet_balls = 0;  // m^2, their discs
};

// `train`: of these waves, in the middle of the sub-step. Nothing where gravity does not pull down.
void apply_water_forces(const Waves& waves, const WaveTrain& train, Load& load,
                        WaterScratch& scratch);

}  // namespace jostle::modules::fields_detail
