// SPDX-License-Identifier: MIT
//
// Fields in scenes and for clients: reads settings and publishes channels.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "jostle/modules/fields.h"
#include "jostle/modules/settings.h"
#include "jostle/physics/limits.h"

namespace jostle::modules {

using namespace physics;

namespace {

bool has_setting(const ModuleSettings& settings, std::string_view prefix) {
    for (const auto& [name, value] : settings.numbers)
        if (name.starts_with(prefix)) return true;
    return false;
}

void read_vector(SettingsReader& reader, const std::string& name, Vec3& to, double most) {
    reader.number(name + "_x", to.x, -most, most);
    reader.number(name + "_y", to.y, -most, most);
    reader.number(name + "_z", to.z, -most, most);
}

void read_count(SettingsReader& reader, const std::string& name, std::uint32_t& to, double low,
                double high) {
    double value = to;
    reader.number(name, value, low, high);
    to = static_cast<std::uint32_t>(value);
}

// Reads an upright box if its half extents are given.
void read_volume(SettingsReader& reader, const std::string& name, Volume& to) {
    BoxVolume box{.pose = {}, .half_extents = {0, 0, 0}};
    read_vector(reader, name + "_center", box.pose.position, limits::max_coordinate);
    for (int k = 0; k < 3; k++)
        reader.number(name + "_half_" + "xyz"[k], box.half_extents[k], 1e-3,
                      limits::max_coordinate);
    if (box.half_extents == Vec3{}) return;
    for (int k = 0; k < 3; k++)
        if (box.half_extents[k] == 0) box.half_extents[k] = limits::max_coordinate;
    to = box;
}

Turbulence read_turbulence(SettingsReader& reader) {
    Turbulence t;
    read_vector(reader, "turbulence_wind", t.wind, limits::max_speed);
    reader.number("turbulence_speed", t.speed, 0, 1e3);
    reader.number("turbulence_scale", t.scale, 0.01, 1e6);
    reader.number("turbulence_rate", t.rate, 0, 1e3);
    read_count(reader, "turbulence_octaves", t.octaves, 1, 8);
    read_count(reader, "turbulence_seed", t.seed, 0, 4294967295.0);
    reader.number("turbulence_density", t.density, 0, limits::max_density);
    reader.number("turbulence_drag", t.drag, 0, 1e6);
    return t;
}

Waves read_waves(SettingsReader& reader) {
    Waves waves;
    reader.number("waves_level", waves.level, -limits::max_coordinate, limits::max_coordinate);
    reader.number("waves_density", waves.density, 0, limits::max_density);
    read_vector(reader, "waves_flow", waves.flow, limits::max_speed);
    reader.number("waves_drag", waves.drag, 0, 1e6);
    reader.number("waves_damping", waves.damping, 0, 1e4);
    for (int k = 1; k <= 4; k++) {
        const std::string name = "wave" + std::to_string(k);
        WaveComponent wave{.amplitude = 0};
        reader.number(name + "_amplitude", wave.amplitude, 0, 100);
        reader.number(name + "_length", wave.length, 0.1, 1e4);
        reader.number(name + "_heading", wave.heading, -1e3, 1e3);
        reader.number(name + "_phase", wave.phase, -1e3, 1e3);
        if (wave.amplitude > 0) waves.components.push_back(wave);
    }
    return waves;
}

Central read_central(SettingsReader& reader) {
    Central central;
    reader.body("center", central.body);
    read_vector(reader, "central_point", central.point, limits::max_coordinate);
    reader.number("central_strength", central.strength, -1e12, 1e12);
    read_count(reader, "central_falloff", central.falloff, 0, 4);
    reader.number("central_nearest", central.min_distance, 1e-6, 1e6);
    reader.flag("central_per_mass", central.per_mass);
    return central;
}

Charge read_charge(SettingsReader& reader) {
    Charge charge;
    Explosion& e = charge.explosion;
    reader.number("blast_time", charge.time, 0, 1e12);
    read_vector(reader, "blast_center", e.center, limits::max_coordinate);
    reader.number("blast_radius", e.radius, 1e-3, 1e4);
    reader.number("blast_strength", e.strength, 0, 1e9);
    reader.number("blast_core", e.core, 1e-3, 1e4);
    read_count(reader, "blast_falloff", e.falloff, 0, 4);
    reader.flag("blast_fade", e.fade);
    reader.number("blast_standoff", e.standoff, 0, 100);
    reader.number("blast_most_speed", e.max_speed, 0, limits::max_speed);
    return charge;
}

double wrap_angle(double angle) {
    return angle - 2 * pi * std::floor(angle / (2 * pi));
}

void write_point(ChannelWriter& channels, Vec3 p) {
    for (const double x : {p.x, p.y, p.z}) channels.f32(static_cast<float>(x));
}

void write_waves(ChannelWriter& channels, const Waves& waves, double gravity, double time) {
    channels.f32(static_cast<float>(waves.level));
    channels.f32(static_cast<float>(waves.density));
    channels.value(static_cast<std::int32_t>(waves.components.size()));
    for (const WaveComponent& wave : waves.components) {
        const double omega = square_root(maximum(gravity, 0) * 2 * pi / wave.length);
        channels.f32(static_cast<float>(wave.amplitude));
        channels.f32(static_cast<float>(wave.length));
        channels.quantized(wrap_angle(wave.heading), 0, 2 * pi, 16);
        channels.quantized(wrap_angle(wave.phase - omega * time), 0, 2 * pi, 16);
        channels.f32(static_cast<float>(omega));
    }
}

void write_field(ChannelWriter& channels, const World& world, const FieldLaw& law) {
    channels.value(static_cast<std::int32_t>(law.index()));
    if (const auto* central = std::get_if<Central>(&law)) {
        const Result<BodyState> body = world.body(central->body);
        write_point(channels, central->point + (body.ok() ? body->center : Vec3{}));
    } else if (const auto* turbulence = std::get_if<Turbulence>(&law)) {
        write_point(channels, turbulence->wind);
        channels.f32(static_cast<float>(turbulence->speed));
    }
}

}  // namespace

Status Fields::configure(World& world, const ModuleSettings& settings) {
    SettingsReader reader(settings);
    VolumeField turbulence{.law = read_turbulence(reader)}, waves{.law = read_waves(reader)},
        central{.law = read_central(reader)};
    read_volume(reader, "turbulence", turbulence.volume);
    read_volume(reader, "waves", waves.volume);
    read_volume(reader, "central", central.volume);
    const Charge charge = read_charge(reader);
    if (Status read = reader.finish(); !read.ok()) return read;
    const auto add_given = [&](bool given, const VolumeField& field) -> Status {
        if (!given) return {};
        const Result<FieldKey> key = add(world, field);
        return key.ok() ? Status{} : key.error();
    };
    if (Status s = add_given(has_setting(settings, "turbulence_"), turbulence); !s.ok()) return s;
    if (Status s = add_given(has_setting(settings, "wave"), waves); !s.ok()) return s;
    const bool attracts = has_setting(settings, "central_") || !settings.bodies.empty();
    if (Status s = add_given(attracts, central); !s.ok()) return s;
    return has_setting(settings, "blast_") ? add_charge(charge) : Status{};
}

std::vector<ChannelKind> Fields::channels() const {
    return {{"waves", ChannelForm::seed, waves_divisor}, {}};
}

void Fields::publish(const World& world, ChannelWriter& channels) const {
    const auto is_water = [](const Entry& entry) {
        return std::holds_alternative<Waves>(entry.field.law);
    };
    if (std::any_of(entries_.begin(), entries_.end(), is_water) && channels.begin(0))
        for (const Entry& entry : entries_)
            if (const auto* waves = std::get_if<Waves>(&entry.field.law))
                write_waves(channels, *waves, -world.gravity().y, world.time());
    const auto others = std::count_if(entries_.begin(), entries_.end(), std::not_fn(is_water));
    if ((others == 0 && blasts_.empty()) || !channels.begin(1)) return;
    channels.value(static_cast<std::int32_t>(others));
    for (const Entry& entry : entries_)
        if (!is_water(entry)) write_field(channels, world, entry.field.law);
    for (const Explosion& blast : blasts_) {
        write_point(channels, blast.center);
        channels.f32(static_cast<float>(blast.radius));
    }
}

}  // namespace jostle::modules
