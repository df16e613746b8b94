// Loads the fuzzer's bytes as a .gltf or .glb file; the first four bytes decide which. The file is alone in
// its folder, and the loader reads only files of this folder, so no other file is read.
#include <cstdlib>

#include "tests/fuzz/fuzzed_file.h"
#include "weft/scene/load_gltf.h"

namespace {

// Returns limits that are much lower than those of the program, so that the accepted inputs load fast.
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
    // The loader has a bug if it fails without an error message.
    if (!scene && scene.errors().empty()) std::abort();
    return 0;
}
