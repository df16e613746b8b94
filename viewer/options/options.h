// Purpose: the options of each command as a struct. add_options.h fills them, the commands read them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "weft/declaration.h"
#include "weft/graph_request.h"
#include "weft/limits.h"

namespace weft::viewer {

struct RenderOptions {
    std::string scene = "builtin:atrium";
    std::string output = "frame.png";
    GraphRequest request;  // an empty path: the shipped graphs/deferred.json
    uint32_t frames = 0;   // 0: the number in the graph
    double fixed_dt_s = 1.0 / 60.0;
    std::string camera;
    std::string env = "sky";
    std::optional<float> hour;
    std::optional<uint32_t> lights;  // number of seeded lights that replace the scene's lights
    uint32_t seed = 1;
    std::optional<float> exposure_ev;
    std::string resource;  // reference to a resource that is written instead of the output
    bool validate = false;
    bool quiet = false;  // do not repeat warnings that were already printed
    std::string stats;
    std::string device;
    double timeout_s = 60;
    uint32_t queues = 1;
    std::string drop_barriers_before;  // for tests only
    bool sandbox = false;
    std::string named_output;  // name of the output in messages; empty: the output's path
    Limits limits;
};

// Files that the command reads. A word such as "sky" is included too, because a file may have that name.
[[nodiscard]] inline std::vector<std::string> inputs_of(const RenderOptions& options) {
    return {options.scene, options.request.path, options.env};
}

struct ViewOptions {
    RenderOptions render;  // frames = 0: run until told to end; output empty: write no picture
    bool headless = false;
    bool fixed_dt = false;  // true: each frame advances time by render.fixed_dt_s, as fast as possible;
                            // false: real time
};

// Options for compilation without a device.
struct OfflineOptions {
    GraphRequest request;  // without a path: each command takes that from its FILE
    std::string profile;   // a file, or the name of a shipped profile; empty: lavapipe
    uint32_t queues = 1;
    Limits limits;
};

struct CheckOptions {
    std::vector<std::string> files;
    OfflineOptions offline;
    bool json = false;
    bool sarif = false;  // `json` and `sarif` exclude each other
    bool run = false;    // also run the graphs' own tests
    std::string device;  // the device for these tests
    bool sandbox = false;
};

struct PlanOptions {
    std::string file;
    OfflineOptions offline;
    std::string format = "text";
    std::string output;
    bool sandbox = false;
};

struct SchemaOptions {
    std::string file;    // empty: the schema of all graphs
    std::string output;  // empty: stdout
    Limits limits;
};

struct ExplainOptions {
    std::string file;
    OfflineOptions offline;
    std::string question;            // one of culled, barrier, alias, wait, resource
    std::vector<std::string> names;  // names of passes or resources
};

struct DiffOptions {
    std::string from, to;
    OfflineOptions offline;
    bool json = false;
};

struct CompareOptions {
    std::string reference, test;
    std::string metric = "flip";  // one of flip, psnr, max
    std::optional<double> max;    // limit for flip (the mean) and max
    std::optional<double> min;    // limit for psnr, in dB
    std::string output;           // file of the heat map; empty: none
    bool json = false;
    Limits limits;
};

struct BenchOptions {
    uint32_t passes = 1000;
    std::string shape = "random";
    uint32_t seed = 1;
    uint32_t queues = 1;
    bool json = false;
};

struct FrameBenchOptions {
    std::string scene = "builtin:lights";
    std::vector<std::string> graphs{"deferred", "tiled_deferred", "light_volumes",
                                    "light_indexed"};  // names of shipped graphs, or files
    std::vector<uint32_t> lights{1, 10, 50, 100, 256, 1024, 3072};
    Extent3D size{640, 360, 1};
    std::string camera;
    uint32_t seed = 1;
    uint32_t rounds = 7;
    std::string device;
    double timeout_s = 60;
    std::string plot;  // an .svg file; empty: none
    bool json = false;
    Limits limits;
};

struct DoctorOptions {
    bool json = false;
    std::string device;
};

}  // namespace weft::viewer
