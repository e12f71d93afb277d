// SPDX-License-Identifier: MIT
//
// A moment of a world in memory, to go back to: for rollback, where every tick keeps one and a late
// command goes back a few. Faster than bytes (snapshot.h), good only within the process; geometry
// is shared with the world, never copied.
//
//     RestorePoint before;
//     before.keep(world);      // 16.7 ms of play that turn out wrong follow
//     before.restore(world);   // the same bits as at keep()
//
// Thread rule: keep() and restore() count as a const and a non-const call of the world; a point is
// used by one thread at a time.
#pragma once

#include <memory>
#include <vector>

#include "jostle/physics/result.h"

namespace jostle::physics {

class Module;
class World;

class RestorePoint {
public:
    RestorePoint();
    RestorePoint(RestorePoint&&) noexcept;  // leaves the other empty
    RestorePoint& operator=(RestorePoint&&) noexcept;
    ~RestorePoint();

    bool empty() const { return !kept_; }

    // Copies all that the next step depends on. What it kept before is forgotten; its memory is
    // used again, so that a point kept for long allocates nothing.
    void keep(const World& world);

    // The world, this one or another, goes on with the same bits as the one that was kept: ids,
    // state_hash(), later steps and their events. It keeps its number of threads; events() is empty
    // until the next step, profile() stays. Modules that it lacks are made by the registry
    // (module.h), those that were not there are removed; listeners that are no modules stay. May be
    // repeated. An empty point is refused (failed_precondition), and a module that this program
    // does not know (not_found).
    Status restore(World& world) const;

private:
    Status restore_modules(World& world, std::vector<std::unique_ptr<Module>> missing) const;

    struct Kept;
    std::unique_ptr<Kept> kept_;
};

}  // namespace jostle::physics
