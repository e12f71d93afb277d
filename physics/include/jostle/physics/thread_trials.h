// SPDX-License-Identifier: MIT
//
// Whether worlds of several threads find out by trial what short steps are worth to them
// (WorldDef::threads). They do unless told otherwise. Which thread does what changes no bit; a
// program that is to prove that has every step shared. Process-wide; may be changed between steps
// of any world.
#pragma once

namespace jostle::physics {

// false: every step is shared, whatever it costs.
void use_thread_trials(bool on);

}  // namespace jostle::physics
