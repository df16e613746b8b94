// Purpose: the commands of the `weft` program. Each returns the process's exit code.
#pragma once

#include <string>

#include "options.h"
#include "weft/result.h"

namespace weft::viewer {

// The contract that scripts rely on.
enum class ExitCode : int {
    ok = 0,
    failed = 1,
    usage = 2,
    invalid_input = 3,
    no_device = 4,
    validation = 5,
    mismatch = 6,
    lost = 7,
};

[[nodiscard]] ExitCode run_render(const RenderOptions& options);
[[nodiscard]] ExitCode run_view(const ViewOptions& options);
[[nodiscard]] ExitCode run_check(const CheckOptions& options);
[[nodiscard]] ExitCode run_plan(const PlanOptions& options);
[[nodiscard]] ExitCode run_schema(const SchemaOptions& options);
[[nodiscard]] ExitCode run_explain(const ExplainOptions& options);
[[nodiscard]] ExitCode run_diff(const DiffOptions& options);
[[nodiscard]] ExitCode run_compare(const CompareOptions& options);
[[nodiscard]] ExitCode run_bench_compile(const BenchOptions& options);
[[nodiscard]] ExitCode run_bench_frame(const FrameBenchOptions& options);
[[nodiscard]] ExitCode run_doctor(const DoctorOptions& options);

// Prints to stderr.
void report(const Diagnostics& diagnostics);
// X571, for an exception that came from an allocation.
void report_out_of_memory();
// The exit code that the first error's code stands for: W, S, X53x, X56x: input; V40x: device; V407, V408:
// lost; X520 to X522: usage.
[[nodiscard]] ExitCode exit_code_for(const Diagnostics& errors);

}  // namespace weft::viewer
