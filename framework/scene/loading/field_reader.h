// Purpose: reads the values of a JSON object with checks: types, ranges, unknown and missing keys. The
// readers of files with light probes and of camera paths use it. Each fault names the place in the file and a
// remedy.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "weft/syntax/json_doc.h"

namespace weft::scene {

class FieldReader {
 public:
    struct Range {
        double least;
        double most;
    };

    // `code` is the code of all faults that the functions of this class find. `page` is the page of the
    // documentation that describes the file.
    FieldReader(const JsonDoc& document, const char* code, const char* page)
        : document_(document), code_(code), page_(page) {}

    [[nodiscard]] Diagnostics& faults() { return faults_; }
    [[nodiscard]] const JsonDoc& document() const { return document_; }

    void fault(const SourceLoc& loc, const char* code, std::string message, std::string help);
    void fault(const SourceLoc& loc, std::string message, std::string help) {
        fault(loc, code_, std::move(message), std::move(help));
    }
    // Returns true if the node has the wanted type; otherwise adds a fault.
    bool expect(const JsonNode& node, JsonKind kind);
    // Adds a fault for each key that is not in `known`.
    void check_keys(const JsonNode& object, const std::vector<std::string>& known);
    // Returns the value of the key. If the key is missing, adds a fault and returns null.
    const JsonNode* required(const JsonNode& object, const char* key);
    // Adds a fault if the required key "version" is not 1.
    void check_version(const JsonNode& root);
    // Stores the number in `out`. Returns false after a fault.
    bool number(const JsonNode& node, const Range& range, bool whole, double& out);
    // Reads `count` numbers. Returns an empty list after a fault.
    std::vector<double> numbers(const JsonNode& node, size_t count, const Range& range, bool whole);
    // Reads three numbers. Returns `usual` if `node` is null or after a fault.
    glm::vec3 vector(const JsonNode* node, const Range& range, const glm::vec3& usual);
    std::optional<glm::ivec3> whole_vector(const JsonNode& node, const Range& range);

 private:
    const JsonDoc& document_;
    const char* code_;
    const char* page_;
    Diagnostics faults_;
};

}  // namespace weft::scene
