// SPDX-License-Identifier: MIT
//
// Water forces on one body in one sub-step: pressure on submerged panels, drag, and wave-making
// loss.
#pragma once

#include <vector>

#include "jostle/modules/waves.h"
#include "modules/fields/src/load.h"
#include "modules/fields/src/wave_train.h"

namespace jostle::modules::fields_detail {

// Memory that is reused from body to body.
struct WaterScratch {
    struct Wet {
        physics::Vec3 area;  // m^2, outward
        physics::Vec3 arm;   // m, its centroid relative to the centre of mass
    };
    std::vector<physics::Vec3> arms;  // m, vertices of a surface relative to the centre of mass
    WaveTrain::Pressure pressure;     // at these vertices
    std::vector<Wet> wet;
    double wet_balls = 0;  // m^2, disc area of the submerged balls
};

// `train` holds these waves at the middle of the sub-step. Does nothing if gravity is not
// downwards.
void apply_water_forces(const Waves& waves, const WaveTrain& train, Load& load,
                        WaterScratch& scratch);

}  // namespace jostle::modules::fields_detail
