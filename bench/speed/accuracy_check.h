// SPDX-License-Identifier: MIT
//
// The accuracy check: measures the error of an engine's poses by geometry alone, equally for every
// engine. It measures penetration and joint drift, and is never part of a timing.
#pragma once

#include <span>
#include <vector>

#include "bench/speed/portable_scene.h"

namespace jostle::bench {

// Distance by which one of two shapes must move to separate them, m; zero or less if they do not
// overlap. Exact for all pairs of convex shapes. For meshes: the depth of the shape's deepest point
// below a triangle.
double penetration_depth(const Primitive& a, const physics::Transform& pose_a, const Primitive& b,
                         const physics::Transform& pose_b);

struct Penetration {
    double deepest = 0;  // m
    double mean = 0;     // m, over the overlapping pairs
    int pairs = 0;       // overlapping pairs
    int over_1cm = 0;    // of those
    int lost = 0;        // bodies whose pose is not finite; they are not tested
};

// Checks the poses of one portable scene. It tests each pair with at least one dynamic body; pairs
// that a joint connects are skipped, since they may overlap.
class AccuracyCheck {
public:
    explicit AccuracyCheck(const scenes::SceneDescription& scene);

    Penetration penetration(std::span<const physics::Transform> poses) const;
    // m: largest distance between the two anchors of a joint.
    double joint_drift(std::span<const physics::Transform> poses) const;

private:
    struct Ends {
        std::size_t a, b;
        physics::Vec3 in_a, in_b;  // anchors in the frames of the bodies
    };

    bool joined(std::uint32_t a, std::uint32_t b) const;

    struct Piece {
        std::uint32_t body;
        bool is_dynamic;
        Part part;
    };

    std::vector<Piece> pieces_;  // of the bodies that collide
    std::vector<Ends> ends_;
    std::vector<std::uint64_t> joined_;  // pairs with the smaller index in the upper half; sorted
};

}  // namespace jostle::bench
