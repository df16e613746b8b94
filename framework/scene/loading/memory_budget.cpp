#include "scene/loading/memory_budget.h"

#include "weft/limits.h"

namespace weft::scene::gltf {
namespace {

std::string mebibytes(uint64_t bytes) {
    return std::to_string(bytes / (1 << 20) + (bytes % (1 << 20) != 0 ? 1 : 0)) + " MiB";
}

}  // namespace

bool take_memory(MemoryBudget& budget, const MemoryRequest& request, Report& report) {
    if (budget.take(request.bytes)) return true;
    report.error(request.code, request.pointer,
                 "with " + request.what + ", the scene and its copy on the GPU need " +
                     mebibytes(saturating_add(budget.taken_bytes(), request.bytes)) + ", the limit is " +
                     mebibytes(budget.limit_bytes()),
                 request.remedy + ", " + raise_limit_text("scene.memoryBytes"));
    return false;
}

}  // namespace weft::scene::gltf
