// Signals are noted, and what was there before is put back.
#include "boards/linux_spi/stop_on_signal.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

namespace shade16::linux_spi {
namespace {

class Signals : public testing::TestWithParam<int> {};

void (*action_of(int number))(int) {
    struct sigaction action {};
    sigaction(number, nullptr, &action);
    return action.sa_handler;
}

TEST_P(Signals, AskToStop) {
    {
        const StopOnSignal stop;
        EXPECT_EQ(stop.asked(), 0);
        EXPECT_NO_THROW(stop.throw_if_asked());
        std::raise(GetParam());
        EXPECT_EQ(stop.asked(), GetParam());
        EXPECT_THROW(stop.throw_if_asked(), Stopped);
    }
    EXPECT_EQ(action_of(GetParam()), SIG_DFL);
    EXPECT_EQ(StopOnSignal().asked(), 0) << "a new loop was not asked yet";
}

TEST_P(Signals, EndTheProgramTheThirdTime) {
    const auto thrice = [] {
        const StopOnSignal stop;
        std::raise(GetParam()), std::raise(GetParam());
        EXPECT_EQ(stop.asked(), GetParam()) << "a shell may say it twice";
        std::raise(GetParam());
    };
    EXPECT_EXIT(thrice(), testing::KilledBySignal(GetParam()), "");
    EXPECT_EXIT(end_by(Stopped{GetParam()}), testing::KilledBySignal(GetParam()), "");
}

TEST_P(Signals, LeaveTheThirdToWhoeverHandledThemBefore) {
    const auto thrice = [] {
        std::signal(GetParam(), [](int) { _exit(42); });  // as one that cleans a terminal up
        const StopOnSignal stop;
        for (int i = 0; i < 3; ++i) std::raise(GetParam());
    };
    EXPECT_EXIT(thrice(), testing::ExitedWithCode(42), "");
}

TEST_P(Signals, AreIgnoredWhereTheyWereIgnored) {
    std::signal(GetParam(), SIG_IGN);
    {
        const StopOnSignal stop;
        std::raise(GetParam());
        EXPECT_EQ(stop.asked(), 0);
    }
    EXPECT_EQ(action_of(GetParam()), SIG_IGN);
    std::signal(GetParam(), SIG_DFL);
}

TEST(StopOnSignal, SignalsHaveNames) {
    EXPECT_STREQ(Stopped{SIGINT}.name(), "SIGINT");
    EXPECT_STREQ(Stopped{SIGTERM}.name(), "SIGTERM");
    EXPECT_STREQ(Stopped{SIGHUP}.name(), "SIGHUP");
}

INSTANTIATE_TEST_SUITE_P(Each, Signals, testing::Values(SIGINT, SIGTERM, SIGHUP));

}  // namespace
}  // namespace shade16::linux_spi
