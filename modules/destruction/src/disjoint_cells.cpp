// SPDX-License-Identifier: MIT
#include "modules/destruction/src/fracture_cells.h"

namespace jostle::modules::destruction_detail {

using namespace physics;

namespace {

constexpr double sliver_share = 1e-9;   // of the volume
constexpr double overlap_share = 1e-7;  // of the size: cells with less overlap only touch

// Returns true if a face plane of the first cell separates it from the second.
bool are_apart(const ConvexCell& a, const ConvexCell& b, double slack) {
    for (const CellFace& face : a.faces) {
        const double offset = dot(face.normal, face.points[0]) - slack;
        bool beyond = true;
        for (const CellFace& other : b.faces)
            for (const Vec3 p : other.points) beyond = beyond && dot(face.normal, p) >= offset;
        if (beyond) return true;
    }
    return false;
}

// Adds the part of a cell outside another one: for each face of the other, cuts off the part
// beyond.
void add_outside(std::vector<ConvexCell>& to, const ConvexCell& cell, const ConvexCell& taken,
                 double size) {
    if (are_apart(taken, cell, overlap_share * size) ||
        are_apart(cell, taken, overlap_share * size)) {
        to.push_back(cell);
        return;
    }
    ConvexCell rest = cell;
    for (const CellFace& face : taken.faces) {
        if (rest.empty()) return;
        const double offset = dot(face.normal, face.points[0]);
        ConvexCell out =
            clipped(rest, -face.normal, -offset, outer_face, plane_tolerance_ratio * size);
        if (!out.empty()) to.push_back(std::move(out));
        rest = clipped(rest, face.normal, offset, outer_face, plane_tolerance_ratio * size);
    }
}

}  // namespace

std::vector<ConvexCell> disjoint_cells(std::span<const std::shared_ptr<const ConvexHull>> hulls) {
    std::vector<ConvexCell> hull_cells, cells;
    double volume = 0, size = 0;
    for (const auto& hull : hulls) {
        hull_cells.push_back(cell_of(*hull));
        volume += hull->volume;
        size = maximum(size, square_root(furthest_squared(hull_cells.back(),
                                                          hull_cells[0].faces[0].points[0])));
    }
    for (std::size_t k = 0; k < hull_cells.size(); k++) {
        std::vector<ConvexCell> left = {hull_cells[k]};
        for (std::size_t i = 0; i < k; i++) {
            std::vector<ConvexCell> next;
            for (const ConvexCell& cell : left) add_outside(next, cell, hull_cells[i], size);
            left = std::move(next);
        }
        for (ConvexCell& cell : left)
            if (k == 0 || left.size() == 1 || mass_of(cell).volume > sliver_share * volume)
                cells.push_back(std::move(cell));
    }
    return cells;
}

}  // namespace jostle::modules::destruction_detail
