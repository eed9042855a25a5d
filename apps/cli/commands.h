// The subcommands. Each adds itself to the program; running it sets `code`.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/console.h"

namespace kiri::cli {

void addRenderCommand(CLI::App& app, Console& console, int& code);
void addSheetCommand(CLI::App& app, Console& console, int& code);
void addAnimateCommand(CLI::App& app, Console& console, int& code);
void addInfoCommand(CLI::App& app, Console& console, int& code);
void addStepsCommand(CLI::App& app, Console& console, int& code);
void addExportCommand(CLI::App& app, Console& console, int& code);
void addResolveCommand(CLI::App& app, Console& console, int& code);
void addLeafCommand(CLI::App& app, Console& console, int& code);
void addMeasureCommand(CLI::App& app, Console& console, int& code);
void addGalleryCommand(CLI::App& app, Console& console, int& code);
void addCheckCommand(CLI::App& app, Console& console, int& code);
void addStatesCommand(CLI::App& app, Console& console, int& code);
void addConvertCommand(CLI::App& app, Console& console, int& code);

}  // namespace kiri::cli
