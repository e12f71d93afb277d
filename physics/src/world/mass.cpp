// SPDX-License-Identifier: MIT
#include "physics/src/world/mass.h"

#include "jostle/base/check.h"
#include "physics/src/geometry/mass_properties.h"
#include "physics/src/geometry/outline.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

bool is_isotropic(const Mat3& m) {
    return m.x.x == m.y.y && m.y.y == m.z.z && m.x.y == 0 && m.x.z == 0 && m.y.z == 0;
}

MassProperties scaled_to(const MassProperties& p, double mass) {
    return {mass, p.center, p.inertia * (mass / p.mass)};
}

// In a planar world bodies rotate about z only, so the moment about z replaces all three.
void flatten(BodyCold& cold) {
    const double about_z = cold.inertia.z.z;
    cold.inertia = diagonal({about_z, about_z, about_z});
}

MassProperties mass_of_shape(const ShapeRecord& shape, bool planar) {
    // An explicit mass needs no density.
    const double density = shape.mass > 0 && shape.density == 0 ? 1 : shape.density;
    const MassProperties p =
        planar ? planar_mass_of(shape.geometry, density) : mass_of(shape.geometry, density);
    return shape.mass > 0 && p.mass > 0 ? scaled_to(p, shape.mass) : p;
}

}  // namespace

void update_mass(ShapedBodies& stores, const WorldDef& def, std::uint32_t body) {
    BodyCold& cold = stores.bodies.cold[body];
    ASSERT(!cold.asleep_in_place);
    BodyWarm& warm = warm_of(stores, body);
    MassProperties total;
    for (std::uint32_t s = cold.first_shape; s != none; s = stores.shapes.shapes[s].next) {
        const ShapeRecord& shape = stores.shapes.shapes[s];
        if (!shape.trigger)
            total = combined(total, moved(mass_of_shape(shape, def.planar), shape.pose));
    }
    if (cold.mass_override > 0 && total.mass > 0) total = scaled_to(total, cold.mass_override);
    const bool dynamic = cold.type == BodyType::dynamic && total.mass > 0;
    const Vec3 origin = warm.center - warm.axes * cold.local_center;
    const Vec3 old_center = warm.center;
    cold.local_center = dynamic ? total.center : Vec3{};
    if (cold.island != none)
        stores.islands.islands[cold.island].mass += (dynamic ? total.mass : 0) - cold.mass;
    cold.mass = dynamic ? total.mass : 0;
    cold.inertia = dynamic ? total.inertia : diagonal({0, 0, 0});
    if (def.planar) flatten(cold);
    cold.isotropic = is_isotropic(cold.inertia) && (cold.locks == 0 || def.planar);
    invert_mass(cold);
    warm.center = origin + warm.axes * cold.local_center;
    warm.v += cross(warm.w, warm.center - old_center);

    cold.radius = 0;
    cold.inner_radius = 1e300;
    for (std::uint32_t s = cold.first_shape; s != none; s = stores.shapes.shapes[s].next) {
        ShapeRecord& shape = stores.shapes.shapes[s];
        derive_shape_pose(cold, shape);
        if (!is_plane(shape))
            cold.radius = maximum(cold.radius, length(shape.offset) + radius_of(shape.geometry));
        if (!shape.trigger)
            cold.inner_radius = minimum(cold.inner_radius, inner_radius_of(shape.geometry));
    }
}

}  // namespace jostle::physics
