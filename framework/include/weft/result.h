// Purpose: errors as data. Anything that can be wrong because of what a user wrote comes back as Diagnostics.
// Units: lines and columns count from 1; a 0 means "unknown". Columns count bytes.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace weft {

enum class Severity : uint8_t { error, warning };

struct Note {
    std::string file;
    uint32_t line = 0;
    uint32_t column = 0;
    std::string message;
};

// One fault, self-contained: it can be printed after the file it came from is gone.
struct Diagnostic {
    Severity severity = Severity::error;
    std::string code;     // "W103"; docs/diagnostics.md has a page for each
    std::string message;  // lower case: what was found and what was wanted
    std::string file;
    uint32_t line = 0;
    uint32_t column = 0;
    uint32_t length = 1;      // bytes to underline
    std::string pointer;      // JSON pointer of the value, when there is one
    std::string source_line;  // the text of `line`, for the excerpt
    std::vector<std::string> help;
    std::vector<Note> notes;
    std::string tier;
};

using Diagnostics = std::vector<Diagnostic>;

[[nodiscard]] bool has_errors(const Diagnostics& diagnostics);

// "file:line:col: error[W103]: message" with an excerpt, help and notes; no trailing newline.
[[nodiscard]] std::string to_text(const Diagnostic& diagnostic);
[[nodiscard]] std::string to_text(const Diagnostics& diagnostics);

// Closest names first, at most three, only those near enough to be a slip of the finger.
[[nodiscard]] std::vector<std::string> did_you_mean(const std::string& name,
                                                    const std::vector<std::string>& known);
// "did you mean "a" or "b"?", or empty when nothing is near.
[[nodiscard]] std::string did_you_mean_text(const std::string& name, const std::vector<std::string>& known);

// A value, or every diagnostic that stood in its way. Warnings travel beside a value through `Diagnostics&`.
template <class T>
class [[nodiscard]] Result {
 public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Diagnostic error) : state_(std::in_place_index<1>, Diagnostics{std::move(error)}) {}
    Result(Diagnostics errors) : state_(std::in_place_index<1>, std::move(errors)) {}

    [[nodiscard]] bool ok() const { return state_.index() == 0; }
    explicit operator bool() const { return ok(); }

    T& value() & { return std::get<0>(state_); }
    const T& value() const& { return std::get<0>(state_); }
    T&& value() && { return std::get<0>(std::move(state_)); }
    T* operator->() { return &std::get<0>(state_); }
    const T* operator->() const { return &std::get<0>(state_); }
    T& operator*() & { return std::get<0>(state_); }
    const T& operator*() const& { return std::get<0>(state_); }
    T&& operator*() && { return std::get<0>(std::move(state_)); }

    const Diagnostics& errors() const { return std::get<1>(state_); }
    Diagnostics&& take_errors() { return std::get<1>(std::move(state_)); }

 private:
    std::variant<T, Diagnostics> state_;
};

struct Unit {};
using Status = Result<Unit>;

}  // namespace weft
