// SPDX-License-Identifier: MIT
//
// The attributes of a world, its players and its entities. The thread that owns the world changes
// them and publishes immutable tables, which any thread may read. A world without attributes
// publishes the same empty table in every tick.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "server/world/attribute.h"
#include "server/world/command.h"
#include "server/world/saved_host_state.h"

namespace jostle::server {

struct AttributeLimits {
    int per_target_max = 32;       // attributes of one target
    int text_bytes_max = 256;      // of one value
    int client_bytes_max = 32768;  // of all attributes that one client set
    int world_bytes_max = 1 << 20;

    bool operator==(const AttributeLimits&) const = default;
};

using AttributeMap = std::map<std::string, Attribute, std::less<>>;

// --- the published form ---

struct AttributesOfTarget {
    AttributeTarget target;
    ClientId owner = 0;  // reads attributes with AttributeVisibility::owner; 0: no client
    AttributeMap attributes;
};

// The difference of one attribute between two published tables.
struct PublishedChange {
    AttributeTarget target;
    ClientId owner = 0;
    std::string key;
    std::optional<Attribute> before, now;  // not both nothing
};

// The changes of one tick.
struct AttributeChanges {
    std::uint32_t tick = 0;
    std::vector<PublishedChange> changes;  // sorted by target and key
    std::vector<AttributeTarget> ended;    // targets that ended, sorted
    bool has_owner_only = false;           // a change concerns an attribute that only owners read
};

struct AttributeTable {
    static constexpr std::size_t buckets_max = 256;
    static constexpr std::size_t recent_max = 64;
    // Sorted by target.
    using Bucket = std::vector<std::shared_ptr<const AttributesOfTarget>>;

    // Number of ticks with changes since the start of the process, and of recent.back().
    std::uint32_t revision = 0;
    // By hash of the target, so that a tick copies only buckets with changes. Empty: no attributes.
    std::vector<std::shared_ptr<const Bucket>> buckets;
    std::vector<std::shared_ptr<const AttributeChanges>> recent;  // oldest first

    // All targets with attributes, sorted.
    std::vector<std::shared_ptr<const AttributesOfTarget>> targets() const;
    std::shared_ptr<const AttributesOfTarget> find(const AttributeTarget& target) const;
};
using AttributeTablePtr = std::shared_ptr<const AttributeTable>;

// --- the state ---

class Attributes {
public:
    Attributes();

    // Applies all changes or none. `setter`: scene_client for the server, which no limit of clients
    // applies to. `owner`: of the target. The changes passed check_attribute_change(), and the
    // target exists. invalid_argument: a key is repeated. permission_denied: the server set an
    // attribute that a client changes. resource_exhausted: a limit, which the message names.
    Status set(const AttributeTarget& target, ClientId owner, ClientId setter,
               std::span<const AttributeChange> changes, const AttributeLimits& limits);
    // The target ended.
    void remove(const AttributeTarget& target);

    // Null: no such attribute.
    const Attribute* find(const AttributeTarget& target, std::string_view key) const;
    bool empty() const { return targets_.empty(); }
    std::size_t size() const { return count_; }
    std::size_t bytes() const { return bytes_; }

    // The table after the changes since the last call; the same pointer if there were none.
    const AttributeTablePtr& publish(std::uint32_t tick);

    void write(SavedHostState& host_state) const;
    // Into an empty store.
    Status restore(const SavedHostState& host_state);

private:
    struct State {
        ClientId owner = 0;
        AttributeMap attributes;
    };
    using ChangeKey = std::pair<AttributeTarget, std::string>;

    Status check(const AttributeTarget& target, ClientId setter,
                 std::span<const AttributeChange> changes, const AttributeLimits& limits) const;
    void put(const AttributeTarget& target, ClientId owner, const std::string& key,
             std::optional<Attribute> attribute);
    void count(const std::string& key, const Attribute& attribute, int sign);
    void copy_to_bucket(AttributeTable& table, const AttributeTarget& target) const;

    std::map<AttributeTarget, State> targets_;   // none is empty
    std::map<ClientId, std::size_t> set_bytes_;  // by setter, without the server
    std::size_t bytes_ = 0, count_ = 0;
    // Since the last publish(): attributes with their earlier value, and targets.
    std::map<ChangeKey, std::optional<Attribute>> changed_;
    std::set<AttributeTarget> ended_, touched_;
    AttributeTablePtr table_;
};

}  // namespace jostle::server
