// SPDX-License-Identifier: MIT
#pragma once

namespace jostle::modules::cloth_detail {

// A vertex of a sheet. Displacements are apart from positions, so that velocities and momentum are
// not rounded to the precision of positions.
struct alignas(32) SheetNode {
    float x = 0, y = 0, z = 0;  // m, relative to the sheet's root, at the start of the sub-step
    float inverse_mass = 0;     // 1/kg
    float moved_x = 0, moved_y = 0, moved_z = 0;  // m, in the sub-step
    float unused = 0;
};

}  // namespace jostle::modules::cloth_detail
