// SPDX-License-Identifier: MIT
//
// State of cloth: saved, loaded, hashed and compared. Loaded values are checked here.
#include <algorithm>
#include <cmath>

#include "jostle/modules/cloth.h"
#include "jostle/modules/settings.h"
#include "modules/cloth/src/cloth_checks.h"
#include "modules/cloth/src/cloth_data.h"

namespace jostle::modules {

using namespace physics;
using namespace cloth_detail;

namespace {

// Positions and velocities beyond these are not reached by cloth that is checked, m and m/s.
constexpr double position_max = 1e9, velocity_max = 1e9;

bool is_within(Vec3 v, double most) {
    const Vec3 size = abs(v);
    return size.x <= most && size.y <= most && size.z <= most;
}

void visit_grid(StateVisitor& v, ClothGrid& grid) {
    v.enter("grid");
    v.field("rows", grid.rows);
    v.field("columns", grid.columns);
    v.field("origin", grid.origin);
    v.field("across", grid.across);
    v.field("down", grid.down);
    v.field("width", grid.width);
    v.field("height", grid.height);
    v.leave();
}

void visit_def(StateVisitor& v, ClothDef& def) {
    v.enter("def");
    visit_grid(v, def.grid);
    const std::size_t vertices = v.count("vertices", def.vertices.size());
    if (v.loading()) def.vertices.resize(std::min<std::size_t>(vertices, ClothDef::vertices_max));
    v.field("vertices", std::span<Vec3>(def.vertices));
    const std::size_t indices = v.count("triangles", def.triangles.size());
    if (v.loading()) def.triangles.resize(std::min(indices, 6 * def.vertices.size() + 6));
    v.field("triangles", std::span<std::uint32_t>(def.triangles));
    v.field("mass_per_area", def.mass_per_area);
    v.field("stretch_stiffness", def.stretch_stiffness);
    v.field("shear_stiffness", def.shear_stiffness);
    v.field("bending_stiffness", def.bending_stiffness);
    v.field("damping", def.damping);
    v.field("drag", def.drag);
    v.field("wind", def.wind);
    v.field("gust", def.gust);
    v.field("gust_period", def.gust_period);
    v.field("thickness", def.thickness);
    v.field("friction", def.friction);
    v.field("breaking_load", def.breaking_load);
    v.field("substeps", def.substeps);
    v.field("collide_bodies", def.collide_bodies);
    v.field("collide_self", def.collide_self);
    v.field("collide_cloths", def.collide_cloths);
    v.field("body_categories", def.body_categories);
    v.field("color", def.color);
    v.leave();
    if (!v.loading() || v.failed()) return;
    if (vertices > def.vertices.size() || indices > def.triangles.size())
        return v.fail("def", "has too many vertices or triangles");
    if (const Status s = check(def); !s.ok()) v.fail("def", s.error().message);
}

// Positions relative to the root are single precision, so a saved position is exact.
void visit_nodes(StateVisitor& v, Sheet& sheet) {
    Vec3 root = sheet.root();
    v.field("root", root);
    if (v.loading()) {
        if (!is_within(root, position_max)) return v.fail("root", "is out of range");
        sheet.set_root(root);
    }
    std::vector<Vec3> positions(sheet.size()), velocities(sheet.size());
    for (std::size_t k = 0; k < sheet.size(); k++) {
        positions[k] = sheet.relative_position(k);
        velocities[k] = sheet.velocity(k);
    }
    v.field("positions", std::span<Vec3>(positions));
    v.field("velocities", std::span<Vec3>(velocities));
    float rate = sheet.transverse_rate();
    v.field("transverse_rate", rate);
    if (!v.loading() || v.failed()) return;
    const auto bad = [](double most) { return [most](Vec3 x) { return !is_within(x, most); }; };
    if (std::ranges::any_of(positions, bad(position_max)))
        return v.fail("positions", "are out of range");
    if (std::ranges::any_of(velocities, bad(velocity_max)))
        return v.fail("velocities", "are out of range");
    if (!(rate >= 0 && rate < 1e30f)) return v.fail("transverse_rate", "is out of range");
    for (std::size_t k = 0; k < sheet.size(); k++) {
        sheet.set_relative_position(k, positions[k]);
        sheet.set_velocity(k, velocities[k]);
    }
    sheet.set_transverse_rate(rate);
}

void visit_torn(StateVisitor& v, Sheet& sheet) {
    std::vector<std::uint32_t> torn;
    for (std::uint32_t e = 0; e < sheet.torn().size(); e++)
        if (sheet.is_torn(e)) torn.push_back(e);
    const std::size_t count = v.count("torn", torn.size());
    if (v.loading()) {
        if (count > sheet.torn().size()) return v.fail("torn", "has more threads than the cloth");
        torn.resize(count);
    }
    v.field("torn", std::span<std::uint32_t>(torn));
    if (!v.loading() || v.failed() || torn.empty()) return;
    for (std::size_t k = 0; k < torn.size(); k++)
        if (torn[k] >= sheet.torn().size() || (k > 0 && torn[k] <= torn[k - 1]))
            return v.fail("torn", "has threads that do not exist or are not strictly increasing");
    sheet.tear(torn);
}

void visit_attachments(StateVisitor& v, Cloth& cloth) {
    v.all("attachments", cloth.attachments, [&](ClothAttachment& attachment) {
        v.field("vertex", attachment.vertex);
        v.field("body", attachment.body);
        v.field("point", attachment.point);
        v.field("holder", attachment.holder);
        if (!v.loading() || v.failed()) return;
        if (const Status s = check(attachment, cloth.sheet.size()); !s.ok())
            v.fail("vertex", s.error().message);
    });
    if (!v.loading() || v.failed()) return;
    if (cloth.attachments.size() > Cloths::attachments_max)
        return v.fail("attachments", "are more than 1000");
    for (std::size_t k = 1; k < cloth.attachments.size(); k++)
        if (cloth.attachments[k].vertex <= cloth.attachments[k - 1].vertex)
            return v.fail("attachments", "have vertices that are not strictly increasing");
}

void visit_contacts(StateVisitor& v, Cloth& cloth) {
    v.all("pressed", cloth.pressed, [&](Pressed& pressed) {
        v.field("vertex", pressed.vertex);
        v.field("shape", pressed.shape);
    });
    if (!v.loading() || v.failed()) return;
    for (std::size_t k = 0; k < cloth.pressed.size(); k++)
        if (cloth.pressed[k].vertex >= cloth.sheet.size() ||
            (k > 0 && cloth.pressed[k].vertex <= cloth.pressed[k - 1].vertex))
            return v.fail("pressed", "has vertices that do not exist or are not increasing");
}

void visit_cloth(StateVisitor& v, Cloth& cloth) {
    v.field("key", cloth.key.number);
    visit_def(v, cloth.def);
    if (v.failed()) return;
    if (v.loading()) cloth.sheet = Sheet(cloth.def);
    visit_torn(v, cloth.sheet);
    if (v.failed()) return;
    visit_nodes(v, cloth.sheet);
    if (v.failed()) return;
    visit_attachments(v, cloth);
    v.field("awake", cloth.awake);
    bounded(v, "rest_time", cloth.rest_time, 0, 1e12);
    visit_contacts(v, cloth);
    cloth.bodies.visit(v);
    if (v.loading() && !cloth.bodies.has_grabs_of(supports_of(cloth)))
        v.fail("attachments", "have holders without a grab");
}

}  // namespace

void Cloths::visit(StateVisitor& v) {
    v.field("last_key", last_key_);
    v.enter("cloths");
    const std::size_t count = v.count("size", cloths_.size());
    if (v.loading()) {
        cloths_.clear();
        if (count > cloths_max)
            v.fail("size", "is more than 256");
        else
            for (std::size_t k = 0; k < count; k++) cloths_.push_back(std::make_unique<Cloth>());
    }
    for (std::size_t k = 0; k < cloths_.size(); k++) {
        v.enter(k);
        visit_cloth(v, *cloths_[k]);
        v.leave();
        if (v.failed()) break;
        if (v.loading() && vertex_count() > vertices_max) {
            v.fail("cloths", "have more than 100000 vertices");
            break;
        }
    }
    v.leave();
    if (!v.loading()) return;
    if (v.failed()) {
        cloths_.clear();
        return;
    }
    for (std::size_t k = 0; k < cloths_.size(); k++) {
        const std::uint32_t key = cloths_[k]->key.number;
        if (key == 0 || key > last_key_ || (k > 0 && key <= cloths_[k - 1]->key.number))
            v.fail("cloths", "have keys that are not strictly increasing");
    }
}

}  // namespace jostle::modules
