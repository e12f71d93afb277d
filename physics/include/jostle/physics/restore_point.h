// SPDX-License-Identifier: MIT
//
// A moment of a world in memory, to go back to. For rollback: every tick keeps one, and when a
// command comes late the world goes back a few ticks. Faster than bytes (serialization.h), but good
// only within the process. Geometry is shared with the world, never copied.
//
//     RestorePoint before;
//     before.keep(world);
//     world.step(1.0 / 60).expect();
//     before.restore(world).expect();   // the same bits as at keep()
//
// Thread rule: keep() counts as a const call of the world, restore() as a non-const one (world.h).
// One thread at a time uses a point. It shares nothing with its world but geometry, which nobody
// changes: another thread may save() it, or restore() it into a world of its own, while the kept
// world goes on.
#pragma once

#include <cstddef>
#include <cstdint>
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

    bool empty() const { return !state_; }

    // Copies all that the next step depends on. Forgets what was kept before and uses its memory
    // again.
    void capture(const World& world);

    // Makes any world what the kept one was: it goes on with the same bits, in ids, state_hash(),
    // later steps and their events. The world keeps its number of threads and its profile();
    // events() is empty until the next step. Modules that the world lacks are made by the registry
    // (module.h), those that were not kept are removed; listeners that are no modules stay. May be
    // repeated. An empty point is refused (failed_precondition), and a module that this program
    // does not know (not_found).
    Status restore(World& world) const;

    // What save(world) and state_hash(world) (serialization.h) were at keep(), without a world to
    // restore it into. Refused like restore().
    struct Saved {
        std::vector<std::byte> bytes;
        std::uint64_t hash = 0;
    };
    Result<Saved> save() const;

private:
    Status restore_modules(World& world, std::vector<std::unique_ptr<Module>> missing) const;

    struct CapturedState;
    std::unique_ptr<CapturedState> state_;
};

}  // namespace jostle::physics
