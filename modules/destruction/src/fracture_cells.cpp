// SPDX-License-Identifier: MIT
#include "modules/destruction/src/fracture_cells.h"

#include <algorithm>
#include <string>
#include <utility>

namespace jostle::modules::destruction_detail {

using namespace physics;

namespace {

// Relative to the square of the size: smaller faces create no bond.
constexpr double face_area_share_min = 1e-8;
// Relative to the mean volume: smaller remainders at boundaries between parts are omitted.
constexpr double splinter_share = 1e-6;
constexpr std::size_t seeds_per_progress_call = 50;

// Removes points that are nearer than `distance` to an earlier point.
std::vector<Vec3> welded(std::span<const Vec3> points, double distance) {
    std::vector<Vec3> distinct;
    for (const Vec3 p : points)
        if (std::none_of(distinct.begin(), distinct.end(),
                         [&](Vec3 q) { return length_squared(p - q) <= distance * distance; }))
            distinct.push_back(p);
    return distinct;
}

// Planes that intersect at a grazing angle create corners too close together to determine the faces
// of a hull. Corners within a small distance are welded. The mass remains that of the cell.
Result<std::shared_ptr<const ConvexHull>> hull_of(const ConvexCell& cell) {
    std::vector<Vec3> points;
    for (const CellFace& face : cell.faces)
        points.insert(points.end(), face.points.begin(), face.points.end());
    auto hull = build_hull(points);
    const double size = square_root(furthest_squared(cell, points[0]));
    for (const double share : {1e-6, 1e-5, 1e-4, 1e-3})
        if (!hull.ok()) hull = build_hull(welded(points, share * size));
    return hull;
}

Result<FractureChunk> chunk_of(const ConvexCell& cell, const CellMass& mass) {
    auto hull = hull_of(cell);
    if (!hull.ok()) return hull.error();
    return FractureChunk{.geometry = Hull{*hull},
                         .center = mass.center,
                         .volume = mass.volume,
                         .unit_inertia = mass.inertia};
}

// Bond through a flat face of a towards b.
FractureBond bond_of(std::span<const Vec3> points, Vec3 normal, std::uint32_t a, std::uint32_t b) {
    const Section s = section_of(points, normal);
    return {a, b, s.center, normal, s.axis, s.area, s.moment_u, s.moment_v, s.reach_u, s.reach_v};
}

// A cell that became a chunk, with the indices of its seed and part.
struct Cut {
    std::uint32_t seed = 0, part = 0;
    ConvexCell cell;
    Aabb bounds;
};

// Chunks are sorted by seed and part.
std::uint32_t chunk_at(std::span<const Cut> cuts, std::uint32_t seed, std::uint32_t part) {
    const auto found = std::lower_bound(
        cuts.begin(), cuts.end(), std::pair(seed, part),
        [](const Cut& cut, const auto& key) { return std::pair(cut.seed, cut.part) < key; });
    return found != cuts.end() && found->seed == seed && found->part == part
               ? static_cast<std::uint32_t>(found - cuts.begin())
               : outer_face;
}

// Bonds within a part: each face stores the cell on its other side.
void bond_within(FracturedShape& shape, std::span<const Cut> cuts, double area_min) {
    for (std::uint32_t a = 0; a < cuts.size(); a++)
        for (const CellFace& face : cuts[a].cell.faces) {
            if (face.neighbour == outer_face) continue;
            const std::uint32_t b = chunk_at(cuts, face.neighbour, cuts[a].part);
            if (b == outer_face || b < a) continue;
            const FractureBond bond = bond_of(face.points, face.normal, a, b);
            if (bond.area > area_min) shape.bonds.push_back(bond);
        }
}

// Bonds between parts, where outer faces are in contact. Finds pairs of boxes by a sweep along x.
void bond_across(FracturedShape& shape, std::span<const Cut> cuts, double size, double area_min) {
    const double near = face_contact_tolerance_ratio * size;
    std::vector<std::uint32_t> order(cuts.size());
    for (std::uint32_t k = 0; k < order.size(); k++) order[k] = k;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(cuts[a].bounds.low.x, a) < std::pair(cuts[b].bounds.low.x, b);
    });
    const std::size_t before = shape.bonds.size();
    for (std::size_t i = 0; i < order.size(); i++)
        for (std::size_t j = i + 1; j < order.size(); j++) {
            const std::uint32_t a = std::min(order[i], order[j]), b = std::max(order[i], order[j]);
            if (cuts[order[j]].bounds.low.x > cuts[order[i]].bounds.high.x + near) break;
            if (cuts[a].part == cuts[b].part || !are_near(cuts[a].bounds, cuts[b].bounds, near))
                continue;
            for (const FaceContact& contact : face_contacts(cuts[a].cell, cuts[b].cell, near)) {
                const FractureBond bond = bond_of(contact.points, contact.normal, a, b);
                if (bond.area > area_min) shape.bonds.push_back(bond);
            }
        }
    std::stable_sort(shape.bonds.begin() + static_cast<std::ptrdiff_t>(before), shape.bonds.end(),
                     [](const FractureBond& x, const FractureBond& y) {
                         return std::pair(x.a, x.b) < std::pair(y.a, y.b);
                     });
}

