// SPDX-License-Identifier: MIT
//
// What jostle-replay says: text for people, JSON for programs. Pure functions.
#pragma once

#include <string>

#include "jostle/client/playback.h"
#include "jostle/client/recording_summary.h"

namespace jostle::replay {

std::string to_text(const client::RecordingReader& recording,
                    const client::RecordingSummary& summary);
std::string to_json(const client::RecordingReader& recording,
                    const client::RecordingSummary& summary);

// The world as the view has it, asked for in that tick.
std::string state_text(const client::Playback& playback, std::uint32_t tick);
std::string state_json(const client::Playback& playback, std::uint32_t tick);

std::string to_text(const client::RecordingVerification& check);
std::string to_json(const client::RecordingVerification& check);

}  // namespace jostle::replay
