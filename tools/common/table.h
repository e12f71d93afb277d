// SPDX-License-Identifier: MIT
//
// Text tables for a terminal. Untrusted text, such as the names of clients, is sanitized so that it
// can neither move the cursor nor look like another row.
#pragma once

#include <string>
#include <vector>

namespace jostle::common {

enum class Align { left, right };

struct Column {
    std::string title;
    Align align = Align::left;
};

class Table {
public:
    explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

    // Adds a row with one cell per column.
    void add(std::vector<std::string> cells);
    // Returns the titles and the rows; the last column is not padded.
    std::string text() const;

private:
    std::vector<Column> columns_;
    std::vector<std::vector<std::string>> rows_;
};

// Replaces control characters and truncates the text to `width_max` code points, with "..."
// appended.
std::string sanitized(const std::string& text, std::size_t width_max = 32);
// Formats a duration: "12 s", "3 min 20 s", "2 h 5 min", "4 d 1 h".
std::string duration_text(double seconds);
// Formats a number with `digits` decimal places.
std::string number_text(double number, int digits);

}  // namespace jostle::common
