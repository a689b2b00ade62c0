// Content and names inside URIs of glTF files. RFC 2397 (data), RFC 3986 section 2.1 (percent-encoding),
// RFC 4648 section 4 (base64).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace skydrop::render {

bool isDataUri(std::string_view uri);
// Both throw core::DataError of `file` and `place`. Only base64 is read.
std::vector<std::byte> decodeDataUri(std::string_view uri, const std::string& file, const std::string& place);
std::string decodePercent(std::string_view uri, const std::string& file, const std::string& place);

}  // namespace skydrop::render
