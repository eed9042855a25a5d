// Looks through pages of HTML for what browsers and readers stumble over.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kiri::cli {

/// What is wrong with the pages below a folder, a sentence each: tags that are not closed in their
/// order, links and pictures that lead nowhere, pictures without alt or size,
/// films that start or load unasked, ids that stand there
/// twice, headings that skip a level, no language, title or view port, scripts, what lies
/// elsewhere.
std::vector<std::string> htmlMistakes(const std::filesystem::path& folder);

/// The pages below a folder.
std::vector<std::filesystem::path> pagesBelow(const std::filesystem::path& folder);

}  // namespace kiri::cli
