// Purpose: the commands of the `weft` program. Each function runs one command and returns the exit code of
// the process.
#pragma once

#include "viewer/options/options.h"
#include "viewer/output/exit_code.h"

namespace weft::viewer {

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
[[nodiscard]] ExitCode run_scene(const SceneOptions& options);
[[nodiscard]] ExitCode run_doctor(const DoctorOptions& options);

}  // namespace weft::viewer
