// SPDX-License-Identifier: MIT
//
// State of ropes: saved, loaded, hashed and compared. Loaded values are checked here.
#include <algorithm>

#include "jostle/modules/rope.h"
#include "jostle/modules/settings.h"
#include "modules/rope/src/rope_checks.h"
#include "modules/rope/src/rope_data.h"

namespace jostle::modules {

using namespace physics;
using namespace rope_detail;

namespace {

// Positions and velocities beyond these are not reached by ropes that are checked, m and m/s.
constexpr double position_max = 1e9, speed_max = 1e9, tension_max = 1e18;

bool is_within(Vec3 v, double most) {
    const Vec3 size = abs(v);
    return size.x <= most && size.y <= most && size.z <= most;
}

void visit_def(StateVisitor& v, RopeDef& def) {
    v.enter("def");
    std::size_t points = v.count("points", def.points.size());
    if (v.loading()) def.points.resize(std::min(points, RopeDef::points_max));
    v.field("points", std::span<Vec3>(def.points));
    v.field("links", def.links);
    v.field("length", def.length);
    v.field("radius", def.radius);
    v.field("mass_per_length", def.mass_per_length);
    v.field("stretch_stiffness", def.stretch_stiffness);
    v.field("bending_stiffness", def.bending_stiffness);
    v.field("damping", def.damping);
    v.field("friction", def.friction);
    v.field("breaking_load", def.breaking_load);
    v.field("substeps", def.substeps);
    v.field("collide_bodies", def.collide_bodies);
    v.field("collide_self", def.collide_self);
    v.field("collide_ropes", def.collide_ropes);
    v.field("body_categories", def.body_categories);
    v.field("color", def.color);
    v.leave();
    if (!v.loading()) return;
    if (points > RopeDef::points_max) return v.fail("def", "has more than 256 points");
    if (const Status s = check(def); !s.ok()) v.fail("def", s.error().message);
}

void visit_strand(StateVisitor& v, Strand& s) {
    v.enter("strand");
    const std::size_t nodes = v.count("nodes", s.positions.size());
    if (v.loading()) {
        if (nodes < 2 || nodes > RopeDef::links_max + 1) {
            v.fail("nodes", "must be between 2 and 2001");
            v.leave();
            return;
        }
        s.positions.resize(nodes);
        s.velocities.resize(nodes);
        s.rest_lengths.resize(nodes - 1);
        s.force_densities.resize(nodes - 1);
    }
    v.field("positions", std::span<Vec3>(s.positions));
    v.field("velocities", std::span<Vec3>(s.velocities));
    v.field("rest_lengths", std::span<double>(s.rest_lengths));
    v.field("force_densities", std::span<double>(s.force_densities));
    v.leave();
    if (!v.loading() || v.failed()) return;
    const auto bad = [](double most) { return [most](Vec3 x) { return !is_within(x, most); }; };
    if (std::ranges::any_of(s.positions, bad(position_max)))
        v.fail("strand.positions", "are out of range");
    if (std::ranges::any_of(s.velocities, bad(speed_max)))
        v.fail("strand.velocities", "are out of range");
    if (std::ranges::any_of(s.rest_lengths, [](double x) { return !(x >= 1e-6 && x <= 1e6); }))
        v.fail("strand.rest_lengths", "are out of range; must be between 1e-6 and 1e6 m");
    if (std::ranges::any_of(s.force_densities,
                            [](double x) { return !(std::abs(x) <= tension_max); }))
        v.fail("strand.force_densities", "are out of range");
}

void visit_attachments(StateVisitor& v, Rope& rope) {
    v.all("attachments", rope.attachments, [&](RopeAttachment& attachment) {
        v.field("node", attachment.node);
        v.field("body", attachment.body);
        v.field("point", attachment.point);
        v.field("direction", attachment.direction);
        v.field("holder", attachment.holder);
        if (!v.loading() || v.failed()) return;
        if (const Status s = check(attachment, rope.strand.links()); !s.ok())
            v.fail("node", s.error().message);
    });
    if (!v.loading() || v.failed()) return;
    if (rope.attachments.size() > Ropes::attachments_max)
        return v.fail("attachments", "are more than 64");
    for (std::size_t k = 1; k < rope.attachments.size(); k++)
        if (rope.attachments[k].node <= rope.attachments[k - 1].node)
            return v.fail("attachments", "have nodes that are not strictly increasing");
}

void visit_contacts(StateVisitor& v, Rope& rope) {
    v.all("contacts", rope.contacts, [&](SavedContact& contact) {
        v.field("link", contact.link);
        v.field("shape", contact.shape);
        v.field("grip", contact.grip, ContactGrip::drags);
        v.field("slip", contact.slip);
        v.field("pressure", contact.pressure);
        if (!v.loading() || v.failed()) return;
        if (contact.link >= rope.strand.links()) v.fail("link", "does not exist");
        if (!is_within(contact.slip, 1.001)) v.fail("slip", "is longer than 1");
        if (!(contact.pressure >= 0 && contact.pressure <= tension_max))
            v.fail("pressure", "is out of range");
    });
}

void visit_link_contacts(StateVisitor& v, Rope& rope) {
    v.all("link_contacts", rope.link_contacts, [&](LinkContact& contact) {
        v.field("link", contact.link);
        v.field("other", contact.other);
        v.field("other_link", contact.other_link);
        v.field("normal", contact.normal);
        v.field("distance", contact.distance);
        v.field("force", contact.force);
        if (!v.loading() || v.failed()) return;
        if (contact.link >= rope.strand.links()) v.fail("link", "does not exist");
        if (!is_within(contact.normal, 1.001)) v.fail("normal", "is longer than 1");
        if (!(contact.distance > 0 && contact.distance <= 2 * 10))
            v.fail("distance", "is out of range; must be above 0 and at most 20 m");
        if (!is_within(contact.force, tension_max)) v.fail("force", "is out of range");
    });
    if (!v.loading() || v.failed()) return;
    const auto place = [](const LinkContact& c) {
        return std::tuple(c.link, c.other, c.other_link);
    };
    for (std::size_t k = 1; k < rope.link_contacts.size(); k++)
        if (place(rope.link_contacts[k]) <= place(rope.link_contacts[k - 1]))
            return v.fail("link_contacts", "are not strictly increasing");
}

void visit_rope(StateVisitor& v, Rope& rope) {
    v.field("key", rope.key.number);
    visit_def(v, rope.def);
    if (v.failed()) return;
    visit_strand(v, rope.strand);
    if (v.failed()) return;
    visit_attachments(v, rope);
    bounded(v, "winch_first", rope.winch[0], -100, 100);
    bounded(v, "winch_last", rope.winch[1], -100, 100);
    bounded(v, "link_length", rope.link_length, 1e-4, 1e6);
    v.field("awake", rope.awake);
    bounded(v, "rest_time", rope.rest_time, 0, 1e12);
    visit_contacts(v, rope);
    visit_link_contacts(v, rope);
    rope.bodies.visit(v);
    if (!v.loading()) return;
    if (!rope.bodies.has_grabs_of(supports_of(rope)))
        v.fail("attachments", "have holders without a grab");
    rope.strand.mass_per_length = rope.def.mass_per_length;
    rope.strand.stretch_stiffness = rope.def.stretch_stiffness;
    rope.strand.bending_stiffness = rope.def.bending_stiffness;
}

}  // namespace

void Ropes::visit(StateVisitor& v) {
    v.field("last_key", last_key_);
    v.enter("ropes");
    const std::size_t count = v.count("size", ropes_.size());
    if (v.loading()) {
        ropes_.clear();
        if (count > ropes_max)
            v.fail("size", "is more than 1024");
        else
            for (std::size_t k = 0; k < count; k++) ropes_.push_back(std::make_unique<Rope>());
    }
    for (std::size_t k = 0; k < ropes_.size(); k++) {
        v.enter(k);
        visit_rope(v, *ropes_[k]);
        v.leave();
        if (v.failed()) break;
    }
    v.leave();
    if (!v.loading()) return;
    if (v.failed()) {
        ropes_.clear();
        return;
    }
    for (std::size_t k = 0; k < ropes_.size(); k++) {
        const std::uint32_t key = ropes_[k]->key.number;
        if (key == 0 || key > last_key_ || (k > 0 && key <= ropes_[k - 1]->key.number))
            v.fail("ropes", "have keys that are not strictly increasing");
    }
    if (link_count() > links_max) v.fail("ropes", "have more than 20000 links");
}

}  // namespace jostle::modules
