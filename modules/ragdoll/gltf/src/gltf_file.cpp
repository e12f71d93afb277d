// SPDX-License-Identifier: MIT
#include "modules/ragdoll/gltf/src/gltf_file.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

#include "jostle/base/base64.h"
#include "jostle/physics/scalar.h"

namespace jostle::modules::gltf {

using namespace physics;
using nlohmann::json;

namespace {

constexpr int depth_max = 64;  // nesting depth of JSON

Error corrupt(std::string message) {
    return {ErrorCode::corrupt_data, std::move(message)};
}

// glTF is little-endian, like all supported machines.
template <class T>
T read_bits(const std::byte* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

struct Component {
    std::size_t bytes = 0;
    double largest = 1;  // value that corresponds to 1 when normalized
    double (*read)(const std::byte*) = nullptr;
};
template <class T>
Component component() {
    const double largest =
        std::is_integral_v<T> ? static_cast<double>(std::numeric_limits<T>::max()) : 1;
    return {sizeof(T), largest,
            [](const std::byte* from) { return static_cast<double>(read_bits<T>(from)); }};
}
Component component_of(std::size_t type) {
    switch (type) {
        case 5120:
            return component<std::int8_t>();
        case 5121:
            return component<std::uint8_t>();
        case 5122:
            return component<std::int16_t>();
        case 5123:
            return component<std::uint16_t>();
        case 5125:
            return component<std::uint32_t>();
        case 5126:
            return component<float>();
        default:
            return {};
    }
}

std::size_t width_of(std::string_view type) {
    if (type == "SCALAR") return 1;
    if (type == "VEC3") return 3;
    if (type == "VEC4") return 4;
    return type == "MAT4" ? 16 : 0;
}

// Reads a non-negative integer; returns `fallback` if it is absent.
Result<std::size_t> read_integer(const JsonNode& node, std::size_t fallback) {
    if (!node.exists()) return fallback;
    if (!node.value->is_number_integer()) return node.make_error("is not an integer");
    const auto value = node.value->is_number_unsigned()
                           ? node.value->get<std::uint64_t>()
                           : static_cast<std::uint64_t>(node.value->get<std::int64_t>());
    if (value > file_bytes_max)
        return node.make_error("is out of range; it must be from 0 to 64 million");
    return static_cast<std::size_t>(value);
}

}  // namespace

Error JsonNode::make_error(const std::string& what) const {
    return corrupt((path.empty() ? "the file" : path) + " " + what);
}
JsonNode JsonNode::at(const char* name) const {
    const std::string below = path.empty() ? name : path + "." + name;
    if (value == nullptr || !value->is_object()) return {nullptr, below};
    const auto found = value->find(name);
    return {found == value->end() ? nullptr : &*found, below};
}
JsonNode JsonNode::at(std::size_t index) const {
    const std::string below = path + "[" + std::to_string(index) + "]";
    return {index < size() ? &(*value)[index] : nullptr, below};
}
std::size_t JsonNode::size() const {
    return value != nullptr && value->is_array() ? value->size() : 0;
}

Result<File> File::open(std::span<const std::byte> bytes, const GltfBufferReader& outside) {
    if (bytes.size() > file_bytes_max) return corrupt("the file is larger than 64 MB");
    File file;
    if (Status s = file.open_container(bytes); !s.ok()) return s.error();
    const JsonNode version = file.root().at("asset").at("version");
    if (!version.exists() || !version.value->is_string() ||
        !version.value->get_ref<const std::string&>().starts_with("2."))
        return version.make_error("is not \"2.0\"; only glTF 2 is supported");
    if (Status s = file.load_buffers(outside); !s.ok()) return s.error();
    return file;
}

// A .glb has a header of 12 bytes, followed by chunks. The first chunk is the JSON text, an
// optional second one the first buffer. Any other file is a .gltf: the text alone.
Status File::open_container(std::span<const std::byte> bytes) {
    constexpr std::uint32_t magic = 0x46546c67, json_type = 0x4e4f534a, binary_type = 0x004e4942;
    if (bytes.size() < 4 || read_bits<std::uint32_t>(bytes.data()) != magic) return parse(bytes);
    if (bytes.size() < 20) return corrupt("the file ends inside the .glb header");
    if (read_bits<std::uint32_t>(bytes.data() + 4) != 2)
        return corrupt("the .glb version is not 2");
    if (read_bits<std::uint32_t>(bytes.data() + 8) > bytes.size())
        return corrupt("the file is shorter than its header states");
    std::size_t at = 12;
    for (int k = 0; k < 2 && at + 8 <= bytes.size(); k++) {
        const std::size_t size = read_bits<std::uint32_t>(bytes.data() + at);
        const auto type = read_bits<std::uint32_t>(bytes.data() + at + 4);
        at += 8;
        if (size > bytes.size() - at)
            return corrupt("chunk " + std::to_string(k) + " extends past the end of the file");
        if (k == 0 && type != json_type) return corrupt("the first chunk is not JSON");
        const std::span<const std::byte> chunk = bytes.subspan(at, size);
        if (k == 0) {
            if (Status s = parse(chunk); !s.ok()) return s;
        } else if (type == binary_type) {
            has_chunk_ = true;
            chunk_.assign(chunk.begin(), chunk.end());
        }
        at += size;
    }
    return {};
}

Status File::parse(std::span<const std::byte> text) {
    if (text.size() > json_bytes_max) return corrupt("the JSON text is larger than 16 MB");
    bool deep = false;
    const auto keep = [&](int depth, json::parse_event_t, json&) {
        deep = deep || depth > depth_max;
        return !deep;
    };
    const char* const from = reinterpret_cast<const char*>(text.data());
    json_ = json::parse(from, from + text.size(), keep, false);
    if (deep) return corrupt("the JSON text is nested deeper than 64 levels");
    if (!json_.is_object()) return corrupt("the file is neither a .glb nor a JSON object");
    return {};
}

Status File::load_buffers(const GltfBufferReader& outside) {
    const Result<JsonNode> list = array("buffers");
    if (!list.ok()) return list.error();
    std::size_t total = 0;
    for (std::size_t k = 0; k < list->size(); k++) {
        const JsonNode buffer = list->at(k), uri = buffer.at("uri");
        const Result<std::size_t> length = read_integer(buffer.at("byteLength"), 0);
        if (!length.ok()) return length.error();
        std::vector<std::byte> bytes;
        if (!uri.exists()) {
            if (k > 0 || !has_chunk_)
                return buffer.make_error("has no uri, and the file has no binary chunk for it");
            bytes = std::move(chunk_);
        } else if (!uri.value->is_string()) {
            return uri.make_error("is not a string");
        } else if (const auto& text = uri.value->get_ref<const std::string&>();
                   text.starts_with("data:")) {
            const std::size_t comma = text.find(";base64,");
            if (comma == std::string::npos)
                return uri.make_error("is a data URI that is not base64");
            auto decoded = decode_base64(std::string_view(text).substr(comma + 8));
            if (!decoded.ok())
                return uri.make_error("is not valid base64: " + decoded.error().message);
            bytes = std::move(*decoded);
        } else {
            if (!outside)
                return uri.make_error("names an external buffer, but no buffer reader is given");
            Result<std::vector<std::byte>> read = outside(text);
            if (!read.ok()) return uri.make_error("cannot be read: " + read.error().message);
            bytes = std::move(*read);
        }
        total += bytes.size();
        if (total > file_bytes_max) return list->make_error("exceed 64 MB in total");
        if (bytes.size() < *length)
            return buffer.make_error("has " + std::to_string(bytes.size()) +
                                     " bytes but declares " + std::to_string(*length));
        buffers_.push_back(std::move(bytes));
    }
    return {};
}

Result<JsonNode> File::array(const char* name) const {
    const JsonNode node = root().at(name);
    if (node.exists() && !node.value->is_array()) return node.make_error("is not an array");
    if (node.size() > elements_max)
        return node.make_error("has more than " + std::to_string(elements_max) + " elements");
    return node;
}

Result<std::size_t> File::index(const JsonNode& node, std::size_t count, const char* of_what) {
    if (!node.exists()) return node.make_error("is missing");
    const Result<std::size_t> value = read_integer(node, 0);
    if (!value.ok()) return value.error();
    if (*value >= count)
        return node.make_error("is " + std::to_string(*value) + "; there are " +
                               std::to_string(count) + " " + of_what);
    return value;
}

Result<std::vector<double>> File::numbers(const JsonNode& node, std::size_t count) {
    if (node.size() != count)
        return node.make_error("must have " + std::to_string(count) + " numbers");
    std::vector<double> values;
    for (std::size_t k = 0; k < count; k++) {
        const JsonNode number = node.at(k);
        if (!number.value->is_number()) return number.make_error("is not a number");
        values.push_back(number.value->get<double>());
        if (!is_finite(values.back())) return number.make_error("is not finite");
    }
    return values;
}

Result<AccessorData> File::accessor(const JsonNode& which, const std::string& type) const {
    const Result<JsonNode> accessors = array("accessors"), views = array("bufferViews");
    if (!accessors.ok()) return accessors.error();
    if (!views.ok()) return views.error();
    const Result<std::size_t> found = index(which, accessors->size(), "accessors");
    if (!found.ok()) return found.error();
    const JsonNode a = accessors->at(*found);
    if (a.at("sparse").exists()) return a.make_error("is sparse, which is not supported");
    const JsonNode kind = a.at("type");
    if (!kind.exists() || *kind.value != type) return kind.make_error("is not \"" + type + "\"");
    const Result<std::size_t> component_type = read_integer(a.at("componentType"), 0),
                              count = read_integer(a.at("count"), 0),
                              offset = read_integer(a.at("byteOffset"), 0);
    for (const auto* value : {&component_type, &count, &offset})
        if (!value->ok()) return value->error();
    if (*count > numbers_max / width_of(type))
        return a.at("count").make_error("is more than " +
                                        std::to_string(numbers_max / width_of(type)));
    const Component component = component_of(*component_type);
    if (component.read == nullptr)
        return a.at("componentType").make_error("is not a glTF component type");

    const Result<std::size_t> view_index = index(a.at("bufferView"), views->size(), "buffer views");
    if (!view_index.ok()) return view_index.error();
    const JsonNode view = views->at(*view_index);
    const Result<std::size_t> buffer = index(view.at("buffer"), buffers_.size(), "buffers");
    if (!buffer.ok()) return buffer.error();
    AccessorData numbers{.width = width_of(type)};
    const std::size_t element = numbers.width * component.bytes;
    const Result<std::size_t> begin = read_integer(view.at("byteOffset"), 0),
                              length = read_integer(view.at("byteLength"), 0),
                              stride = read_integer(view.at("byteStride"), element);
    for (const auto* value : {&begin, &length, &stride})
        if (!value->ok()) return value->error();
    const std::vector<std::byte>& bytes = buffers_[*buffer];
    if (*begin > bytes.size() || *length > bytes.size() - *begin)
        return view.make_error("extends past the end of its buffer");
    if (*stride < element)
        return view.at("byteStride").make_error("is less than the size of an element");
    // Each factor is at most 64 million, so no product overflows.
    if (*count > 0 && *offset + (*count - 1) * *stride + element > *length)
        return a.make_error("extends past the end of its buffer view");

    const JsonNode normalised = a.at("normalized");
    const bool shares = normalised.exists() && *normalised.value == true;
    numbers.values.reserve(*count * numbers.width);
    for (std::size_t k = 0; k < *count; k++)
        for (std::size_t i = 0; i < numbers.width; i++) {
            const double value =
                component.read(bytes.data() + *begin + *offset + k * *stride + i * component.bytes);
            if (!is_finite(value)) return a.make_error("has a number that is not finite");
            numbers.values.push_back(shares ? value / component.largest : value);
        }
    return numbers;
}

}  // namespace jostle::modules::gltf
