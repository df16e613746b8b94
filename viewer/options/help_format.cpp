#include "viewer/options/help_format.h"

#include <CLI/CLI.hpp>

#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace weft::viewer {
namespace {

struct ValueName {
    std::string_view option;
    const char* value;
};
constexpr std::array kValueNames{
    ValueName{"camera", "NAME|NUMBERS"}, ValueName{"camera-path", "FILE"}, ValueName{"debug", "NAME"},
    ValueName{"device", "INDEX|NAME"},   ValueName{"graph", "FILE"},       ValueName{"graphs", "NAME|FILE"},
    ValueName{"limits", "FILE"},         ValueName{"output", "FILE"},      ValueName{"profile", "FILE|NAME"},
    ValueName{"resource", "REF"},        ValueName{"stats", "FILE"},       ValueName{"tier", "NAME"},
    ValueName{"format", "NAME"},         ValueName{"metric", "NAME"},      ValueName{"shape", "NAME"},
};

// Returns the placeholder of an option's value, such as "FILE" for --output. Returns an empty text if
// kValueNames does not contain the option. The table contains no positional arguments, because the help
// already shows their names.
const char* value_name(const CLI::Option& option) {
    for (const std::string& name : option.get_lnames())
        for (const ValueName& row : kValueNames)
            if (row.option == name) return row.value;
    return "";
}

std::string erased(std::string text, const std::string& part) {
    const size_t at = part.empty() ? std::string::npos : text.find(part);
    return at == std::string::npos ? text : text.erase(at, part.size());
}

// Returns the default value of an option, without the brackets around a list.
std::string default_value(const CLI::Option& option) {
    const std::string& value = option.get_default_str();
    return value.starts_with('[') ? value.substr(1, value.size() - 2) : value;
}

class HelpFormatter final : public CLI::Formatter {
 public:
    // CLI11 prints the type of a value before the text of its validator, as in "TEXT:WxH". The help shows
    // only the text of the validator ("WxH"), because it is more exact than the type.
    std::string make_option_opts(const CLI::Option* option) const override {
        std::string text = CLI::Formatter::make_option_opts(option);
        for (const char* type : {"TEXT:", "UINT:", "FLOAT:"}) text = erased(std::move(text), type);
        const std::string& value = option->get_default_str();
        return value.empty() ? text : erased(std::move(text), "=" + value);
    }
    std::string make_option_desc(const CLI::Option* option) const override {
        const std::string value = default_value(*option);
        return option->get_description() + (value.empty() ? "" : " [default: " + value + "]");
    }
};

}  // namespace

void format_help(CLI::App& app) {
    app.formatter_fn(
        [formatter = HelpFormatter()](const CLI::App* command, std::string name, CLI::AppFormatMode mode) {
            return formatter.make_help(command, std::move(name), mode);
        });
    for (CLI::Option* option : app.get_options())
        if (option->get_type_name() == "TEXT") option->type_name(value_name(*option));
    for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) format_help(*command);
}

}  // namespace weft::viewer
