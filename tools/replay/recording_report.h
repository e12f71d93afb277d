// SPDX-License-Identifier: MIT
//
// Formats the output of jostle-replay: text, or JSON. Pure functions.
#pragma once

#include <string>

#include "jostle/client/playback.h"
#include "jostle/client/recording_summary.h"

namespace jostle::replay {

std::string to_text(const client::RecordingReader& recording,
                    const client::RecordingSummary& summary);
std::string to_json(const client::RecordingReader& recording,
                    const client::RecordingSummary& summary);

// The state of the view, requested for `tick`.
std::string state_text(const client::Playback& playback, std::uint32_t tick);
std::string state_json(const client::Playback& playback, std::uint32_t tick);

std::string to_text(const client::RecordingVerification& check);
std::string to_json(const client::RecordingVerification& check);

}  // namespace jostle::replay
