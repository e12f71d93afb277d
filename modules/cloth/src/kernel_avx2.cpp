// SPDX-License-Identifier: MIT
#include "modules/cloth/src/sheet_kernel_body.h"

namespace jostle::modules::cloth_detail {

extern const SheetKernel avx2_kernel;
const SheetKernel avx2_kernel = {solve_chains, solve_cells, solve_hinges};

}  // namespace jostle::modules::cloth_detail
