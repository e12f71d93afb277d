// SPDX-License-Identifier: MIT
#include "modules/fields/src/blast_points.h"

#include "modules/fields/src/panel_surface.h"

namespace jostle::modules::fields_detail {

using namespace physics;

std::vector<BlastPoint> blast_points(const Geometry& geometry, const Transform& pose,
                                     std::uint32_t count) {
    std::vector<PanelSurface> surfaces = panel_surfaces(geometry, pose);
    double total_area = 0;
    for (const PanelSurface& surface : surfaces) total_area += surface.area;
    std::vector<BlastPoint> points;
    for (PanelSurface& surface : surfaces) {
        // Bisection leaves panels with between half and all of the target area.
        refine(surface, 1e30, 1.5 * total_area / count, 4 * std::size_t{count});
        for (const auto& t : surface.triangles) {
            const Vec3 corners =
                surface.vertices[t[0]] + surface.vertices[t[1]] + surface.vertices[t[2]];
            points.push_back({corners * (1.0 / 3), area_of(surface, t)});
        }
    }
    return points;
}

}  // namespace jostle::modules::fields_detail
