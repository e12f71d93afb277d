// SPDX-License-Identifier: MIT
#include "bench/result_file.h"

#include <gtest/gtest.h>

#include "bench/speed/growth.h"
#include "bench/speed/speed_row.h"

namespace {

using namespace jostle::bench;

TEST(ResultFile, csv_has_the_columns_of_all_rows_in_order_of_first_use) {
    EXPECT_EQ(csv_text(nlohmann::ordered_json::array(
                  {{{"engine", "jostle"}, {"failed", nullptr}, {"ms_mean", 1.5}},
                   {{"engine", "ode"}, {"why", "ended by signal 11"}}})),
              "engine,failed,ms_mean,why\njostle,,1.5,\node,,,ended by signal 11\n");
}

TEST(ResultFile, csv_quotes_separators) {
    EXPECT_EQ(csv_text(nlohmann::ordered_json::array(
                  {{{"error", "RMS, m"}, {"text", "a \"b\"\nc"}, {"repeats", true}}})),
              "error,text,repeats\n\"RMS, m\",\"a \"\"b\"\"\nc\",true\n");
}

TEST(ResultFile, csv_of_a_failed_row_states_the_reason) {
    const SpeedRow good{.scene = "a", .name = "pyramid", .engine = "jostle", .ms_mean = 1.6};
    const SpeedRow bad{.scene = "a", .name = "pyramid", .engine = "ode", .failed = "lost, all"};
    const std::string csv = csv_text(nlohmann::ordered_json::array({to_json(good), to_json(bad)}));
    EXPECT_TRUE(
        csv.starts_with("scene,name,engine,threads,steps,failed,count,vertices,wheels,"
                        "cell_m,drum_speed_deg_per_s,bodies,ms_mean,"))
        << csv;
    EXPECT_NE(csv.find("\na,pyramid,jostle,1,0,,,,,,,0,1.6,"), std::string::npos) << csv;
    EXPECT_NE(csv.find("\na,pyramid,ode,1,0,\"lost, all\",,,"), std::string::npos) << csv;
}

TEST(ResultFile, rows_record_the_parameters_of_their_scenes) {
    SpeedRow row{.scene = "wheels_mesh", .parameters = {{{}, {}, 8, 0.25, {}}}, .failed = "lost"};
    const auto json = to_json(row);
    EXPECT_EQ(json.at("wheels").dump(), "8");
    EXPECT_EQ(json.at("cell_m").dump(), "0.25");
    EXPECT_TRUE(json.at("count").is_null());
    EXPECT_EQ(speed_row_from(json).parameters, row.parameters);
    EXPECT_NE(csv_text(nlohmann::ordered_json::array({json})).find(",lost,,,8,0.25,"),
              std::string::npos);
    // Files of earlier versions have no such columns.
    nlohmann::ordered_json old = json;
    for (const ParameterKind& kind : parameter_kinds()) old.erase(kind.column);
    EXPECT_EQ(speed_row_from(old).parameters, ParameterValues{});
}

TEST(ResultFile, csv_of_growth_has_one_line_per_number_of_bodies) {
    EXPECT_EQ(csv_text(nlohmann::ordered_json::array({to_json(GrowthRow{.scene = "pile",
                                                                        .engine = "jostle",
                                                                        .bodies = 500,
                                                                        .ms_mean = 1.25,
                                                                        .clock = "cpu",
                                                                        .bytes_per_body = 2000})})),
              "scene,engine,threads,bodies,failed,ms_mean,clock,bytes_per_body\n"
              "pile,jostle,1,500,,1.25,cpu,2000.0\n");
}

}  // namespace
