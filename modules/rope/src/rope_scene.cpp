// SPDX-License-Identifier: MIT
//
// Ropes in scenes and for clients: reads settings and publishes channels.
#include <algorithm>
#include <span>
#include <string>

#include "jostle/modules/rope.h"
#include "jostle/modules/settings.h"
#include "jostle/physics/scalar.h"
#include "modules/rope/src/rope_checks.h"
#include "modules/rope/src/rope_data.h"

namespace jostle::modules {

using namespace physics;
using rope_detail::coordinate_max;

namespace {

// Reads the settings of one rope: items of lists are named "points1_position_x".
class RopeSettings {
public:
    explicit RopeSettings(const ModuleSettings& settings)
        : settings_(settings), reader_(settings) {}

    Status read(RopeDef& def, std::vector<RopeAttachment>& attachments, double (&winch)[2]) {
        list("points", RopeDef::points_max, [&](const std::string& item) {
            vector(item + "position", def.points.emplace_back());
        });
        count("links", def.links, 1, RopeDef::links_max);
        reader_.number("length", def.length, 0, 1e5);
        reader_.number("radius", def.radius, 1e-4, 10);
        reader_.number("mass_per_length", def.mass_per_length, 1e-6, 1e6);
        reader_.number("stretch_stiffness", def.stretch_stiffness, 1, 1e12);
        reader_.number("bending_stiffness", def.bending_stiffness, 0, 1e9);
        reader_.number("damping", def.damping, 0, 1e4);
        reader_.number("friction", def.friction, 0, 10);
        reader_.number("breaking_load", def.breaking_load, 0, 1e12);
        count("substeps", def.substeps, 1, 64);
        reader_.flag("collide_bodies", def.collide_bodies);
        reader_.flag("collide_self", def.collide_self);
        reader_.flag("collide_ropes", def.collide_ropes);
        count("body_categories", def.body_categories, 0, 4294967295.0);
        count("color", def.color, 0, 0xffffff);
        list("attachments", Ropes::attachments_max, [&](const std::string& item) {
            RopeAttachment& attachment = attachments.emplace_back();
            count(item + "node", attachment.node, 0, RopeDef::links_max);
            reader_.body(item + "body", attachment.body);
            vector(item + "point", attachment.point);
            vector(item + "direction", attachment.direction);
        });
        reader_.number("winch_first", winch[0], -100, 100);
        reader_.number("winch_last", winch[1], -100, 100);
        return reader_.finish();
    }

private:
    void count(const std::string& name, std::uint32_t& value, double low, double high) {
        double number = value;
        reader_.number(name, number, low, high);
        value = static_cast<std::uint32_t>(number);
    }
    void vector(const std::string& name, Vec3& value) {
        reader_.number(name + "_x", value.x, -coordinate_max, coordinate_max);
        reader_.number(name + "_y", value.y, -coordinate_max, coordinate_max);
        reader_.number(name + "_z", value.z, -coordinate_max, coordinate_max);
    }
    template <class Visit>
    void list(const std::string& name, std::size_t most, Visit&& visit) {
        for (std::size_t k = 1; k <= most; k++) {
            const std::string item = name + std::to_string(k) + "_";
            const auto is_part = [&](const auto& entry) { return entry.first.starts_with(item); };
            if (std::ranges::none_of(settings_.numbers, is_part)) return;
            visit(item);
        }
    }

    const ModuleSettings& settings_;
    SettingsReader reader_;
};

}  // namespace

Status Ropes::configure(World& world, const ModuleSettings& settings) {
    RopeDef def;
    std::vector<RopeAttachment> attachments;
    double winch[2] = {0, 0};
    if (Status read = RopeSettings(settings).read(def, attachments, winch); !read.ok()) return read;
    const Result<RopeKey> key = add(world, def);
    if (!key.ok()) return key.error();
    Status done;
    for (std::size_t k = 0; k < attachments.size() && done.ok(); k++) {
        done = attach(world, *key, attachments[k]);
        if (!done.ok())
            done = Error{done.error().code,
                         "attachments[" + std::to_string(k) + "]." + done.error().message};
    }
    if (done.ok()) done = set_winch(world, *key, RopeEnd::first, winch[0]);
    if (done.ok()) done = set_winch(world, *key, RopeEnd::last, winch[1]);
    if (!done.ok()) remove(world, *key).expect();
    return done;
}

std::vector<ChannelKind> Ropes::channels() const {
    return {{"", ChannelForm::points, points_divisor}};
}

void Ropes::publish(const World&, ChannelWriter& channels) const {
    for (const auto& rope : ropes_) {
        const auto nodes = static_cast<std::uint32_t>(rope->strand.positions.size());
        channels.points(
            0, {.key = rope->key.number,
                .step = clamp(rope->def.radius / 8, published_step_min, published_step_max),
                .radius = rope->def.radius,
                .color = rope->def.color,
                .form = PointForm::strands,
                .positions = rope->strand.positions,
                .strands = std::span(&nodes, 1)});
    }
}

}  // namespace jostle::modules
