// SPDX-License-Identifier: MIT
//
// The C interface of the predictor, called natively; browsers call it as WebAssembly.
// clients/web/sdk/src/prediction has the longer test cases.
#include "clients/cpp/prediction/wasm/predictor_api.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

using Numbers = std::vector<double>;

std::vector<uint32_t> asked;

struct Caller {
    JostlePredictor* predictor = jostle_predictor_create();
    ~Caller() { jostle_predictor_destroy(predictor); }

    uint32_t put(const Numbers& numbers) {
        double* to = jostle_predictor_buffer(predictor, static_cast<uint32_t>(numbers.size()));
        std::copy(numbers.begin(), numbers.end(), to);
        return static_cast<uint32_t>(numbers.size());
    }
    // A floor (1) and a crate of 0.5 m and 100 kg on it (2).
    uint32_t frame(uint32_t number) {
        put({1, 0, -0.5, 0, 0, 0, 0, 1, 1, 2, 0, 0.25, 0, 0, 0, 0, 1, 0});
        return jostle_predictor_frame(predictor, number, 2);
    }
    double x_of_crate(double position, double now_us) {
        if (jostle_predictor_predicted(predictor) != 1) return std::nan("");
        put({2, 0, 0.25, 0, 0, 0, 0, 1});
        if (jostle_predictor_sample(predictor, position, now_us, 1) != 1) return std::nan("");
        return jostle_predictor_buffer(predictor, 8)[1];
    }
    void begin() {
        asked.clear();
        jostle_predictor_begin(predictor, 60, 0, -9.81, 0, 8);
        jostle_predictor_add_body(predictor, 1, 0, 0);
        jostle_predictor_add_body(predictor, 2, 2, 100);
        jostle_predictor_follow(predictor, 2);
    }
};

}  // namespace

void jostle_predictor_request_shapes(JostlePredictor* predictor, uint32_t entity) {
    asked.push_back(entity);
    const double half = entity == 1 ? 50 : 0.25, high = entity == 1 ? 0.5 : 0.25;
    const Numbers shapes{1,   3,    0, 0, 0, 0, 0, 0, 1, half, high,         half,
                         0.5, 0,    0, 0, 0, 0, 0, 1, 4, 1,    4294967295.0, 0,
                         0,   1000, 0};
    double* to = jostle_predictor_buffer(predictor, static_cast<uint32_t>(shapes.size()));
    std::copy(shapes.begin(), shapes.end(), to);
    EXPECT_EQ(jostle_predictor_set_shapes(predictor, entity, static_cast<uint32_t>(shapes.size())),
              1u);
}

TEST(PredictorApi, predicts_an_impulse_in_the_next_frame_and_requests_shapes_once) {
    Caller caller;
    caller.begin();
    ASSERT_EQ(caller.frame(10), 1u);
    EXPECT_EQ(asked, (std::vector<uint32_t>{2, 1}));
    EXPECT_NEAR(caller.x_of_crate(14, 1e6), 0, 1e-3);
    jostle_predictor_push(caller.predictor, 1, 15, 2, 300, 0, 0);  // 3 m/s
    EXPECT_NEAR(caller.x_of_crate(15, 1.0167e6), 3.0 / 60, 2e-3) << "less friction";
    jostle_predictor_follow(caller.predictor, 0);
    jostle_predictor_follow(caller.predictor, 2);
    EXPECT_EQ(caller.frame(11), 1u);
    EXPECT_EQ(asked.size(), 2u) << "shapes are requested once";
}

TEST(PredictorApi, ignores_invalid_arguments) {
    Caller caller;
    caller.begin();
    EXPECT_EQ(jostle_predictor_frame(caller.predictor, 1, 2), 0u) << "the buffer is empty";
    caller.put({2, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0});
    EXPECT_EQ(jostle_predictor_frame(caller.predictor, 1, 2), 0u) << "entities are not sorted";
    EXPECT_EQ(jostle_predictor_buffer(caller.predictor, 1u << 25), nullptr);
    EXPECT_EQ(jostle_predictor_set_shapes(caller.predictor, 99, 0), 0u);
    ASSERT_EQ(caller.frame(10), 1u);
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(caller.x_of_crate(none, 1e6)));
    EXPECT_TRUE(std::isnan(caller.x_of_crate(11, -1)));
    jostle_predictor_push(caller.predictor, 1, 12, 2, none, 0, 0);
    jostle_predictor_grab(caller.predictor, 2, 12, 2, none, none, none);
    jostle_predictor_drag(caller.predictor, 3, 13, 1e300, 0, 0);
    EXPECT_NEAR(caller.x_of_crate(14, 1e6), 0, 1e-3);
    EXPECT_EQ(jostle_predictor_stat(caller.predictor, 99), 0);
}
