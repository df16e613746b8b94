#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "graph/diagnostics/quantity_text.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/graph_test_run.h"
#include "viewer/commands/tier_check.h"
#include "viewer/files/files.h"
#include "viewer/files/near_files.h"
#include "viewer/output/output.h"
#include "viewer/output/report.h"
#include "viewer/output/sarif.h"

namespace weft::viewer {
namespace {

using Json = nlohmann::ordered_json;

Json diagnostic_json(const Diagnostic& d) {
    Json notes = Json::array();
    for (const Note& note : d.notes)
        notes.push_back(
            {{"file", note.file}, {"line", note.line}, {"column", note.column}, {"message", note.message}});
    return {{"code", d.code},       {"severity", d.severity == Severity::error ? "error" : "warning"},
            {"file", d.file},       {"line", d.line},
            {"column", d.column},   {"pointer", d.pointer},
            {"message", d.message}, {"help", d.help},
            {"notes", notes},       {"tier", d.tier.empty() ? Json(nullptr) : Json(d.tier)}};
}

std::string json_list(const Diagnostics& diagnostics) {
    Json list = Json::array();
    for (const Diagnostic& d : diagnostics) list.push_back(diagnostic_json(d));
    return list.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void say_ok(const std::string& file, const CheckedGraph& checked) {
    const FramePlan& plan = *checked.plan;
    const std::string tiers = checked.tiers > 0 ? " without a tier and with each of its tiers (" +
                                                      std::to_string(checked.tiers) + ")"
                                                : "";
    std::fprintf(stderr, "%s: ok%s: %zu of %zu passes live, %u barriers, %.1f MiB of transient memory\n",
                 file.c_str(), tiers.c_str(), plan.schedule.order.size(), plan.graph.passes.size(),
                 plan.barriers.emitted, static_cast<double>(plan.memory.heap_bytes) / 1048576.0);
}

}  // namespace

ExitCode run_check(const CheckOptions& options) {
    const bool prints_data = options.json || options.sarif;
    Diagnostics all;
    // If the device profile cannot be loaded, the error is reported once and no file is checked. Otherwise,
    // the same error would appear for each file.
    const Result<DeviceProfile> profile = load_profile(options.offline.profile);
    if (!profile) {
        all = profile.errors();
        if (!prints_data) report(all);
    }
    for (const std::string& file : profile ? options.files : std::vector<std::string>{}) {
        // Skip the schema file: a shell pattern such as graphs/*.json matches the schema in the same folder,
        // too.
        if (file.ends_with(".schema.json")) continue;
        CheckedGraph checked = check_tiers(file, options.offline);
        if (options.run && !has_errors(checked.found)) {
            Diagnostics failed = run_graph_tests(file, options);
            checked.found.insert(checked.found.end(), failed.begin(), failed.end());
        }
        if (!prints_data && !has_errors(checked.found)) say_ok(file, checked);
        if (!prints_data) report(checked.found);
        all.insert(all.end(), checked.found.begin(), checked.found.end());
    }
    if (prints_data) std::ranges::for_each(all, add_near_files);
    const ExitCode code = has_errors(all) ? exit_code_for(all) : ExitCode::ok;
    if (options.json) return print_data(json_list(all), code);
    return options.sarif ? print_data(sarif_log(all), code) : code;
}

}  // namespace weft::viewer
