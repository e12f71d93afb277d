// SPDX-License-Identifier: MIT
//
// Suggestions for misspelled names: scenes, flags, settings, fields, subcommands. Any thread.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace jostle {

/// Returns the number of characters to insert, delete, replace or swap with their neighbour that
/// turn one text into the other.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, row(b.size() + 1), next(b.size() + 1);
    for (std::size_t k = 0; k <= b.size(); k++) row[k] = k;
    for (std::size_t i = 1; i <= a.size(); i++) {
        next[0] = i;
        for (std::size_t k = 1; k <= b.size(); k++) {
            next[k] = std::min(
                {row[k] + 1, next[k - 1] + 1, row[k - 1] + (a[i - 1] != b[k - 1] ? 1 : 0)});
            if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
                next[k] = std::min(next[k], before[k - 2] + 1);
        }
        before = row;
        std::swap(row, next);
    }
    return row[b.size()];
}

/// Returns the name with the smallest edit distance to `wrong`, the first of equals; empty if every
/// name differs in more than a third of its characters (at least one, at most three), so that a
/// suggestion is rarely wrong. Names are a range of texts.
template <typename Names>
std::string nearest_name(std::string_view wrong, const Names& names) {
    constexpr std::size_t length_max = 64;  // bounds the cost for untrusted texts
    std::string best;
    if (wrong.size() > length_max) return best;
    std::size_t nearest = 4;
    for (const auto& entry : names) {
        const std::string_view name = entry;
        const std::size_t allowed =
            std::clamp<std::size_t>(std::max(name.size(), wrong.size()) / 3, 1, 3);
        const std::size_t distance = edit_distance(wrong, name);
        if (distance > allowed || distance >= nearest) continue;
        nearest = distance;
        best = name;
    }
    return best;
}

/// Returns "; did you mean "NAME"?" for the end of an error message, or nothing.
template <typename Names>
std::string did_you_mean(std::string_view wrong, const Names& names) {
    const std::string best = nearest_name(wrong, names);
    return best.empty() ? best : "; did you mean \"" + best + "\"?";
}

}  // namespace jostle
