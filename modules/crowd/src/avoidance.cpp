// SPDX-License-Identifier: MIT
#include "modules/crowd/src/avoidance.h"

#include <cmath>

namespace jostle::modules::crowd_detail {

// The velocity obstacle of a neighbour is a cone with a round end: the disc of radius radii / time
// around offset / time. `w` leads from the centre of that disc to the relative velocity, which is
// moved to the nearest boundary: the disc, or a tangent from the origin to it (a leg).
//
// Both cases are computed for all neighbours, in short loops without branches, which compilers
// vectorize.
void avoid_agents(const RelativeNeighbors& neighbors, float horizon, float dt, HalfPlane* planes) {
    using Row = std::array<float, neighbors_max>;
    const float per_horizon = 1 / horizon, per_step = 1 / dt;
    const std::size_t count = (neighbors.count + 3) / 4 * 4;  // the rest of the arrays is ignored
    const auto& [x, y, vx, vy, rx, ry, radii, share, unused] = neighbors;
    Row depth, rate, wx, wy, w_squared, along, w, per_w, leg, per_squared, leg_x, leg_y;
    Row normal_x, normal_y, change, overlap, back, inside, end;
    for (std::size_t k = 0; k < count; k++) {
        depth[k] = x[k] * x[k] + y[k] * y[k] - radii[k] * radii[k];
        rate[k] = depth[k] < 0 ? per_step : per_horizon;
    }
    for (std::size_t k = 0; k < count; k++) {
        wx[k] = rx[k] - x[k] * rate[k];
        wy[k] = ry[k] - y[k] * rate[k];
        w_squared[k] = wx[k] * wx[k] + wy[k] * wy[k];
        along[k] = wx[k] * x[k] + wy[k] * y[k];
        w[k] = std::sqrt(w_squared[k]);
        per_w[k] = 1 / (w[k] + 1e-20f);
        back[k] = along[k] < 0 ? 1.f : 0.f;
        leg[k] = depth[k] < 0 ? 0.f : depth[k];
        per_squared[k] = 1 / (x[k] * x[k] + y[k] * y[k] + 1e-20f);
    }
    for (std::size_t k = 0; k < count; k++) {
        const float far = along[k] * along[k] - radii[k] * radii[k] * w_squared[k];
        inside[k] = far > 0 ? 1.f : 0.f;
        overlap[k] = depth[k] < 0 ? 1.f : 0.f;
    }
    for (std::size_t k = 0; k < count; k++) {
        // 1 at the round end: the agents overlap, or w points back within the half angle.
        end[k] = overlap[k] + (1 - overlap[k]) * back[k] * inside[k];
        leg[k] = std::copysign(std::sqrt(leg[k]), x[k] * wy[k] - y[k] * wx[k]);  // on the side of w
        leg_x[k] = (-x[k] * radii[k] - y[k] * leg[k]) * per_squared[k];
        leg_y[k] = (-y[k] * radii[k] + x[k] * leg[k]) * per_squared[k];
    }
    for (std::size_t k = 0; k < count; k++) {
        normal_x[k] = end[k] * (wx[k] * per_w[k]) + (1 - end[k]) * leg_x[k];
        normal_y[k] = end[k] * (wy[k] * per_w[k]) + (1 - end[k]) * leg_y[k];
        const float leg_change = -(leg_x[k] * rx[k] + leg_y[k] * ry[k]);
        change[k] = end[k] * (radii[k] * rate[k] - w[k]) + (1 - end[k]) * leg_change;
        change[k] = normal_x[k] * vx[k] + normal_y[k] * vy[k] + share[k] * change[k];
    }
    for (std::size_t k = 0; k < neighbors.count; k++)
        planes[k] = {normal_x[k], normal_y[k], change[k]};
}

HalfPlane avoid_wall(float x, float y, float distance, float radius, float horizon, float dt) {
    const float gap = distance - radius, scale = -1 / distance;
    return {x * scale, y * scale, -gap / (gap > 0 ? horizon : dt)};
}

}  // namespace jostle::modules::crowd_detail
