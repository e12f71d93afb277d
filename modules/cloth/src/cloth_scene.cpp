// SPDX-License-Identifier: MIT
//
// Cloth in scenes and for clients: reads settings and publishes channels.
#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "jostle/modules/cloth.h"
#include "jostle/modules/settings.h"
#include "jostle/physics/scalar.h"
#include "modules/cloth/src/cloth_checks.h"
#include "modules/cloth/src/cloth_data.h"

namespace jostle::modules {

using namespace physics;

using cloth_detail::Cloth;
using cloth_detail::Sheet;

namespace {

// Reads the settings of one cloth: items of lists are named "attachments1_vertex".
class ClothSettings {
public:
    explicit ClothSettings(const ModuleSettings& settings)
        : settings_(settings), reader_(settings) {}

    Status read(ClothDef& def, std::vector<ClothAttachment>& attachments, bool& hang) {
        count("grid_rows", def.grid.rows, 2, 1000);
        count("grid_columns", def.grid.columns, 2, 1000);
        vector("grid_origin", def.grid.origin);
        vector("grid_across", def.grid.across);
        vector("grid_down", def.grid.down);
        reader_.number("grid_width", def.grid.width, 0, 1e5);
        reader_.number("grid_height", def.grid.height, 0, 1e5);
        reader_.number("mass_per_area", def.mass_per_area, 1e-4, 1e4);
        reader_.number("stretch_stiffness", def.stretch_stiffness, 1, 1e7);
        reader_.number("shear_stiffness", def.shear_stiffness, 0, 1e7);
        reader_.number("bending_stiffness", def.bending_stiffness, 0, 1e4);
        reader_.number("damping", def.damping, 0, 1e4);
        reader_.number("drag", def.drag, 0, 100);
        vector("wind", def.wind, cloth_detail::speed_max);
        vector("gust", def.gust, cloth_detail::speed_max);
        reader_.number("gust_period", def.gust_period, 1e-3, 1e12);
        reader_.number("thickness", def.thickness, 1e-4, 1);
        reader_.number("friction", def.friction, 0, 10);
        reader_.number("breaking_load", def.breaking_load, 0, 1e12);
        count("substeps", def.substeps, 1, 64);
        reader_.flag("collide_bodies", def.collide_bodies);
        reader_.flag("collide_self", def.collide_self);
        reader_.flag("collide_cloths", def.collide_cloths);
        count("body_categories", def.body_categories, 0, 4294967295.0);
        count("color", def.color, 0, 0xffffff);
        reader_.flag("hang", hang);
        for (std::size_t k = 1; k <= Cloths::attachments_max; k++) {
            const std::string item = "attachments" + std::to_string(k) + "_";
            const auto is_part = [&](const auto& entry) { return entry.first.starts_with(item); };
            if (std::ranges::none_of(settings_.numbers, is_part)) break;
            ClothAttachment& attachment = attachments.emplace_back();
            count(item + "vertex", attachment.vertex, 0, ClothDef::vertices_max);
            reader_.body(item + "body", attachment.body);
            vector(item + "point", attachment.point);
        }
        return reader_.finish();
    }

private:
    void count(const std::string& name, std::uint32_t& value, double low, double high) {
        double number = value;
        reader_.number(name, number, low, high);
        value = static_cast<std::uint32_t>(number);
    }
    // A vector replaces the default as a whole: absent components are 0.
    void vector(const std::string& name, Vec3& value, double most = cloth_detail::coordinate_max) {
        const auto is_part = [&](const auto& entry) { return entry.first.starts_with(name + "_"); };
        if (std::ranges::any_of(settings_.numbers, is_part)) value = {};
        reader_.number(name + "_x", value.x, -most, most);
        reader_.number(name + "_y", value.y, -most, most);
        reader_.number(name + "_z", value.z, -most, most);
    }

    const ModuleSettings& settings_;
    SettingsReader reader_;
};

}  // namespace

Status Cloths::configure(World& world, const ModuleSettings& settings) {
    ClothDef def;
    std::vector<ClothAttachment> attachments;
    bool hang = false;
    if (Status read = ClothSettings(settings).read(def, attachments, hang); !read.ok()) return read;
    const Result<ClothKey> key = add(world, def);
    if (!key.ok()) return key.error();
    Status done;
    if (hang) {
        const Cloth& cloth = *find(*key);
        for (std::uint32_t c = 0; c < def.grid.columns && done.ok(); c++)
            done = attach(world, *key, {.vertex = c, .point = cloth.sheet.position(c)});
    }
    for (std::size_t k = 0; k < attachments.size() && done.ok(); k++) {
        done = attach(world, *key, attachments[k]);
        if (!done.ok())
            done = Error{done.error().code,
                         "attachments[" + std::to_string(k) + "]." + done.error().message};
    }
    if (!done.ok()) remove(world, *key).expect();
    return done;
}

std::vector<ChannelKind> Cloths::channels() const {
    return {{"", ChannelForm::points, points_divisor}};
}

void Cloths::publish(const World&, ChannelWriter& channels) const {
    if (!channels.wants_points(0)) return;
    std::vector<Vec3> positions;
    for (const auto& cloth : cloths_) {
        const Sheet& sheet = cloth->sheet;
        const std::span triangles(sheet.topology().triangles);
        if (sheet.size() > PointObject::points_max || triangles.size() > PointObject::triangles_max)
            continue;
        positions.resize(sheet.size());
        for (std::size_t k = 0; k < sheet.size(); k++) positions[k] = sheet.position(k);
        // A torn cloth is a mesh of the triangles that are left.
        const bool whole = cloth->def.triangles.empty() &&
                           std::ranges::count(sheet.torn(), 0) == std::ssize(sheet.torn());
        PointObject object{
            .key = cloth->key.number,
            .step = clamp(cloth->def.thickness / 2, published_step_min, published_step_max),
            .color = cloth->def.color,
            .form = whole ? PointForm::grid : PointForm::triangles,
            .positions = positions};
        if (whole)
            object.columns = cloth->def.grid.columns;
        else if (!triangles.empty())
            object.triangles = {triangles.front().data(), 3 * triangles.size()};
        channels.points(0, object);
    }
}

}  // namespace jostle::modules
