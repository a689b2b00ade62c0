// The results as the JSON of the report, for files and for the script of the page.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "skydrop/accuracy/result.h"

namespace skydrop::accuracy {

// What stands for a picture's file, `isShown` where its point is on a front or shipped; empty: its name.
using PictureText = std::function<std::string(const std::string& file, bool isShown)>;

nlohmann::ordered_json reportJson(const Results& results, const PictureText& picture);

}  // namespace skydrop::accuracy
