#include "scene/loading/gltf_report.h"

#include <algorithm>
#include <utility>

namespace weft::scene::gltf {
namespace {

constexpr uint64_t kMaxErrors = 50;
constexpr uint64_t kMaxWarningsPerCode = 8;

Diagnostic make(Severity severity, std::string code, const std::string& file, std::string message) {
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.code = std::move(code);
    diagnostic.file = file;
    diagnostic.message = std::move(message);
    return diagnostic;
}

}  // namespace

std::string shortened(const std::string& name) {
    size_t end = std::min<size_t>(name.size(), 64);
    while (end > 0 && end < name.size() && (static_cast<unsigned char>(name[end]) & 0xC0u) == 0x80u) --end;
    return name.substr(0, end);
}

std::string label(const char* kind, size_t index, const std::string& name) {
    return std::string(kind) + " " + (name.empty() ? std::to_string(index) : "\"" + shortened(name) + "\"");
}

void Report::error(const char* code, std::string pointer, std::string message, std::string help) {
    if (++error_count_ > kMaxErrors) return;
    Diagnostic diagnostic = make(Severity::error, code, file_, std::move(message));
    diagnostic.pointer = std::move(pointer);
    diagnostic.help.push_back(std::move(help));
    errors_.push_back(std::move(diagnostic));
}

void Report::error_at(const char* code, uint32_t line, uint32_t column, std::string message,
                      std::string help) {
    error(code, {}, std::move(message), std::move(help));
    if (error_count_ > kMaxErrors) return;
    errors_.back().line = line;
    errors_.back().column = column;
}

void Report::warn(const char* code, std::string pointer, std::string message, std::string help) {
    if (++warnings_by_code_[code] > kMaxWarningsPerCode) return;
    Diagnostic diagnostic = make(Severity::warning, code, file_, std::move(message));
    diagnostic.pointer = std::move(pointer);
    diagnostic.help.push_back(std::move(help));
    warnings_.push_back(std::move(diagnostic));
}

Diagnostics Report::take_errors() {
    if (error_count_ > kMaxErrors) {
        errors_.back().notes.push_back(
            {file_, 0, 0, "the file has " + std::to_string(error_count_ - kMaxErrors) + " more errors"});
    }
    return std::move(errors_);
}

Diagnostics Report::take_warnings() {
    for (const auto& [code, count] : warnings_by_code_) {
        if (count <= kMaxWarningsPerCode) continue;
        const std::string more = std::to_string(count - kMaxWarningsPerCode);
        warnings_.push_back(
            make(Severity::warning, code, file_, more + " more warnings of this kind are not shown"));
    }
    return std::move(warnings_);
}

}  // namespace weft::scene::gltf
