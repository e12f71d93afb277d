// SPDX-License-Identifier: MIT
//
// Converts rows to JSON and back. The list of a row's fields calls one of these with the name and
// value of each field. An optional without a value is null.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace jostle::bench {

struct FieldWriter {
    nlohmann::ordered_json& json;

    template <class Value>
    void operator()(const char* name, const Value& value) const {
        json[name] = value;
    }
    template <class Value>
    void operator()(const char* name, const std::optional<Value>& value) const {
        json[name] = value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
    }
};

struct FieldReader {
    const nlohmann::ordered_json& json;

    template <class Value>
    void operator()(const char* name, Value& value) const {
        json.at(name).get_to(value);
    }
    template <class Value>
    void operator()(const char* name, std::optional<Value>& value) const {
        // The field may be missing in files of earlier versions.
        const auto found = json.find(name);
        if (found != json.end() && !found->is_null()) value = found->template get<Value>();
    }
};

}  // namespace jostle::bench
