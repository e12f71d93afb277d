// SPDX-License-Identifier: MIT
//
// The position of a visitor in the field list, for messages: "bodies.awake[3].center.y".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace jostle::physics {

class Path {
public:
    void enter(std::string_view name) { parts_.push_back({name, 0, false}); }
    void enter(std::size_t index) { parts_.push_back({{}, index, true}); }
    void leave() { parts_.pop_back(); }

    std::string text(std::string_view field) const {
        std::string text;
        for (const PathElement& part : parts_) {
            if (part.is_index) {
                text += '[' + std::to_string(part.index) + ']';
            } else {
                if (!text.empty()) text += '.';
                text += part.name;
            }
        }
        if (!field.empty()) {
            if (!text.empty()) text += '.';
            text += field;
        }
        return text;
    }

private:
    struct PathElement {
        std::string_view name;
        std::size_t index;
        bool is_index;
    };
    std::vector<PathElement> parts_;
};

}  // namespace jostle::physics
