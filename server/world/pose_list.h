// SPDX-License-Identifier: MIT
//
// The poses of all entities of a world in ascending order of id: an immutable list of blocks, so
// that a tick with few changes makes few new blocks and shares the others with the previous tick.
// Equal block pointers mean equal poses. A list is a value, and any thread may hold a copy. A
// PoseEditor belongs to one thread.
#pragma once

#include <cstddef>
#include <iterator>
#include <memory>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/physics/world.h"
#include "server/world/command.h"

namespace jostle::server {

struct EntityPose {
    EntityId id = 0;
    bool awake = false;
    physics::Transform pose;
};
static_assert(sizeof(EntityPose) == 64);  // one cache line; a world retains 25 frames of them

class PoseList {
public:
    static constexpr std::size_t block_size = 128;
    using Block = std::vector<EntityPose>;  // block_size poses; the last block may have fewer
    using Blocks = std::vector<std::shared_ptr<const Block>>;

    PoseList() = default;
    PoseList(const std::vector<EntityPose>& poses);  // in ascending order of id

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const EntityPose& operator[](std::size_t i) const {
        ASSERT(i < size_);
        return (*blocks_[i / block_size])[i % block_size];
    }
    const EntityPose& back() const {
        ASSERT(!empty());
        return (*this)[size_ - 1];
    }
    const Blocks& blocks() const { return blocks_; }

    class Iterator {
    public:
        using iterator_category = std::forward_iterator_tag;
        using value_type = EntityPose;
        using difference_type = std::ptrdiff_t;
        using pointer = const EntityPose*;
        using reference = const EntityPose&;

        Iterator() = default;
        Iterator(const PoseList& list, std::size_t at) : list_(&list), at_(at) {}
        reference operator*() const { return (*list_)[at_]; }
        pointer operator->() const { return &(*list_)[at_]; }
        Iterator& operator++() {
            at_++;
            return *this;
        }
        Iterator operator++(int) {
            Iterator before = *this;
            at_++;
            return before;
        }
        bool operator==(const Iterator& other) const { return at_ == other.at_; }

    private:
        const PoseList* list_ = nullptr;
        std::size_t at_ = 0;
    };
    Iterator begin() const { return {*this, 0}; }
    Iterator end() const { return {*this, size_}; }

private:
    friend class PoseEditor;
    Blocks blocks_;
    std::size_t size_ = 0;
};

// Derives each list from the previous one.
class PoseEditor {
public:
    // Replaces the whole list.
    void assign(const std::vector<EntityPose>& poses);
    // Sets the pose at `index`; an equal pose changes nothing.
    void set(std::size_t index, const physics::Transform& pose, bool awake);
    // Returns the list; `changed`: it differs from the list of the previous take().
    const PoseList& take(bool& changed);

private:
    PoseList list_;
    // Per block of list_: its copy that no reader shares yet; null: not changed.
    std::vector<std::shared_ptr<PoseList::Block>> open_;
    bool changed_ = false;
};

}  // namespace jostle::server
