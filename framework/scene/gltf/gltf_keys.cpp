#include "scene/gltf/gltf_keys.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/gltf/gltf_container.h"

namespace weft::scene::gltf {
namespace {

constexpr size_t kMostNamed = 16;

struct Key {
    std::string_view raw;  // Text of the key between its quotes, with the escapes as they are in the file.
    size_t at = 0;
};

std::string unescaped(std::string_view raw) {
    const std::string quoted = "\"" + std::string(raw) + "\"";
    const nlohmann::json value = nlohmann::json::parse(quoted, nullptr, /*allow_exceptions=*/false);
    return value.is_string() ? value.get<std::string>() : std::string(raw);
}

bool is_escaped(const Key& key) {
    return key.raw.find('\\') != std::string_view::npos;
}

class Scan {
 public:
    Scan(std::string_view text, Report& report) : json_(text), report_(report) {}

    void run() {
        for (at_ = 0; at_ < json_.size() && named_ < kMostNamed; ++at_) {
            const char c = json_[at_];
            if (c == '"') pass_string();
            if (c == '{') first_keys_.push_back(keys_.size());
            if (c == '}' && !first_keys_.empty()) close_object();
        }
    }

 private:
    // Skips one string, from its first quote to its last. If a colon follows, the string is a key of the
    // innermost open object and is added to `keys_`.
    void pass_string() {
        const size_t begin = at_;
        for (++at_; at_ < json_.size() && json_[at_] != '"'; ++at_)
            if (json_[at_] == '\\') ++at_;
        if (at_ >= json_.size() || first_keys_.empty()) return;
        const size_t next = json_.find_first_not_of(" \t\r\n", at_ + 1);
        if (next == std::string_view::npos || json_[next] != ':') return;
        keys_.push_back({json_.substr(begin + 1, at_ - begin - 1), begin});
    }

    void close_object() {
        const size_t first = first_keys_.back();
        first_keys_.pop_back();
        const auto begin = keys_.begin() + static_cast<std::ptrdiff_t>(first);
        // The keys of the object after their escapes are decoded. The vector is filled only if a key has an
        // escape. Then the views in `keys_` refer to this vector instead of the file's text.
        std::vector<std::string> texts;
        if (std::any_of(begin, keys_.end(), is_escaped)) {
            for (auto key = begin; key != keys_.end(); ++key) texts.push_back(unescaped(key->raw));
            for (size_t i = 0; i < texts.size(); ++i) keys_[first + i].raw = texts[i];
        }
        report_twins(first);
        keys_.resize(first);
    }

    void report_twins(size_t first) {
        const auto begin = keys_.begin() + static_cast<std::ptrdiff_t>(first);
        std::sort(begin, keys_.end(),
                  [](const Key& a, const Key& b) { return a.raw != b.raw ? a.raw < b.raw : a.at < b.at; });
        for (size_t i = first + 1; i < keys_.size() && named_ < kMostNamed; ++i) {
            if (keys_[i].raw != keys_[i - 1].raw) continue;
            const TextPosition place = position_of(json_, keys_[i].at);
            report_.error_at(
                "S114", place.line, place.column,
                "the key \"" + shortened(std::string(keys_[i].raw)) + "\" occurs twice in one object",
                "remove one of the two keys, because some programs read the first and others the second");
            ++named_;
        }
    }

    std::string_view json_;
    Report& report_;
    size_t at_ = 0;
    size_t named_ = 0;
    // The keys of all objects that are open at the current position, from the outermost to the innermost
    // object.
    std::vector<Key> keys_;
    std::vector<size_t> first_keys_;  // For each open object, the index of its first key in `keys_`.
};

}  // namespace

void check_keys(std::string_view json, Report& report) {
    Scan(json, report).run();
}

}  // namespace weft::scene::gltf
