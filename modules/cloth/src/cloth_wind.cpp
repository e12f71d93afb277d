// SPDX-License-Identifier: MIT
#include "modules/cloth/src/cloth_wind.h"

#include <variant>

#include "jostle/physics/scalar.h"

namespace jostle::modules::cloth_detail {

using namespace physics;

namespace {

Vec3 center_of(const Sheet& sheet) {
    Vec3 sum;
    for (std::size_t k = 0; k < sheet.size(); k++) sum += sheet.position(k);
    return sum * (1 / static_cast<double>(sheet.size()));
}

Vec3 velocity_of(const UniformWind& wind, double time) {
    if (wind.gust == Vec3{}) return wind.velocity;
    return wind.velocity + wind.gust * sin_cos(2 * pi * time / wind.gust_period).sin;
}

void add_pressure(Sheet& sheet, Vec3 wind, double factor, double mass_per_area, double dt) {
    std::vector<float>& a = sheet.accelerations();
    for (const auto& t : sheet.topology().triangles) {
        const Vec3 p = sheet.position(t[0]);
        const Vec3 twice = cross(sheet.position(t[1]) - p, sheet.position(t[2]) - p);
        const double size = length(twice);
        if (!(size > 1e-12)) continue;
        const Vec3 n = twice * (1 / size);
        const Vec3 mean =
            (sheet.velocity(t[0]) + sheet.velocity(t[1]) + sheet.velocity(t[2])) * (1.0 / 3);
        const double across = dot(wind - mean, n);
        // 1/s, of a free face
        const double rate = factor * absolute(across) / mass_per_area;
        const double force = 0.5 * size * factor * absolute(across) * across / (1 + rate * dt) / 3;
        for (const std::uint32_t v : t)
            for (int axis = 0; axis < 3; axis++)
                a[4 * v + static_cast<std::size_t>(axis)] +=
                    static_cast<float>(n[axis] * force * sheet.free_inverse_mass(v));
    }
}

}  // namespace

bool blow(Sheet& sheet, std::span<const FieldDef> fields, double drag, double mass_per_area,
          double time, double dt) {
    bool acts = false;
    for (const FieldDef& field : fields) {
        const auto* wind = std::get_if<UniformWind>(&field.force);
        if (wind == nullptr || drag == 0) continue;
        const Vec3 center = center_of(sheet);
        if (field.region && !overlap(*field.region, Aabb{center, center})) continue;
        if (!acts) sheet.accelerations().assign(4 * sheet.size(), 0);
        acts = true;
        add_pressure(sheet, velocity_of(*wind, time + 0.5 * dt), 0.5 * wind->density * drag,
                     mass_per_area, dt);
    }
    if (!acts) sheet.accelerations().clear();
    return acts;
}

}  // namespace jostle::modules::cloth_detail
