// SPDX-License-Identifier: MIT
//
// A world of several threads shares a step of less than two milliseconds among them only where a
// trial shows that it gains (WorldDef::threads). Trials go by the clock. They change no bit of a
// step; a program that proves so turns them off. Process-wide, on by default, any thread.
#pragma once

namespace jostle::physics {

// false: every step is shared, however short it is.
void use_thread_trials(bool on);

}  // namespace jostle::physics
