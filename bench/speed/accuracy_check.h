// SPDX-License-Identifier: MIT
//
// The accuracy check: how wrong the poses are that an engine leaves behind, by geometry alone and
// the same for every engine. Penetration and joint drift; never inside a timing.
#pragma once

#include <span>
#include <vector>

#include "bench/speed/portable_scene.h"

namespace jostle::bench {

// How far one of two shapes must move for them to touch no more, m; zero or less when they do not
// overlap. Exact for all pairs that are convex. Into a mesh: how far the deepest point towards a
// triangle is below it.
double penetration_depth(const Primitive& a, const physics::Transform& pose_a, const Primitive& b,
                         const physics::Transform& pose_b);

struct Penetration {
    double deepest = 0;  // m
    double mean = 0;     // m, of the pairs that overlap
    int pairs = 0;       // that overlap
    int over_1cm = 0;    // of those
    int lost = 0;        // bodies whose pose is not a number any more; they overlap nothing
};

// Of one portable scene. Looks at each pair of which at least one is dynamic; two that a joint
// connects are meant to overlap.
class AccuracyCheck {
public:
    explicit AccuracyCheck(const scenes::SceneDescription& scene);

    Penetration penetration(std::span<const physics::Transform> poses) const;
    // m: furthest that the two ends of a joint are apart.
    double joint_drift(std::span<const physics::Transform> poses) const;

private:
    struct Ends {
        std::size_t a, b;
        physics::Vec3 in_a, in_b;  // the anchor in the bodies' own frames
    };

    bool joined(std::uint32_t a, std::uint32_t b) const;

    struct Piece {
        std::uint32_t body;
        bool is_dynamic;
        Part part;
    };

    std::vector<Piece> pieces_;  // of bodies that collide
    std::vector<Ends> ends_;
    std::vector<std::uint64_t> joined_;  // pairs, smaller index in the upper half; sorted
};

}  // namespace jostle::bench
