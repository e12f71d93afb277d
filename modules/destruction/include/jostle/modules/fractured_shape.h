// SPDX-License-Identifier: MIT
//
// A solid that was cut into convex chunks before anything happens, and what holds them together:
// made offline, or once at the start, and given to Destruction::add().
//
//     FracturedShape wall = fracture_box({3, 1.5, 0.15}, random_seeds({3, 1.5, 0.15}, 200, 7));
//     anchor(wall, {0, -1, 0}, 1.45);   // the chunks at its foot
//
// Thread rule: any thread; plain data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "jostle/physics/geometry.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mat3.h"
#include "jostle/physics/result.h"
#include "jostle/physics/transform.h"

namespace jostle::modules {

inline constexpr std::size_t chunks_max = 20000;
inline constexpr std::size_t fracture_parts_max = 1024;

// Places are in the frame of the whole.
struct FractureChunk {
    physics::Geometry geometry = {};
    physics::Transform pose = {};                               // of the geometry
    physics::Vec3 center = {};                                  // of mass
    double volume = 0;                                          // m^3
    physics::Mat3 unit_inertia = physics::diagonal({0, 0, 0});  // about `center`, density 1, m^5
    bool anchored = false;  // held by the ground: what hangs together with it does not move
};

// The face that two chunks share, as the section of a beam.
struct FractureBond {
    std::uint32_t a = 0, b = 0;         // chunks, a < b
    physics::Vec3 center = {};          // of the face
    physics::Vec3 normal = {};          // unit, from a to b
    physics::Vec3 axis = {};            // unit, in the face: the principal axis u; v = normal x u
    double area = 0;                    // m^2
    double moment_u = 0, moment_v = 0;  // m^4: second moments about the axes u and v
    double reach_u = 0, reach_v = 0;    // m: furthest that the face reaches from the axes u and v
};

struct FracturedShape {
    std::vector<FractureChunk> chunks = {};
    std::vector<FractureBond> bonds = {};
};

// One chunk for each seed: what of the hull lies nearer to it than to any other (Voronoi). Seeds:
// 1 to chunks_max, none twice; one whose cell is empty leaves no chunk. An error names the seed.
physics::Result<FracturedShape> fracture_hull(const physics::ConvexHull& hull,
                                              std::span<const physics::Vec3> seeds);
// The same of a box about the origin.
physics::Result<FracturedShape> fracture_box(physics::Vec3 half_extents,
                                             std::span<const physics::Vec3> seeds);
// For those who wait: called now and then.
using FractureProgress = std::function<void(std::size_t seeds_done, std::size_t seeds)>;

struct FractureResult {
    FracturedShape shape = {};
    double volume = 0;       // m^3, of the solid: what its parts hold, each place once
    double lost_volume = 0;  // m^3 of it in splinters, too thin for a hull or of less than a
                             // millionth of the mean volume: they are left out
};
// The same of a solid of several hulls, such as those that a mesh is decomposed into. Cells end
// where a part ends, and bonds hold them together where parts touch. Where parts overlap the first
// one has it.
physics::Result<FractureResult> fracture_parts(
    std::span<const std::shared_ptr<const physics::ConvexHull>> parts,
    std::span<const physics::Vec3> seeds, const FractureProgress& progress = {});
// A box in nx * ny * nz equal boxes, x fastest.
physics::Result<FracturedShape> split_box(physics::Vec3 half_extents, int nx, int ny, int nz);

// Points strewn evenly over a box about the origin; the same ones for the same seed.
std::vector<physics::Vec3> random_seeds(physics::Vec3 half_extents, int count, std::uint64_t seed);

// Anchors each chunk that reaches as far as dot(direction, x) >= offset. How many did.
std::size_t anchor(FracturedShape& shape, physics::Vec3 direction, double offset);

}  // namespace jostle::modules
