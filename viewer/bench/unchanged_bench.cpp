#include "viewer/bench/unchanged_bench.h"

#include <stdlib.h>  // for mkdtemp()

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "file/write_file.h"
#include "render/graph_loader.h"
#include "viewer/bench/bench_file.h"
#include "weft/render/import_catalog.h"

namespace weft::viewer {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kRuns = 100;
// Files that are younger than this are always read again, because their times prove nothing.
constexpr auto kAge = std::chrono::milliseconds(100);

// A temporary folder with the file of a graph and its shaders.
class BenchFolder {
 public:
    explicit BenchFolder(const ResolvedGraph& graph) {
        std::string pattern = (fs::temp_directory_path() / "weft-bench-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr)
            throw std::runtime_error("cannot create a folder in " + fs::temp_directory_path().string());
        folder_ = pattern;
        write("bench.json", bench_file_text(graph));
        for (const auto& [name, text] : bench_shader_texts()) write(name, text);
    }
    ~BenchFolder() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    BenchFolder(const BenchFolder&) = delete;
    BenchFolder& operator=(const BenchFolder&) = delete;

    [[nodiscard]] std::string graph_path() const { return (folder_ / "bench.json").string(); }

 private:
    void write(const std::string& name, const std::string& text) const {
        const Status written = write_file((folder_ / name).string(), text, Durability::cached);
        if (!written) throw std::runtime_error(to_text(written.errors()));
    }

    fs::path folder_;
};

}  // namespace

double measure_unchanged_us(const ResolvedGraph& graph, LoadSettings settings) {
    const BenchFolder folder(graph);
    std::this_thread::sleep_for(kAge);
    const DeviceProfile profile = bench_profile();
    settings.limits.graph = bench_limits();
    render::GraphLoader loader(profile, std::move(settings), {}, render::scene_imports({1280, 720, 1}));
    const GraphRequest request{.path = folder.graph_path()};
    double least_us = 0;
    uint64_t known = 0;
    for (int run = 0; run <= kRuns; ++run) {
        Diagnostics warnings;
        std::set<fs::path> files;
        const Clock::time_point start = Clock::now();
        const Result<render::LoadedVersion> loaded = loader.load(request, nullptr, known, warnings, files);
        const double us = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
        if (!loaded) throw std::logic_error("a generated graph has an error: " + to_text(loaded.errors()));
        known = loaded->number;
        // The first run reads the files.
        if (run > 0) least_us = run == 1 ? us : std::min(least_us, us);
    }
    if (loader.work().read != 1) throw std::logic_error("an unchanged graph was read again");
    return least_us;
}

}  // namespace weft::viewer
