#include "viewer/options/value_names.h"

#include <CLI/CLI.hpp>

#include <array>
#include <string_view>

namespace weft::viewer {
namespace {

struct ValueName {
    std::string_view option;
    const char* value;
};
constexpr std::array kValueNames{
    ValueName{"camera", "NAME|NUMBERS"}, ValueName{"debug", "NAME"},        ValueName{"device", "INDEX|NAME"},
    ValueName{"graph", "FILE"},          ValueName{"graphs", "NAME|FILE"},  ValueName{"limits", "FILE"},
    ValueName{"output", "FILE"},         ValueName{"profile", "FILE|NAME"}, ValueName{"resource", "REF"},
    ValueName{"stats", "FILE"},          ValueName{"tier", "NAME"},
};

// Returns an empty text for a positional argument, because its own name says what to write.
const char* value_name(const CLI::Option& option) {
    for (const std::string& name : option.get_lnames())
        for (const ValueName& row : kValueNames)
            if (row.option == name) return row.value;
    return "";
}

}  // namespace

void name_values(CLI::App& app) {
    for (CLI::Option* option : app.get_options())
        if (option->get_type_name() == "TEXT") option->type_name(value_name(*option));
    for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) name_values(*command);
}

}  // namespace weft::viewer
