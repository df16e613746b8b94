// Purpose: the model of a random graph: which pass writes which value under which condition. Converts it to
// both texts of random_text.h.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace weft::test {

inline constexpr size_t kNone = SIZE_MAX;

struct TextCondition {
    std::string text;
    bool holds = true;
};

enum class ValueKind : uint8_t { color, depth, words };

struct TextResource {
    std::string name;
    ValueKind kind = ValueKind::color;
    std::string format;
    uint32_t side_px = 64;
    uint32_t mips = 1;
    uint32_t layers = 1;
    uint32_t words = 256;  // size of a buffer
    std::string more;      // further members as text: ", "key": value"
    std::string verbatim;  // if not empty, the complete text of the resource
};

// A part of a resource that is always written as a whole, and its writers, in order.
struct TextValue {
    size_t resource = kNone;
    std::string part;  // such as ".mip(1)"
    uint32_t side_px = 64;
    bool single = true;   // true if it is one mip of one layer
    bool fresh = true;    // true if the first writer ignores older content
    bool closed = false;  // true if no further pass may write it
    bool read = false;
    size_t condition = kNone;     // if this condition is false, no pass writes it
    std::vector<size_t> writers;  // indices of passes
};

// The binding of a port: the version of a value after its first `version` writers, or a given text.
struct TextRef {
    size_t value = kNone;
    size_t version = 0;
    bool pin = true;  // write a pin even if it is unnecessary
    std::string words;
};

struct TextPort {
    std::string name;
    TextRef ref;
    TextRef otherwise;  // the `else` input, if one of its members is set
    bool optional = false;
    std::string more;  // further members as text: ", "key": value"
};

struct TextPass {
    std::string name;
    std::string type;
    std::vector<TextPort> in, out, depth;
    std::vector<size_t> after;
    size_t condition = kNone;
    bool stays = false;  // stays in the plain text too, with "if": false: it is the only writer of a history
    bool empty = false;  // a repeat without rounds
    std::string more;    // further members as text: ", "key": value"
    std::string more_text, more_plain;  // the same for only one of the two texts
};

struct TextModel {
    bool idle_output = false;  // the output is imported, but any pass may write it
    std::vector<TextCondition> conditions;
    std::map<std::string, double> defaults;
    std::vector<TextResource> resources;
    std::vector<TextValue> values;
    std::vector<TextPass> passes;
    std::vector<size_t> shuffled;  // passes in the order of the text

    [[nodiscard]] bool holds(size_t condition) const {
        return condition == kNone || conditions[condition].holds;
    }
    [[nodiscard]] bool is_there(const TextRef& ref) const {
        return ref.value == kNone || holds(values[ref.value].condition);
    }
};

[[nodiscard]] std::string text_of(const TextModel& model, bool plain);

}  // namespace weft::test
