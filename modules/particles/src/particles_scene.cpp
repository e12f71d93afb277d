// SPDX-License-Identifier: MIT
//
// Particles in scenes and for clients: reads settings and publishes channels.
#include <algorithm>
#include <string>

#include "jostle/modules/cosmetic_particles.h"
#include "jostle/modules/particles.h"
#include "jostle/modules/settings.h"
#include "jostle/physics/scalar.h"
#include "modules/particles/src/particle_fields.h"

namespace jostle::modules {

using namespace physics;

namespace {

// Reads the field list from settings: nested fields are named "emitter_rate", items of lists
// "planes1_offset", components "_x".
class SettingFields {
public:
    SettingFields(SettingsReader& reader, const ModuleSettings& settings)
        : reader_(reader), settings_(settings) {}

    template <class E>
    void choice(std::string_view name, E& value, E last) {
        double number = static_cast<double>(value);
        reader_.number(path(name), number, 0, static_cast<double>(last));
        value = static_cast<E>(static_cast<int>(number));
    }
    void count(std::string_view name, std::uint32_t& value, double low, double high) {
        double number = value;
        reader_.number(path(name), number, low, high);
        value = static_cast<std::uint32_t>(number);
    }
    void whole(std::string_view name, std::int32_t& value, double low, double high) {
        double number = value;
        reader_.number(path(name), number, low, high);
        value = static_cast<std::int32_t>(number);
    }
    void flag(std::string_view name, bool& value) { reader_.flag(path(name), value); }
    void number(std::string_view name, double& value, double low, double high) {
        reader_.number(path(name), value, low, high);
    }
    void vector(std::string_view name, Vec3& value, double most) {
        // A vector replaces the default as a whole: absent components are 0.
        if (has(path(name) + "_")) value = {};
        reader_.number(path(name) + "_x", value.x, -most, most);
        reader_.number(path(name) + "_y", value.y, -most, most);
        reader_.number(path(name) + "_z", value.z, -most, most);
    }
    void direction(std::string_view name, Vec3& value) { vector(name, value, 1e6); }
    void enter(std::string_view name) { path_ += std::string(name) + "_"; }
    void leave() { path_.erase(path_.rfind('_', path_.size() - 2) + 1); }
    template <class Item, class Visit>
    void list(std::string_view name, std::vector<Item>& items, std::size_t most, Visit&& visit) {
        const std::string outer = path_;
        for (std::size_t k = 0; k < most; k++) {
            const std::string item = path(name) + std::to_string(k + 1) + "_";
            if (!has(item)) break;
            path_ = item;
            visit(items.emplace_back());
            path_ = outer;
        }
    }

private:
    std::string path(std::string_view name) const { return path_ + std::string(name); }
    bool has(std::string_view prefix) const {
        for (const auto& [name, value] : settings_.numbers)
            if (name.starts_with(prefix)) return true;
        return false;
    }

    SettingsReader& reader_;
    const ModuleSettings& settings_;
    std::string path_;
};

// Particles and springs of a scene, at most these numbers.
constexpr std::size_t scene_particles_max = 256, scene_springs_max = 1024;

void visit_start(SettingFields& f, ParticleStart& start) {
    f.vector("position", start.position, particles_detail::coordinate_max);
    f.vector("velocity", start.velocity, particles_detail::speed_max);
    f.number("lifetime", start.lifetime, 0, 1e6);
}

// `to` is 0 for the anchor, otherwise the number of the particle plus 1; so a spring without `to`
// hangs from its anchor.
void visit_spring(SettingFields& f, ParticleSpring& spring) {
    std::uint32_t to = 0;
    f.count("from", spring.a, 0, scene_particles_max - 1);
    f.count("to", to, 0, scene_particles_max);
    spring.b = to == 0 ? spring_anchor : to - 1;
    f.vector("anchor", spring.anchor, particles_detail::coordinate_max);
    f.number("rest_length", spring.rest_length, 0, 1e4);
    f.number("stiffness", spring.stiffness, 0, 1e9);
    f.number("damping", spring.damping, 0, 1e6);
}

}  // namespace

Status Particles::configure(World& world, const ModuleSettings& settings) {
    SettingsReader reader(settings);
    SettingFields fields(reader, settings);
    ParticleGroupDef def;
    std::vector<ParticleStart> starts;
    std::vector<ParticleSpring> springs;
    particles_detail::visit_def(fields, def);
    fields.list("particles", starts, scene_particles_max,
                [&](ParticleStart& start) { visit_start(fields, start); });
    fields.list("springs", springs, scene_springs_max,
                [&](ParticleSpring& spring) { visit_spring(fields, spring); });
    if (Status read = reader.finish(); !read.ok()) return read;
    const Result<ParticleKey> key = add(world, def);
    if (!key.ok()) return key.error();
    ParticleGroup& made = *group(*key);
    Status filled = made.add(starts);
    if (filled.ok()) filled = made.add_springs(springs);
    if (!filled.ok()) remove(*key).expect();
    return filled;
}

std::vector<ChannelKind> Particles::channels() const {
    return {{"", ChannelForm::points, points_divisor}, {"cosmetic", ChannelForm::seed, 60}};
}

void Particles::publish(const World& world, ChannelWriter& channels) const {
    std::vector<const ParticleGroupDef*> cosmetic;
    for (const auto& [key, group] : entries_) {
        const ParticleGroupDef& def = group.def();
        if (def.cosmetic) {
            cosmetic.push_back(&def);
            continue;
        }
        const std::size_t count = std::min(group.positions().size(), PointObject::points_max);
        channels.points(0, {.key = key.number,
                            .step = clamp(def.radius / 4, published_step_min, published_step_max),
                            .radius = def.radius,
                            .color = def.color,
                            .positions = group.positions().first(count),
                            .ids = group.ids().first(count)});
    }
    if (cosmetic.empty() || !channels.begin(1)) return;
    for (const std::int32_t value : encode_cosmetic(world.gravity(), cosmetic))
        channels.value(value);
}

}  // namespace jostle::modules
