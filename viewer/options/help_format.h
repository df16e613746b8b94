// Purpose: formats the help of the commands: "--graph FILE" instead of "--graph TEXT", and "[default: 4]"
// after the description instead of "=4" before it.
#pragma once

namespace CLI {
class App;
}

namespace weft::viewer {

// Sets the format of the help for `app` and its commands. Call this after all options have been added.
void format_help(CLI::App& app);

}  // namespace weft::viewer
