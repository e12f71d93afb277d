// SPDX-License-Identifier: MIT
#include "server/world/attributes.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

std::size_t bucket_of(const AttributeTarget& target) {
    return (target.id * 3 + static_cast<std::uint32_t>(target.kind)) % AttributeTable::buckets_max;
}

Error over_limit(const std::string& what, std::size_t wanted, const char* setting, int limit) {
    return {ErrorCode::resource_exhausted, what + " would have " + std::to_string(wanted) + "; " +
                                               setting + " allows " + std::to_string(limit) +
                                               "; remove attributes first"};
}

const AttributeTablePtr& empty_table() {
    static const AttributeTablePtr table = std::make_shared<const AttributeTable>();
    return table;
}

}  // namespace

// --- the published form ---

std::vector<std::shared_ptr<const AttributesOfTarget>> AttributeTable::targets() const {
    std::vector<std::shared_ptr<const AttributesOfTarget>> all;
    for (const auto& bucket : buckets)
        if (bucket) all.insert(all.end(), bucket->begin(), bucket->end());
    std::ranges::sort(all, {}, [](const auto& entry) { return entry->target; });
    return all;
}

std::shared_ptr<const AttributesOfTarget> AttributeTable::find(
    const AttributeTarget& target) const {
    if (buckets.empty()) return nullptr;
    const auto& bucket = buckets[bucket_of(target)];
    if (!bucket) return nullptr;
    const auto at = std::ranges::lower_bound(*bucket, target, {},
                                             [](const auto& entry) { return entry->target; });
    return at != bucket->end() && (*at)->target == target ? *at : nullptr;
}

// --- the state ---

Attributes::Attributes() : table_(empty_table()) {}

const Attribute* Attributes::find(const AttributeTarget& target, std::string_view key) const {
    const auto at = targets_.find(target);
    if (at == targets_.end()) return nullptr;
    const auto attribute = at->second.attributes.find(key);
    return attribute == at->second.attributes.end() ? nullptr : &attribute->second;
}

// Counts the state after the changes.
Status Attributes::check(const AttributeTarget& target, ClientId setter,
                         std::span<const AttributeChange> changes,
                         const AttributeLimits& limits) const {
    const auto state = targets_.find(target);
    std::size_t count = state == targets_.end() ? 0 : state->second.attributes.size();
    const auto of_setter = set_bytes_.find(setter);
    std::size_t own_bytes = of_setter == set_bytes_.end() ? 0 : of_setter->second;
    std::size_t world_bytes = bytes_;
    bool grows = false;
    std::set<std::string_view> keys;
    for (const AttributeChange& change : changes) {
        if (!keys.insert(change.key).second)
            return invalid_argument("attribute \"" + change.key + "\" is changed twice");
        const Attribute* const before = find(target, change.key);
        if (before && before->setter == scene_client && setter != scene_client)
            return Error{ErrorCode::permission_denied,
                         "attribute \"" + change.key + "\" of " + describe(target) +
                             " was set by the server; clients cannot change it"};
        const std::size_t old_bytes = before ? bytes_of(change.key, before->value) : 0;
        const std::size_t new_bytes = change.value ? bytes_of(change.key, *change.value) : 0;
        const auto* text = change.value ? std::get_if<std::string>(&*change.value) : nullptr;
        if (text && text->size() > static_cast<std::size_t>(limits.text_bytes_max))
            return Error{ErrorCode::resource_exhausted,
                         "the text of attribute \"" + change.key + "\" has " +
                             std::to_string(text->size()) +
                             " bytes; world.attribute_text_bytes_max allows " +
                             std::to_string(limits.text_bytes_max)};
        if (change.value && !before) count++;
        if (!change.value && before) count--;
        const bool is_own = before && before->setter == setter;
        if (is_own) own_bytes -= std::min(own_bytes, old_bytes);
        own_bytes += new_bytes;
        world_bytes += new_bytes;
        world_bytes -= std::min(world_bytes, old_bytes);
        grows = grows || new_bytes > (is_own ? old_bytes : 0);
    }
    // Removing attributes and shrinking own ones is always possible, also after the limits were
    // lowered.
    if (!grows) return {};
    if (count > static_cast<std::size_t>(limits.per_target_max))
        return over_limit("the attributes of " + describe(target), count,
                          "world.attributes_per_target_max", limits.per_target_max);
    if (setter != scene_client && own_bytes > static_cast<std::size_t>(limits.client_bytes_max))
        return over_limit("the bytes of the attributes that this client set", own_bytes,
                          "client.attribute_bytes_max", limits.client_bytes_max);
    if (world_bytes > static_cast<std::size_t>(limits.world_bytes_max))
        return over_limit("the bytes of all attributes of the world", world_bytes,
                          "world.attribute_bytes_max", limits.world_bytes_max);
    return {};
}

Status Attributes::set(const AttributeTarget& target, ClientId owner, ClientId setter,
                       std::span<const AttributeChange> changes, const AttributeLimits& limits) {
    if (Status s = check(target, setter, changes, limits); !s.ok()) return s;
    for (const AttributeChange& change : changes) {
        std::optional<Attribute> attribute;
        if (change.value)
            attribute = {.value = *change.value,
                         .visibility = change.visibility,
                         .roles = change.roles,
                         .setter = setter};
        put(target, owner, change.key, std::move(attribute));
    }
    return {};
}

