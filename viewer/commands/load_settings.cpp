#include "viewer/commands/load_settings.h"

#include "viewer/files/files.h"

namespace weft::viewer {

LoadSettings load_settings(const Limits& limits, const std::vector<std::string>& graph_path) {
    const std::filesystem::path root = shipped_root();
    return {.reader = reader_up_to(limits.graph.json_bytes),
            .reads_disk = true,
            .graph_root = root / "graphs",
            .shader_root = root / "shaders",
            .shader_cache = shader_cache(),
            .shader_worker = find_shader_worker(),
            .limits = limits,
            .graph_path = {graph_path.begin(), graph_path.end()}};
}

}  // namespace weft::viewer
