// The commands of the program. A new one is its own file, one line here and one in main.
#pragma once

namespace CLI {
class App;
}

namespace umbral {

// Each adds its command to `app`; when that is called for, it runs and leaves its ExitCode in `exit_code`.
void add_render_command(CLI::App& app, int& exit_code);
void add_check_command(CLI::App& app, int& exit_code);
void add_convert_command(CLI::App& app, int& exit_code);
void add_info_command(CLI::App& app, int& exit_code);
void add_merge_command(CLI::App& app, int& exit_code);
void add_compare_command(CLI::App& app, int& exit_code);
void add_converge_command(CLI::App& app, int& exit_code);
void add_help_command(CLI::App& app, int& exit_code);

}  // namespace umbral
