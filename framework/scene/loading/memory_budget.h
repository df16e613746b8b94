// Purpose: the memory budget for loading a scene (scene.memoryBytes). The loader takes bytes from the budget
// before it allocates memory: for the file, the scene's streams and mips, temporary data, and the copy on the
// GPU. Sums are checked for overflow. Errors: S107 (S106 for images) when more bytes are requested than
// remain. The message names the place in the file and a remedy.
#pragma once

#include <cstdint>
#include <string>

#include "scene/loading/gltf_report.h"

namespace weft::scene {

class MemoryBudget {
 public:
    explicit MemoryBudget(uint64_t limit_bytes) : limit_bytes_(limit_bytes) {}

    // Takes `bytes` from the budget. Returns false and takes nothing when fewer than `bytes` remain.
    [[nodiscard]] bool take(uint64_t bytes) {
        if (bytes > left_bytes()) return false;
        taken_bytes_ += bytes;
        return true;
    }
    void give_back(uint64_t bytes) { taken_bytes_ -= bytes < taken_bytes_ ? bytes : taken_bytes_; }

    [[nodiscard]] uint64_t left_bytes() const { return limit_bytes_ - taken_bytes_; }
    [[nodiscard]] uint64_t taken_bytes() const { return taken_bytes_; }
    [[nodiscard]] uint64_t limit_bytes() const { return limit_bytes_; }

 private:
    uint64_t limit_bytes_;
    uint64_t taken_bytes_ = 0;
};

// Returns the sum. If the sum would overflow, the result is the largest 64-bit number. saturating_mul() does
// the same for products.
[[nodiscard]] constexpr uint64_t saturating_add(uint64_t a, uint64_t b) {
    return a > UINT64_MAX - b ? UINT64_MAX : a + b;
}
[[nodiscard]] constexpr uint64_t saturating_mul(uint64_t a, uint64_t b) {
    return b != 0 && a > UINT64_MAX / b ? UINT64_MAX : a * b;
}

namespace gltf {

// A request for memory with the parts of its error message: `pointer` is a JSON pointer, `what` names the
// object that needs the memory ("the mesh"), `remedy` is the help text.
struct MemoryRequest {
    uint64_t bytes = 0;
    const char* code = "S107";
    std::string pointer;
    std::string what;
    std::string remedy = "simplify the scene or split it";
};
// Takes the requested bytes from the budget. If too few bytes remain, reports an error and returns false.
[[nodiscard]] bool take_memory(MemoryBudget& budget, const MemoryRequest& request, Report& report);

}  // namespace gltf
}  // namespace weft::scene
