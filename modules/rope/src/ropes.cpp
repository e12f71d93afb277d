// SPDX-License-Identifier: MIT
#include "jostle/modules/rope.h"

#include <algorithm>
#include <cmath>

#include "jostle/base/check.h"
#include "modules/rope/src/rope_checks.h"
#include "modules/rope/src/rope_companions.h"
#include "modules/rope/src/rope_data.h"
#include "modules/rope/src/rope_step.h"
#include "modules/rope/src/rope_winch.h"

namespace jostle::modules {

using namespace physics;
using rope_detail::Rope;
using rope_detail::Strand;

namespace {

// Work of a link in a sub-step, in units of StepProfile::work, times 100.
constexpr std::int64_t link_work = 80;
// The same per link of ropes near each other, and per square of the number of touching links.
constexpr std::int64_t near_link_work = 2000, touching_work = 600;

// In a sub-step, of a leader and its companions.
std::int64_t contact_work(const Rope& leader) {
    std::int64_t links = 0, touching = 0;
    const auto count = [&](const Rope& rope) {
        if (rope.link_contacts.empty()) return;
        links += static_cast<std::int64_t>(rope.strand.links());
        touching += std::ranges::count_if(
            rope.link_contacts, [](const auto& contact) { return contact.force != Vec3{}; });
    };
    count(leader);
    for (const Rope* companion : leader.companions) count(*companion);
    return links * near_link_work + touching * touching * touching_work;
}

Error unknown(RopeKey key) {
    return Error{ErrorCode::not_found, "no rope has the key " + std::to_string(key.number)};
}

// The point at a distance along a line of points.
Vec3 point_at(const std::vector<Vec3>& points, double distance) {
    for (std::size_t k = 1; k < points.size(); k++) {
        const double piece = length(points[k] - points[k - 1]);
        if (distance <= piece && piece > 0)
            return points[k - 1] + (points[k] - points[k - 1]) * (distance / piece);
        distance -= piece;
    }
    return points.back();
}

Strand strand_of(const RopeDef& def) {
    double line = 0;
    for (std::size_t k = 1; k < def.points.size(); k++)
        line += length(def.points[k] - def.points[k - 1]);
    Strand strand;
    for (std::uint32_t i = 0; i <= def.links; i++)
        strand.positions.push_back(point_at(def.points, line * i / def.links));
    strand.velocities.resize(def.links + 1);
    strand.rest_lengths.assign(def.links, (def.length > 0 ? def.length : line) / def.links);
    strand.force_densities.assign(def.links, 0);
    strand.mass_per_length = def.mass_per_length;
    strand.stretch_stiffness = def.stretch_stiffness;
    strand.bending_stiffness = def.bending_stiffness;
    return strand;
}

bool same_material(const RopeDef& a, const RopeDef& b) {
    return a.mass_per_length == b.mass_per_length && a.stretch_stiffness == b.stretch_stiffness &&
           a.bending_stiffness == b.bending_stiffness && a.radius == b.radius;
}

void move_grab_of(const RopeAttachment& attachment, Rope& from, Rope& to) {
    if (const PointGrab* grab = from.bodies.grab(attachment.holder)) {
        to.bodies.add_grab(*grab);
        from.bodies.remove_grab(attachment.holder);
    }
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from, std::size_t first = 0) {
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first), from.end());
}

}  // namespace

Ropes::Ropes() = default;
Ropes::~Ropes() = default;

Rope* Ropes::find(RopeKey key) const {
    const auto at =
        std::ranges::lower_bound(ropes_, key, {}, [](const auto& rope) { return rope->key; });
    return at != ropes_.end() && (*at)->key == key ? at->get() : nullptr;
}

std::size_t Ropes::link_count() const {
    std::size_t sum = 0;
    for (const auto& rope : ropes_) sum += rope->strand.links();
    return sum;
}

std::vector<RopeKey> Ropes::ropes() const {
    std::vector<RopeKey> keys;
    for (const auto& rope : ropes_) keys.push_back(rope->key);
    return keys;
}

