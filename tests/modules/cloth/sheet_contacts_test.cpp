// SPDX-License-Identifier: MIT
//
// Crumpled cloth never crosses itself, and cloths never cross each other.
#include "modules/cloth/src/sheet_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/modules/cloth/crossings.h"

namespace jostle::modules::cloth_detail {
namespace {

using namespace physics;

int self_crossings(const Sheet& sheet) {
    std::vector<Vec3> positions;
    for (std::size_t k = 0; k < sheet.size(); k++) positions.push_back(sheet.position(k));
    const auto& triangles = sheet.topology().triangles;
    return crossings(positions, triangles, positions, triangles);
}

ContactSheet touching_itself(Sheet& sheet, const ClothDef& def) {
    return {.sheet = &sheet, .thickness = def.thickness, .friction = 0.5, .collide_self = true};
}

// Everything is pulled to one point, so the sheet crumples to a ball under pressure.
TEST(SheetContacts, keep_a_crumpled_sheet_free_of_crossings) {
    ClothDef def{.grid = {.rows = 21, .columns = 21, .across = {1, 0, 0}, .down = {0, 0, 1}},
                 .thickness = 0.01};
    for (const bool collide : {true, false}) {
        Sheet sheet(def);
        for (std::size_t k = 0; k < sheet.size(); k++) {
            const Vec3 p = sheet.position(k);
            sheet.set_position(k, p + Vec3{0, 0.02 * std::sin(7 * p.x) * std::cos(5 * p.z), 0});
        }
        SheetContacts self;
        const ContactSheet itself[] = {touching_itself(sheet, def)};
        int found = 0;
        for (int n = 0; n < (collide ? 150 : 40); n++) {
            self.begin_step();
            const int parts = sheet.stable_parts(1.0 / 60, 8);
            const double h = 1.0 / 60 / parts;
            sheet.accelerations().assign(4 * sheet.size(), 0);
            // Pulled together, shaken apart, and again.
            const double pull = n % 100 < 80 ? -60 : 30;
            for (std::size_t k = 0; k < sheet.size(); k++)
                for (int axis = 0; axis < 3; axis++)
                    sheet.accelerations()[4 * k + static_cast<std::size_t>(axis)] =
                        static_cast<float>(pull * (sheet.position(k) - Vec3{0.5, -0.1, 0.5})[axis]);
            for (int part = 0; part < parts; part++) {
                sheet.predict(h, {0, -2, 0});
                sheet.solve_bends(h);
                sheet.solve_threads(h);
                if (collide) self.resolve(itself);
                sheet.finish(h, {0, -2, 0}, 0.5);
            }
            if (n % 10 == 9) found += self_crossings(sheet);
        }
        if (collide)
            EXPECT_EQ(found, 0);
        else
            EXPECT_GT(found, 100);
    }
}

// Two layers, of one mesh, that fall onto each other: the upper one is carried at the gap.
TEST(SheetContacts, carry_one_layer_on_another) {
    ClothDef def;
    def.thickness = 0.01;
    for (int layer = 0; layer < 2; layer++)
        for (int r = 0; r < 9; r++)
            for (int c = 0; c < 9; c++)
                def.vertices.push_back({0.05 * c + 0.02 * layer, 0.1 * layer, 0.05 * r});
    for (std::uint32_t layer = 0; layer < 2; layer++)
        for (std::uint32_t r = 0; r < 8; r++)
            for (std::uint32_t c = 0; c < 8; c++) {
                const std::uint32_t a = 81 * layer + 9 * r + c;
                def.triangles.insert(def.triangles.end(), {a, a + 9, a + 1, a + 1, a + 9, a + 10});
            }
    Sheet sheet(def);
    for (std::size_t k = 0; k < 81; k++) sheet.set_inverse_mass(k, 0);
    SheetContacts self;
    const ContactSheet itself[] = {touching_itself(sheet, def)};
    for (int n = 0; n < 120; n++) {
        self.begin_step();
        for (int part = 0; part < 8; part++) {
            const double h = 1.0 / 480;
            sheet.predict(h, {0, -9.81, 0});
            for (std::size_t k = 0; k < 81; k++) sheet.set_moved(k, {});
            sheet.solve_bends(h);
            sheet.solve_threads(h);
            self.resolve(itself);
            sheet.finish(h, {0, -9.81, 0}, 0.5);
        }
    }
    EXPECT_EQ(self_crossings(sheet), 0);
    double least = 1, most = 0;
    for (std::size_t k = 81; k < 162; k++) {
        const Vec3 p = sheet.position(k);
        if (p.x > 0.4) continue;  // hangs over the edge
        least = std::min(least, p.y);
        most = std::max(most, p.y);
    }
    EXPECT_GT(least, 0.018);
    EXPECT_LT(most, 0.03);
}

}  // namespace
}  // namespace jostle::modules::cloth_detail
