// Purpose: describes a random graph as a model. The model records which passes write each value, and the
// condition of each pass. text_of() converts the model to RandomText::text or RandomText::plain.
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
    // Size of a buffer, in 32-bit words.
    uint32_t words = 256;
    // Further members of the resource as JSON text: `, "key": value`.
    std::string more;
    // Complete JSON text of the resource; empty if the text is made from the other fields.
    std::string verbatim;
};

// The content of a part of a resource, such as one mip or a whole buffer.
struct TextValue {
    size_t resource = kNone;
    // Suffix that selects the part in a reference, such as ".mip(1)".
    std::string part;
    uint32_t side_px = 64;
    // True if the part is one mip of one layer.
    bool single = true;
    // True if the first writer ignores the content from before this write.
    bool fresh = true;
    // True if no further pass may write the part.
    bool closed = false;
    bool read = false;
    // Index of a condition; if it is false, no pass writes the part. kNone if the part is always written.
    size_t condition = kNone;
    // Indices of the passes that write the part, in the order in which they run. May be empty if `closed` is
    // true; then the generator has not recorded the writers.
    std::vector<size_t> writers;
};

// Reference of a port. If `value` is kNone, the reference is the text `words`. Otherwise it is the version of
// the value after its first `version` writers.
struct TextRef {
    size_t value = kNone;
    size_t version = 0;
    // A pin, "name@pass", selects the version that this pass wrote. True: write the pin even if a reference
    // without a pin would select the same version.
    bool pin = true;
    std::string words;
};

struct TextPort {
    std::string name;
    TextRef ref;
    // The `else` input, which replaces `ref` if the value of `ref` is missing. The port has no `else` input
    // if `otherwise.value` is kNone and `otherwise.words` is empty.
    TextRef otherwise;
    bool optional = false;
    // Further members of the port as JSON text: `, "key": value`.
    std::string more;
};

struct TextPass {
    std::string name;
    std::string type;
    std::vector<TextPort> in, out, depth;
    std::vector<size_t> after;
    size_t condition = kNone;
    // True if RandomText::plain keeps the pass even if its condition is false. The pass then has "if": false.
    // It must stay, because it is the only writer of a resource with history.
    bool stays = false;
    // True if the pass is a repeat without iterations.
    bool empty = false;
    // Further members of the pass as JSON text: `, "key": value`.
    std::string more;
    // Further members of the pass in only one of the texts: `more_text` in RandomText::text, `more_plain` in
    // RandomText::plain.
    std::string more_text, more_plain;
};

struct TextModel {
    // True if the output shall be imported although no pass writes it.
    bool idle_output = false;
    std::vector<TextCondition> conditions;
    std::map<std::string, double> defaults;
    std::vector<std::string> view_lists;  // The members of the section "views", as JSON text.
    std::vector<TextResource> resources;
    std::vector<TextValue> values;
    std::vector<TextPass> passes;
    // Indices of passes in the random order in which the text lists them.
    std::vector<size_t> shuffled;

    [[nodiscard]] bool holds(size_t condition) const {
        return condition == kNone || conditions[condition].holds;
    }
    [[nodiscard]] bool is_there(const TextRef& ref) const {
        return ref.value == kNone || holds(values[ref.value].condition);
    }
};

[[nodiscard]] std::string text_of(const TextModel& model, bool plain);

}  // namespace weft::test
