// SPDX-License-Identifier: MIT
#include "parts.h"

namespace jostle::scenes {

using namespace physics;

SceneBody fixed_box(std::string name, Vec3 center, Vec3 half_extents, Quat rotation) {
    return {.name = std::move(name),
            .body = {.type = BodyType::fixed, .pose = {center, rotation}},
            .shapes = {{.geometry = Box{half_extents}}},
            .color = {}};
}

SceneBody ground() {
    return fixed_box("ground", {0, -1, 0}, {200, 1, 200});
}

SceneBody loose(std::string name, Vec3 position, Geometry geometry, Quat rotation) {
    return {.name = std::move(name),
            .body = {.pose = {position, rotation}},
            .shapes = {{.geometry = geometry}},
            .color = {}};
}

SceneBody colored(SceneBody body, std::uint32_t color) {
    body.color = color;
    return body;
}

}  // namespace jostle::scenes
