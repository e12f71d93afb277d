// SPDX-License-Identifier: MIT
//
// Control of threading trials. A world with several threads uses them for a step shorter than 2 ms
// only if a timed trial shows a speed-up (WorldDef::threads).
#pragma once

namespace jostle::physics {

/// Enables or disables threading trials. If disabled, all threads take part in every step, however
/// short. Trials depend on the clock but never change the results of a step; tests of that property
/// disable them. Process-wide, enabled by default, thread-safe.
void use_thread_trials(bool on);

}  // namespace jostle::physics
