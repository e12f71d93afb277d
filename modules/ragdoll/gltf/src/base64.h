// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace jostle::modules::gltf {

// Decodes base64 (RFC 4648), with or without padding. Returns nullopt for invalid input.
std::optional<std::vector<std::byte>> from_base64(std::string_view text);

}  // namespace jostle::modules::gltf
