// What the program does, by verb. Each returns the exit code and throws the types of core/error.h.
#pragma once

#include "app/types/command_line.h"

namespace skydrop::app {

int fly(const CommandLine& line);
int render(const CommandLine& line);
int simulate(const CommandLine& line);
int accuracy(const CommandLine& line);
int calibrateBudget(const CommandLine& line);  // accuracy calibrate
int judgeLight(const CommandLine& line);       // accuracy judge
int printStability(const CommandLine& line);   // accuracy stability
int noise(const CommandLine& line);
int generateNoise(const CommandLine& line);  // noise --generate
int sky(const CommandLine& line);
int weather(const CommandLine& line);
int lab(const CommandLine& line);
int checkWeather(const CommandLine& line);    // weather check
int fetchWeather(const CommandLine& line);    // weather fetch
int checkElevation(const CommandLine& line);  // elevation check
int info(const CommandLine& line);
int compare(const CommandLine& line);
int listSettings(const CommandLine& line);  // settings

// The whole program: parses, runs, and turns errors into one line on stderr and an exit code.
int runProgram(int argc, const char* const* argv);

}  // namespace skydrop::app
