// Pictures of others: PNG or JPEG, recognised by content. Any thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "skydrop/core/image.h"

namespace skydrop::core {

// JPEG of 8 bits, one or three components, baseline or progressive. Throws DataError (naming `name` and the
// place) for anything else, for what is larger than 16384 a side or than 512 MiB of pixels, and for a file
// that is cut off: there is no checksum in a JPEG, so damage within the pixels that the codes allow gives a
// picture that is wrong.
Image decodeJpeg(std::span<const std::byte> bytes, std::string_view name);

// Either, by their first bytes.
Image decodePicture(std::span<const std::byte> bytes, std::string_view name);
Image readPicture(const std::filesystem::path& path);

}  // namespace skydrop::core