const RopeDef& Ropes::def(RopeKey key) const {
    static const RopeDef none;
    const Rope* rope = find(key);
    return rope == nullptr ? none : rope->def;
}
std::span<const Vec3> Ropes::positions(RopeKey key) const {
    const Rope* rope = find(key);
    return rope == nullptr ? std::span<const Vec3>() : rope->strand.positions;
}
std::span<const Vec3> Ropes::velocities(RopeKey key) const {
    const Rope* rope = find(key);
    return rope == nullptr ? std::span<const Vec3>() : rope->strand.velocities;
}
std::span<const double> Ropes::rest_lengths(RopeKey key) const {
    const Rope* rope = find(key);
    return rope == nullptr ? std::span<const double>() : rope->strand.rest_lengths;
}
std::span<const RopeAttachment> Ropes::attachments(RopeKey key) const {
    const Rope* rope = find(key);
    return rope == nullptr ? std::span<const RopeAttachment>() : rope->attachments;
}
double Ropes::tension(RopeKey key, std::size_t link) const {
    const Rope* rope = find(key);
    if (rope == nullptr || link >= rope->strand.links()) return 0;
    return rope->strand.force_densities[link] * rope->strand.rest_lengths[link];
}
bool Ropes::is_awake(RopeKey key) const {
    const Rope* rope = find(key);
    return rope != nullptr && rope->awake;
}

Result<RopeKey> Ropes::add(World&, const RopeDef& def) {
    if (Status s = rope_detail::check(def); !s.ok()) return s.error();
    if (ropes_.size() >= ropes_max)
        return Error{ErrorCode::resource_exhausted,
                     "there are " + std::to_string(ropes_max) + " ropes already"};
    if (link_count() + def.links > links_max)
        return Error{ErrorCode::resource_exhausted, "links: all ropes would have more than " +
                                                        std::to_string(links_max) +
                                                        " links; reduce the links of this rope"};
    auto rope = std::make_unique<Rope>();
    rope->key = {++last_key_};
    rope->def = def;
    rope->strand = strand_of(def);
    rope->link_length = rope->strand.rest_lengths[0];
    ropes_.push_back(std::move(rope));
    return ropes_.back()->key;
}

Status Ropes::remove(World& world, RopeKey key) {
    Rope* rope = find(key);
    if (rope == nullptr) return unknown(key);
    rope->bodies.ties().release(world);
    rope_detail::forget_companion(ropes_, *rope);
    std::erase_if(ropes_, [&](const auto& each) { return each.get() == rope; });
    return {};
}

Status Ropes::attach(World& world, RopeKey key, const RopeAttachment& attachment) {
    Rope* rope = find(key);
    if (rope == nullptr) return unknown(key);
    if (Status s = rope_detail::check(attachment, rope->strand.links()); !s.ok()) return s;
    if (attachment.holder != 0)
        return Error{ErrorCode::invalid_argument, "holder: must be 0; use grab()"};
    if (!is_null(attachment.body) && !world.contains(attachment.body))
        return Error{ErrorCode::not_found, "body: no body has this id"};
    const auto at =
        std::ranges::lower_bound(rope->attachments, attachment.node, {}, &RopeAttachment::node);
    if (at != rope->attachments.end() && at->node == attachment.node) {
        *at = attachment;
    } else {
        if (rope->attachments.size() >= attachments_max)
            return Error{
                ErrorCode::resource_exhausted,
                "the rope has " + std::to_string(attachments_max) + " attachments already"};
        rope->attachments.insert(at, attachment);
    }
    rope_detail::wake(*rope);
    return {};
}

Status Ropes::detach(World&, RopeKey key, std::uint32_t node) {
    Rope* rope = find(key);
    if (rope == nullptr) return unknown(key);
    const auto removed = std::erase_if(rope->attachments, [&](const RopeAttachment& attachment) {
        return attachment.node == node;
    });
    if (removed == 0)
        return Error{ErrorCode::not_found, "node " + std::to_string(node) + " is not attached"};
    rope_detail::wake(*rope);
    return {};
}

Status Ropes::set_winch(World&, RopeKey key, RopeEnd end, double speed) {
    Rope* rope = find(key);
    if (rope == nullptr) return unknown(key);
    if (!(std::abs(speed) <= 100))
        return Error{ErrorCode::invalid_argument,
                     "speed: " + std::to_string(speed) +
                         " is out of range; must be between -100 and 100 m/s"};
    const auto node = end == RopeEnd::first ? 0u : static_cast<std::uint32_t>(rope->strand.links());
    if (speed != 0 && std::ranges::find(rope->attachments, node, &RopeAttachment::node) ==
                          rope->attachments.end())
        return Error{ErrorCode::failed_precondition,
                     "the end is not attached; attach it to the winch first"};
    rope->winch[end == RopeEnd::first ? 0 : 1] = speed;
    rope_detail::wake(*rope);
    return {};
}

// ---- cutting and joining ----

