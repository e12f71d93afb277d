// SPDX-License-Identifier: MIT
//
// The passes over all blocks of all colours, in solve order; each colour's blocks are shared among
// the threads.
#pragma once

#include <span>

#include "constraints/kernels.h"
#include "foundation/task_team.h"

namespace jostle::physics {

void warm_start(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
                TaskTeam& team);
void solve(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
           TaskTeam& team);
// `last`: ends the step; sets `aged` and `pressing` of every block.
void relax(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set, bool last,
           TaskTeam& team);

// Restitution. begin_bounces says whether any block is bouncy; if none is, the others need not
// be called.
bool begin_bounces(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
                   TaskTeam& team);
void foresee_bounces(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
                     TaskTeam& team);
void note_bounce_peaks(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
                       TaskTeam& team);
void end_bounces(ManifoldStore& store, std::span<HotBody> bodies, const ContactSettings& set,
                 TaskTeam& team);

}  // namespace jostle::physics
