// Weather: open_meteo.
#include "fuzz/weather_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::readWeather(data, size);
  return 0;
}
