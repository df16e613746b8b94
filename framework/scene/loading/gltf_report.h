// Purpose: collects all faults of one glTF file, so that they can be reported together. After a maximum
// number of entries the report only counts further faults. So a hostile file cannot make the report grow
// without limit.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "weft/result.h"

namespace weft::scene::gltf {

// Returns a name from the file, shortened for messages: at most 64 bytes, never cut inside a UTF-8 character.
[[nodiscard]] std::string shortened(const std::string& name);
// Returns a text such as `mesh "Body"`, or `mesh 3` for a mesh without a name.
[[nodiscard]] std::string label(const char* kind, size_t index, const std::string& name);

class Report {
 public:
    explicit Report(std::string file) : file_(std::move(file)) {}

    // Adds an error. `pointer` is a JSON pointer to the faulty value, empty if the error concerns the whole
    // file.
    void error(const char* code, std::string pointer, std::string message, std::string help);
    void warn(const char* code, std::string pointer, std::string message, std::string help);
    void error_at(const char* code, uint32_t line, uint32_t column, std::string message, std::string help);

    [[nodiscard]] bool failed() const { return !errors_.empty(); }
    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] Diagnostics take_errors();
    [[nodiscard]] Diagnostics take_warnings();

 private:
    std::string file_;
    Diagnostics errors_;
    Diagnostics warnings_;
    std::map<std::string, uint64_t> warnings_by_code_;
    uint64_t error_count_ = 0;
};

}  // namespace weft::scene::gltf
