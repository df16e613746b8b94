// Loads bytes as a .gltf or a .glb (the first four bytes decide); no other file can be read.
#include <cstdlib>

#include "tests/fuzz/fuzzed_file.h"
#include "weft/scene/load_gltf.h"

namespace {

// Much lower than the program's limits, so that accepted inputs are fast.
weft::scene::SceneLimits small_limits() {
    weft::scene::SceneLimits limits;
    limits.resource_bytes = 16 << 20;
    limits.json_values = 20'000;
    limits.array_items = 4'096;
    limits.materials = 256;
    limits.instances = 4'096;
    limits.vertices = 200'000;
    limits.triangles = 200'000;
    limits.image_side_px = 2'048;
    limits.memory_bytes = 96 << 20;
    return limits;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const weft::fuzz::FuzzedFile file("scene.gltf");
    file.write({data, size});
    weft::Diagnostics warnings;
    const weft::Result<weft::scene::Scene> scene =
        weft::scene::load_gltf(file.path(), warnings, small_limits());
    if (!scene && scene.errors().empty()) std::abort();  // an error without a reason is a bug
    return 0;
}
