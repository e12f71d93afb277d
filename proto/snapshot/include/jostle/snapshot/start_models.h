// SPDX-License-Identifier: MIT
//
// Initial models of codec 2, one letter per model in the order of FrameModels (WIRE.md, "Initial
// models"). Trained on scenes and written by bench/train_start_models.cpp. [0]: for baselines that
// are one or two ticks old; [1]: for older ones.
#pragma once

#include <string_view>

namespace jostle::snapshot {

extern const std::string_view start_model_letters[2];

}  // namespace jostle::snapshot
