// SPDX-License-Identifier: MIT
//
// Adds, changes and removes fields, and wakes the affected bodies. fields_step.cpp applies the
// forces.
#include "jostle/modules/fields.h"

#include <mutex>

#include "modules/fields/src/field_checks.h"
#include "modules/fields/src/field_scratch.h"

namespace jostle::modules {

using namespace physics;

namespace {

// Wakes the bodies that enter or leave the influence of the field.
void wake_volume(World& world, const VolumeField& field) {
    std::vector<BodyState> bodies;
    world.copy_bodies(bodies);
    for (const BodyState& body : bodies) {
        if (body.type != BodyType::dynamic || body.awake || !contains(field.volume, body.center))
            continue;
        if ((fields_detail::categories_of(world, body.id) & field.mask) != 0)
            world.wake(body.id).expect();
    }
}

Status check_target(const World& world, const VolumeField& field) {
    const auto* central = std::get_if<Central>(&field.law);
    if (central == nullptr || is_null(central->body) || world.contains(central->body)) return {};
    return Error{ErrorCode::not_found, "central.body is not in the world"};
}

std::shared_ptr<const UserForce> force_of(const VolumeField& field) {
    const auto* user = std::get_if<UserField>(&field.law);
    return user == nullptr ? nullptr : find_user_field(user->law);
}

Error no_such_field(FieldKey key) {
    return {ErrorCode::not_found, "field " + std::to_string(key.number) + " does not exist"};
}

}  // namespace

Fields::Fields() : scratch_(std::make_unique<fields_detail::FieldScratch>()) {}
Fields::~Fields() = default;

Result<FieldKey> Fields::add(World& world, const VolumeField& field) {
    if (entries_.size() >= fields_max)
        return Error{ErrorCode::resource_exhausted,
                     "the module already has the maximum of 64 fields; remove one first"};
    if (Status s = check_field(world, {}, field); !s.ok()) return s.error();
    entries_.push_back({FieldKey{++last_key_}, field, {}, force_of(field)});
    scratch_->body_cache.clear();
    wake_volume(world, field);
    return entries_.back().key;
}

Status Fields::set(World& world, FieldKey key, const VolumeField& field) {
    Entry* entry = find(key);
    if (entry == nullptr) return no_such_field(key);
    if (Status s = check_field(world, key, field); !s.ok()) return s;
    wake_volume(world, entry->field);
    *entry = {key, field, {}, force_of(field)};
    scratch_->body_cache.clear();
    wake_volume(world, field);
    return {};
}

Status Fields::remove(World& world, FieldKey key) {
    Entry* entry = find(key);
    if (entry == nullptr) return no_such_field(key);
    wake_volume(world, entry->field);
    entries_.erase(entries_.begin() + (entry - entries_.data()));
    scratch_->body_cache.clear();
    return {};
}

Result<VolumeField> Fields::field(FieldKey key) const {
    for (const Entry& entry : entries_)
        if (entry.key == key) return entry.field;
    return no_such_field(key);
}

std::vector<FieldKey> Fields::fields() const {
    std::vector<FieldKey> keys;
    for (const Entry& entry : entries_) keys.push_back(entry.key);
    return keys;
}

Status Fields::add_charge(const Charge& charge) {
    if (charges_.size() >= charges_max)
        return Error{
            ErrorCode::resource_exhausted,
            "the module already has the maximum of 128 pending charges; retry after one explodes"};
    if (Status s = fields_detail::check(charge); !s.ok()) return s;
    charges_.push_back(charge);
    return {};
}

// Number of waters except the field with this key.
std::size_t Fields::count_waters_except(FieldKey key) const {
    std::size_t count = 0;
    for (const Entry& entry : entries_)
        count += entry.key != key && std::holds_alternative<Waves>(entry.field.law);
    return count;
}

Status Fields::check_field(const World& world, FieldKey key, const VolumeField& field) const {
    if (Status s = fields_detail::check(field); !s.ok()) return s;
    if (std::holds_alternative<Waves>(field.law) && count_waters_except(key) >= waters_max)
        return Error{ErrorCode::resource_exhausted,
                     "the module already has the maximum of 4 waters; remove one first"};
    return check_target(world, field);
}

Fields::Entry* Fields::find(FieldKey key) {
    for (Entry& entry : entries_)
        if (entry.key == key) return &entry;
    return nullptr;
}

void register_fields() {
    static std::once_flag once;
    // A module of this name that the program registered earlier stays registered.
    std::call_once(once, [] {
        static_cast<void>(register_module("fields", [] { return std::make_unique<Fields>(); }));
    });
}

}  // namespace jostle::modules
