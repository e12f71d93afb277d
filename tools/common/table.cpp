// SPDX-License-Identifier: MIT
#include "tools/common/table.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace jostle::common {

namespace {

// Number of code points of UTF-8 text: all bytes except continuation bytes.
std::size_t code_point_count(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, Align align) {
    const std::size_t code_points = code_point_count(text);
    const std::string space(width > code_points ? width - code_points : 0, ' ');
    return align == Align::left ? text + space : space + text;
}

}  // namespace

void Table::add(std::vector<std::string> cells) {
    cells.resize(columns_.size());
    rows_.push_back(std::move(cells));
}

std::string Table::text() const {
    std::vector<std::size_t> widths;
    for (std::size_t c = 0; c < columns_.size(); c++) {
        widths.push_back(code_point_count(columns_[c].title));
        for (const auto& row : rows_) widths[c] = std::max(widths[c], code_point_count(row[c]));
    }
    std::string out;
    const auto line = [&](const auto& cell_of) {
        for (std::size_t c = 0; c < columns_.size(); c++) {
            const bool is_last = c + 1 == columns_.size();
            if (is_last && columns_[c].align == Align::left)
                out += cell_of(c);
            else
                out += padded(cell_of(c), widths[c], columns_[c].align);
            out += is_last ? "\n" : "  ";
        }
    };
    line([&](std::size_t c) { return columns_[c].title; });
    for (const auto& row : rows_) line([&](std::size_t c) { return row[c]; });
    return out;
}

// Control characters are U+0000 to U+001F, DEL, and U+0080 to U+009F, which are encoded as C2 80 to
// C2 9F.
std::string sanitized(const std::string& text, std::size_t width_max) {
    std::string out;
    std::size_t code_points = 0;
    for (std::size_t i = 0; i < text.size(); i++) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const bool begins = (byte & 0xc0) != 0x80;
        if (begins && code_points++ == width_max) return out + "...";
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
        if (byte < 0x20 || byte == 0x7f) {
            out += '?';
        } else if (byte == 0xc2 && next >= 0x80 && next <= 0x9f) {
            out += '?';
            i++;
        } else {
            out += text[i];
        }
    }
    return out;
}

std::string duration_text(double seconds) {
    struct Unit {
        const char* name;
        long long seconds;
    };
    static constexpr std::array<Unit, 4> units{{{"d", 86400}, {"h", 3600}, {"min", 60}, {"s", 1}}};
    const auto whole = static_cast<long long>(std::max(0.0, seconds));
    for (std::size_t i = 0; i + 1 < units.size(); i++) {
        if (whole < units[i].seconds) continue;
        const long long rest = whole % units[i].seconds / units[i + 1].seconds;
        return std::to_string(whole / units[i].seconds) + " " + units[i].name +
               (rest ? " " + std::to_string(rest) + " " + units[i + 1].name : "");
    }
    return std::to_string(whole) + " s";
}

std::string number_text(double number, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, number);
    return text;
}

}  // namespace jostle::common
