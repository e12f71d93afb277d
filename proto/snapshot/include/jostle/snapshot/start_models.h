// SPDX-License-Identifier: MIT
//
// How codec 2's models begin, a letter for each in the order of FrameModels (WIRE.md, "How models
// begin"): trained over scenes, written by bench/train_start_models.cpp. [0]: for bases one or two
// ticks back, [1]: for older ones.
#pragma once

#include <string_view>

namespace jostle::wire {

extern const std::string_view start_model_letters[2];

}  // namespace jostle::wire
