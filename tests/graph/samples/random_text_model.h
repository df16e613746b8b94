// Purpose: a graph while its text is made up: what is written by whom under which condition, and the text of
// it in both ways of random_text.h.
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
    uint32_t words = 256;  // of buffers
    std::string more;      // ", "key": value"
    std::string verbatim;  // all of its text, where it is not empty
};

// A part of a resource that is written as a whole, and the passes that write it, in order.
struct TextValue {
    size_t resource = kNone;
    std::string part;  // ".mip(1)"
    uint32_t side_px = 64;
    bool single = true;   // one mip of one layer
    bool fresh = true;    // the first writer sees nothing of older content
    bool closed = false;  // nobody writes it any more
    bool read = false;
    size_t condition = kNone;     // without it nobody writes it
    std::vector<size_t> writers;  // indices of passes
};

// What a port is bound to: the version of a value after its first `version` writers, or something in words.
struct TextRef {
    size_t value = kNone;
    size_t version = 0;
    bool pin = true;  // though it need not
    std::string words;
};

struct TextPort {
    std::string name;
    TextRef ref;
    TextRef otherwise;  // `else`, where one of the two is set
    bool optional = false;
    std::string more;  // ", "key": value"
};

struct TextPass {
    std::string name;
    std::string type;
    std::vector<TextPort> in, out, depth;
    std::vector<size_t> after;
    size_t condition = kNone;
    bool stays = false;  // in the plain text too, with "if": false: the only writer of a history
    bool empty = false;  // a repeat without rounds
    std::string more;    // ", "key": value"
    std::string more_text, more_plain;  // the same, for one of the two texts
};

struct TextModel {
    bool idle_output = false;  // imported, whoever writes it
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
