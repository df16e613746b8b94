#include "arguments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>

#include "weft/result.h"

namespace weft::viewer {
namespace {

struct FutureFlag {
    const char* name;
    const char* what;
};
constexpr std::array kFutureRenderFlags{
    FutureFlag{"--profile", "rendering to a profile"},
};

struct FutureFlags {
    const char* command;
    std::span<const FutureFlag> flags;
};
constexpr std::array kFutureFlags{FutureFlags{"render", kFutureRenderFlags}};

std::optional<double> number_of(const std::string& text) {
    if (text == "true" || text == "false") return text == "true" ? 1 : 0;
    if (text.empty() || text.front() == ' ') return std::nullopt;
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (*end != 0 || !std::isfinite(number)) return std::nullopt;
    return number;
}

// ": did you mean …?", or empty.
std::string with_guess(const std::string& text, const std::vector<std::string>& known) {
    const std::string guess = did_you_mean_text(text, known);
    return guess.empty() ? "" : ": " + guess;
}

}  // namespace

std::string size_fault(const std::string& text) {
    unsigned width = 0, height = 0;
    char end = 0;
    const bool whole = std::sscanf(text.c_str(), "%5ux%5u%c", &width, &height, &end) == 2;
    if (whole && width > 0 && height > 0 && width <= 16384 && height <= 16384) return "";
    return "a size is WIDTHxHEIGHT in pixels, each 1 to 16384, not \"" + text + "\"";
}

Extent3D parse_size(const std::string& text) {
    Extent3D size;
    std::sscanf(text.c_str(), "%5ux%5u", &size.width, &size.height);
    return size;
}

std::string param_fault(const std::string& text) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) return "a parameter is NAME=VALUE, not \"" + text + "\"";
    const std::string value = text.substr(equals + 1);
    return number_of(value) ? "" : "\"" + value + "\" is not a number, true or false";
}

std::string choice_fault(const std::string& text, const std::vector<std::string>& choices) {
    if (std::ranges::find(choices, text) != choices.end()) return "";
    std::string all;
    for (const std::string& choice : choices) all += (all.empty() ? "" : ", ") + choice;
    return "\"" + text + "\" is not one of " + all + with_guess(text, choices);
}

std::string limit_fault(const std::string& text) {
    const std::optional<double> number = text == "true" || text == "false" ? std::nullopt : number_of(text);
    return number ? "" : "\"" + text + "\" is not a finite number";
}

std::string plot_fault(const std::string& text) {
    return text.size() > 4 && text.ends_with(".svg") ? "" : "a plot is an .svg, not \"" + text + "\"";
}

std::string env_fault(const std::string& text) {
    const bool is_file = text.find_first_of("./") != std::string::npos;
    return text == "sky" || text == "none" || is_file
               ? ""
               : "an environment is sky, none or a Radiance picture (FILE.hdr), not \"" + text + "\"" +
                     with_guess(text, {"sky", "none"});
}

std::map<std::string, double> parse_params(const std::vector<std::string>& texts) {
    std::map<std::string, double> params;
    for (const std::string& text : texts) {
        const size_t equals = text.find('=');
        params[text.substr(0, equals)] = number_of(text.substr(equals + 1)).value_or(0);
    }
    return params;
}

std::string future_fault(const std::vector<std::string>& arguments) {
    if (arguments.empty()) return "";
    const auto says = [&](const char* word) { return std::ranges::find(arguments, word) != arguments.end(); };
    if (arguments[0] == "view" && !says("--headless") && !says("--help") && !says("-h"))
        return "`view` is not there yet in this version of weft; `view --headless` is";
    for (const FutureFlags& command : kFutureFlags) {
        if (arguments.front() != command.command) continue;
        for (const std::string& argument : arguments)
            for (const FutureFlag& flag : command.flags)
                if (argument.substr(0, argument.find('=')) == flag.name)
                    return std::string(flag.name) + ": " + flag.what +
                           " are not there yet in this version of weft";
    }
    return "";
}

}  // namespace weft::viewer