// Both parts contain the node, so mass and momentum are conserved. Attachments of the node remain
// with the first part.
Result<RopeKey> Ropes::split(World& world, Rope& rope, std::size_t node, RopeEventKind kind,
                             double tension) {
    ASSERT(node > 0 && node < rope.strand.links());
    if (ropes_.size() >= ropes_max)
        return Error{ErrorCode::resource_exhausted,
                     "there are " + std::to_string(ropes_max) + " ropes already"};
    auto rest = std::make_unique<Rope>();
    rest->key = {++last_key_};
    rest->def = rope.def;
    rest->link_length = rope.link_length;
    Strand &a = rope.strand, &b = rest->strand;
    b.mass_per_length = a.mass_per_length;
    b.stretch_stiffness = a.stretch_stiffness;
    b.bending_stiffness = a.bending_stiffness;
    append(b.positions, a.positions, node);
    append(b.velocities, a.velocities, node);
    append(b.rest_lengths, a.rest_lengths, node);
    append(b.force_densities, a.force_densities, node);
    a.positions.resize(node + 1);
    a.velocities.resize(node + 1);
    a.rest_lengths.resize(node);
    a.force_densities.resize(node);
    for (RopeAttachment attachment : rope.attachments) {
        if (attachment.node <= node) continue;
        attachment.node -= static_cast<std::uint32_t>(node);
        rest->attachments.push_back(attachment);
        move_grab_of(attachment, rope, *rest);
    }
    std::erase_if(rope.attachments,
                  [&](const RopeAttachment& attachment) { return attachment.node > node; });
    rest->winch[1] = std::exchange(rope.winch[1], 0);
    rope.contacts.clear();
    rope.link_contacts.clear();
    rope_detail::forget_companion(ropes_, rope);
    rope.bodies.ties().release(world);
    rope_detail::wake(rope);
    events_.push_back({kind, rope.key, rest->key, b.positions[0], tension});
    ropes_.push_back(std::move(rest));
    return ropes_.back()->key;
}

Result<RopeKey> Ropes::cut(World& world, RopeKey key, Vec3 point) {
    Rope* rope = find(key);
    if (rope == nullptr) return unknown(key);
    if (!is_finite(point))
        return Error{ErrorCode::invalid_argument, "point: is not finite; must be a point in m"};
    if (rope->strand.links() < 2)
        return Error{ErrorCode::failed_precondition,
                     "the rope has one link; only ropes with inner nodes can be cut"};
    std::size_t nearest = 1;
    for (std::size_t i = 1; i < rope->strand.links(); i++)
        if (length_squared(rope->strand.positions[i] - point) <
            length_squared(rope->strand.positions[nearest] - point))
            nearest = i;
    return split(world, *rope, nearest, RopeEventKind::cut, 0);
}

Status Ropes::join(World& world, RopeKey key, RopeKey next_key) {
    Rope *rope = find(key), *next = find(next_key);
    if (rope == nullptr) return unknown(key);
    if (next == nullptr) return unknown(next_key);
    if (rope == next)
        return Error{ErrorCode::failed_precondition, "a rope cannot be joined to itself"};
    if (!same_material(rope->def, next->def))
        return Error{ErrorCode::invalid_argument,
                     "the ropes differ in mass_per_length, stretch_stiffness, bending_stiffness or "
                     "radius; they must be equal"};
    Strand &a = rope->strand, &b = next->strand;
    if (a.links() + b.links() + 1 > RopeDef::links_max)
        return Error{ErrorCode::resource_exhausted, "the joined rope would have more than " +
                                                        std::to_string(RopeDef::links_max) +
                                                        " links"};
    const double gap = length(b.positions.front() - a.positions.back());
    const double longest = std::max(*std::ranges::max_element(a.rest_lengths),
                                    *std::ranges::max_element(b.rest_lengths));
    if (gap > longest)
        return Error{ErrorCode::invalid_argument,
                     "the ends are " + std::to_string(gap) + " m apart; must be at most " +
                         std::to_string(longest) + " m, the length of a link"};
    a.rest_lengths.push_back(std::max(gap, 0.1 * rope->link_length));
    a.force_densities.push_back(0);
    const auto offset = static_cast<std::uint32_t>(a.positions.size());
    append(a.positions, b.positions);
    append(a.velocities, b.velocities);
    append(a.rest_lengths, b.rest_lengths);
    append(a.force_densities, b.force_densities);
    for (RopeAttachment attachment : next->attachments) {
        if (rope->attachments.size() >= attachments_max) break;
        attachment.node += offset;
        rope->attachments.push_back(attachment);
        move_grab_of(attachment, *next, *rope);
    }
    rope->winch[1] = next->winch[1];
    // Directions are held at the ends only.
    for (RopeAttachment& attachment : rope->attachments)
        if (attachment.node != 0 && attachment.node != a.links()) attachment.direction = {};
    rope->contacts.clear();
    rope->link_contacts.clear();
    rope_detail::forget_companion(ropes_, *rope);
    rope_detail::wake(*rope);
    events_.push_back({RopeEventKind::joined, key, next_key, a.positions[offset], 0});
    return remove(world, next_key);
}

