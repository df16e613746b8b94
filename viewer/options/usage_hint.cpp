#include "viewer/options/usage_hint.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#include <CLI/CLI.hpp>
#pragma GCC diagnostic pop

#include <vector>

#include "weft/result.h"

namespace weft::viewer {
namespace {

// Returns the innermost command of the arguments. For `weft bench frame --lihgts` this is `frame`, because
// the suggestions must come from the flags of `frame`.
const CLI::App& innermost(const CLI::App& app) {
    const CLI::App* at = &app;
    for (bool is_deeper = true; is_deeper;) {
        is_deeper = false;
        for (const CLI::App* command : at->get_subcommands({}))
            if (command->parsed()) {
                at = command;
                is_deeper = true;
                break;
            }
    }
    return *at;
}

std::vector<std::string> commands_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

// Returns the names of all flags of a command, such as "--size". Flags without a group exist only for tests,
// so they are left out.
std::vector<std::string> flags_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        if (!option->get_group().empty())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

}  // namespace

std::string usage_hint(const CLI::App& app) {
    const CLI::App& command = innermost(app);
    std::string hints;
    for (const std::string& argument : app.remaining(true)) {
        const bool is_flag = argument.starts_with("-");
        const std::string name = is_flag ? argument.substr(0, argument.find('=')) : argument;
        const std::string hint = did_you_mean_text(name, is_flag ? flags_of(command) : commands_of(command));
        if (!hint.empty()) hints += "\"" + name + "\": " + hint + "\n";
    }
    return hints;
}

}  // namespace weft::viewer
