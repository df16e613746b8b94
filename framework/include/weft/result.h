// Purpose: errors as data. Functions return the faults of the user's input as Diagnostics. Units: lines and
// columns count from 1, and 0 means unknown. Columns count bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace weft {

enum class Severity : uint8_t { error, warning };

struct Note {
    std::string file;
    uint32_t line = 0;
    uint32_t column = 0;
    std::string message;
};

// One fault or warning. It has copies of all texts that are printed, so that it does not depend on the file.
struct Diagnostic {
    Severity severity = Severity::error;
    std::string code;  // Code such as "W103". docs/diagnostics.md explains every code.
    // Tells the value that was found and the value that was wanted. Begins in lower case.
    std::string message;
    std::string file;
    uint32_t line = 0;
    uint32_t column = 0;
    uint32_t length = 1;  // Number of bytes to underline in source_line.
    // JSON pointer of the value, such as "/passes/outline/in/1"; empty if there is none.
    std::string pointer;
    std::string source_line;  // The text of line `line`, which is printed below the message.
    std::vector<std::string> help;
    std::vector<Note> notes;
    std::string tier;
};

using Diagnostics = std::vector<Diagnostic>;

[[nodiscard]] bool has_errors(const Diagnostics& diagnostics);

// Formats a diagnostic as "file:line:col: error[W103]: message", followed by the source line, the help and
// the notes. The text has no newline at the end.
[[nodiscard]] std::string to_text(const Diagnostic& diagnostic);
[[nodiscard]] std::string to_text(const Diagnostics& diagnostics);

// Returns up to three names of `known` that the user may have meant by `name`, most similar first. A known
// name is proposed if it differs from `name` by a few letters, or if it contains `name`.
[[nodiscard]] std::vector<std::string> did_you_mean(const std::string& name,
                                                    const std::vector<std::string>& known);
// Returns a text such as `did you mean "a" or "b"?`; empty if no name is similar.
[[nodiscard]] std::string did_you_mean_text(const std::string& name, const std::vector<std::string>& known);
// Returns a text such as `did you mean "a" or "b"?` for the names that did_you_mean() returned.
[[nodiscard]] std::string did_you_mean_text(const std::vector<std::string>& names);

// Contains a value, or the diagnostics with the reasons why there is no value. Functions that also have
// warnings return them through a parameter of type `Diagnostics&`.
template <class T>
class [[nodiscard]] Result {
 public:
    Result(T value) : value_(std::move(value)) {}
    Result(Diagnostic error) { errors_.push_back(std::move(error)); }
    Result(Diagnostics errors) : errors_(std::move(errors)) {}

    [[nodiscard]] bool ok() const { return value_.has_value(); }
    explicit operator bool() const { return ok(); }

    T& value() & { return value_.value(); }
    const T& value() const& { return value_.value(); }
    T&& value() && { return std::move(value_).value(); }
    T* operator->() { return &value_.value(); }
    const T* operator->() const { return &value_.value(); }
    T& operator*() & { return value_.value(); }
    const T& operator*() const& { return value_.value(); }
    T&& operator*() && { return std::move(value_).value(); }

    const Diagnostics& errors() const { return errors_; }
    Diagnostics&& take_errors() { return std::move(errors_); }

 private:
    std::optional<T> value_;
    Diagnostics errors_;
};

struct Unit {};
using Status = Result<Unit>;

}  // namespace weft
