// SPDX-License-Identifier: MIT
//
// Where all entities of a world are, in rising order of id: an immutable list in blocks, so that a
// tick in which little moves makes few new blocks and shares the others with the tick before. Equal
// block pointers mean equal poses. A list is a value: any thread may keep a copy. A PoseEditor is
// one thread's.
#pragma once

#include <cstddef>
#include <iterator>
#include <memory>
#include <vector>

#include "jostle/physics/world.h"
#include "server/world/command.h"

namespace jostle::server {

struct EntityPose {
    EntityId id = 0;
    physics::Transform pose;
    bool awake = false;
};

class PoseList {
public:
    static constexpr std::size_t block_size = 128;
    using Block = std::vector<EntityPose>;  // full, but for the last one
    using Blocks = std::vector<std::shared_ptr<const Block>>;

    PoseList() = default;
    PoseList(const std::vector<EntityPose>& poses);  // in rising order of id

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const EntityPose& operator[](std::size_t i) const {
        return (*blocks_[i / block_size])[i % block_size];
    }
    const EntityPose& back() const { return (*this)[size_ - 1]; }
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

// Makes the next list of the one before.
class PoseEditor {
public:
    // All anew.
    void assign(const std::vector<EntityPose>& poses);
    // The entity at that place; nothing happens when it is as it was.
    void set(std::size_t index, const physics::Transform& pose, bool awake);
    // The list with all that was set; `changed` says whether it differs from the last one taken.
    const PoseList& take(bool& changed);

private:
    PoseList list_;
    std::vector<std::shared_ptr<PoseList::Block>> open_;  // of list_.blocks_: not yet shared
    bool changed_ = false;
};

}  // namespace jostle::server
