// SPDX-License-Identifier: MIT
//
// The dictionaries: words that libFuzzer puts into text at random, for those targets that read it.
#pragma once

#include <filesystem>

namespace jostle::fuzz {

// FOLDER/TARGET.dict for each target that has one.
void write_dictionaries(const std::filesystem::path& folder);

}  // namespace jostle::fuzz
