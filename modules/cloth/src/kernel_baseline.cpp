// SPDX-License-Identifier: MIT
#include "modules/cloth/src/sheet_kernel_body.h"

namespace jostle::modules::cloth_detail {

extern const SheetKernel baseline_kernel;
const SheetKernel baseline_kernel = {solve_chains, solve_cells, solve_hinges};

}  // namespace jostle::modules::cloth_detail
