// SPDX-License-Identifier: MIT
#include "foundation/byte_stream.h"
#include "foundation/hash.h"
#include "jostle/physics/snapshot.h"
#include "jostle/physics/world.h"
#include "persist/field_list.h"
#include "persist/shared_geometry.h"
#include "state/world_access.h"

namespace jostle::physics {
namespace {

struct HashVisitor {
    static constexpr bool kLoading = false;
    Hasher hasher;

    void enter(std::string_view) {}
    void enter(std::size_t) {}
    void leave() {}
    template <class T>
    void field(std::string_view, T& value) {
        hasher.add(bits_of(value));
    }
    template <class T>
    void optional(std::string_view name, T& value, std::uint32_t) {
        if (value != T{}) field(name, value);
    }
    template <class T>
    void unhashed(std::string_view, T&, std::uint32_t) {}
    std::size_t count(std::string_view, std::size_t size) {
        hasher.add(size);
        return size;
    }
    template <class Data>
    void shared(std::string_view, std::shared_ptr<const Data>& data) {
        hasher.add(data->content_hash);
    }
};

}  // namespace

std::uint64_t state_hash(const World& world) {
    HashVisitor visitor;
    visit_world(visitor, const_cast<WorldState&>(state_of(world)));
    return visitor.hasher.value;
}

}  // namespace jostle::physics
