// SPDX-License-Identifier: MIT
//
// All scenes on one sheet, a small panel each: processor time against error.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/analysis.h"

namespace jostle::bench::accuracy {

// The file's text. A panel has a line an engine, through those of its rows that none of its own
// beats; rings around the rows that nobody beats; and a mark on the right for each tolerance, with
// who reaches it with the least work.
std::string accuracy_overview(const std::vector<Row>& rows);

}  // namespace jostle::bench::accuracy
