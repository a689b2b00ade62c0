#include "skydrop/core/error.h"

#include "skydrop/core/message.h"

namespace skydrop::core {

DataError::DataError(std::string_view file, std::string_view place, std::string_view reason)
    : std::runtime_error(messageLine(file, place, reason)) {}

UsageError::UsageError(std::string_view message) : std::runtime_error(printable(message)) {}

RangeError::RangeError(std::string_view message) : std::runtime_error(printable(message)) {}

GraphicsUnavailable::GraphicsUnavailable(std::string_view message) : std::runtime_error(printable(message)) {}

}  // namespace skydrop::core