// ---- the step ----

StepHooks Ropes::hooks() const {
    const bool owned = std::ranges::any_of(ropes_, [](const auto& rope) {
        return rope->awake && !rope->bodies.ties().bodies().empty();
    });
    return {.substeps = owned, .pre_solve = false, .concurrent = true};
}

void Ropes::before_step(World& world, double dt) {
    events_.clear();
    if (ropes_.empty()) return;
    fields_.clear();
    for (const FieldId id : world.fields())
        if (const Result<FieldDef> field = world.field(id); field.ok()) fields_.push_back(*field);
    std::vector<Rope*> alone;
    std::int64_t work = 0;
    for (const auto& rope : ropes_) {
        if (rope->winch[0] != 0 || rope->winch[1] != 0)
            rope_detail::keep_link_lengths(*rope, links_max - std::min(links_max, link_count()));
        rope_detail::begin_step(world, *rope, dt, !fields_.empty());
    }
    rope_detail::find_companions(ropes_, dt, world.gravity());
    // Leaders tie the bodies of their companions.
    for (const bool leads : {false, true})
        for (const auto& rope : ropes_)
            if (rope->awake && (rope->leader == nullptr) == leads)
                rope_detail::find_bodies(world, *rope, dt);
    for (const auto& rope : ropes_) {
        if (!rope->awake) continue;
        std::int64_t each = static_cast<std::int64_t>(rope->strand.links()) * link_work;
        if (rope->leader == nullptr) each += contact_work(*rope);
        work += each * std::max<std::int64_t>(rope->def.substeps, world.substeps());
        if (rope->leader == nullptr && rope->bodies.ties().bodies().empty())
            alone.push_back(rope.get());
    }
    world.count_work(work / 100);
    struct Run {
        std::vector<Rope*>& ropes;
        rope_detail::RopeSubstep substep;
        int count;
    } run{alone,
          {dt / world.substeps(), world.gravity(), world.time(), fields_, nullptr},
          world.substeps()};
    world.parallel_for(static_cast<int>(alone.size()), 1, [&run](int first, int last) {
        for (int k = first; k < last; k++)
            for (int n = 0; n < run.count; n++) {
                rope_detail::RopeSubstep substep = run.substep;
                substep.time += n * substep.h;
                rope_detail::advance(*run.ropes[static_cast<std::size_t>(k)], substep, run.count);
            }
    });
}

void Ropes::before_substep(SubstepContext& substep) {
    const rope_detail::RopeSubstep own{substep.h(), substep.world().gravity(), substep.time(),
                                       fields_, &substep};
    const auto leads = [&](const Rope& rope) {
        return rope.awake && rope.leader == nullptr && rope.bodies.ties().owned_by(substep);
    };
    for (const auto& rope : ropes_) {
        if (!leads(*rope)) continue;
        rope->bodies.push_as_before(substep);
        for (Rope* companion : rope->companions) companion->bodies.push_as_before(substep);
    }
    for (const auto& rope : ropes_)
        if (leads(*rope)) rope_detail::advance(*rope, own, substep.count());
}

void Ropes::after_step(World& world, double dt) {
    if (ropes_.empty()) return;
    const std::size_t count = ropes_.size();
    for (std::size_t k = 0; k < count; k++) {
        Rope& rope = *ropes_[k];
        // Its bodies were in no group, for example because the step was stopped.
        if (rope.awake && rope.leader == nullptr && rope.substeps_done == 0)
            rope_detail::advance(rope, {dt, world.gravity(), world.time() - dt, fields_, nullptr},
                                 1);
    }
    for (std::size_t k = 0; k < count; k++) {
        Rope& rope = *ropes_[k];
        if (!rope.awake) continue;
        rope_detail::end_step(world, rope, dt, !fields_.empty());
        if (rope.def.breaking_load == 0 || rope.peak_tension <= rope.def.breaking_load) continue;
        // Breaks at the inner node next to the link, or at its attachment if there is none.
        const std::size_t node = std::clamp<std::size_t>(
            rope.peak_link, 1, std::max<std::size_t>(rope.strand.links(), 2) - 1);
        if (rope.strand.links() >= 2)
            static_cast<void>(split(world, rope, node, RopeEventKind::broken, rope.peak_tension));
    }
}

void Ropes::restored(const World&) {
    events_.clear();
}

void register_ropes() {
    static_cast<void>(register_module("rope", [] { return std::make_unique<Ropes>(); }));
}

}  // namespace jostle::modules
