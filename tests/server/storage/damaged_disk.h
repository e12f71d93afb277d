// SPDX-License-Identifier: MIT
//
// Damage that disks do to the files of a database: changed, lost, torn and misdirected writes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <string>

#include "tests/support/random.h"

namespace jostle::test {

// The content of files by name.
using FileContents = std::map<std::string, std::string>;

// Damages one of the files and returns what was done. `older` holds an earlier state of the files,
// from which lost writes are taken.
inline std::string damage_one_file(FileContents& files, const FileContents& older, Random& random) {
    constexpr std::size_t page = 4096;
    auto at = files.begin();
    std::advance(at, static_cast<std::ptrdiff_t>(random.below(files.size())));
    auto& [name, bytes] = *at;
    const std::string& before = older.at(name);
    if (bytes.empty()) return "nothing: " + name + " is empty";
    // Pages of a log follow a header of 32 bytes and have a header of 24 bytes each.
    const bool is_log = name.ends_with("-wal");
    const std::size_t start = is_log ? 32 : 0, stride = is_log ? page + 24 : page;
    const std::size_t pages =
        bytes.size() > start ? (bytes.size() - start + stride - 1) / stride : 0;
    const auto range_of = [&](std::size_t k) {
        const std::size_t first = start + k * stride;
        return std::pair(first, std::min(stride, bytes.size() - first));
    };
    const std::size_t kind = random.below(pages > 0 ? 7 : 2);
    const auto [first, size] = range_of(pages > 0 ? random.below(pages) : 0);
    switch (kind) {
        case 0: {
            const std::size_t k = random.below(bytes.size());
            bytes[k] = static_cast<char>(bytes[k] ^ (1 << random.below(8)));
            return name + ": a bit of byte " + std::to_string(k) + " flipped";
        }
        case 1: {
            const std::size_t length = random.below(bytes.size());
            bytes.resize(length);
            return name + ": truncated to " + std::to_string(length);
        }
        case 2:
            std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(first), size, '\0');
            return name + ": zeros at " + std::to_string(first);
        case 3:
        case 4: {  // the disk lost a write, or wrote a part of it
            const std::size_t length = kind == 3 ? size : size / 2;
            const std::string old = before.size() > first ? before.substr(first, length) : "";
            bytes.replace(first, old.size(), old);
            return name + (kind == 3 ? ": lost write at " : ": torn write at ") +
                   std::to_string(first);
        }
        case 5: {  // written to another place
            const auto [from, from_size] = range_of(random.below(pages));
            const std::string other = bytes.substr(from, std::min(size, from_size));
            bytes.replace(first, other.size(), other);
            return name + ": page at " + std::to_string(from) + " written to " +
                   std::to_string(first);
        }
        default:  // no write since the earlier state reached the file
            bytes = before;
            return name + ": replaced by its earlier state";
    }
}

// Number of damages that a test tries; JOSTLE_FLIPS overrides it.
inline int damages_to_try(int usual) {
    const char* const wished = std::getenv("JOSTLE_FLIPS");
    return wished != nullptr ? std::atoi(wished) : usual;
}

}  // namespace jostle::test
