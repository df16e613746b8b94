#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "files.h"
#include "offline_graph.h"
#include "sarif.h"

namespace weft::viewer {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Diagnostic& d) {
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

}  // namespace

ExitCode run_check(const CheckOptions& options) {
    // Once is enough to say that there is no such profile.
    if (const Result<DeviceProfile> profile = load_profile(options.offline.profile); !profile) {
        report(profile.errors());
        return exit_code_for(profile.errors());
    }
    const bool prints_data = options.json || options.sarif;
    Diagnostics all;
    for (const std::string& file : options.files) {
        Diagnostics found;
        Result<OfflinePlan> made = compile_offline(file, options.offline, found);
        if (!made) {
            const Diagnostics errors = made.take_errors();
            found.insert(found.end(), errors.begin(), errors.end());
        } else if (!prints_data) {
            const FramePlan& plan = made->plan;
            std::fprintf(stderr,
                         "%s: ok, %zu passes live of %zu, %u barriers, %.1f MiB of transient memory\n",
                         file.c_str(), plan.schedule.order.size(), plan.graph.passes.size(),
                         plan.barriers.emitted, static_cast<double>(plan.memory.heap_bytes) / 1048576.0);
        }
        if (!prints_data) report(found);
        all.insert(all.end(), found.begin(), found.end());
    }
    if (options.json) {
        Json list = Json::array();
        for (const Diagnostic& d : all) list.push_back(to_json(d));
        std::printf("%s\n", list.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
    }
    if (options.sarif) std::fputs(sarif_log(all).c_str(), stdout);
    return has_errors(all) ? exit_code_for(all) : ExitCode::ok;
}

}  // namespace weft::viewer
