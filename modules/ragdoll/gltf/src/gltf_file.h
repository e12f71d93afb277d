// SPDX-License-Identifier: MIT
//
// A glTF file as JSON and buffers, and numbers out of its accessors; nothing of what they mean.
// Whatever is asked for is checked when it is asked for: an error names its place in the file.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "jostle/modules/ragdoll_gltf.h"

namespace jostle::modules::gltf {

inline constexpr std::size_t file_bytes_max = 64u << 20;
inline constexpr std::size_t json_bytes_max = 16u << 20;
inline constexpr std::size_t elements_max = 1u << 16;  // of an array of nodes, meshes, ...
inline constexpr std::size_t numbers_max = 1u << 22;   // of an accessor

// A value of the JSON text and where it stands: "nodes[3].children".
struct JsonNode {
    const nlohmann::json* value = nullptr;
    std::string path = {};

    bool exists() const { return value != nullptr; }
    physics::Error make_error(const std::string& what) const;
    JsonNode at(const char* name) const;   // of an object; not there if it lacks it
    JsonNode at(std::size_t index) const;  // of an array
    std::size_t size() const;              // of an array; else 0
};

// What an accessor holds, as doubles: `width` for each element.
struct AccessorData {
    std::size_t width = 0;
    std::vector<double> values;

    std::size_t count() const { return width == 0 ? 0 : values.size() / width; }
    const double* operator[](std::size_t k) const { return values.data() + k * width; }
};

class File {
public:
    static physics::Result<File> open(std::span<const std::byte> bytes,
                                      const GltfBufferReader& outside);

    JsonNode root() const { return {&json_, ""}; }
    // An array of the root of at most elements_max; not there: empty.
    physics::Result<JsonNode> array(const char* name) const;
    // An index into an array of the root of so many.
    static physics::Result<std::size_t> index(const JsonNode& place, std::size_t count,
                                              const char* of_what);
    static physics::Result<std::vector<double>> numbers(const JsonNode& place, std::size_t count);
    // Of the type ("VEC3", "MAT4"), each finite; integers as they are, or as shares of their
    // largest when normalised.
    physics::Result<AccessorData> accessor(const JsonNode& index, const std::string& type) const;

private:
    physics::Status open_container(std::span<const std::byte> bytes);
    physics::Status parse(std::span<const std::byte> text);
    physics::Status load_buffers(const GltfBufferReader& outside);

    nlohmann::json json_;
    bool has_chunk_ = false;
    std::vector<std::byte> chunk_;  // of a .glb
    std::vector<std::vector<std::byte>> buffers_;
};

}  // namespace jostle::modules::gltf
