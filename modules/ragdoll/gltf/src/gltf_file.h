// SPDX-License-Identifier: MIT
//
// A glTF file as JSON and buffers, and the numbers of its accessors, without interpretation. All
// values are checked on access; an error names the location in the file.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "jostle/modules/ragdoll_gltf.h"

namespace jostle::modules::gltf {

inline constexpr std::size_t file_bytes_max = 64u << 20;
inline constexpr std::size_t json_bytes_max = 16u << 20;
inline constexpr std::size_t elements_max = 1u << 16;  // in an array of nodes, meshes, ...
inline constexpr std::size_t numbers_max = 1u << 22;   // per accessor

// A value of the JSON text and its path, such as "nodes[3].children".
struct JsonNode {
    const nlohmann::json* value = nullptr;
    std::string path = {};

    bool exists() const { return value != nullptr; }
    physics::Error make_error(const std::string& what) const;
    // Member of an object; does not exist if the object lacks it
    JsonNode at(const char* name) const;
    JsonNode at(std::size_t index) const;  // element of an array
    std::size_t size() const;              // of an array, otherwise 0
};

// Contents of an accessor as doubles, `width` per element.
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
    // An array in the root, with at most elements_max elements; empty if absent.
    physics::Result<JsonNode> array(const char* name) const;
    // An index into an array with `count` elements.
    static physics::Result<std::size_t> index(const JsonNode& node, std::size_t count,
                                              const char* of_what);
    static physics::Result<std::vector<double>> numbers(const JsonNode& node, std::size_t count);
    // Reads an accessor of a type ("VEC3", "MAT4"). All values are finite. Integers are converted
    // as they are, or to fractions of their maximum if normalized.
    physics::Result<AccessorData> accessor(const JsonNode& index, const std::string& type) const;

private:
    physics::Status open_container(std::span<const std::byte> bytes);
    physics::Status parse(std::span<const std::byte> text);
    physics::Status load_buffers(const GltfBufferReader& outside);

    nlohmann::json json_;
    bool has_chunk_ = false;
    std::vector<std::byte> chunk_;  // binary chunk of a .glb
    std::vector<std::vector<std::byte>> buffers_;
};

}  // namespace jostle::modules::gltf
