// SPDX-License-Identifier: MIT
// The folders in which LinuxCNC looks for subprograms.
#pragma once

#include <string>

#include "hal/import/ini_file.hpp"

namespace softcnc::hal {

/// Takes over [DISPLAY]PROGRAM_PREFIX and [RS274NGC]SUBROUTINE_PATH of the configuration `file`, in
/// the order in which LinuxCNC looks through them, as `program.path`, counted from `target_folder`
/// (empty: the working folder). A folder of a home ('~') is left: only a shell knows it.
void take_subroutine_path(IniFile& ini, const std::string& file, const std::string& target_folder,
                          MachineDraft& draft);

}  // namespace softcnc::hal
