#include "viewer/bench/reload_bench.h"

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

constexpr int kRuns = 50;
// The benchmark waits this long before the first load. If a file changed only shortly before it was read, the
// loader always reads it again, because a second change soon after the first may give the file the same time
// of change.
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

// Loads a graph repeatedly. Each time, the class tells the loader which result it has from the last load, as
// a session does.
class Reloading {
 public:
    Reloading(const DeviceProfile& profile, LoadSettings settings, const std::string& path)
        : loader_(profile, std::move(settings), {}, render::scene_imports({1280, 720, 1})) {
        request_.path = path;
        load_us();  // Not measured: only the first load reads the files.
    }

    double unchanged_us() {
        return fastest_us([](GraphRequest&) {});
    }
    double value_us() {
        double gain = 1;
        return fastest_us([&](GraphRequest& request) { request.params["gain"] = gain += 1; });
    }
    [[nodiscard]] const render::LoadWork& work() const { return loader_.work(); }

 private:
    template <class Change>
    double fastest_us(const Change& change) {
        double least_us = 0;
        for (int run = 0; run < kRuns; ++run) {
            change(request_);
            const double us = load_us();
            least_us = run == 0 ? us : std::min(least_us, us);
        }
        return least_us;
    }
    double load_us() {
        Diagnostics warnings;
        std::set<fs::path> files;
        const Clock::time_point start = Clock::now();
        const Result<render::LoadedVersion> loaded = loader_.load(request_, nullptr, known_, warnings, files);
        const double us = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
        if (!loaded) throw std::logic_error("a generated graph has an error: " + to_text(loaded.errors()));
        known_ = loaded->number;
        return us;
    }

    render::GraphLoader loader_;
    GraphRequest request_;
    uint64_t known_ = 0;
};

}  // namespace

ReloadTimes measure_reload(const ResolvedGraph& graph, LoadSettings settings) {
    const BenchFolder folder(graph);
    std::this_thread::sleep_for(kAge);
    const DeviceProfile profile = bench_profile();
    settings.limits.graph = bench_limits();
    Reloading reloading(profile, std::move(settings), folder.graph_path());
    ReloadTimes times;
    times.unchanged_us = reloading.unchanged_us();
    times.value_us = reloading.value_us();
    const render::LoadWork& work = reloading.work();
    if (work.read != 1 || work.resolved != 1)
        throw std::logic_error("a graph was loaded again without a change");
    return times;
}

}  // namespace weft::viewer
