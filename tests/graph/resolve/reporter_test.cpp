#include "graph/resolve/reporter.h"

#include <gtest/gtest.h>

namespace weft::test {
namespace {

class ReporterTest : public ::testing::Test {
 protected:
    ReporterTest() { graph.sources.add_file("graph.json", "abcdef"); }

    static SourceLoc at(uint32_t column) { return {.file = 0, .line = 1, .column = column}; }

    GraphDesc graph;
    Diagnostics warnings;
};

TEST_F(ReporterTest, StopsBehindTheMostErrorsAndSaysSo) {
    Reporter reporter(graph, 1000, warnings);
    for (size_t i = 0; i < Reporter::kMostErrors; ++i) reporter.error({}, "W101", "fault");
    EXPECT_THROW(reporter.error({}, "W101", "one too many"), ResolveStopped);
    const Diagnostics errors = reporter.finish();
    ASSERT_EQ(errors.size(), Reporter::kMostErrors);
    EXPECT_EQ(errors.back().help, std::vector<std::string>{"only the first 100 errors are shown"});
}

TEST_F(ReporterTest, StopsWhenTheStepsAreUsedUp) {
    Reporter reporter(graph, 10, warnings);
    reporter.spend(10, at(1));
    EXPECT_THROW(reporter.spend(1, at(3)), ResolveStopped);
    const Diagnostics errors = reporter.finish();
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].code, "W125");
    EXPECT_EQ(errors[0].column, 3u);
}

TEST_F(ReporterTest, TiersShareTheSteps) {
    graph.tiers.resize(4);
    const Reporter reporter(graph, 100, warnings);
    EXPECT_EQ(reporter.most_steps(), 20u);
}

TEST_F(ReporterTest, AFaultOfARepeatIsReportedOnceAndItsSearchIsPaid) {
    Reporter reporter(graph, 10, warnings);
    const auto report = [&](uint32_t column) {
        reporter.add_once(graph.sources.error(at(column), "W103", "fault"), at(column), 6).help.push_back("");
    };
    report(1);
    report(2);
    EXPECT_EQ(reporter.error_count(), 2u);
    report(1);
    EXPECT_EQ(reporter.error_count(), 2u);
    EXPECT_THROW(report(1), ResolveStopped) << "12 steps";
}

TEST_F(ReporterTest, TheSamePlaceMayHaveFaultsOfSeveralCodes) {
    Reporter reporter(graph, 10, warnings);
    for (const char* code : {"W106", "W109", "W106"}) reporter.add_once(graph.sources.error(at(1), code, ""));
    EXPECT_EQ(reporter.error_count(), 2u);
}

TEST_F(ReporterTest, SortsTheLaterErrorsByTheirPlace) {
    Reporter reporter(graph, 10, warnings);
    for (const uint32_t column : {5u, 4u, 2u, 3u}) reporter.error(at(column), "W110", "");
    reporter.sort_errors(1);
    std::vector<uint32_t> columns;
    for (const Diagnostic& d : reporter.finish()) columns.push_back(d.column);
    EXPECT_EQ(columns, (std::vector<uint32_t>{5, 2, 3, 4}));
}

TEST_F(ReporterTest, CountsTheWarningsThatItLeavesOut) {
    warnings.resize(Reporter::kMostWarnings - 1);
    Reporter reporter(graph, 10, warnings);
    for (int i = 0; i < 3; ++i) reporter.warn(at(1), "W130", "unused", "remove it");
    EXPECT_TRUE(reporter.finish().empty());
    ASSERT_EQ(warnings.size(), Reporter::kMostWarnings);
    EXPECT_EQ(warnings.back().severity, Severity::warning);
    EXPECT_EQ(warnings.back().help, (std::vector<std::string>{"remove it", "and 2 more warnings"}));
}

}  // namespace
}  // namespace weft::test
