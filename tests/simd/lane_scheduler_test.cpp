// Requirement R-1002: a scheduler changes no bit of a trajectory, whatever runs beside it; it leaves no lane without
// work while there is any, and steps half of the lanes where half suffice.
#include "simd/lane_scheduler.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace overturn::simd {
namespace {

enum class Number : int { x, left, count };
enum class Wave : int { push, count };

double stepped(double x, double push) { return 3.7 * x * (1 - x) + push; }

// Some segments of chaotic steps; between two segments something that lanes do not do.
struct Walk {
    std::size_t number = 0;
    double x = 0;
    std::vector<int> segments;
    double push = 0;

    bool rest() {
        if (segments.empty()) {
            return false;
        }
        x = std::sqrt(x);
        return true;
    }
};

Walk walk(std::size_t number) {
    Walk made{.number = number, .x = 0.1 + 0.8 * std::abs(std::sin(static_cast<double>(number))), .segments = {}};
    made.push = 1e-3 * static_cast<double>(number % 5);
    for (std::size_t segment = 0; segment < number * 7 % 4; ++segment) {  // some have none: they never need a lane
        made.segments.push_back(static_cast<int>(1 + (number + segment) * 13 % 40));
    }
    return made;
}

double alone(std::size_t number) {
    auto one = walk(number);
    while (one.rest()) {
        for (int i = 0; i < one.segments.back(); ++i) {
            one.x = stepped(one.x, one.push);
        }
        one.segments.pop_back();
    }
    return one.x;
}

class Walks {
  public:
    using Fields = LaneFields<Number, Wave, most_lanes>;
    using Trajectory = Walk;

    Walks(int width, std::size_t count) : ends(count), width_(width), count_(count) {}

    [[nodiscard]] int width() const { return width_; }
    bool start_next(std::optional<Walk>& place) {
        if (next_ == count_) {
            return false;
        }
        place = walk(next_++);
        return true;
    }
    bool advance(Walk& one) { return one.rest(); }
    void load_lane(Walk& one, Fields& fields, int lane) {
        fields.at(Number::x, lane) = one.x;
        fields.at(Number::left, lane) = one.segments.back();
        pushes_.at(one.number % pushes_.size()) = one.push;
        fields.at(Wave::push, lane) = &pushes_.at(one.number % pushes_.size());  // a walk may move
        ++running_;
    }
    void store_lane(Walk& one, Fields const& fields, int lane) {
        one.x = fields.at(Number::x, lane);
        one.segments.pop_back();
        --running_;
    }
    std::uint32_t step(Fields& fields, int used) {
        EXPECT_TRUE(used == width_ || used == width_ / 2);
        EXPECT_EQ(used == width_, running_ > width_ / 2) << running_;
        if (next_ < count_) {
            EXPECT_EQ(running_, width_);
        }
        std::uint32_t ended = 0;
        while (ended == 0) {
            for (int lane = 0; lane < used; ++lane) {
                double& left = fields.at(Number::left, lane);
                EXPECT_GT(left, 0);  // never an idle lane
                fields.at(Number::x, lane) = stepped(fields.at(Number::x, lane), *fields.at(Wave::push, lane));
                left -= 1;
                ended |= left == 0 ? 1U << static_cast<unsigned>(lane) : 0;
            }
        }
        return ended;
    }
    void finish(Walk const& one) { ends.at(one.number) = one.x; }

    std::vector<std::optional<double>> ends;

  private:
    int width_;
    std::size_t count_;
    std::size_t next_ = 0;
    int running_ = 0;
    std::array<double, 5> pushes_{};
};

class Scheduler : public testing::TestWithParam<int> {};

TEST_P(Scheduler, GivesWhatEachTrajectoryGivesAlone) {
    for (std::size_t count = 0; count < 60; ++count) {
        Walks walks(GetParam(), count);
        LaneScheduler(walks).run();
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_TRUE(walks.ends[i].has_value()) << i;
            EXPECT_EQ(*walks.ends[i], alone(i)) << i << " of " << count;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Widths, Scheduler, testing::Values(1, 2, 4, 8, 16), testing::PrintToStringParamName());

TEST(LaneFields, CopyALane) {
    LaneFields<Number, Wave, 4> fields;
    std::array<double, 1> const wave{};
    fields.at(Number::x, 1) = 5;
    fields.at(Number::left, 1) = 6;
    fields.at(Wave::push, 1) = wave.data();

    fields.copy_lane(1, 3);

    EXPECT_EQ(fields.at(Number::x, 3), 5);
    EXPECT_EQ(fields.at(Number::left, 3), 6);
    EXPECT_EQ(fields.at(Wave::push, 3), wave.data());
    EXPECT_EQ(fields.at(Wave::push, 2), nullptr);
}

}  // namespace
}  // namespace overturn::simd
