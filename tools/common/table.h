// SPDX-License-Identifier: MIT
//
// Text in columns for a terminal. What strangers called themselves is shown so that it can neither
// move the cursor nor look like another row.
#pragma once

#include <string>
#include <vector>

namespace jostle::ctl {

enum class Align { left, right };

struct Column {
    std::string title;
    Align align = Align::left;
};

class Table {
public:
    explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

    // One cell for each column.
    void add(std::vector<std::string> cells);
    // The titles, then the rows; the last column is not padded.
    std::string text() const;

private:
    std::vector<Column> columns_;
    std::vector<std::vector<std::string>> rows_;
};

// On one line, without control characters, and at most so many letters, "..." when it was longer.
std::string sanitized(const std::string& text, std::size_t width_max = 32);
// "12 s", "3 min 20 s", "2 h 5 min", "4 d 1 h".
std::string duration_text(double seconds);
// With so many digits after the point.
std::string number_text(double number, int digits);

}  // namespace jostle::ctl
