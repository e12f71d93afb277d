// SPDX-License-Identifier: MIT
#include "jostle/modules/cloth.h"

#include <algorithm>
#include <string>

#include "jostle/base/check.h"
#include "modules/cloth/src/cloth_checks.h"
#include "modules/cloth/src/cloth_companions.h"
#include "modules/cloth/src/cloth_data.h"
#include "modules/cloth/src/cloth_step.h"

namespace jostle::modules {

using namespace physics;
using cloth_detail::Cloth;

namespace {

// Work per vertex and part of a sub-step, in units of StepProfile::work, times 100.
constexpr std::int64_t vertex_work = 30;

Error unknown(ClothKey key) {
    return Error{ErrorCode::not_found, "no cloth has the key " + std::to_string(key.number)};
}

// Breaks threads and reports them.
void tear_threads(Cloth& cloth, std::vector<std::uint32_t> threads, double tension,
                  std::vector<ClothEvent>& events) {
    const std::uint32_t first = threads.front();
    std::ranges::sort(threads);
    threads.erase(std::unique(threads.begin(), threads.end()), threads.end());
    const auto& edge = cloth.sheet.topology().edges[first];
    const Vec3 point = (cloth.sheet.position(edge.a) + cloth.sheet.position(edge.b)) * 0.5;
    cloth.sheet.tear(threads);
    cloth_detail::wake(cloth);
    events.push_back({ClothEventKind::torn, cloth.key, static_cast<std::uint32_t>(threads.size()),
                      point, tension});
}

}  // namespace

Cloths::Cloths() = default;
Cloths::~Cloths() = default;

Cloth* Cloths::find(ClothKey key) const {
    const auto at =
        std::ranges::lower_bound(cloths_, key, {}, [](const auto& cloth) { return cloth->key; });
    return at != cloths_.end() && (*at)->key == key ? at->get() : nullptr;
}

std::size_t Cloths::vertex_count() const {
    std::size_t sum = 0;
    for (const auto& cloth : cloths_) sum += cloth->sheet.size();
    return sum;
}

std::vector<ClothKey> Cloths::cloths() const {
    std::vector<ClothKey> keys;
    for (const auto& cloth : cloths_) keys.push_back(cloth->key);
    return keys;
}

const ClothDef& Cloths::def(ClothKey key) const {
    static const ClothDef none;
    const Cloth* cloth = find(key);
    return cloth == nullptr ? none : cloth->def;
}
std::vector<Vec3> Cloths::positions(ClothKey key) const {
    std::vector<Vec3> all;
    if (const Cloth* cloth = find(key))
        for (std::size_t k = 0; k < cloth->sheet.size(); k++)
            all.push_back(cloth->sheet.position(k));
    return all;
}
std::vector<Vec3> Cloths::velocities(ClothKey key) const {
    std::vector<Vec3> all;
    if (const Cloth* cloth = find(key))
        for (std::size_t k = 0; k < cloth->sheet.size(); k++)
            all.push_back(cloth->sheet.velocity(k));
    return all;
}
std::vector<double> Cloths::masses(ClothKey key) const {
    const Cloth* cloth = find(key);
    return cloth == nullptr ? std::vector<double>() : cloth->sheet.topology().masses;
}
std::span<const std::array<std::uint32_t, 3>> Cloths::triangles(ClothKey key) const {
    const Cloth* cloth = find(key);
    if (cloth == nullptr) return {};
    return cloth->sheet.topology().triangles;
}
std::span<const ClothAttachment> Cloths::attachments(ClothKey key) const {
    const Cloth* cloth = find(key);
    return cloth == nullptr ? std::span<const ClothAttachment>() : cloth->attachments;
}
double Cloths::greatest_tension(ClothKey key) const {
    const Cloth* cloth = find(key);
    double most = 0;
    if (cloth == nullptr) return most;
    const auto& edges = cloth->sheet.topology().edges;
    for (std::size_t e = 0; e < edges.size(); e++)
        most = std::max(most, cloth->sheet.tension(e) / edges[e].width);
    return most;
}
bool Cloths::is_awake(ClothKey key) const {
    const Cloth* cloth = find(key);
    return cloth != nullptr && cloth->awake;
}

Result<ClothKey> Cloths::add(World&, const ClothDef& def) {
    if (Status s = cloth_detail::check(def); !s.ok()) return s.error();
    if (cloths_.size() >= cloths_max)
        return Error{ErrorCode::resource_exhausted,
                     "there are " + std::to_string(cloths_max) + " cloths already"};
    const std::size_t vertices =
        def.triangles.empty() ? std::size_t{def.grid.rows} * def.grid.columns : def.vertices.size();
    if (vertex_count() + vertices > vertices_max)
        return Error{ErrorCode::resource_exhausted,
                     "all cloths would have more than " + std::to_string(vertices_max) +
                         " vertices; reduce the vertices of this cloth"};
    auto cloth = std::make_unique<Cloth>();
    cloth->key = {++last_key_};
    cloth->def = def;
    cloth->sheet = cloth_detail::Sheet(def);
    cloths_.push_back(std::move(cloth));
    return cloths_.back()->key;
}

Status Cloths::remove(World& world, ClothKey key) {
    Cloth* cloth = find(key);
    if (cloth == nullptr) return unknown(key);
    cloth->bodies.ties().release(world);
    cloth_detail::forget_companion(cloths_, *cloth);
    std::erase_if(cloths_, [&](const auto& each) { return each.get() == cloth; });
    return {};
}

Status Cloths::attach(World& world, ClothKey key, const ClothAttachment& attachment) {
    Cloth* cloth = find(key);
    if (cloth == nullptr) return unknown(key);
    if (Status s = cloth_detail::check(attachment, cloth->sheet.size()); !s.ok()) return s;
    if (attachment.holder != 0)
        return Error{ErrorCode::invalid_argument, "holder: must be 0; use grab()"};
    if (!is_null(attachment.body) && !world.contains(attachment.body))
        return Error{ErrorCode::not_found, "body: no body has this id"};
    const auto at = std::ranges::lower_bound(cloth->attachments, attachment.vertex, {},
                                             &ClothAttachment::vertex);
    if (at != cloth->attachments.end() && at->vertex == attachment.vertex) {
        *at = attachment;
    } else {
        if (cloth->attachments.size() >= attachments_max)
            return Error{
                ErrorCode::resource_exhausted,
                "the cloth has " + std::to_string(attachments_max) + " attachments already"};
        cloth->attachments.insert(at, attachment);
    }
    cloth_detail::wake(*cloth);
    return {};
}

Status Cloths::detach(World&, ClothKey key, std::uint32_t vertex) {
    Cloth* cloth = find(key);
    if (cloth == nullptr) return unknown(key);
    const auto removed = std::erase_if(cloth->attachments, [&](const ClothAttachment& attachment) {
        return attachment.vertex == vertex;
    });
    if (removed == 0)
        return Error{ErrorCode::not_found, "vertex " + std::to_string(vertex) + " is not attached"};
    cloth_detail::wake(*cloth);
    return {};
}

Result<std::uint32_t> Cloths::tear(World&, ClothKey key, Vec3 point, double radius) {
    Cloth* cloth = find(key);
    if (cloth == nullptr) return unknown(key);
    if (!is_finite(point) || !(radius >= 0 && radius <= 1e6))
        return Error{ErrorCode::invalid_argument,
                     "point and radius: must be finite, and the radius between 0 and 1e6 m"};
    std::vector<std::uint32_t> threads;
    const auto& edges = cloth->sheet.topology().edges;
    const auto is_near = [&](std::uint32_t v) {
        return length(cloth->sheet.position(v) - point) <= radius;
    };
    for (std::uint32_t e = 0; e < edges.size(); e++)
        if (!cloth->sheet.is_torn(e) && (is_near(edges[e].a) || is_near(edges[e].b)))
            threads.push_back(e);
    const auto count = static_cast<std::uint32_t>(threads.size());
    if (count > 0) tear_threads(*cloth, std::move(threads), 0, events_);
    return count;
}

Status Cloths::apply_impulse(World&, ClothKey key, std::uint32_t vertex, Vec3 impulse) {
    Cloth* cloth = find(key);
    if (cloth == nullptr) return unknown(key);
    if (vertex >= cloth->sheet.size())
        return Error{ErrorCode::invalid_argument, "vertex: does not exist"};
    const Vec3 change = impulse * cloth->sheet.free_inverse_mass(vertex);
    if (!is_finite(impulse) || !(length(change) <= 1e4))
        return Error{ErrorCode::invalid_argument,
                     "impulse: must change the velocity of the vertex by at most 10000 m/s"};
    cloth->sheet.set_velocity(vertex, cloth->sheet.velocity(vertex) + change);
    cloth_detail::wake(*cloth);
    return {};
}

// ---- the step ----

StepHooks Cloths::hooks() const {
    const bool owned = std::ranges::any_of(cloths_, [](const auto& cloth) {
        return cloth->awake && !cloth->bodies.ties().bodies().empty();
    });
    return {.substeps = owned, .pre_solve = false, .concurrent = true};
}

void Cloths::before_step(World& world, double dt) {
    events_.clear();
    if (cloths_.empty()) return;
    for (const auto& cloth : cloths_) cloth_detail::begin_step(world, *cloth, dt);
    cloth_detail::find_companions(cloths_, dt, world.gravity());
    // Leaders tie the bodies of their companions.
    for (const bool leads : {false, true})
        for (const auto& cloth : cloths_)
            if (cloth->awake && (cloth->leader == nullptr) == leads)
                cloth_detail::find_bodies(world, *cloth, dt);
    std::vector<Cloth*> alone;
    std::int64_t work = 0;
    for (const auto& cloth : cloths_) {
        if (!cloth->awake) continue;
        work += static_cast<std::int64_t>(cloth->sheet.size()) * vertex_work *
                cloth->sheet.stable_parts(dt, static_cast<int>(cloth->def.substeps));
        if (cloth->leader == nullptr && cloth->bodies.ties().bodies().empty())
            alone.push_back(cloth.get());
    }
    world.count_work(work / 100);
    struct Run {
        std::vector<Cloth*>& cloths;
        cloth_detail::ClothSubstep substep;
    } run{alone, {dt, world.gravity(), nullptr}};
    world.parallel_for(static_cast<int>(alone.size()), 1, [&run](int first, int last) {
        for (int k = first; k < last; k++) {
            Cloth& cloth = *run.cloths[static_cast<std::size_t>(k)];
            cloth_detail::advance(cloth, run.substep, 1);
        }
    });
}

void Cloths::before_substep(SubstepContext& substep) {
    const cloth_detail::ClothSubstep own{substep.h(), substep.world().gravity(), &substep};
    for (const auto& cloth : cloths_) {
        if (!cloth->awake || cloth->leader != nullptr) continue;
        if (!cloth->bodies.ties().owned_by(substep)) continue;
        cloth_detail::advance(*cloth, own, substep.count());
    }
}

void Cloths::after_step(World& world, double dt) {
    for (const auto& cloth : cloths_) {
        if (!cloth->awake) continue;
        // Its bodies were in no group, for example because the step was stopped.
        if (cloth->substeps_done == 0 && cloth->leader == nullptr)
            cloth_detail::advance(*cloth, {dt, world.gravity(), nullptr}, 1);
        cloth_detail::end_step(world, *cloth, dt);
        if (!cloth->overloaded.empty())
            tear_threads(*cloth, std::move(cloth->overloaded), cloth->overload, events_);
        cloth->overloaded.clear();
    }
}

void Cloths::restored(const World&) {
    events_.clear();
}

void register_cloths() {
    static_cast<void>(register_module("cloth", [] { return std::make_unique<Cloths>(); }));
}

}  // namespace jostle::modules
