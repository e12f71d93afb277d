// SPDX-License-Identifier: MIT
//
// What is done with a scene that was accepted: when it is small it is built, and what could be
// built runs for a few steps.
#pragma once

#include "jostle/scenes/scene.h"
#include "jostle/v1/scene.pb.h"
#include "tests/fuzz/particle_work.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

// Repeats are bounded by the reader, but a hundred thousand bodies make no better input than ten.
inline bool is_too_large(const v1::Scene& scene) {
    std::size_t bodies = 0;
    for (const v1::Body& body : scene.bodies()) {
        std::size_t copies = 1;
        for (const v1::Repeat& repeat : body.repeat())
            copies = std::min<std::size_t>(copies * std::min(repeat.count(), 1000u), 1000);
        bodies += copies;
    }
    for (const v1::Joint& joint : scene.joints())
        if (joint.has_repeat()) bodies += std::min(joint.repeat().count(), 1000u);
    return bodies > 200;
}

inline void exercise_scene(const scenes::SceneDescription& scene) {
    constexpr std::size_t bodies_max = 12, joints_max = 12;
    if (scene.bodies.size() > bodies_max || scene.joints.size() > joints_max) return;
    auto built = scenes::build_scene(scene);
    if (!built.ok()) return expect(!built.error().message.empty(), "a refusal has a reason");
    if (has_many_particles(built->world)) return;
    for (int k = 0; k < 4; k++) {
        const Status stepped = built->world.step(1 / scene.hz);
        expect(stepped.ok(),
               stepped.ok() ? "" : "a world stands still: " + stepped.error().message);
    }
}

}  // namespace jostle::fuzz
