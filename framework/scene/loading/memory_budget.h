// Purpose: the one budget that loading a scene draws from (scene.memoryBytes). What is about to be allocated
// is taken from it first: the file's bytes, the scene's streams and mips, what loading needs beside them, and
// the copy on the GPU. Sums are checked for overflow. Errors: S107 (S106 for images), with place and remedy,
// when more is asked for than left.
#pragma once

#include <cstdint>
#include <string>

#include "scene/loading/gltf_report.h"

namespace weft::scene {

class MemoryBudget {
 public:
    explicit MemoryBudget(uint64_t limit_bytes) : limit_bytes_(limit_bytes) {}

    // False: that is not left, and nothing is taken.
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

// Sums and products that stay at the largest number where they would not fit.
[[nodiscard]] constexpr uint64_t saturating_add(uint64_t a, uint64_t b) {
    return a > UINT64_MAX - b ? UINT64_MAX : a + b;
}
[[nodiscard]] constexpr uint64_t saturating_mul(uint64_t a, uint64_t b) {
    return b != 0 && a > UINT64_MAX / b ? UINT64_MAX : a * b;
}

namespace gltf {

// What is asked for, and where: `what` begins the message ("the mesh"), `remedy` the help.
struct MemoryRequest {
    uint64_t bytes = 0;
    const char* code = "S107";
    std::string pointer;
    std::string what;
    std::string remedy = "simplify the scene or split it";
};
// False after an error was reported.
[[nodiscard]] bool take_memory(MemoryBudget& budget, const MemoryRequest& request, Report& report);

}  // namespace gltf
}  // namespace weft::scene
