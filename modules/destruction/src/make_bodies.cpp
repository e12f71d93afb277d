// SPDX-License-Identifier: MIT
#include "make_bodies.h"

#include <utility>

namespace jostle::modules::destruction_detail {

using namespace physics;

Result<std::vector<BodyId>> make_bodies(World& world, std::vector<BodyAndShapes> bodies) {
    std::vector<std::vector<ShapeDef>> all(bodies.size());
    for (std::size_t k = 0; k < bodies.size(); k++)
        if (bodies[k].shapes.size() > 1) {
            all[k] = std::move(bodies[k].shapes);
            bodies[k].shapes = {all[k].front()};
        }
    Result<std::vector<BodyId>> made = world.create_bodies(bodies);
    if (!made.ok()) return made;
    for (std::size_t k = 0; k < all.size(); k++) {
        if (all[k].empty()) continue;
        const Result<std::vector<ShapeId>> shapes = world.set_shapes((*made)[k], all[k]);
        if (shapes.ok()) {
            // The centre of mass moved: what the def says is of the one of all shapes.
            static_cast<void>(world
                                  .set_velocity((*made)[k], bodies[k].body.linear_velocity,
                                                bodies[k].body.angular_velocity)
                                  .ok());
            continue;
        }
        static_cast<void>(world.destroy_bodies(*made).ok());
        return shapes.error();
    }
    return made;
}

}  // namespace jostle::modules::destruction_detail
