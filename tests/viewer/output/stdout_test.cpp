// Tests that every command checks its writes to standard output, and reports lost data as an error.
#include <gtest/gtest.h>

#include <ostream>

#include "tests/viewer/output/full_disk.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

constexpr const char* kPrintedGraph = WEFT_SOURCE_DIR "/docs/examples/ink.json";
constexpr const char* kBroken = WEFT_SOURCE_DIR "/tests/diagnostics/W103_port.json";

struct Printer {
    const char* name;
    std::vector<std::string> arguments;
    // Exit code of the command if all its output could be written.
    int exit_code = 0;
};

void PrintTo(const Printer& printer, std::ostream* out) {
    *out << printer.name;
}

const std::vector<Printer>& printers() {
    static const std::vector<Printer> all{
        {"Help", {"--help"}},
        {"HelpOfACommand", {"render", "--help"}},
        {"Version", {"--version"}},
        {"Schema", {"schema"}},
        {"PlanText", {"plan", kPrintedGraph}},
        {"PlanJson", {"plan", kPrintedGraph, "--format", "json"}},
        {"PlanDot", {"plan", kPrintedGraph, "--format", "dot"}},
        {"PlanPage", {"plan", kPrintedGraph, "--format", "html"}},
        {"Explain", {"explain", kPrintedGraph, "resource", "tone"}},
        {"Diff", {"diff", kPrintedGraph, kPrintedGraph}},
        {"DiffJson", {"diff", kPrintedGraph, kPrintedGraph, "--json"}},
        {"CheckJson", {"check", kBroken, "--json"}, 3},
        {"CheckSarif", {"check", kBroken, "--sarif"}, 3},
        {"BenchCompile", {"bench", "compile", "--passes", "10"}},
        {"BenchCompileJson", {"bench", "compile", "--passes", "10", "--json"}},
    };
    return all;
}

class Printed : public testing::TestWithParam<Printer> {
 protected:
    [[nodiscard]] static RunResult shell(const std::string& redirection) {
        return run_program({"sh", "-c", weft_in_shell(GetParam().arguments) + redirection});
    }
    static void expect_refused(const RunResult& run, const char* why) {
        EXPECT_EQ(run.exit_code, 1) << run.text();
        const std::string wanted = std::string("error[X512]: standard output cannot be written: ") + why;
        EXPECT_NE(run.err.find(wanted), std::string::npos) << run.text();
    }
};

TEST_P(Printed, WhereAllGoesWell) {
    const RunResult run = run_weft(GetParam().arguments);
    EXPECT_EQ(run.exit_code, GetParam().exit_code) << run.text();
    EXPECT_FALSE(run.out.empty());
}

TEST_P(Printed, ToAFullDevice) {
    expect_refused(shell(" >/dev/full"), "No space left on device");
}

TEST_P(Printed, ToAPipeThatNobodyReads) {
    // Opening a pipe for writing waits for a reader. So the shell first opens the pipe for reading and
    // writing (descriptor 3), then for writing (4), and then closes descriptor 3, so that no reader remains.
    const ScratchFolder scratch;
    const std::string pipe = scratch / "pipe";
    const std::string open = "mkfifo " + pipe + "; exec 3<>" + pipe + " 4>" + pipe + " 3<&-; ";
    expect_refused(run_program({"sh", "-c", open + weft_in_shell(GetParam().arguments) + " >&4"}),
                   "Broken pipe");
}

TEST_P(Printed, ToAClosedDescriptor) {
    expect_refused(shell(" >&-"), "Bad file descriptor");
}

TEST_P(Printed, ToAFullDisk) {
    if (!can_mount()) GTEST_SKIP() << "this user may not mount a file system";
    expect_refused(
        run_on_small_disk("64k", "fill_disk\n" + weft_in_shell(GetParam().arguments) + " >\"$DISK/out\""),
        "No space left on device");
}

INSTANTIATE_TEST_SUITE_P(All, Printed, testing::ValuesIn(printers()),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace weft::test
