#include "viewer/options/validators.h"

#include <CLI/CLI.hpp>

#include "viewer/options/arguments.h"
#include "viewer/options/import_texts.h"

namespace weft::viewer {

CLI::Validator size_validator() {
    return CLI::Validator([](std::string& text) { return size_fault(text); }, "WxH");
}

CLI::Validator frames_validator() {
    return CLI::Validator([](std::string& text) { return frames_fault(text); }, "N|A..B");
}

CLI::Validator param_validator() {
    return CLI::Validator([](std::string& text) { return param_fault(text); }, "NAME=VALUE");
}

CLI::Validator turns_validator() {
    return CLI::Validator([](std::string& text) { return turns_fault(text); }, "NAME=ROUND,ROUND…");
}

CLI::Validator import_validator() {
    return CLI::Validator([](std::string& text) { return import_fault(text); }, "NAME=KIND:VALUE");
}

CLI::Validator env_validator() {
    return CLI::Validator([](std::string& text) { return env_fault(text); }, "sky|none|FILE.hdr");
}

CLI::Validator plot_validator() {
    return CLI::Validator([](std::string& text) { return plot_fault(text); }, "FILE.svg");
}

CLI::Validator folder_validator() {
    return CLI::Validator([](std::string& text) { return folder_fault(text); }, "DIR");
}

// Checks the number, and replaces its text by a plain decimal number, which CLI11 reads in the same way in
// every locale.
CLI::Validator number_in(const NumberRange& range) {
    return CLI::Validator(
        [range](std::string& text) {
            std::string fault = number_fault(text, range);
            if (fault.empty()) text = decimal(*finite_number(text));
            return fault;
        },
        describe(range));
}

CLI::Validator choice_validator(std::vector<std::string> choices) {
    return CLI::Validator(
        [choices = std::move(choices)](std::string& text) { return choice_fault(text, choices); }, "");
}

CLI::Validator fraction_in(const NumberRange& range) {
    return CLI::Validator(
        [range](std::string& text) {
            std::string fault = fraction_fault(text, range);
            if (fault.empty()) text = decimal(*finite_fraction(text));
            return fault;
        },
        describe(range) + ", or a fraction");
}

CLI::Validator whole_number_in(uint64_t least, uint64_t most) {
    return CLI::Validator(
        [least, most](std::string& text) {
            std::string fault = whole_number_fault(text, least, most);
            if (fault.empty()) text = std::to_string(*whole_number(text));
            return fault;
        },
        std::to_string(least) + " to " + std::to_string(most));
}

}  // namespace weft::viewer