void Attributes::put(const AttributeTarget& target, ClientId owner, const std::string& key,
                     std::optional<Attribute> attribute) {
    const Attribute* const known = find(target, key);
    if (!known && !attribute) return;
    if (known && attribute && *known == *attribute) return;
    const std::optional<Attribute> before = known ? std::optional(*known) : std::nullopt;
    changed_.try_emplace({target, key}, before);
    touched_.insert(target);
    if (before) count(key, *before, -1);
    if (attribute) {
        count(key, *attribute, 1);
        State& state = targets_[target];
        state.owner = owner;
        state.attributes.insert_or_assign(key, *std::move(attribute));
        return;
    }
    const auto at = targets_.find(target);
    at->second.attributes.erase(key);
    if (at->second.attributes.empty()) targets_.erase(at);
}

void Attributes::count(const std::string& key, const Attribute& attribute, int sign) {
    const std::size_t bytes = bytes_of(key, attribute.value);
    if (sign > 0) {
        bytes_ += bytes;
        count_++;
        if (attribute.setter != scene_client) set_bytes_[attribute.setter] += bytes;
        return;
    }
    ASSERT(bytes_ >= bytes && count_ > 0);
    bytes_ -= bytes;
    count_--;
    if (attribute.setter == scene_client) return;
    const auto of_setter = set_bytes_.find(attribute.setter);
    ASSERT(of_setter != set_bytes_.end() && of_setter->second >= bytes);
    of_setter->second -= bytes;
    if (of_setter->second == 0) set_bytes_.erase(of_setter);
}

void Attributes::remove(const AttributeTarget& target) {
    const auto at = targets_.find(target);
    if (at != targets_.end()) {
        for (const auto& [key, attribute] : at->second.attributes) count(key, attribute, -1);
        targets_.erase(at);
    } else if (!touched_.contains(target)) {
        return;
    }
    // Clients discard everything of the target, so its single changes are not published.
    const auto first = changed_.lower_bound({target, ""});
    auto last = first;
    while (last != changed_.end() && last->first.first == target) ++last;
    changed_.erase(first, last);
    touched_.insert(target);
    ended_.insert(target);
}

void Attributes::copy_to_bucket(AttributeTable& table, const AttributeTarget& target) const {
    std::shared_ptr<const AttributeTable::Bucket>& bucket = table.buckets[bucket_of(target)];
    auto copy = bucket ? std::make_shared<AttributeTable::Bucket>(*bucket)
                       : std::make_shared<AttributeTable::Bucket>();
    const auto at = std::ranges::lower_bound(*copy, target, {},
                                             [](const auto& entry) { return entry->target; });
    const bool is_known = at != copy->end() && (*at)->target == target;
    const auto state = targets_.find(target);
    if (state == targets_.end()) {
        if (is_known) copy->erase(at);
    } else {
        auto entry = std::make_shared<const AttributesOfTarget>(
            AttributesOfTarget{target, state->second.owner, state->second.attributes});
        if (is_known)
            *at = std::move(entry);
        else
            copy->insert(at, std::move(entry));
    }
    bucket = copy->empty() ? nullptr : std::move(copy);
}

const AttributeTablePtr& Attributes::publish(std::uint32_t tick) {
    if (touched_.empty()) return table_;
    auto changes = std::make_shared<AttributeChanges>();
    changes->tick = tick;
    const auto is_owner_only = [](const std::optional<Attribute>& attribute) {
        return attribute && attribute->visibility == AttributeVisibility::owner;
    };
    for (const auto& [key, before] : changed_) {
        const Attribute* const now = find(key.first, key.second);
        if (now ? before && *now == *before : !before) continue;
        const auto state = targets_.find(key.first);
        PublishedChange change{.target = key.first,
                               .owner = state == targets_.end() ? 0 : state->second.owner,
                               .key = key.second,
                               .before = before,
                               .now = now ? std::optional(*now) : std::nullopt};
        // The last attribute of its target was removed: its owner is that of the old table.
        if (state == targets_.end())
            if (const auto old = table_->find(key.first)) change.owner = old->owner;
        changes->has_owner_only =
            changes->has_owner_only || is_owner_only(change.before) || is_owner_only(change.now);
        changes->changes.push_back(std::move(change));
    }
    changes->ended.assign(ended_.begin(), ended_.end());
    auto table = std::make_shared<AttributeTable>(*table_);
    table->buckets.resize(AttributeTable::buckets_max);
    for (const AttributeTarget& target : touched_) copy_to_bucket(*table, target);
    if (table->recent.size() == AttributeTable::recent_max)
        table->recent.erase(table->recent.begin());
    table->recent.push_back(std::move(changes));
    table->revision++;
    table_ = std::move(table);
    changed_.clear();
    ended_.clear();
    touched_.clear();
    return table_;
}

void Attributes::write(SavedHostState& host_state) const {
    for (const auto& [target, state] : targets_)
        for (const auto& [key, attribute] : state.attributes)
            host_state.attributes.push_back({target, state.owner, key, attribute});
}

Status Attributes::restore(const SavedHostState& host_state) {
    ASSERT(targets_.empty());
    for (const SavedHostState::SavedAttribute& saved : host_state.attributes) {
        const AttributeChange change{saved.key, saved.attribute.value, saved.attribute.visibility,
                                     saved.attribute.roles};
        if (Status s = check_attribute_change(change, "attributes."); !s.ok())
            return Error{ErrorCode::corrupt_data, "corrupt host state: " + s.error().message};
        put(saved.target, saved.owner, saved.key, saved.attribute);
    }
    // New clients receive the complete table.
    AttributeTable table = *publish(0);
    table.revision = 0;
    table.recent.clear();
    table_ = std::make_shared<const AttributeTable>(std::move(table));
    return {};
}

}  // namespace jostle::server