Aabb bounds_of(std::span<const ConvexCell> parts) {
    Aabb bounds = bounds_of(parts[0]);
    for (const ConvexCell& part : parts) {
        const Aabb own = bounds_of(part);
        bounds = {min(bounds.low, own.low), max(bounds.high, own.high)};
    }
    return bounds;
}

// Cuts parts by the Voronoi cells of all seeds in a box around all parts, so that cells in
// different parts end at the same planes.
class Cutter {
public:
    Cutter(std::span<const ConvexCell> parts, std::span<const Vec3> seeds)
        : parts_(parts), seeds_(seeds), bounds_(bounds_of(parts)) {
        const Vec3 half = (bounds_.high - bounds_.low) * 0.5;
        size_ = square_root(length_squared(half));
        const Vec3 middle = (bounds_.high + bounds_.low) * 0.5;
        around_ = cell_of_box(half * 1.01);
        for (CellFace& face : around_.faces)
            for (Vec3& p : face.points) p += middle;
        for (const ConvexCell& part : parts) part_bounds_.push_back(bounds_of(part));
    }
    double size() const { return size_; }
    double mean_volume() const {
        double volume = 0;
        for (const ConvexCell& part : parts_) volume += mass_of(part).volume;
        return volume / static_cast<double>(seeds_.size());
    }

    // The parts of a seed's cell.
    std::vector<Cut> cut(std::uint32_t seed) const {
        std::vector<Cut> cuts;
        if (parts_.size() == 1) {
            add(cuts, seed, 0, voronoi_cell(parts_[0], seeds_, seed, plane_tolerance()));
            return cuts;
        }
        const ConvexCell own = voronoi_cell(around_, seeds_, seed, plane_tolerance());
        if (own.empty()) return cuts;
        const Aabb reach = bounds_of(own);
        for (std::uint32_t p = 0; p < parts_.size(); p++) {
            if (!are_near(part_bounds_[p], reach, 0)) continue;
            ConvexCell cell = parts_[p];
            for (const CellFace& face : own.faces)
                if (face.neighbour != outer_face && !cell.empty())
                    cell = clip_by_bisector(cell, seeds_, seed, face.neighbour, plane_tolerance());
            add(cuts, seed, p, std::move(cell));
        }
        return cuts;
    }

private:
    double plane_tolerance() const { return plane_tolerance_ratio * size_; }
    static void add(std::vector<Cut>& cuts, std::uint32_t seed, std::uint32_t part,
                    ConvexCell cell) {
        if (cell.empty()) return;
        const Aabb bounds = bounds_of(cell);
        cuts.push_back({seed, part, std::move(cell), bounds});
    }

    std::span<const ConvexCell> parts_;
    std::span<const Vec3> seeds_;
    std::vector<Aabb> part_bounds_;
    Aabb bounds_;
    ConvexCell around_;
    double size_ = 0;
};

}  // namespace

Result<FractureResult> fracture_cells(std::span<const ConvexCell> parts,
                                      std::span<const Vec3> seeds,
                                      const FractureProgress& progress) {
    if (Status s = check_seeds(seeds); !s.ok()) return s.error();
    const Cutter cutter(parts, seeds);
    FractureResult made;
    std::vector<Cut> cuts;
    const double least_volume = parts.size() == 1 ? 0 : splinter_share * cutter.mean_volume();
    for (std::uint32_t seed = 0; seed < seeds.size(); seed++) {
        if (progress && seed % seeds_per_progress_call == 0) progress(seed, seeds.size());
        for (Cut& cut : cutter.cut(seed)) {
            const CellMass mass = mass_of(cut.cell);
            if (!(mass.volume > 0)) continue;
            made.volume += mass.volume;
            Result<FractureChunk> chunk = chunk_of(cut.cell, mass);
            if (!chunk.ok() && parts.size() == 1)
                return invalid_argument("seeds[" + std::to_string(seed) +
                                        "]: the chunk is too thin: " + chunk.error().message);
            if (!chunk.ok() || mass.volume < least_volume) {
                made.lost_volume += mass.volume;
                continue;
            }
            if (cuts.size() == chunks_max)
                return invalid_argument("the result has more than " + std::to_string(chunks_max) +
                                        " chunks; use fewer seeds or parts");
            made.shape.chunks.push_back(std::move(*chunk));
            cuts.push_back(std::move(cut));
        }
    }
    const double area_min = face_area_share_min * cutter.size() * cutter.size();
    bond_within(made.shape, cuts, area_min);
    if (parts.size() > 1) bond_across(made.shape, cuts, cutter.size(), area_min);
    if (progress) progress(seeds.size(), seeds.size());
    return made;
}

Result<FracturedShape> fracture_cell(const ConvexCell& solid, std::span<const Vec3> seeds) {
    Result<FractureResult> made = fracture_cells(std::span(&solid, 1), seeds, {});
    if (!made.ok()) return made.error();
    return std::move(made->shape);
}

}  // namespace jostle::modules::destruction_detail
