// SPDX-License-Identifier: MIT
#include "jostle/modules/particles.h"

#include <algorithm>

#include "jostle/modules/settings.h"
#include "modules/particles/src/body_impacts.h"

namespace jostle::modules {

using namespace physics;

Particles::Particles() : impacts_(std::make_unique<particles_detail::BodyImpacts>()) {}
Particles::~Particles() = default;

Particles::Entry* Particles::find(ParticleKey key) {
    const auto at = std::ranges::find(entries_, key, &Entry::key);
    return at == entries_.end() ? nullptr : &*at;
}

ParticleGroup* Particles::group(ParticleKey key) {
    Entry* entry = find(key);
    return entry == nullptr ? nullptr : &entry->group;
}

const ParticleGroup* Particles::group(ParticleKey key) const {
    return const_cast<Particles*>(this)->group(key);
}

std::vector<ParticleKey> Particles::groups() const {
    std::vector<ParticleKey> keys;
    for (const Entry& entry : entries_) keys.push_back(entry.key);
    return keys;
}

double Particles::work_except(ParticleKey key) const {
    double sum = 0;
    for (const Entry& entry : entries_)
        if (entry.key != key) sum += work_of(entry.group.def());
    return sum;
}

Status Particles::check_work(ParticleKey key, const ParticleGroupDef& def) const {
    const double sum = work_except(key) + work_of(def);
    if (sum <= work_max) return {};
    return Error{ErrorCode::resource_exhausted,
                 "the groups need " + std::to_string(static_cast<std::int64_t>(sum)) +
                     " units of work per step; the maximum is 4000000; reduce count_max, substeps "
                     "or flow.octaves"};
}

Result<ParticleKey> Particles::add(const World& world, const ParticleGroupDef& def) {
    if (entries_.size() >= groups_max)
        return Error{ErrorCode::resource_exhausted, "there are 64 groups already"};
    if (Status s = check_work({}, def); !s.ok()) return s.error();
    Result<ParticleGroup> group = ParticleGroup::create(def);
    if (!group.ok()) return group.error();
    if (entries_.empty()) time_ = world.time();
    entries_.push_back({{++last_key_}, std::move(*group)});
    return entries_.back().key;
}

Status Particles::remove(ParticleKey key) {
    Entry* entry = find(key);
    if (entry == nullptr) return Error{ErrorCode::not_found, "no group has this key"};
    entries_.erase(entries_.begin() + (entry - entries_.data()));
    return {};
}

Status Particles::set(ParticleKey key, const ParticleGroupDef& def) {
    Entry* entry = find(key);
    if (entry == nullptr) return Error{ErrorCode::not_found, "no group has this key"};
    if (Status s = check_work(key, def); !s.ok()) return s;
    return entry->group.set_def(def);
}

void Particles::refresh_fields(const World& world) {
    fields_.clear();
    const auto uses_fields = [](const Entry& entry) { return entry.group.def().world_fields; };
    if (std::ranges::none_of(entries_, uses_fields)) return;
    for (const FieldId id : world.fields())
        if (const Result<FieldDef> field = world.field(id); field.ok()) fields_.push_back(*field);
}

void Particles::apply_pulse(World&, const PressurePulse& pulse) {
    for (Entry& entry : entries_) entry.group.apply_pulse(pulse);
}

void Particles::after_step(World& world, double dt) {
    if (entries_.empty()) return;
    // A module that was added late or whose world was at rest emits nothing for the past.
    const double end = world.time();
    if (!(time_ > end - 2 * dt && time_ < end)) time_ = end - dt;
    refresh_fields(world);
    impacts_->begin(world);
    const ParticleEnvironment environment{
        .gravity = world.gravity(), .fields = fields_, .world = &world, .bodies = impacts_.get()};
    for (Entry& entry : entries_)
        if (!entry.group.def().cosmetic) entry.group.advance(environment, time_, end);
    impacts_->apply(world);
    time_ = end;
}

void Particles::visit(StateVisitor& v) {
    v.field("last_key", last_key_);
    v.field("time", time_);
    v.enter("groups");
    const std::size_t count = v.count("size", entries_.size());
    if (v.loading()) {
        entries_.clear();
        if (count > groups_max)
            v.fail("size", "is more than 64");
        else
            entries_.resize(count);
    }
    for (std::size_t k = 0; k < entries_.size(); k++) {
        Entry& entry = entries_[k];
        v.enter(k);
        v.field("key", entry.key.number);
        entry.group.visit(v);
        v.leave();
        if (v.failed()) break;
    }
    v.leave();
    if (v.loading()) check_loaded(v);
}

void Particles::check_loaded(StateVisitor& v) const {
    if (v.failed()) return;
    if (!(work() <= work_max)) v.fail("groups", "need more than 4000000 units of work per step");
    for (std::size_t k = 0; k < entries_.size(); k++) {
        const std::uint32_t key = entries_[k].key.number;
        if (key == 0 || key > last_key_ || (k > 0 && key <= entries_[k - 1].key.number))
            v.fail("groups", "have keys that are not strictly increasing");
    }
}

void Particles::restored(const World&) {
    fields_.clear();
}

void register_particles() {
    static_cast<void>(register_module("particles", [] { return std::make_unique<Particles>(); }));
}

}  // namespace jostle::modules
