// SPDX-License-Identifier: MIT
//
// The joints of a world as received by one client that sets ClientOptions::joints. One thread at a
// time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>

#include "jostle/base/result.h"
#include "jostle/v1/play.pb.h"

namespace jostle::client {

/// Maximum number of joints of a world.
inline constexpr std::size_t joints_max = 1u << 20;

/// A joint between two entities.
struct ListedJoint {
    std::uint32_t entity_a = 0;  ///< 0: the world
    std::uint32_t entity_b = 0;
    /// Frames and kind; parameters as of the creation of the joint. Shared by equal joints, never
    /// null. Its numbers are untrusted.
    std::shared_ptr<const v1::Joint> form;
};

class JointList {
public:
    /// Starts a stream whose first update is complete.
    void clear() { joints_.clear(); }
    /// Applies an update. On an error (corrupt_data) nothing changes.
    Status apply(const v1::JointUpdate& update);
    /// Joints by id.
    const std::map<std::uint32_t, ListedJoint>& joints() const { return joints_; }

private:
    std::map<std::uint32_t, ListedJoint> joints_;
};

}  // namespace jostle::client
