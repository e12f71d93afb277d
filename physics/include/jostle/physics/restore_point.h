// SPDX-License-Identifier: MIT
//
// In-memory copy of a world's state, for rollback: the server captures one per tick and restores
// one when a late command arrives. Faster than serialization (serialization.h), but valid only
// within the process. Geometry is shared with the world, never copied.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/physics/result.h"

namespace jostle::physics {

class Module;
class World;

/// A copy of a world's state.
///
///     RestorePoint point;
///     point.capture(world);
///     world.step(1.0 / 60).expect();
///     point.restore(world).expect();   // the same bits as at capture()
///
/// Thread rule: capture() counts as a const call of the world, restore() as a non-const one
/// (world.h). A restore point is not thread-safe. It shares only immutable geometry with its world,
/// so another thread may save() it or restore() it into a world of its own while the captured world
/// continues.
class RestorePoint {
public:
    /// Creates an empty restore point.
    RestorePoint();
    RestorePoint(RestorePoint&&) noexcept;  ///< leaves the source empty
    RestorePoint& operator=(RestorePoint&&) noexcept;
    ~RestorePoint();

    bool empty() const { return !state_; }  ///< true until the first capture()

    /// Size of the states of the modules, bytes.
    std::size_t module_bytes() const;

    /// Copies everything that the next step depends on. Replaces the previous content and reuses
    /// its memory.
    void capture(const World& world);

    /// Sets any world to the captured state. Ids, state_hash(), later steps and their events are
    /// then bit-identical to those of the captured world. May be called repeatedly.
    ///
    /// The world retains its number of threads and its profile(). events() is empty until the next
    /// step. Missing modules are created by the registry (module.h), modules that are not part of
    /// the state are removed, and listeners that are not modules remain.
    ///
    /// Errors: failed_precondition if the restore point is empty or the world is stepping;
    /// not_found if a module is not registered in this program.
    Status restore(World& world) const;

    /// The result of save(world) and state_hash(world) (serialization.h).
    struct Saved {
        std::vector<std::byte> bytes;  ///< the saved world
        std::uint64_t hash = 0;        ///< its state hash
    };
    /// Returns the saved world and its hash as of capture(), without a world to restore it into.
    /// Errors: as restore().
    Result<Saved> save() const;

private:
    Status restore_modules(World& world, std::vector<std::unique_ptr<Module>> missing) const;

    struct CapturedState;
    std::unique_ptr<CapturedState> state_;
};

}  // namespace jostle::physics
