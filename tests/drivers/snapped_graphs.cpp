#include "drivers/snapped_graphs.h"

#include <fstream>
#include <sstream>
#include <string>

namespace weft::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOnGrid = R"(
    if (gl_Position.w > 0.0) {
        const vec2 snapped_size = 1.0 / view.inverse_viewport;
        const vec2 snapped_px = (gl_Position.xy / gl_Position.w * 0.5 + 0.5) * snapped_size;
        gl_Position.xy = (round(snapped_px * 16.0) / 16.0 / snapped_size * 2.0 - 1.0) * gl_Position.w;
    }
)";

// True when the shader projects its vertices with the view.
bool snap(const fs::path& shader) {
    std::ostringstream read;
    read << std::ifstream(shader).rdbuf();
    std::string text = read.str();
    const size_t projection = text.find("gl_Position = view.view_projection *");
    if (projection == std::string::npos) return false;
    text.insert(text.find(';', projection) + 1, kOnGrid);
    std::ofstream(shader) << text;
    return true;
}

}  // namespace

int write_snapped_graphs(const fs::path& folder) {
    // A shader's name is looked up beside the graph first.
    fs::copy(WEFT_SOURCE_DIR "/graphs", folder, fs::copy_options::recursive);
    fs::copy(WEFT_SOURCE_DIR "/shaders", folder, fs::copy_options::recursive);
    int changed = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".vert" && snap(entry.path())) ++changed;
    return changed;
}

}  // namespace weft::test
