// SPDX-License-Identifier: MIT
#include "modules/fields/src/field_checks.h"

#include <cstdio>
#include <initializer_list>

#include "jostle/physics/limits.h"

namespace jostle::modules::fields_detail {

using namespace physics;

namespace {

std::string text(double number) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.10g", number);
    return digits;
}

// Stores the first error.
class Checker {
public:
    void range(const std::string& name, double value, double low, double high) {
        if (value >= low && value <= high) return;
        fail(name + " is " + text(value) + "; it must be from " + text(low) + " to " + text(high));
    }
    void vector(const std::string& name, Vec3 v, double most) {
        range(name + ".x", v.x, -most, most);
        range(name + ".y", v.y, -most, most);
        range(name + ".z", v.z, -most, most);
    }
    void fail(std::string fault) {
        if (fault_.empty()) fault_ = std::move(fault);
    }
    Status status() const {
        if (fault_.empty()) return {};
        return invalid_argument(fault_);
    }

    void operator()(const Everywhere&) {}
    void operator()(const BoxVolume& box) {
        vector("volume.position", box.pose.position, limits::max_coordinate);
        const double norm = norm_squared(box.pose.rotation);
        if (!(absolute(norm - 1) < 1e-6)) fail("volume.rotation is not a unit quaternion");
        for (int k = 0; k < 3; k++)
            range("volume.half_extents", box.half_extents[k], 1e-3, limits::max_coordinate);
    }
    void operator()(const SphereVolume& sphere) {
        vector("volume.center", sphere.center, limits::max_coordinate);
        range("volume.radius", sphere.radius, 1e-3, limits::max_coordinate);
    }
    void operator()(const CapsuleVolume& capsule) {
        vector("volume.from", capsule.from, limits::max_coordinate);
        vector("volume.to", capsule.to, limits::max_coordinate);
        range("volume.radius", capsule.radius, 1e-3, limits::max_coordinate);
    }

    void operator()(const Central& central) {
        vector("central.point", central.point, limits::max_coordinate);
        range("central.strength", central.strength, -1e12, 1e12);
        range("central.falloff", central.falloff, 0, 4);
        range("central.min_distance", central.min_distance, 1e-6, 1e6);
    }
    void operator()(const Turbulence& t) {
        vector("turbulence.wind", t.wind, limits::max_speed);
        range("turbulence.speed", t.speed, 0, 1e3);
        range("turbulence.scale", t.scale, 0.01, 1e6);
        range("turbulence.rate", t.rate, 0, 1e3);
        range("turbulence.octaves", t.octaves, 1, 8);
        range("turbulence.density", t.density, 0, limits::max_density);
        range("turbulence.drag", t.drag, 0, 1e6);
    }
    void operator()(const UserField& user) {
        if (user.parameters.size() > user_parameters_max)
            fail("user.parameters has " + std::to_string(user.parameters.size()) +
                 " elements; it must have at most 16");
        for (const double parameter : user.parameters)
            range("user.parameters", parameter, -1e12, 1e12);
        if (find_user_field(user.law)) return;
        std::string known;
        for (const std::string& name : user_fields()) known += (known.empty() ? "" : ", ") + name;
        fail("user.law is \"" + user.law +
             "\", which is not registered; must be one of: " + (known.empty() ? "none" : known));
    }
    void operator()(const Waves& waves) {
        range("waves.level", waves.level, -limits::max_coordinate, limits::max_coordinate);
        range("waves.density", waves.density, 0, limits::max_density);
        vector("waves.flow", waves.flow, limits::max_speed);
        range("waves.drag", waves.drag, 0, 1e6);
        range("waves.damping", waves.damping, 0, 1e4);
        if (waves.components.size() > wave_components_max)
            fail("waves.components has " + std::to_string(waves.components.size()) +
                 " elements; it must have at most 8");
        for (const WaveComponent& wave : waves.components) {
            range("waves.amplitude", wave.amplitude, 0, 100);
            range("waves.length", wave.length, 0.1, 1e4);
            range("waves.heading", wave.heading, -1e3, 1e3);
            range("waves.phase", wave.phase, -1e3, 1e3);
        }
    }

private:
    std::string fault_;
};

}  // namespace

Status check(const VolumeField& field) {
    Checker checker;
    std::visit([&](const auto& kind) { checker(kind); }, field.volume);
    if (Status volume = checker.status(); !volume.ok()) return volume;
    Checker law;
    std::visit([&](const auto& kind) { law(kind); }, field.law);
    return law.status();
}

Status check(const Explosion& e) {
    Checker checker;
    checker.vector("explosion.center", e.center, limits::max_coordinate);
    checker.range("explosion.radius", e.radius, 1e-3, 1e4);
    checker.range("explosion.strength", e.strength, 0, 1e9);
    checker.range("explosion.core", e.core, 1e-3, 1e4);
    checker.range("explosion.falloff", e.falloff, 0, 4);
    checker.range("explosion.standoff", e.standoff, 0, 100);
    checker.range("explosion.points", e.points, 6, 1024);
    checker.range("explosion.max_speed", e.max_speed, 0, limits::max_speed);
    return checker.status();
}

Status check(const Charge& charge) {
    Checker checker;
    checker.range("charge.time", charge.time, 0, 1e12);
    if (Status time = checker.status(); !time.ok()) return time;
    return check(charge.explosion);
}

}  // namespace jostle::modules::fields_detail
