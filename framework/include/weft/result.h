// Purpose: errors as data. Faults in the user's input are returned as Diagnostics. Units: lines and columns
// count from 1; 0 means unknown. Columns count bytes.
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

// One fault, self-contained: it can be printed after its file has been freed.
struct Diagnostic {
    Severity severity = Severity::error;
    std::string code;     // such as "W103"; explained in docs/diagnostics.md
    std::string message;  // starts in lower case: the value found and the value wanted
    std::string file;
    uint32_t line = 0;
    uint32_t column = 0;
    uint32_t length = 1;      // number of bytes to underline
    std::string pointer;      // JSON pointer of the value, if there is one
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

// At most three similar names, most similar first; only names that could be meant by a typing mistake.
[[nodiscard]] std::vector<std::string> did_you_mean(const std::string& name,
                                                    const std::vector<std::string>& known);
// A text such as `did you mean "a" or "b"?`; empty if no name is similar.
[[nodiscard]] std::string did_you_mean_text(const std::string& name, const std::vector<std::string>& known);

// A value, or the diagnostics that prevented it. Warnings are returned separately through `Diagnostics&`.
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
