// Purpose: names the values of options in the help, as in "--graph FILE" instead of "--graph TEXT".
#pragma once

namespace CLI {
class App;
}

namespace weft::viewer {

// Sets the value names of all options of `app` and its commands. Options with a validator already have one.
void name_values(CLI::App& app);

}  // namespace weft::viewer
