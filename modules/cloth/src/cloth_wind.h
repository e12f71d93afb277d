// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "jostle/physics/force_fields.h"
#include "modules/cloth/src/sheet.h"

namespace jostle::modules::cloth_detail {

// Sets the accelerations of a sheet by the pressure of wind on its faces, density / 2 * drag * area
// * |u_n| u_n along the normal n, where u_n is the wind relative to the face along n. The change of
// speed in dt is implicit, so any wind is stable. Returns whether a wind acts.
bool blow(Sheet& sheet, std::span<const physics::FieldDef> fields, double drag,
          double mass_per_area, double time, double dt);

}  // namespace jostle::modules::cloth_detail
