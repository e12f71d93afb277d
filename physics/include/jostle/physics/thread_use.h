// SPDX-License-Identifier: MIT
//
// Control of the use of threads. A world with several threads uses them only for steps with enough
// work (WorldDef::threads).
#pragma once

namespace jostle::physics {

/// If on, all threads of a world take part in every step, however short. The results of a step
/// never depend on the threads that take part; tests of that property use this. Process-wide, off
/// by default, thread-safe.
void share_short_steps(bool on);

}  // namespace jostle::physics
