#include "tests/graph/samples/random_text_model.h"

#include <algorithm>

namespace weft::test {
namespace {

class Writer {
 public:
    Writer(const TextModel& model, bool plain) : model_(model), plain_(plain) {}

    std::string run() const {
        std::string text = "{\"version\": 1, \"name\": \"random\",\n" + imports() + parameters() +
                           view_lists() + "\"sizes\": {\"half\": \"ceil(output / 2)\"},\n\"resources\": {\n";
        for (const TextResource& r : model_.resources)
            text += resource(r) + (&r == &model_.resources.back() ? "\n" : ",\n");
        text += "},\n\"passes\": {\n";
        std::string passes;
        for (const size_t i : model_.shuffled) {
            const TextPass& p = model_.passes[i];
            if (plain_ && (p.empty || (!model_.holds(p.condition) && !p.stays))) continue;
            passes += (passes.empty() ? "" : ",\n") + pass(p);
        }
        return text + passes + "}}\n";
    }

 private:
    // Returns the imports of the graph. The output is imported only if a pass writes it, because an unwritten
    // output is an error. With `idle_output`, the text has this error on purpose.
    std::string imports() const {
        const auto presents = [](const TextPass& p) {
            return std::any_of(p.out.begin(), p.out.end(),
                               [](const TextPort& port) { return port.ref.words == "backbuffer"; });
        };
        const bool output =
            std::any_of(model_.passes.begin(), model_.passes.end(), presents) || model_.idle_output;
        const bool table = std::ranges::any_of(model_.passes, [](const TextPass& p) {
            return std::ranges::any_of(p.in,
                                       [](const TextPort& port) { return port.ref.words == "pictures"; });
        });
        return std::string(
                   "\"imports\": {\"opaque\": \"drawlist\", \"noise\": \"image\", "
                   "\"instances\": \"buffer\", \"lamps\": \"views\"") +
               (table ? ", \"pictures\": \"textures\"" : "") +
               (output ? ", \"backbuffer\": \"output\"},\n" : "},\n");
    }

    std::string parameters() const {
        std::string text;
        for (const auto& [name, value] : model_.defaults)
            text += (text.empty() ? "\"" : ", \"") + name + "\": " + std::to_string(static_cast<int>(value));
        return "\"params\": {" + text + "},\n";
    }

    std::string view_lists() const {
        std::string text;
        for (const std::string& list : model_.view_lists) text += (text.empty() ? "  " : ",\n  ") + list;
        return text.empty() ? "" : "\"views\": {\n" + text + "},\n";
    }

    static std::string resource(const TextResource& r) {
        std::string text = "  \"" + r.name + "\": {";
        if (!r.verbatim.empty()) return text + r.verbatim + "}";
        if (r.kind == ValueKind::words)
            return text + "\"buffer\": \"u32\", \"count\": " + std::to_string(r.words) + r.more + "}";
        const std::string side = std::to_string(r.side_px);
        text += "\"format\": \"" + r.format + "\", \"size\": ";
        text += r.side_px == 64   ? "\"output\""
                : r.side_px == 32 ? "\"half\""
                                  : "[" + side + ", " + side + "]";
        if (r.mips > 1) text += ", \"mips\": " + std::to_string(r.mips);
        if (r.layers > 1) text += ", \"layers\": " + std::to_string(r.layers);
        return text + r.more + "}";
    }

    // Returns the text of a reference, such as "image@pass.mip(1)". The last version of a closed value gets
    // no pin, because the value may have alternative writers, of which only one runs.
    std::string reference(const TextRef& ref) const {
        if (ref.value == kNone) return ref.words;
        const TextValue& value = model_.values[ref.value];
        const std::string& name = model_.resources[value.resource].name;
        const bool last = ref.version == value.writers.size();
        if (ref.version == 0 || (last && value.closed) || (last && !ref.pin && !plain_))
            return name + value.part;
        size_t writer = ref.version - 1;
        while (plain_ && writer > 0 && !model_.holds(model_.passes[value.writers[writer]].condition))
            --writer;
        return name + "@" + model_.passes[value.writers[writer]].name + value.part;
    }

    std::string port(const TextPort& p) const {
        const bool other = p.otherwise.value != kNone || !p.otherwise.words.empty();
        const bool replaced = plain_ && other && !model_.is_there(p.ref);
        const std::string ref = reference(replaced ? p.otherwise : p.ref);
        std::string more = p.more;
        if (other && !plain_) more += ", \"else\": \"" + reference(p.otherwise) + "\"";
        if (p.optional && !plain_) more += ", \"optional\": true";
        return more.empty() ? "\"" + ref + "\"" : "{\"ref\": \"" + ref + "\"" + more + "}";
    }

    std::string ports(const char* key, const std::vector<TextPort>& list) const {
        std::string text;
        for (const TextPort& p : list) {
            if (plain_ && p.optional && !model_.is_there(p.ref)) continue;
            text += (text.empty() ? "\"" : ", \"") + p.name + "\": " + port(p);
        }
        return text.empty() ? "" : std::string(", \"") + key + "\": {" + text + "}";
    }

    std::string condition(const TextPass& p) const {
        if (p.condition == kNone) return "";
        const TextCondition& c = model_.conditions[p.condition];
        if (plain_) return c.holds ? "" : ", \"if\": false";
        return ", \"if\": \"" + c.text + "\"";
    }

    std::string after(const TextPass& p) const {
        std::string text;
        for (const size_t i : p.after) {
            const TextPass& other = model_.passes[i];
            if (plain_ && (other.empty || !model_.holds(other.condition))) continue;
            text += (text.empty() ? "\"" : ", \"") + other.name + "\"";
        }
        return text.empty() ? "" : ", \"after\": [" + text + "]";
    }

    std::string pass(const TextPass& p) const {
        std::string text = "  \"" + p.name + "\": {\"type\": \"" + p.type + "\"" + p.more +
                           (plain_ ? p.more_plain : p.more_text);
        text += ports("in", p.in) + ports("out", p.out);
        if (!p.depth.empty()) text += ", \"depth\": " + port(p.depth.front());
        return text + condition(p) + after(p) + "}";
    }

    const TextModel& model_;
    bool plain_;
};

}  // namespace

std::string text_of(const TextModel& model, bool plain) {
    return Writer(model, plain).run();
}

}  // namespace weft::test
