// The files that frames go to, from one pattern.
#pragma once

#include <string>

namespace skydrop::app {

// Whether the name of the pattern's file counts frames. Throws core::UsageError for a % that is followed by
// neither d nor %.
bool countsFrames(const std::string& pattern);

// In the name of the pattern's file, not of its folders, "%d" becomes the frame's number and "%%" a percent
// sign; the pattern has passed countsFrames().
std::string framePath(const std::string& pattern, int frame);

}  // namespace skydrop::app
