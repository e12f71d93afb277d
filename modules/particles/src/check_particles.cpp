// SPDX-License-Identifier: MIT
//
// Range checks of definitions from callers, scenes, saved state and clients.
#include <cstdio>
#include <string>

#include "modules/particles/src/particle_fields.h"

namespace jostle::modules {

using namespace physics;

namespace {

std::string decimal(double number) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.10g", number);
    return digits;
}

// Visits the field list and stores the first error.
class RangeCheck {
public:
    template <class E>
    void choice(std::string_view name, E& value, E last) {
        range(name, static_cast<double>(value), 0, static_cast<double>(last));
    }
    void count(std::string_view name, std::uint32_t& value, double low, double high) {
        range(name, value, low, high);
    }
    void whole(std::string_view name, std::int32_t& value, double low, double high) {
        range(name, value, low, high);
    }
    void flag(std::string_view, bool&) {}
    void number(std::string_view name, double& value, double low, double high) {
        range(name, value, low, high);
    }
    void vector(std::string_view name, Vec3& value, double most) {
        for (int k = 0; k < 3; k++)
            range(std::string(name) + "." + "xyz"[k], value[k], -most, most);
    }
    void direction(std::string_view name, Vec3& value) {
        vector(name, value, 1e6);
        const double size = length(value);
        if (!(size >= 1e-6))
            fail(name, "has the length " + decimal(size) + "; it must be at least 1e-06");
    }
    void enter(std::string_view name) { path_ += std::string(name) + "."; }
    void leave() { path_.erase(path_.rfind('.', path_.size() - 2) + 1); }
    template <class Item, class Visit>
    void list(std::string_view name, std::vector<Item>& items, std::size_t most, Visit&& visit) {
        if (items.size() > most)
            return fail(name, "has " + std::to_string(items.size()) +
                                  " elements; it must have at most " + std::to_string(most));
        for (std::size_t k = 0; k < items.size(); k++) {
            enter(std::string(name) + "[" + std::to_string(k) + "]");
            visit(items[k]);
            leave();
        }
    }

    void fail(std::string_view name, const std::string& what) {
        if (fault_.empty()) fault_ = path_ + std::string(name) + " " + what;
    }
    const std::string& fault() const { return fault_; }

private:
    void range(std::string_view name, double value, double low, double high) {
        if (value >= low && value <= high) return;
        fail(name,
             "is " + decimal(value) + "; it must be from " + decimal(low) + " to " + decimal(high));
    }

    std::string path_, fault_;
};

// The largest number of particles of an emitter that exist at once.
double most_alive(const Emitter& e) {
    const double life = e.lifetime * (1 + e.lifetime_spread);
    const double bursts = e.burst_period > 0 ? life / e.burst_period + 1 : 1;
    return e.rate * life + 1 + e.burst * bursts;
}

// Cosmetic particles depend on nothing but their definition. If some were not emitted because
// count_max is reached, they would depend on the time at which a client connects.
void check_cosmetic(RangeCheck& check, const ParticleGroupDef& d) {
    if (!d.cosmetic) return;
    if (d.collide_particles)
        check.fail("collide_particles", "is true; it must be false for cosmetic particles");
    if (d.attraction != 0) check.fail("attraction", "must be 0 for cosmetic particles");
    if (d.world_fields) check.fail("world_fields", "must be false for cosmetic particles");
    const double alive = most_alive(d.emitter);
    if (alive > d.count_max)
        check.fail("count_max", "is " + std::to_string(d.count_max) +
                                    "; cosmetic particles need at least " + decimal(alive) +
                                    " for the rate, bursts and lifetime of the emitter");
}

}  // namespace

// Weights measured with jostle-bench modules.
double work_of(const ParticleGroupDef& def) {
    if (def.cosmetic) return 0;
    constexpr double evaluations_of[] = {1, 1, 4, 1, 4};  // implicit Euler: Newton iterations
    const double evaluations = evaluations_of[static_cast<int>(def.integrator)];
    const double count = def.count_max;
    double each = 1 + evaluations * (def.flow.speed > 0 ? 1 + def.flow.octaves : 0.5);
    if (def.collide_bodies) each += 2;
    if (def.collide_particles) each += 20;
    if (def.attraction != 0) each += evaluations * count / 50;
    return def.substeps * count * each;
}

Status check(const ParticleGroupDef& def) {
    RangeCheck check;
    ParticleGroupDef copy = def;  // the list visits references that may be written
    particles_detail::visit_def(check, copy);
    const Vec3 h = def.emitter.half_extents;
    if (!(h.x >= 0 && h.y >= 0 && h.z >= 0))
        check.fail("emitter.half_extents", "has a negative component");
    const double period = def.emitter.burst_period;
    if (period > 0 && period < 1e-3)
        check.fail("emitter.burst_period",
                   "is " + decimal(period) + "; it must be 0 or at least 0.001");
    if (def.attraction != 0 && def.count_max > ParticleGroupDef::attracting_max)
        check.fail("count_max", "is " + std::to_string(def.count_max) +
                                    "; it must be at most 2048 for particles that attract each "
                                    "other");
    if (def.collide_particles && def.radius == 0)
        check.fail("radius", "is 0; particles that hit each other need a radius");
    check_cosmetic(check, def);
    if (check.fault().empty()) return {};
    return invalid_argument(check.fault());
}

}  // namespace jostle::modules
