// SPDX-License-Identifier: MIT
//
// The referee: how wrong the poses are that an engine leaves behind, by geometry alone and the same
// for every engine. Deepest overlap and joint drift; never inside a timing.
#pragma once

#include <span>
#include <vector>

#include "speed/scene_description.h"

namespace jostle::bench {

// How far one of two shapes must move for them to touch no more, m; zero or less when they do not
// overlap. Exact for all pairs of spheres, capsules and boxes.
double overlap_depth(const Form& a, const physics::Transform& pose_a, const Form& b,
                     const physics::Transform& pose_b);

struct Overlaps {
    double deepest = 0;  // m
    double mean = 0;     // m, of the pairs that overlap
    int pairs = 0;       // that overlap
    int over_1cm = 0;    // of those
    int lost = 0;        // bodies whose pose is not a number any more; they overlap nothing
};

// One scene's judge. Looks at each pair of which at least one is not fixed; two that a joint
// connects are meant to overlap. The scene must outlive it.
class Referee {
public:
    explicit Referee(const SceneDescription& scene);

    Overlaps overlaps(std::span<const physics::Transform> poses) const;
    // m: furthest that the two ends of a joint are apart.
    double joint_drift(std::span<const physics::Transform> poses) const;

private:
    struct Ends {
        std::uint32_t a, b;
        physics::Vec3 in_a, in_b;  // the anchor in the bodies' own frames
    };

    bool joined(std::uint32_t a, std::uint32_t b) const;

    const SceneDescription& scene_;
    std::vector<Ends> ends_;
    std::vector<std::uint64_t> joined_;          // pairs, smaller index in the upper half; sorted
    std::vector<std::uint32_t> fixed_, moving_;  // bodies that collide
};

}  // namespace jostle::bench
