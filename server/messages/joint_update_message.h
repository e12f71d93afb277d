// SPDX-License-Identifier: MIT
//
// Encodes lists of joints and their changes as fields of snapshots. Each field has at most about
// 64 KiB and is for one snapshot, so that the list of a large world neither delays other clients
// nor exceeds the maximum size of a message.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "server/messages/out_message.h"
#include "server/world/joint_list.h"

namespace jostle::server {

// Collects one update. One thread.
class JointUpdateWriter {
public:
    JointUpdateWriter();
    ~JointUpdateWriter();

    void set_complete();
    // Removals come before additions.
    void remove(std::uint32_t id);
    void add(const JointDescription& joint);
    bool is_full() const;
    std::size_t bytes() const { return bytes_; }  // about
    // The field of jostle.v1.Snapshot; starts the next update. Null: nothing was written.
    SharedBytes take();

private:
    struct Update;
    std::unique_ptr<Update> update_;
    std::size_t bytes_ = 0;
};

// The change from one list to another. The fields are encoded when the first client needs them, and
// all clients share them. Any thread.
class JointListChange {
public:
    // `from` null: the client's list is unknown, and the first field replaces it.
    JointListChange(std::shared_ptr<const JointList> from, std::shared_ptr<const JointList> to);

    const std::shared_ptr<const JointList>& from() const { return from_; }
    const std::shared_ptr<const JointList>& to() const { return to_; }

    // Of one snapshot. The fields are sent in the order of their index. At least one field if
    // `from` is null; none if the lists are equal.
    struct Field {
        SharedBytes bytes;    // null: there is no such field
        bool is_last = true;  // no field follows
    };
    Field field(std::size_t index);

private:
    // Positions in both lists: the entries before them were compared.
    struct Position {
        std::size_t from = 0, to = 0;
    };
    // The next joint that `to` does not contain; null: none.
    const JointDescription* next_removed();
    // The next joint that `from` does not contain; null: none.
    const JointDescription* next_added();
    void encode_field();

    const std::shared_ptr<const JointList> from_, to_;
    std::mutex mutex_;
    Position removals_, additions_;
    // The next entries to encode; null: none.
    const JointDescription* removed_ = nullptr;
    const JointDescription* added_ = nullptr;
    JointUpdateWriter writer_;
    std::vector<SharedBytes> fields_;
    bool is_complete_ = false;  // fields_ has all fields
};

}  // namespace jostle::server
